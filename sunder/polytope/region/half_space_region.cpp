#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/region/half_space_region.h>
#include <sunder/polytope/region/program_outcome_internal.h>
#include <sunder/polytope/region/program_search_internal.h>
#include <sunder/polytope/region/rows_check_internal.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <variant>
#include <vector>

namespace sunder::polytope {

namespace {

using Place = ExactPointN;

// x, .., w: in the span of others iff it is in their affine hull.
ExactVector homogeneous(const Place& place) {
  ExactVector result = place.numbers;
  result.push_back(place.denominator);
  return result;
}

// Of two groups whose sums are u and -u: numbers whose sum is zero.
void add_opposite(Weights& to, const Weights& first, const Weights& second) {
  for (const auto& [group, other] : {std::pair(&first, &second), {&second, &first}}) {
    for (const auto& [row, numerator] : group->parts) {
      to.add(row, numerator * other->denominator);
    }
  }
}

class RegionSearch {
 public:
  explicit RegionSearch(const Polytope& body) : body_(body), d_(body.dimension()), points_(d_ + 1), across_(d_) {}

  HalfSpaceRegion find() {
    for (std::size_t c = 0; c < d_; ++c) {
      if (std::optional<EmptyRegion> empty = add_coordinate(c)) return answer(std::move(*empty));
    }
    while (points_.rank() + across_.rank() < d_ + 1) widen();
    extent_.dimension = points_.rank() - 1;
    if (direction_) return answer(UnboundedRegion{std::move(extent_), std::move(*direction_)});
    return answer(BoundedRegion{std::move(extent_), std::move(enclosing_)});
  }

 private:
  HalfSpaceRegion answer(HalfSpaceRegion::Evidence evidence) const { return {std::move(evidence), decided_by_, cost_}; }

  ProgramEvidence best_along(const ExactVector& objective) {
    std::array<double, most_dimension> rounded{};
    std::int64_t top = 0;
    for (const Dyadic& x : objective) {
      if (x.sign() != Sign::zero) top = std::max(top, x.top());
    }
    for (std::size_t c = 0; c < d_; ++c) rounded[c] = objective[c].scaled(-top).nearest();
    LinearProgramAnswer answer =
        decide_from(body_, objective, basis_by_scans(body_, std::span<const double>(rounded).first(d_)));
    cost_.probes += answer.cost.probes;
    cost_.iterations += answer.cost.iterations;
    cost_.exact += answer.cost.exact;
    cost_.proposals += answer.cost.proposals;
    if (answer.decided_by == DecidedBy::finishing) decided_by_ = DecidedBy::finishing;
    return std::move(answer.evidence);
  }

  void add_point(const Place& point) {
    if (points_.add(homogeneous(point))) extent_.points.push_back(point);
  }

  // Requires a feasible program.
  void add_points(const ProgramEvidence& best) {
    const Place& point = *named_point(best);
    add_point(point);
    if (const auto* many = std::get_if<ManyOptima>(&best)) add_point(many->other);
    const auto* far = std::get_if<NoBound>(&best);
    if (far == nullptr) return;
    Place further = point;
    for (std::size_t c = 0; c < d_; ++c) further.numbers[c] = further.numbers[c] + far->direction[c];
    add_point(further);
    if (!direction_) direction_ = far->direction;
  }

  // Some rows hold the direction u where the points are.
  void add_flat(const Weights& first, const Weights& second) {
    add_opposite(extent_.flat, first, second);
    for (const Weights* const group : {&first, &second}) {
      for (const Weights::Part& part : group->parts) {
        const std::span<const double> normal = body_.row(part.index).first(d_);
        across_.add(ExactVector(normal.begin(), normal.end()));
      }
    }
  }

