#include <sunder/base/contract.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/predicate/point/common_point.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/pair/contact_evidence.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <optional>
#include <span>

namespace sunder::solid {

namespace {

// The subset of corners whose bits are set, and their images.
std::size_t take_corners(unsigned subset, const PosedTriangle& triangle, std::span<std::uint32_t> named,
                         std::span<Posed3> at) {
  std::size_t n = 0;
  for (std::uint32_t k = 0; k < 3; ++k) {
    if ((subset >> k & 1) == 0) continue;
    named[n] = k;
    at[n++] = triangle[k];
  }
  return n;
}

// The fewest corners of either triangle whose hulls have a common point: its weights are unique and positive then. Of
// triangles that meet there are such; each is a corner of what they have in common. Until of_point(point) is true.
template <class OfPoint>
void each_common_point(const PosedTriangle& t, const PosedTriangle& u, const OfPoint& of_point) {
  for (int count = 2; count <= 5; ++count) {
    for (unsigned of_t = 1; of_t < 8; ++of_t) {
      for (unsigned of_u = 1; of_u < 8; ++of_u) {
        if (std::popcount(of_t) + std::popcount(of_u) != count) continue;
        CommonVertices tried;
        std::array<Posed3, 6> at{};
        std::array<std::uint32_t, 6> named{};
        const std::size_t a = take_corners(of_t, t, named, at),
                          b = take_corners(of_u, u, std::span(named).subspan(a), std::span(at).subspan(a));
        const std::span<const Posed3> all(at.data(), a + b);
        if (!have_common_point(all.first(a), all.subspan(a))) continue;
        tried.count_a = static_cast<std::uint8_t>(a);
        tried.count_b = static_cast<std::uint8_t>(b);
        std::copy_n(named.begin(), a + b, tried.vertices.begin());
        if (of_point(common_point(tried, all))) return;
      }
    }
  }
}

// Corners 0, 1, 2 by the numbers of the points of their mesh.
void name_points(const Mesh::Triangle& triangle, Combination& of) {
  for (Weights::Part& part : of.parts) part.index = triangle[part.index];
}

void add_rays(ClaimsWriter& file, const char* key, const std::vector<MeshCover::Ray>& rays) {
  file.begin_list(key);
  for (const auto& [triangle, along] : rays) {
    file.begin_list();
    file.add_index(triangle);
    file.add_numbers(along);
    file.end_list();
  }
  file.end_list();
}

void add_walk(ClaimsWriter& file, std::span<const std::int64_t> cuts,
              std::span<const std::array<Dyadic, 3>> directions) {
  file.integers("cuts", cuts);
  file.begin_list("directions");
  for (const auto& direction : directions) file.add_numbers(direction);
  file.end_list();
}

void add_weights(ClaimsWriter& file, const char* key, const Combination& weights) {
  file.begin_list(key);
  for (const auto& [index, numerator] : weights.parts) file.add_weight(index, numerator, weights.denominator);
  file.end_list();
}

// A point that is inside of one triangle, or inside of an edge of each. Requires that they cross: then there is such a
// point (triangle_contact.h), and the mean of the corners of their common part is one. Weights name corners 0, 1, 2.
CommonPoint crossing_point_of(const PosedTriangle& t, const PosedTriangle& u) {
  std::optional<CommonPoint> found;
  CommonPoint sum;
  double count = 0;
  const auto add = [](Combination& to, const Combination& of, const Dyadic& times, const Dyadic& over) {
    for (Weights::Part& part : to.parts) part.numerator = part.numerator * over;
    for (const auto& [index, numerator] : of.parts) to.add(index, numerator * times);
    to.denominator = to.denominator * over;
  };
  each_common_point(t, u, [&](CommonPoint&& point) {
    const std::size_t a = point.of_a.parts.size(), b = point.of_b.parts.size();
    if (a == 3 || b == 3) {
      found = std::move(point);
      return true;
    }
    const Dyadic over_a = point.of_a.denominator, over_b = point.of_b.denominator;
    add(sum.of_a, point.of_a, sum.of_a.denominator, over_a);
    add(sum.of_b, point.of_b, sum.of_b.denominator, over_b);
    count += 1;
    return false;
  });
  if (found) return *std::move(found);
  SUNDER_REQUIRE(count > 0);
  sum.of_a.denominator = sum.of_a.denominator * Dyadic(count);
  sum.of_b.denominator = sum.of_b.denominator * Dyadic(count);
  const Vector3<Dyadic> at = numerators_of(sum.of_a, [&](std::uint32_t k) { return coordinates<Dyadic>(t[k]); });
  sum.at = exact_point(at, sum.of_a.denominator);
  return sum;
}

class Statement {
 public:
  Statement(ClaimsWriter& file, const StatedMesh& a, const StatedMesh& b) : file_(file), a_(a), b_(b) {}

