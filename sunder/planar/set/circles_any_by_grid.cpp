#include <sunder/near/set_methods.h>
#include <sunder/planar/set/circle_boxes.h>
#include <sunder/planar/set/circles_any.h>

namespace sunder::planar {

CirclesAnswer circles_any_by_grid(const Circles& circles, const SetOptions& options) {
  const std::vector<Box2> boxes = rounded_boxes(circles);
  return any_by_grid(circles, std::span(boxes), BoxGrid::over(boxes), options, circles_any_by_sweep);
}

}  // namespace sunder::planar
