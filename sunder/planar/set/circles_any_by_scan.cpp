#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

CirclesAnswer circles_any_by_scan(const Circles& circles, const SetOptions& options) {
  return first_of<CirclesContact>(
      [&](const CirclesContactVisitor& visit) { return visit_circle_contacts_by_scan(circles, options, visit); });
}

}  // namespace sunder::planar
