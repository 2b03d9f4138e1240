#include <sunder/planar/region/discs_prepared.h>

#include <numeric>

namespace sunder::planar {

DiscIntersection disc_intersection_by_division(const Discs& circles) {
  return circles_part(circles, [](const std::vector<Disc>& discs, ArcChains& chains, Cost&) {
    std::vector<std::uint32_t> all(discs.size());
    std::iota(all.begin(), all.end(), 0u);
    return chains.divide(all);
  });
}

}  // namespace sunder::planar
