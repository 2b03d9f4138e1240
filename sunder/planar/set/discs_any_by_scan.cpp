#include <sunder/planar/set/discs_all.h>

namespace sunder::planar {

DiscsAnswer discs_any_by_scan(const Discs& circles, const SetOptions& options) {
  return first_of<DiscsContact>([&](const DiscsVisitor& visit) { return discs_all_by_scan(circles, options, visit); });
}

}  // namespace sunder::planar