  void operator()(const MeshesApart&) const {
    begin("apart");
    file_.begin_claims();
    add_cover("covered", cover(), "rays_a", "rays_b");
    file_.end_statement();
  }

  void closest(const NearTriangles& nearest) const {
    begin("closest", "mesh_distance");
    const auto [of_a, of_b] = two_points(nearest);
    const ShortestWay<Dyadic> way = nearest.closest.way().way;
    add_cover("covered_apart", cover({nearest.closest.squared(), way.way}), "rays_a", "rays_b");
    file_.end_statement();
  }

  void kept(double least) const {
    begin_clearance("kept", least);
    file_.begin_claims();
    add_cover("covered_clear", cover({{Dyadic(least) * Dyadic(least)}, {}}), "rays_a", "rays_b");
    file_.end_statement();
  }
  void broken(double least, const NearTriangles& near) const {
    begin_clearance("broken", least);
    two_points(near);
    file_.begin_claim("nearer");
    file_.end_claim();
    file_.end_statement();
  }
  void broken(double least, const MeetingTriangles& meeting) const {
    begin_clearance("broken", least);
    const CommonPoint point = common_point(a_.mesh, a_.pose, b_.mesh, b_.pose, meeting);
    two_points(meeting.of_a, {point.at, point.of_a}, meeting.of_b, {point.at, point.of_b});
    file_.begin_claim("nearer");
    file_.end_claim();
    file_.end_statement();
  }

  // By what is known of how they lie to each other. False: nothing is stated.
  bool related(const MeshRelation& known, const MeshEvidence& evidence) const {
    switch (known.relation) {
      case Relation::touching: touching(*known.partition, std::get<MeetingTriangles>(evidence)); return true;
      case Relation::overlapping: overlapping(*known.inside); return true;
      case Relation::a_part_of_b: parted("a_part_of_b", "part_of", *known.partition, true); return true;
      case Relation::b_part_of_a: parted("b_part_of_a", "part_of", *known.partition, false); return true;
      case Relation::equal: parted("equal", "equal_insides", *known.partition, true); return true;
      case Relation::a_inside_b: within("a_inside_b", a_, b_); return true;
      case Relation::b_inside_a: within("b_inside_a", b_, a_); return true;
      case Relation::none:
      case Relation::meeting: break;
    }
    return false;
  }

  void operator()(const MeetingTriangles& meeting) const {
    begin("meet");
    common_point_of(meeting);
    file_.end_statement();
  }

  void operator()(const PointWithin& within) const {
    begin(within.is_of_a ? "a_within" : "b_within");
    point_within(within);
  }

