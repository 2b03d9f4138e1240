// The front doors, and the methods that all sets share.
#include <sunder/near/set_methods.h>
#include <sunder/planar/discs/disc_boxes.h>
#include <sunder/planar/discs/discs_all.h>

namespace sunder::planar {

Cost discs_visit(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit) {
  return discs_all_by_grid(circles, options, visit);
}

Cost discs_visit_block(const Discs& circles, const SetOptions& options, const Block& block, DiscsMethod* by,
                       const DiscsVisitor& visit) {
  return visit_of_block(circles, rounded_boxes, options, block, by, visit);
}

DiscsAllAnswer discs_all(const Discs& circles, const SetOptions& options) {
  return all_of<DiscsContact>([&](const DiscsVisitor& visit) { return discs_visit(circles, options, visit); });
}

CountAnswer<> discs_count(const Discs& circles, const SetOptions& options) {
  return count_of<DiscsContact>([&](const DiscsVisitor& visit) { return discs_visit(circles, options, visit); });
}

Cost discs_all_by_grid(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit) {
  const std::vector<Box2> boxes = rounded_boxes(circles);
  return visit_by_grid(circles, std::span(boxes), BoxGrid::over(boxes), options, visit, discs_all_by_sweep);
}

Cost discs_all_by_scan(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit) {
  return visit_by_scan(circles, options, visit);
}

}  // namespace sunder::planar
