#include <sunder/base/names.h>
#include <sunder/planar/region/discs_prepared.h>

#include <numeric>

namespace sunder::planar {

std::string_view name_of(DiscIntersectionKind kind) {
  return name_in<DiscIntersectionKind::plane>({"empty", "point", "region", "plane"}, kind);
}

DiscIntersection disc_intersection(const Discs& circles) { return disc_intersection_by_batches(circles); }

DiscIntersection disc_intersection_by_division(const Discs& circles) {
  return circles_part(circles, [](const std::vector<Disc>& discs, ArcChains& chains, Cost&) {
    std::vector<std::uint32_t> all(discs.size());
    std::iota(all.begin(), all.end(), 0u);
    return chains.divide(all);
  });
}

}  // namespace sunder::planar
