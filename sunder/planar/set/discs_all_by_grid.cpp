#include <sunder/near/set_methods.h>
#include <sunder/planar/set/disc_boxes.h>
#include <sunder/planar/set/discs_all.h>

namespace sunder::planar {

Cost discs_all_by_grid(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit) {
  const std::vector<Box2> boxes = rounded_boxes(circles);
  return visit_by_grid(circles, std::span(boxes), BoxGrid::over(boxes), options, visit, discs_all_by_sweep);
}

}  // namespace sunder::planar
