// The common part of both halves, and of these (SH76, Theorem 9). Sides of both are merged by angle; on them the chains
// and joints of region_search.h work in linear time, which is the paper's step, the common part of two convex polygons.
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/region_search.h>

namespace sunder::planar {

namespace {

constexpr std::size_t few_sides = 8;

template <class Given>
class Division {
 public:
  explicit Division(Signs<Given>& signs) : signs_(signs) {}

  // Of the numbers from first to last.
  Chains chains(std::uint32_t first, std::uint32_t last) {
    std::vector<std::uint32_t> sorted;
    const auto is_before = [&](std::uint32_t i, std::uint32_t j) { return signs_.is_before(i, j); };
    if (last - first <= few_sides) {
      for (std::uint32_t i = first; i < last; ++i) sorted.push_back(i);
      std::sort(sorted.begin(), sorted.end(), is_before);
    } else {
      const std::uint32_t middle = first + (last - first) / 2;
      Chains left = chains(first, middle);
      if (!left.contradiction.empty()) return left;
      Chains right = chains(middle, last);
      if (!right.contradiction.empty()) return right;
      const std::vector<std::uint32_t> a = in_one(left), b = in_one(right);
      sorted.resize(a.size() + b.size());
      std::merge(a.begin(), a.end(), b.begin(), b.end(), sorted.begin(), is_before);
    }
    const auto same = [&](std::uint32_t i, std::uint32_t j) { return signs_.same_direction(i, j); };
    sorted.erase(std::unique(sorted.begin(), sorted.end(), same), sorted.end());
    return common_part_of_sorted(signs_, std::span<const std::uint32_t>(sorted));
  }

 private:
  static std::vector<std::uint32_t> in_one(const Chains& chains) {
    std::vector<std::uint32_t> all = chains.up;
    all.insert(all.end(), chains.down.begin(), chains.down.end());
    return all;
  }

  Signs<Given>& signs_;
};

}  // namespace

template <class Given>
Region half_plane_intersection_by_division(const Given& given, const RegionOptions& options) {
  Signs<Given> signs(given);
  const Chains chains = Division(signs).chains(0, given.size());
  return region_of(signs, chains, options);
}

template Region half_plane_intersection_by_division(const Constraints&, const RegionOptions&);
template Region half_plane_intersection_by_division(const HalfPlanes&, const RegionOptions&);
template Region half_plane_intersection_by_division(const PolygonSides&, const RegionOptions&);

}  // namespace sunder::planar
