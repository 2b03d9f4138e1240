#include <sunder/base/contract.h>
#include <sunder/polytope/pair/polytope_claims.h>

#include <span>
#include <vector>

namespace sunder::polytope {

namespace {

void begin_entry(ClaimsWriter& file, const std::string& name) {
  file.begin_entry();
  file.text("name", name.empty() ? "unnamed" : cut_text(name));
}

void add_body(ClaimsWriter& file, const NamedPolytope& of, bool as_polytope) {
  file.say(of.said);
  begin_entry(file, of.name);
  const Polytope& p = of.polytope;
  if (as_polytope) file.number("dimension", p.dimension());
  file.begin_list(p.is_of_points() ? "points" : "half_spaces");
  for (std::uint32_t k = 0; k < p.size(); ++k) file.add_row(p.row(k));
  file.end_list();
  file.end_entry();
}

void add_image(ClaimsWriter& file, const std::string& name, std::uint32_t of, const Pose& pose) {
  begin_entry(file, name);
  file.index("of", of);
  file.doubles("linear", pose.linear());
  file.doubles("translation", pose.translation());
  file.end_entry();
}

// The polytope, and where its pose is another one than the identity, its image. Returns the number of the last of them;
// `first` is that of the first.
std::uint32_t add_placed(ClaimsWriter& file, const NamedPolytope& of, bool as_polytope, std::uint32_t first) {
  add_body(file, of, as_polytope);
  if (of.pose.is_identity()) return first;
  add_image(file, of.name, first, of.pose);
  return first + 1;
}

void add_weights(ClaimsWriter& file, const char* key, const Weights& weights) {
  file.begin_list(key);
  for (const auto& [row, numerator] : weights.parts) file.add_weight(row, numerator, weights.denominator);
  file.end_list();
}

// Of points the weights, of half-spaces the place in the body's frame.
void add_keeps(ClaimsWriter& file, const Weights& weights, const ExactPointN& place) {
  file.begin_claim("keeps");
  add_weights(file, "weights", weights);
  file.fractions("at", place.numbers, place.denominator);
  file.end_claim();
}

void add_planes(ClaimsWriter& file, const char* key, const std::vector<std::vector<Dyadic>>& planes) {
  std::vector<Dyadic> numbers;
  for (const std::vector<Dyadic>& plane : planes) numbers.insert(numbers.end(), plane.begin(), plane.end());
  file.numbers(key, numbers);
}

void add_holds(ClaimsWriter& file, const Weights& weights) {
  file.begin_claim("holds");
  add_weights(file, "weights", weights);
  file.end_claim();
}

// Writes the statement about two entries of the table, which have these numbers, and its claims.
void add_statement(ClaimsWriter& file, const NamedPolytope& a, std::uint32_t index_a, const NamedPolytope& b,
                   std::uint32_t index_b, const PolytopeAnswer& answer, bool as_polytopes) {
  const ExactEvidence evidence = exact_evidence(a.polytope, a.pose, b.polytope, b.pose, answer);
  file.begin_statement(as_polytopes ? "polytopes" : "pair");
  file.index("a", index_a);
  file.index("b", index_b);
  file.text("verdict", answer.meet() ? "meet" : "apart");
  if (answer.meet()) {
    file.fractions("point", evidence.numbers, evidence.denominator);
    file.begin_claims();
    if (as_polytopes) {
      add_keeps(file, evidence.of_a, evidence.in_a);
      add_keeps(file, evidence.of_b, evidence.in_b);
    } else {
      add_holds(file, evidence.of_a);
      add_holds(file, evidence.of_b);
    }
  } else {
    file.begin_claims();
    file.begin_claim(as_polytopes ? "parted_by" : "parted");
    file.numbers("direction", evidence.numbers);
    if (as_polytopes) {
      add_weights(file, "of_a", evidence.of_a);
      add_weights(file, "of_b", evidence.of_b);
    }
    file.end_claim();
  }
  file.end_statement();
}

bool are_half_spaces(const NamedPolytope& a, const NamedPolytope& b) {
  return !a.polytope.is_of_points() || !b.polytope.is_of_points();
}

}  // namespace

void add_claims(ClaimsWriter& file, const NamedPolytope& a, const NamedPolytope& b, const PolytopeAnswer& answer) {
  const bool as_polytopes = are_half_spaces(a, b);
  file.begin_table(as_polytopes ? "polytopes" : "bodies");
  const std::uint32_t index_a = add_placed(file, a, as_polytopes, 0);
  const std::uint32_t index_b = add_placed(file, b, as_polytopes, index_a + 1);
  file.end_table();
  add_statement(file, a, index_a, b, index_b, answer, as_polytopes);
}

void add_claims(ClaimsWriter& file, const NamedPolytope& a, const NamedPolytope& b, std::span<const Pose> poses,
                std::span<const PolytopeAnswer> answers) {
  SUNDER_REQUIRE(poses.size() == answers.size());
  const bool as_polytopes = are_half_spaces(a, b);
  file.begin_table(as_polytopes ? "polytopes" : "bodies");
  const std::uint32_t index_a = add_placed(file, a, as_polytopes, 0), first_b = index_a + 1;
  add_body(file, b, as_polytopes);
  for (std::size_t k = 0; k < poses.size(); ++k) {
    add_image(file, (b.name.empty() ? "unnamed" : b.name) + " at pose " + std::to_string(k), first_b, poses[k]);
  }
  file.end_table();
  for (std::size_t k = 0; k < poses.size(); ++k) {
    add_statement(file, a, index_a, {b.name, b.polytope, poses[k]}, first_b + 1 + static_cast<std::uint32_t>(k),
                  answers[k], as_polytopes);
  }
}

void add_claims(ClaimsWriter& file, const NamedPolytope& a, const NamedPolytope& b,
                const HyperplaneEvidence& evidence) {
  file.begin_table("polytopes");
  const std::uint32_t index_a = add_placed(file, a, true, 0);
  const std::uint32_t index_b = add_placed(file, b, true, index_a + 1);
  file.end_table();
  file.begin_statement("polytopes");
  file.index("a", index_a);
  file.index("b", index_b);
  file.text("verdict", "apart_by_hyperplanes");
  file.begin_claims();
  file.begin_claim("parted_by_hyperplanes");
  file.numbers("direction", evidence.direction);
  add_planes(file, "planes_a", evidence.a.planes);
  add_weights(file, "by_a", evidence.a.multipliers);
  add_planes(file, "planes_b", evidence.b.planes);
  add_weights(file, "by_b", evidence.b.multipliers);
  file.end_claim();
  file.end_statement();
}

}  // namespace sunder::polytope

namespace sunder {

void prove(const TextSink& sink, const AskedPair<polytope::Polytope, polytope::Pose>& asked,
           const polytope::PolytopeAnswer& answer) {
  ClaimsWriter file(sink);
  file.add_origin(asked.origin);
  add_claims(file, {asked.name_a, asked.a, asked.at_a}, {asked.name_b, asked.b, asked.at_b}, answer);
  file.end();
}

}  // namespace sunder
