// The oracle: every pair.
#include <sunder/near/set_methods.h>
#include <sunder/planar/set/discs_all.h>

namespace sunder::planar {

Cost discs_all_by_scan(const Discs& circles, const SetOptions& options, const DiscsVisitor& visit) {
  return visit_by_scan(circles, options, visit);
}

}  // namespace sunder::planar