  void motion(const StatedMotion& a, const StatedMotion& b, const MeshMotion& answer) const {
    const SweepContact* const contact = contact_on_the_way(answer);
    const auto* const meeting = std::get_if<MeetingTriangles>(&answer.evidence);
    const auto* const within = std::get_if<PointWithin>(&answer.evidence);
    begin(contact != nullptr   ? "first"
          : meeting != nullptr ? "meet"
          : within == nullptr  ? "apart"
          : within->is_of_a    ? "a_within"
                               : "b_within",
          "mesh_motion");
    file_.index("to_a", a.end);
    file_.index("to_b", b.end);
    if (within != nullptr) return point_within(*within);
    if (contact != nullptr) {
      const auto& later = std::get<TrianglesOnTheWay>(answer.evidence);
      file_.fraction("time", contact->time.numerator, contact->time.denominator);
      on_both(contact->point, later.of_a, later.of_b, "on_triangle_at");
    } else if (meeting != nullptr) {
      file_.fraction("time", Dyadic(), Dyadic(1.0));
      on_both(common_point(a_.mesh, a_.pose, b_.mesh, b_.pose, *meeting), meeting->of_a, meeting->of_b,
              "on_triangle_at");
    } else {
      file_.begin_claims();
    }
    if (meeting == nullptr) {
      add_cover(contact != nullptr ? "covered_before" : "covered_all_along",
                mesh_cover_on_the_way(a_.mesh, a.of, b_.mesh, b.of, contact), "rays_a", "rays_b");
    }
    file_.end_statement();
  }
  void broken(double least, const PointWithin& within) const {
    begin_clearance(within.is_of_a ? "a_within" : "b_within", least);
    point_within(within);
  }

  void point_within(const PointWithin& within) const {
    const StatedMesh &of = within.is_of_a ? a_ : b_, &other = within.is_of_a ? b_ : a_;
    const PlacedMesh placed(of.mesh, of.pose), around(other.mesh, other.pose);
    const Posed3 at = placed.at(within.point);
    const std::array<Dyadic, 3> along = ray_away(around, at).along;
    const Vector3<Dyadic> point = coordinates<Dyadic>(at);
    const auto has_point = [&](const Mesh::Triangle& t) {
      return std::find(t.begin(), t.end(), within.point) != t.end();
    };
    const std::span<const Mesh::Triangle> all = of.mesh.triangles();
    const auto triangle = static_cast<std::uint32_t>(std::find_if(all.begin(), all.end(), has_point) - all.begin());
    file_.numbers("point", std::array{point.x, point.y, point.z});
    file_.begin_claims();
    for (const bool is_a : {true, false}) {
      if (is_a == within.is_of_a) {
        add_on_triangle(file_, triangle, Combination({{within.point, Dyadic(1.0)}}));
      } else {
        file_.begin_claim("encloses");
        file_.numbers("direction", along);
        file_.end_claim();
      }
    }
    file_.end_statement();
  }

  void overlapping(const FinePoint& inside) const {
    Affine3 pose;
    const Posed3 at = posed_at(inside, pose);
    begin("overlapping");
    file_.numbers("point", exact(inside));
    file_.begin_claims();
    for (const StatedMesh* of : {&a_, &b_}) {
      file_.begin_claim("encloses");
      file_.numbers("direction", ray_away(PlacedMesh(of->mesh, of->pose), at).along);
      file_.end_claim();
    }
    file_.end_statement();
  }

 private:
  void touching(const MeshPartition& partition, const MeetingTriangles& meeting) const {
    begin("touching");
    common_point_of(meeting);
    add_partition("insides_apart", partition, true);
    file_.end_statement();
  }

  void parted(const char* verdict, const char* rule, const MeshPartition& partition, bool is_a_first) const {
    begin(verdict);
    file_.begin_claims();
    add_partition(rule, partition, is_a_first);
    file_.end_statement();
  }

  void common_point_of(const MeetingTriangles& meeting) const {
    on_both(common_point(a_.mesh, a_.pose, b_.mesh, b_.pose, meeting), meeting.of_a, meeting.of_b, "on_triangle");
  }
  void on_both(const CommonPoint& point, std::uint32_t triangle_a, std::uint32_t triangle_b, const char* rule) const {
    file_.fractions("point", point.at);
    file_.begin_claims();
    add_on_triangle(file_, triangle_a, point.of_a, rule);
    add_on_triangle(file_, triangle_b, point.of_b, rule);
  }

