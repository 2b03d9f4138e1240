#include <sunder/planar/set/circles_any.h>

namespace sunder::planar {

CirclesAnswer circles_any(const Circles& circles, const SetOptions& options) {
  return circles_any_by_grid(circles, options);
}

}  // namespace sunder::planar
