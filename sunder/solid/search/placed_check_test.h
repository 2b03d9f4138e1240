// Does the checker accept what is said of two placed bodies?
#pragma once

#include <sunder/certificate/check.h>
#include <sunder/solid/search/placed.h>

namespace sunder::solid {

inline CheckResult check_placed(const PairCertificate& c, const Placed& a, const Placed& b) {
  return check_absolutely(c, {a.graph.vertices, a.pose, false}, {b.graph.vertices, b.pose, false});
}

}  // namespace sunder::solid