  // Begins the claims: that triangles hold the nearest points, or others.
  ClosestPoints two_points(const NearTriangles& near) const {
    ClosestPoints points = closest_points(near.closest);
    two_points(near.of_a, points.of_a, near.of_b, points.of_b);
    return points;
  }
  void two_points(std::uint32_t triangle_a, const PointOf& of_a, std::uint32_t triangle_b, const PointOf& of_b) const {
    file_.fractions("from_a", of_a.at);
    file_.fractions("to_b", of_b.at);
    file_.begin_claims();
    add_on_triangle(file_, triangle_a, of_a.of_body);
    add_on_triangle(file_, triangle_b, of_b.of_body);
  }

  void begin_clearance(const char* verdict, double least) const {
    begin(verdict, "mesh_clearance");
    file_.real("least", least);
  }

  void within(const char* verdict, const StatedMesh& inner, const StatedMesh& outer) const {
    begin(verdict);
    file_.begin_claims();
    add_cover("covered_within", mesh_cover(inner.mesh, inner.pose, outer.mesh, outer.pose), "rays_inner", "rays_outer");
    file_.end_statement();
  }

  MeshCover cover(const CoverWidth& width = {}) const { return mesh_cover(a_.mesh, a_.pose, b_.mesh, b_.pose, width); }

  void add_cover(const char* rule, const MeshCover& cover, const char* key_a, const char* key_b) const {
    file_.begin_claim(rule);
    add_walk(file_, cover.cuts, cover.directions);
    add_rays(file_, key_a, cover.rays_a);
    add_rays(file_, key_b, cover.rays_b);
    file_.end_claim();
  }

  void add_partition(const char* rule, const MeshPartition& partition, bool is_a_first) const {
    file_.begin_claim(rule);
    file_.integers("cuts", partition.cuts);
    file_.begin_list("planes");
    for (const MeshPartition::Plane& plane : partition.planes) file_.add_numbers(plane.numbers);
    file_.end_list();
    file_.begin_list("cells");
    for (const MeshPartition::Cell& cell : partition.cells) file_.add_numbers(exact(cell.point));
    file_.end_list();
    for (const bool is_first : {true, false}) {
      const bool is_of_a = is_first == is_a_first;
      const PlacedMesh of(is_of_a ? a_.mesh : b_.mesh, is_of_a ? a_.pose : b_.pose);
      file_.begin_list(is_first ? "rays_first" : "rays_second");
      for (std::uint32_t k = 0; k < partition.cells.size(); ++k) {
        const MeshPartition::Cell& cell = partition.cells[k];
        if (!(is_of_a ? cell.tells_a : cell.tells_b)) continue;
        Affine3 pose;
        file_.begin_list();
        file_.add_index(k);
        file_.add_numbers(ray_away(of, posed_at(cell.point, pose)).along);
        file_.end_list();
      }
      file_.end_list();
    }
    file_.end_claim();
  }

  void begin(const char* verdict, const char* question = "meshes") const {
    file_.begin_statement(question);
    file_.index("a", a_.index);
    file_.index("b", b_.index);
    file_.text("verdict", verdict);
  }

