#include <sunder/planar/region/disc_intersection.h>

namespace sunder::planar {

DiscIntersection disc_intersection(const Discs& circles) { return disc_intersection_by_batches(circles); }

}  // namespace sunder::planar
