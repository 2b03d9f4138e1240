#include <sunder/planar/region/circles.h>

namespace sunder::planar {

CirclesPart circles_common_part(const Circles& circles) { return circles_common_part_by_batches(circles); }

}  // namespace sunder::planar