  // Gives what contradicts, where there is no common point.
  std::optional<EmptyRegion> add_coordinate(std::size_t c) {
    ExactVector up(d_), down(d_);
    up[c] = 1.0;
    down[c] = -1.0;
    const ProgramEvidence greatest = best_along(up);
    if (const auto* none = std::get_if<NoPoint>(&greatest)) return EmptyRegion{none->multipliers};
    const ProgramEvidence least = best_along(down);
    add_points(greatest);
    add_points(least);
    RegionExtent::Range& range = extent_.ranges[c];
    const Place &highest = *named_point(greatest), &lowest = *named_point(least);
    const Weights *const from_above = named_multipliers(greatest), *const from_below = named_multipliers(least);
    if (from_above != nullptr) range.greatest = nearest_ratio(highest.numbers[c], highest.denominator);
    if (from_below != nullptr) range.least = nearest_ratio(lowest.numbers[c], lowest.denominator);
    if (from_above != nullptr && from_below != nullptr) {
      if (!direction_) add_opposite(enclosing_, *from_above, *from_below);
      if (highest.numbers[c] * lowest.denominator == lowest.numbers[c] * highest.denominator) {
        add_flat(*from_above, *from_below);
      }
    }
    return std::nullopt;
  }

  // Across the points that there are, and rows that are known to be flat: further points, or a row.
  void widen() {
    Elimination known(d_);
    const Place& first = extent_.points.front();
    for (const Place& point : extent_.points) {
      ExactVector difference(d_);
      for (std::size_t c = 0; c < d_; ++c) {
        difference[c] = point.numbers[c] * first.denominator - first.numbers[c] * point.denominator;
      }
      known.add(difference);
    }
    for (const Weights::Part& part : extent_.flat.parts) {
      const std::span<const double> normal = body_.row(part.index).first(d_);
      known.add(ExactVector(normal.begin(), normal.end()));
    }
    const std::vector<Integer> across = *known.across();
    ExactVector along, back;
    for (const Integer& x : across) along.push_back(dyadic_of(x, 0));
    for (const Dyadic& x : along) back.push_back(-x);
    const std::size_t rank = points_.rank();
    const ProgramEvidence greatest = best_along(along);
    add_points(greatest);
    if (points_.rank() > rank) return;
    const ProgramEvidence least = best_along(back);
    add_points(least);
    if (points_.rank() == rank) add_flat(*named_multipliers(greatest), *named_multipliers(least));
  }

  const Polytope& body_;
  std::size_t d_;
  RegionExtent extent_;
  Weights enclosing_;                             // of coordinates so far, unless there is a direction
  std::optional<std::vector<Dyadic>> direction_;  // in which the region is not bounded
  DecidedBy decided_by_ = DecidedBy::evidence;
  Cost cost_;
  Elimination points_, across_;
};

}  // namespace

std::string_view name_of(RegionKind kind) {
  switch (kind) {
    case RegionKind::empty: return "empty";
    case RegionKind::bounded: return "bounded";
    case RegionKind::unbounded: return "unbounded";
  }
  return "";
}

const RegionExtent* extent_of(const HalfSpaceRegion& region) {
  return std::visit(
      [](const auto& held) -> const RegionExtent* {
        if constexpr (requires { held.dimension; }) return &held;
        return nullptr;
      },
      region.evidence);
}

HalfSpaceRegion half_space_region(const Polytope& half_spaces) {
  SUNDER_REQUIRE(!half_spaces.is_of_points());
  return RegionSearch(half_spaces).find();
}

bool check(const Polytope& half_spaces, const HalfSpaceRegion& region) {
  const std::size_t d = half_spaces.dimension();
  const RegionExtent* const extent = extent_of(region);
  if (extent == nullptr) return contradicts(half_spaces, std::get<EmptyRegion>(region.evidence).contradiction);
  Elimination points(d + 1);
  for (const Place& point : extent->points) {
    if (!keeps(half_spaces, point) || !points.add(homogeneous(point))) return false;
  }
  const auto is_zero = [](const Dyadic& x) { return x.sign() == Sign::zero; };
  const auto flat = sum_of(half_spaces, extent->flat);
  if (!flat || !std::all_of(flat->row.begin(), flat->row.end(), is_zero)) return false;
  if (points.rank() != extent->dimension + 1 || flat->rank + extent->dimension != d) return false;
  if (const auto* far = std::get_if<UnboundedRegion>(&region.evidence)) return recedes(half_spaces, far->direction);
  const auto around = sum_of(half_spaces, std::get<BoundedRegion>(region.evidence).enclosing);
  return around && around->rank == d && std::all_of(around->row.begin(), around->row.end() - 1, is_zero);
}

}  // namespace sunder::polytope
