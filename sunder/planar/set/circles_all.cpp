#include <sunder/near/set_methods.h>
#include <sunder/planar/set/circle_boxes.h>
#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

Cost visit_circle_contacts(const Circles& circles, const SetOptions& options, const CirclesContactVisitor& visit) {
  return visit_circle_contacts_by_grid(circles, options, visit);
}

Cost visit_circle_contacts_of_block(const Circles& circles, const SetOptions& options, const Block& block,
                                    CirclesContactMethod* by, const CirclesContactVisitor& visit) {
  return visit_of_block(circles, rounded_boxes, options, block, by, visit);
}

CirclesAllAnswer circles_all(const Circles& circles, const SetOptions& options) {
  return all_of<CirclesContact>(
      [&](const CirclesContactVisitor& visit) { return visit_circle_contacts(circles, options, visit); });
}

CountAnswer circles_count(const Circles& circles, const SetOptions& options) {
  return count_of<CirclesContact>(
      [&](const CirclesContactVisitor& visit) { return visit_circle_contacts(circles, options, visit); });
}

}  // namespace sunder::planar
