#include <sunder/planar/region/circles_prepared.h>

#include <numeric>

namespace sunder::planar {

CirclesPart circles_common_part_by_division(const Circles& circles) {
  return circles_part(circles, [](const std::vector<Circle>& discs, ArcChains& chains, Cost&) {
    std::vector<std::uint32_t> all(discs.size());
    std::iota(all.begin(), all.end(), 0u);
    return chains.divide(all);
  });
}

}  // namespace sunder::planar
