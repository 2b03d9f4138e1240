// Sorted by angle, two chains, two joints (region_search.h).
#include <sunder/planar/object/polygon_sides.h>
#include <sunder/planar/region/angle_order.h>
#include <sunder/planar/region/region_search.h>

namespace sunder::planar {

template <class Given>
Region half_plane_intersection_by_sort(const Given& given, const RegionOptions& options) {
  Signs<Given> signs(given);
  const std::vector<std::uint32_t> sorted = tightest_by_angle(signs);
  return region_of(signs, common_part_of_sorted(signs, std::span(sorted)), options);
}

template Region half_plane_intersection_by_sort(const Constraints&, const RegionOptions&);
template Region half_plane_intersection_by_sort(const HalfPlanes&, const RegionOptions&);
template Region half_plane_intersection_by_sort(const PolygonSides&, const RegionOptions&);

}  // namespace sunder::planar