  ClaimsWriter& file_;
  const StatedMesh &a_, &b_;
};

StatedMesh add_named(MeshClaims& meshes, const NamedMesh& of) {
  const std::uint32_t mesh = meshes.add_mesh(of.name, of.mesh, of.said);
  return {of.pose.affine() == Affine3() ? mesh : meshes.add_placed(of.name, mesh, of.pose), of.mesh, of.pose};
}

}  // namespace

void add_on_triangle(ClaimsWriter& file, std::uint32_t triangle, const Combination& weights, const char* rule) {
  file.begin_claim(rule);
  file.index("triangle", triangle);
  add_weights(file, "weights", weights);
  file.end_claim();
}

CommonPoint crossing_point(const Mesh& mesh, const CrossingTriangles& pair) {
  const Pose here;
  const PlacedMesh placed(mesh, here);
  CommonPoint point = crossing_point_of(placed.triangle(pair.first), placed.triangle(pair.second));
  name_points(mesh.triangles()[pair.first], point.of_a);
  name_points(mesh.triangles()[pair.second], point.of_b);
  return point;
}

CommonPoint common_point(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                         const MeetingTriangles& evidence) {
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  std::optional<CommonPoint> found;
  each_common_point(placed_a.triangle(evidence.of_a), placed_b.triangle(evidence.of_b), [&](CommonPoint&& point) {
    found = std::move(point);
    return true;
  });
  SUNDER_REQUIRE(found.has_value());  // the triangles meet
  CommonPoint& point = *found;
  name_points(a.triangles()[evidence.of_a], point.of_a);
  name_points(b.triangles()[evidence.of_b], point.of_b);
  return point;
}

Point3 rounded_point_of(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                        const MeshEvidence& evidence) {
  if (const auto* meeting = std::get_if<MeetingTriangles>(&evidence)) {
    return nearest(common_point(a, pose_a, b, pose_b, *meeting).at);
  }
  const auto& within = std::get<PointWithin>(evidence);
  const PlacedMesh placed(within.is_of_a ? a : b, within.is_of_a ? pose_a : pose_b);
  const Vector3<Dyadic> at = coordinates<Dyadic>(placed.at(within.point));
  return {at.x.nearest(), at.y.nearest(), at.z.nearest()};
}

void MeshClaims::begin_entry(const std::string& name, const Said& said) {
  if (count_ == 0) file_.begin_table("meshes");
  file_.say(said);
  file_.begin_entry();
  file_.text("name", name.empty() ? "unnamed" : cut_text(name));
}

std::uint32_t MeshClaims::add_mesh(const std::string& name, const Mesh& mesh, const Said& said) {
  begin_entry(name, said);
  file_.begin_list("points");
  for (const Point3& p : mesh.points()) file_.add_row(std::array{p.x, p.y, p.z});
  file_.end_list();
  file_.begin_list("triangles");
  for (const Mesh::Triangle& t : mesh.triangles()) file_.add_list(t);
  file_.end_list();
  file_.end_entry();
  return count_++;
}

std::uint32_t MeshClaims::add_placed(const std::string& name, std::uint32_t mesh, const Pose& pose) {
  begin_entry(name, {});
  file_.index("of", mesh);
  file_.doubles("linear", pose.affine().linear);
  file_.doubles("translation", pose.affine().translation);
  file_.end_entry();
  return count_++;
}

void MeshClaims::end_table() {
  if (count_ > 0) file_.end_table();
}

void MeshClaims::add_pair(const StatedMesh& a, const StatedMesh& b, const MeshEvidence& evidence,
                          const MeshRelation* relation) {
  const Statement statement(file_, a, b);
  if (relation == nullptr || !statement.related(*relation, evidence)) std::visit(statement, evidence);
}

void MeshClaims::add_overlapping(const StatedMesh& a, const StatedMesh& b, const FinePoint& inside) {
  Statement(file_, a, b).overlapping(inside);
}

void MeshClaims::add_around(std::uint32_t mesh, std::uint32_t body, const MeshHolders& holders) {
  file_.begin_statement("around");
  file_.index("a", mesh);
  file_.index("b", body);
  file_.text("verdict", "around");
  file_.begin_claims();
  file_.begin_claim("around");
  file_.begin_list("holders");
  for (const auto& holder : holders.holders) file_.add_list(holder);
  file_.end_list();
  file_.indices("held", holders.held);
  file_.end_claim();
  file_.end_statement();
}

void MeshClaims::add_distance(const StatedMesh& a, const StatedMesh& b, const MeshDistance& distance) {
  if (const NearTriangles* nearest = nearest_of(distance)) Statement(file_, a, b).closest(*nearest);
}

void MeshClaims::add_clearance(const StatedMesh& a, const StatedMesh& b, const MeshDistance& distance, double least) {
  SUNDER_REQUIRE(least > 0);
  const Statement statement(file_, a, b);
  if (const auto* within = std::get_if<PointWithin>(&distance.evidence)) return statement.broken(least, *within);
  if (const auto* meeting = std::get_if<MeetingTriangles>(&distance.evidence)) return statement.broken(least, *meeting);
  if (compare_distance(distance, least) == Sign::negative) return statement.broken(least, *nearest_of(distance));
  statement.kept(least);
}

void MeshClaims::add_motion(const StatedMotion& a, const StatedMotion& b, const MeshMotion& answer) {
  Statement(file_, a.begin, b.begin).motion(a, b, answer);
}

void MeshClaims::add_crossing(std::uint32_t index, const Mesh& mesh, const CrossingTriangles& pair) {
  const CommonPoint point = crossing_point(mesh, pair);
  file_.begin_statement("mesh_crossing");
  file_.index("a", index);
  file_.text("verdict", "two");
  file_.fractions("point", point.at);
  file_.begin_claims();
  file_.begin_claim("triangles_cross");
  file_.index("triangle", pair.first);
  add_weights(file_, "weights", point.of_a);
  file_.index("other_triangle", pair.second);
  add_weights(file_, "other_weights", point.of_b);
  file_.end_claim();
  file_.end_statement();
}

void MeshClaims::add_no_crossings(std::uint32_t index, const MeshSelfCover& cover) {
  file_.begin_statement("mesh_crossing");
  file_.index("a", index);
  file_.text("verdict", "none");
  file_.begin_claims();
  file_.begin_claim("no_crossings");
  add_walk(file_, cover.cuts, cover.directions);
  file_.end_claim();
  file_.end_statement();
}

StatedMesh add_table(ClaimsWriter& file, const NamedMesh& of) {
  MeshClaims meshes(file);
  const StatedMesh stated = add_named(meshes, of);
  meshes.end_table();
  return stated;
}

void add_claims(ClaimsWriter& file, const NamedMesh& a, const NamedMesh& b, const MeshAnswer& answer,
                const MeshRelation* relation, const MeshMeasures& measures) {
  MeshClaims meshes(file);
  const StatedMesh stated_a = add_named(meshes, a), stated_b = add_named(meshes, b);
  meshes.end_table();
  meshes.add_pair(stated_a, stated_b, answer.evidence, relation);
  if (measures.tells_distance) meshes.add_distance(stated_a, stated_b, *measures.distance);
  if (measures.least > 0) meshes.add_clearance(stated_a, stated_b, *measures.distance, measures.least);
}

void add_claims(ClaimsWriter& file, const NamedMotion& a, const NamedMotion& b, const MeshMotion& answer) {
  MeshClaims meshes(file);
  const auto add = [&](const NamedMotion& of) {
    const std::uint32_t mesh = meshes.add_mesh(of.name, of.mesh, of.said);
    const auto placed = [&](const Pose& pose) {
      return pose.affine() == Affine3() ? mesh : meshes.add_placed(of.name, mesh, pose);
    };
    const std::uint32_t first = placed(of.of.begin()), last = of.of.rests() ? first : placed(of.of.end());
    return StatedMotion{{first, of.mesh, of.of.begin()}, last, of.of};
  };
  const StatedMotion stated_a = add(a), stated_b = add(b);
  meshes.end_table();
  meshes.add_motion(stated_a, stated_b, answer);
}

void prove(const TextSink& sink, const AskedPair<Mesh, Pose>& asked, const MeshAnswer& answer) {
  ClaimsWriter file(sink);
  file.add_origin(asked.origin);
  MeshRelation relation;
  if (asked.tells_relation) relation = mesh_relation(asked.a, asked.at_a, asked.b, asked.at_b, answer);
  add_claims(file, {asked.name_a, asked.a, asked.at_a}, {asked.name_b, asked.b, asked.at_b}, answer, &relation);
  file.end();
}

}  // namespace sunder::solid
