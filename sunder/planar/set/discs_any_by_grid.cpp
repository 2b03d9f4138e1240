#include <sunder/near/set_methods.h>
#include <sunder/planar/set/disc_boxes.h>
#include <sunder/planar/set/discs_any.h>

namespace sunder::planar {

DiscsAnswer discs_any_by_grid(const Discs& circles, const SetOptions& options) {
  const std::vector<Box2> boxes = rounded_boxes(circles);
  return any_by_grid(circles, std::span(boxes), BoxGrid::over(boxes), options, discs_any_by_sweep);
}

}  // namespace sunder::planar
