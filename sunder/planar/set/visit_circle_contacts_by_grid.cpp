#include <sunder/near/set_methods.h>
#include <sunder/planar/set/circle_boxes.h>
#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

Cost visit_circle_contacts_by_grid(const Circles& circles, const SetOptions& options,
                                   const CirclesContactVisitor& visit) {
  const std::vector<Box2> boxes = rounded_boxes(circles);
  return visit_by_grid(circles, std::span(boxes), BoxGrid::over(boxes), options, visit, visit_circle_contacts_by_sweep);
}

}  // namespace sunder::planar
