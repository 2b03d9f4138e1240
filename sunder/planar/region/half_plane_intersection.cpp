// A search proposes: the region of a small random sample. Those that it implies, by a corner that they hold, are
// dropped; of the rest, the same. Where a sample implies few, sorting decides: by angle, two chains, two joints
// (region_search.h), which is also a method by itself.
#include <sunder/base/interruption.h>
#include <sunder/base/random.h>
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/angle_order.h>
#include <sunder/planar/region/region_search.h>

#include <cstddef>

namespace sunder::planar {

namespace {

constexpr std::uint64_t seed = 20261201;
constexpr std::size_t few = 2048, sample_size = 256;

template <class Given>
class Sampling {
 public:
  using Numbers = std::vector<std::uint32_t>;
  explicit Sampling(Signs<Given>& signs) : signs_(signs) {}

  // Those of all; the numbers to which they can be reduced.
  Chains chains() {
    if (signs_.given().size() < few) return sorted(tightest_by_angle(signs_));
    Numbers left;
    const auto all = [](std::uint32_t k) { return k; };
    Chains contradiction;
    if (!reduce(signs_.given().size(), all, left, contradiction)) return sorted(tightest_by_angle(signs_));
    while (contradiction.contradiction.empty() && left.size() >= few) {
      const Numbers before = std::move(left);
      left = {};
      const auto member = [&](std::uint32_t k) { return before[k]; };
      const auto size = static_cast<std::uint32_t>(before.size());
      if (!reduce(size, member, left, contradiction)) return of(before);
    }
    return contradiction.contradiction.empty() ? of(left) : contradiction;
  }

 private:
  Chains of(const Numbers& numbers) { return sorted(tightest_by_angle(signs_, std::span(numbers))); }
  Chains sorted(const Numbers& by_angle) { return common_part_of_sorted(signs_, std::span(by_angle)); }

  // Of the numbers number(0), number(1), ..: leaves those that the region of a sample does not imply, and its sides.
  // False where it implies too few to pay. Where the sample's region is empty, `chains` is that of all.
  template <class Number>
  bool reduce(std::uint32_t size, const Number& number, Numbers& left, Chains& chains) {
    const auto any = [&] { return number(static_cast<std::uint32_t>(random_.below(size))); };
    Numbers sample(sample_size);
    for (std::uint32_t& k : sample) k = any();
    chains = of(sample);
    if (!chains.contradiction.empty()) return true;
    const bool one_chain = chains.up.empty() || chains.down.empty();
    if (chains.up.size() + chains.down.size() < 2 || !(chains.right || chains.left || one_chain)) return false;
    Region region;
    region.kind = chains.right && chains.left ? RegionKind::bounded : RegionKind::unbounded;
    region.sides = sides_in_turn(chains);
    const SideTable table(signs_.given(), region.sides);
    std::size_t not_implied = 0;
    for (std::size_t n = 0; n < sample_size; ++n) {
      if (!is_implied(region, table, any())) ++not_implied;
    }
    if (4 * not_implied > sample_size) return false;
    for (std::uint32_t k = 0; k < size; ++k) {
      if (k % 1024 == 0) may_be_interrupted(1024);
      if (!is_implied(region, table, number(k))) left.push_back(number(k));
    }
    if (2 * left.size() > size) return false;
    left.insert(left.end(), region.sides.begin(), region.sides.end());
    return true;
  }

  // Does the region, its sides as they are numbered, stay what it is with k? (For k one of the sides: no.)
  bool is_implied(const Region& region, const SideTable& table, std::uint32_t k) {
    const std::optional<std::uint32_t> cone = cone_in(signs_, region, table, k);
    if (!cone) return false;
    const std::uint32_t i = region.sides[*cone], j = region.sides[*cone + 1 == region.sides.size() ? 0 : *cone + 1];
    const Sign side = signs_.corner_side(i, j, k);
    if (side != Sign::zero) return side == Sign::negative;
    if (signs_.turn(i, k) == Sign::zero) return i < k;
    return signs_.turn(k, j) != Sign::zero || j < k;
  }

  Signs<Given>& signs_;
  Random random_{seed};
};

}  // namespace

template <class Given>
Region half_plane_intersection(const Given& given, const RegionOptions& options) {
  Signs<Given> signs(given);
  return region_of(signs, Sampling(signs).chains(), options);
}

template <class Given>
Region half_plane_intersection_by_sort(const Given& given, const RegionOptions& options) {
  Signs<Given> signs(given);
  const std::vector<std::uint32_t> sorted = tightest_by_angle(signs);
  return region_of(signs, common_part_of_sorted(signs, std::span(sorted)), options);
}

template Region half_plane_intersection(const Constraints&, const RegionOptions&);
template Region half_plane_intersection(const HalfPlanes&, const RegionOptions&);
template Region half_plane_intersection(const PolygonSides&, const RegionOptions&);
template Region half_plane_intersection_by_sort(const Constraints&, const RegionOptions&);
template Region half_plane_intersection_by_sort(const HalfPlanes&, const RegionOptions&);
template Region half_plane_intersection_by_sort(const PolygonSides&, const RegionOptions&);

}  // namespace sunder::planar
