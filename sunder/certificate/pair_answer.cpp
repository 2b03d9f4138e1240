#include <sunder/base/names.h>
#include <sunder/certificate/pair_answer.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace sunder {

namespace {

// The opposite direction, with the names of the bodies exchanged.
Direction opposite(const Direction& d) {
  using enum Direction::Kind;
  Direction result = d;
  result.given = {-d.given.x, -d.given.y, -d.given.z};
  switch (d.kind) {
    case given: break;
    case normal_of_a: result.kind = normal_of_b; break;
    case normal_of_b: result.kind = normal_of_a; break;
    case side_of_a: result.kind = side_of_b; break;
    case side_of_b: result.kind = side_of_a; break;
    case edge_cross_edge: result.index = {d.index[2], d.index[3], d.index[0], d.index[1]}; return result;
    case difference: result.index = {d.index[1], d.index[0]}; return result;
    case exact: {
      const auto& [x, y, z] = *d.numbers;
      result.numbers = std::make_shared<const std::array<Dyadic, 3>>(std::array<Dyadic, 3>{-x, -y, -z});
      return result;
    }
  }
  result.reversed = d.kind != given && !d.reversed;
  return result;
}

}  // namespace

PairAnswer exchanged(const PairAnswer& answer) {
  PairAnswer result = answer;
  if (auto* apart = std::get_if<Separation>(&result.evidence)) {
    apart->direction = opposite(apart->direction);
    std::swap(apart->extreme_a, apart->extreme_b);
  } else {
    auto& [count_a, count_b, vertices] = std::get<CommonVertices>(result.evidence);
    std::swap(count_a, count_b);
    std::rotate(vertices.begin(), vertices.begin() + count_b, vertices.begin() + count_a + count_b);
  }
  return result;
}

std::string_view name_of(Verdict verdict) {
  switch (verdict) {
    case Verdict::apart: return "apart";
    case Verdict::meet: return "meet";
    case Verdict::undecided: break;
  }
  return "undecided";
}

std::string_view name_of(DecidedBy decided_by) {
  return name_in<DecidedBy::scan>({"filter", "evidence", "finishing", "scan"}, decided_by);
}

std::string_view name_of(Relation relation) {
  return name_in<Relation::b_part_of_a>(
      {"none", "touching", "overlapping", "A inside B", "B inside A", "equal", "meeting", "A part of B", "B part of A"},
      relation);
}

}  // namespace sunder
