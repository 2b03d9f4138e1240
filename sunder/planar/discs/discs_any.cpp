// The front door, and the methods that all sets share.
#include <sunder/near/set_methods.h>
#include <sunder/planar/discs/disc_boxes.h>
#include <sunder/planar/discs/discs_all.h>

namespace sunder::planar {

DiscsAnswer discs_any(const Discs& circles, const SetOptions& options) { return discs_any_by_grid(circles, options); }

DiscsAnswer discs_any_by_grid(const Discs& circles, const SetOptions& options) {
  const std::vector<Box2> boxes = rounded_boxes(circles);
  return any_by_grid(circles, std::span(boxes), BoxGrid::over(boxes), options, discs_any_by_sweep);
}

DiscsAnswer discs_any_by_scan(const Discs& circles, const SetOptions& options) {
  return first_of<DiscsContact>([&](const DiscsVisitor& visit) { return discs_all_by_scan(circles, options, visit); });
}

}  // namespace sunder::planar
