// The oracle: every pair.
#include <sunder/near/set_methods.h>
#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

Cost visit_circle_contacts_by_scan(const Circles& circles, const SetOptions& options,
                                   const CirclesContactVisitor& visit) {
  return visit_by_scan(circles, options, visit);
}

}  // namespace sunder::planar
