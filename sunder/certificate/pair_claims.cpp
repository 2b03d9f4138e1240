#include <sunder/base/contract.h>
#include <sunder/certificate/direction.h>
#include <sunder/certificate/pair_claims.h>

#include <algorithm>
#include <cmath>

namespace sunder {

void PairClaims::begin_entry(const std::string& name) {
  if (entries_.empty()) file_.begin_table("bodies");
  file_.begin_entry();
  file_.text("name", name.empty() ? "unnamed" : cut_text(name));
}

void PairClaims::add_points_of_entry(std::span<const Point3> points) {
  file_.begin_list("points");
  for (const Point3& p : points) {
    const std::array row{p.x, p.y, p.z};
    file_.add_row(std::span(row).first(dimension()));
  }
  file_.end_list();
}

std::uint32_t PairClaims::add_round_body(const std::string& name, std::span<const Point3> core, RoundKind kind,
                                         double radius) {
  SUNDER_REQUIRE(space_ == Space::solid && radius >= 0 && std::isfinite(radius));
  const RoundKindRow& row = row_of(kind);
  SUNDER_REQUIRE(row.points == 0 ? !core.empty() : core.size() == row.points);
  begin_entry(name);
  add_points_of_entry(core);
  file_.real(row.key, radius);
  file_.end_entry();
  entries_.push_back({name, core, Affine3()});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

std::uint32_t PairClaims::add_body(const std::string& name, std::span<const Point3> vertices,
                                   std::span<const Way3> ways) {
  begin_entry(name);
  const std::size_t d = dimension();
  add_points_of_entry(vertices);
  if (!ways.empty()) {
    file_.begin_list("ways");
    for (const Way3& way : ways) {
      const std::array<double, 6> row = d == 2 ? std::array{way.from.x, way.from.y, way.to.x, way.to.y, 0.0, 0.0}
                                               : std::array{way.from.x, way.from.y, way.from.z,  //
                                                            way.to.x,   way.to.y,   way.to.z};
      file_.add_row(std::span(row).first(2 * d));
    }
    file_.end_list();
  }
  file_.end_entry();
  entries_.push_back({name, vertices, Affine3()});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

std::uint32_t PairClaims::add_placed(const std::string& name, std::uint32_t body, const Affine3& pose) {
  if (pose == Affine3() && name == entries_[body].name) return body;
  begin_entry(name);
  file_.index("of", body);
  const auto& m = pose.linear;
  if (space_ == Space::planar) {
    file_.doubles("linear", std::array{m[0], m[1], m[3], m[4]});
  } else {
    file_.doubles("linear", m);
  }
  file_.doubles("translation", std::span(pose.translation).first(dimension()));
  file_.end_entry();
  entries_.push_back({name, entries_[body].vertices, pose});
  return static_cast<std::uint32_t>(entries_.size() - 1);
}

void PairClaims::go_to_statements() {
  if (!states_something_ && !entries_.empty()) file_.end_table();
  states_something_ = true;
}

void PairClaims::begin_statement(const char* question, std::uint32_t a, std::uint32_t b, const char* verdict) {
  go_to_statements();
  file_.begin_statement(question);
  file_.index("a", a);
  file_.index("b", b);
  file_.text("verdict", verdict);
}

void PairClaims::add_parting(const char* claim, const std::array<Dyadic, 3>& direction) {
  file_.begin_claim(claim);
  file_.numbers("direction", std::span(direction).first(dimension()));
  file_.end_claim();
}

void PairClaims::add_apart(std::uint32_t a, std::uint32_t b, const std::array<Dyadic, 3>& direction) {
  begin_statement("pair", a, b, "apart");
  file_.begin_claims();
  add_parting("parted", direction);
  file_.end_statement();
}

// The point, then a claim for each body; leaves the list of claims open.
void PairClaims::add_point_claims(const char* claim, const CommonPoint& point) {
  file_.fractions("point", point.at, dimension());
  file_.begin_claims();
  for (const Combination* of : {&point.of_a, &point.of_b}) add_combination(claim, *of);
}

void PairClaims::add_combination(const char* claim, const Combination& combination) {
  file_.begin_claim(claim);
  file_.begin_list("weights");
  for (const auto& [index, numerator] : combination.parts) {
    file_.add_weight(index, numerator, combination.denominator);
  }
  file_.end_list();
  if (combination.from) file_.fractions("from", *combination.from);
  file_.end_claim();
}

void PairClaims::add_common_part(std::uint32_t a, std::uint32_t b, const CommonPoint& first, const CommonPoint& last,
                                 const std::array<Dyadic, 3>& before, const std::array<Dyadic, 3>& after) {
  begin_statement("common_part", a, b, "between");
  file_.fractions("first", first.at, dimension());
  file_.fractions("last", last.at, dimension());
  file_.begin_claims();
  for (const CommonPoint* point : {&first, &last}) {
    for (const Combination* of : {&point->of_a, &point->of_b}) add_combination("holds", *of);
  }
  file_.begin_claim("no_further");
  file_.numbers("before", std::span(before).first(dimension()));
  file_.numbers("after", std::span(after).first(dimension()));
  file_.end_claim();
  file_.end_statement();
}

void PairClaims::add_nearest(std::uint32_t a, std::uint32_t b, std::uint32_t vertex,
                             const std::array<Dyadic, 3>& direction) {
  begin_statement("nearest", a, b, "point");
  file_.index("i", vertex);
  file_.begin_claims();
  add_parting("first_along", direction);
  file_.end_statement();
}

void PairClaims::add_two_supports(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> on_first,
                                  std::span<const std::uint32_t> on_last, const std::array<Dyadic, 3>& before,
                                  const std::array<Dyadic, 3>& after) {
  begin_statement("support", a, b, "two");
  file_.indices("on_first", on_first);
  file_.indices("on_last", on_last);
  file_.begin_claims();
  file_.begin_claim("wedge");
  file_.numbers("before", before);
  file_.numbers("after", after);
  file_.end_claim();
  file_.end_statement();
}

void PairClaims::add_one_support(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> on_plane,
                                 const std::array<Dyadic, 3>& direction) {
  begin_statement("support", a, b, "one");
  file_.indices("on_plane", on_plane);
  file_.begin_claims();
  add_parting("rests", direction);
  file_.end_statement();
}

void PairClaims::add_no_support(std::uint32_t a, std::uint32_t b, const CommonPoint& point,
                                const std::array<std::uint32_t, 4>& spanning) {
  begin_statement("support", a, b, "none");
  file_.fractions("point", point.at, dimension());
  file_.begin_claims();
  add_combination("inside", point.of_a);
  add_combination("holds", point.of_b);
  file_.begin_claim("full");
  for (std::size_t k = 0; k < 4; ++k) file_.index(std::string_view("ijkl").substr(k, 1), spanning[k]);
  file_.end_claim();
  file_.end_statement();
}

void PairClaims::add_distance(std::uint32_t a, std::uint32_t b, const PointOf& from_a, const PointOf& to_b) {
  begin_statement("distance", a, b, "closest");
  add_points("slab", from_a, to_b);
}

void PairClaims::add_clearance(std::uint32_t a, std::uint32_t b, double least, const std::array<Dyadic, 3>& direction) {
  SUNDER_REQUIRE(least > 0);
  begin_statement("clearance", a, b, "kept");
  file_.real("least", least);
  file_.begin_claims();
  add_parting("clear", direction);
  file_.end_statement();
}

void PairClaims::add_clearance_broken(std::uint32_t a, std::uint32_t b, double least, const PointOf& from_a,
                                      const PointOf& to_b) {
  SUNDER_REQUIRE(least > 0);
  begin_statement("clearance", a, b, "broken");
  file_.real("least", least);
  add_points("nearer", from_a, to_b);
}

void PairClaims::add_pairs(const char* name, const std::vector<std::array<std::uint32_t, 2>>& pairs) {
  file_.begin_list(name);
  for (const auto& pair : pairs) file_.add_list(pair);
  file_.end_list();
}

void PairClaims::begin_members(const char* question, const AllPairs& pairs) {
  go_to_statements();
  file_.begin_statement(question);
  file_.indices("members", pairs.members);
  file_.indices("groups", pairs.groups);
  const auto is_mesh = [](const auto& mesh) { return mesh.has_value(); };
  if (std::none_of(pairs.as_meshes.begin(), pairs.as_meshes.end(), is_mesh)) return;
  file_.begin_list("as_meshes");
  for (const auto& mesh : pairs.as_meshes) {
    if (mesh) {
      file_.add_index(*mesh);
    } else {
      file_.add_null();
    }
  }
  file_.end_list();
}

void PairClaims::add_all_pairs(const AllPairs& pairs) {
  begin_members("bodies", pairs);
  file_.text("allowed", pairs.touching_allowed ? "touch" : "nothing");
  add_pairs("except", pairs.besides);
  file_.text("verdict", "these");
  add_pairs("contacts", pairs.contacts);
  file_.begin_claims();
  file_.claim("each_pair");
  file_.end_statement();
}

void PairClaims::add_all_clearances(const AllPairs& pairs, double least) {
  SUNDER_REQUIRE(least > 0);
  begin_members("clearances", pairs);
  add_pairs("except", pairs.besides);
  file_.real("least", least);
  file_.text("verdict", pairs.contacts.empty() ? "kept" : "broken");
  if (!pairs.contacts.empty()) add_pairs("nearer", pairs.contacts);
  file_.begin_claims();
  file_.claim("each_clearance");
  file_.end_statement();
}

// A point of each body, and the claims that prove them; the last one is of the two points. Ends the statement.
void PairClaims::add_points(const char* claim, const PointOf& from_a, const PointOf& to_b) {
  file_.fractions("from_a", from_a.at, dimension());
  file_.fractions("to_b", to_b.at, dimension());
  file_.begin_claims();
  add_combination("holds", from_a.of_body);
  add_combination("holds", to_b.of_body);
  file_.claim(claim);
  file_.end_statement();
}

void PairClaims::add_meet(std::uint32_t a, std::uint32_t b, const CommonPoint& point) {
  begin_statement("pair", a, b, "meet");
  add_point_claims("holds", point);
  file_.end_statement();
}

void PairClaims::begin_motion(std::uint32_t a, std::uint32_t b, std::uint32_t to_a, std::uint32_t to_b,
                              const char* verdict) {
  begin_statement("motion", a, b, verdict);
  file_.index("to_a", to_a);
  file_.index("to_b", to_b);
}

void PairClaims::add_motion_apart(std::uint32_t a, std::uint32_t b, std::uint32_t to_a, std::uint32_t to_b,
                                  const std::array<Dyadic, 3>& direction) {
  begin_motion(a, b, to_a, to_b, "apart");
  file_.begin_claims();
  add_parting("parted_all_along", direction);
  file_.end_statement();
}

void PairClaims::add_motion_meet(std::uint32_t a, std::uint32_t b, std::uint32_t to_a, std::uint32_t to_b,
                                 const ExactFraction& time, const CommonPoint& point,
                                 const std::array<Dyadic, 3>* first_along) {
  begin_motion(a, b, to_a, to_b, first_along == nullptr ? "meet" : "first");
  file_.fraction("time", time.numerator, time.denominator);
  add_point_claims("holds_at", point);
  if (first_along != nullptr) add_parting("not_before", *first_along);
  file_.end_statement();
}

void PairClaims::add_touching(std::uint32_t a, std::uint32_t b, const CommonPoint& point,
                              const std::array<Dyadic, 3>& direction) {
  begin_statement("pair", a, b, "touching");
  add_point_claims("holds", point);
  add_parting("parted_weakly", direction);
  file_.end_statement();
}

void PairClaims::add_overlapping(std::uint32_t a, std::uint32_t b, const CommonPoint& point) {
  begin_statement("pair", a, b, "overlapping");
  add_point_claims("inside", point);
  file_.end_statement();
}

CommonPoint PairClaims::common_point(std::uint32_t a, std::uint32_t b, const CommonVertices& c) const {
  const Entry &of_a = entries_[a], &of_b = entries_[b];
  return sunder::common_point(c, PlacedVertices{of_a.vertices, of_a.pose, false},
                              PlacedVertices{of_b.vertices, of_b.pose, false});
}

void PairClaims::add_pair(std::uint32_t a, std::uint32_t b, const PairCertificate& c) {
  if (const auto* meet = std::get_if<CommonVertices>(&c)) return add_meet(a, b, common_point(a, b, *meet));
  const Entry &of_a = entries_[a], &of_b = entries_[b];
  const WorldDirection d = world_direction(std::get<Separation>(c).direction, {of_a.vertices, of_a.pose, false},
                                           {of_b.vertices, of_b.pose, false});
  const Vector3<Dyadic> exact = d.exact();
  add_apart(a, b, {exact.x, exact.y, exact.z});
}

void PairClaims::end() {
  if (!states_something_ && !entries_.empty()) file_.end_table();
  file_.end();
}

}  // namespace sunder
