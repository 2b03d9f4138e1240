// The oracle: every pair.
#include <sunder/planar/set/circles_all.h>

namespace sunder::planar {

Cost visit_circle_contacts_by_scan(const Circles& circles, const CirclesOptions& options,
                                   const CirclesContactVisitor& visit) {
  Cost cost;
  for (std::uint32_t i = 0; i < circles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < circles.size(); ++j) {
      ++cost.probes;
      const DiscContact kind = circle_circle(circles[i], circles[j]);
      if (!counts(kind, options.allowed) || may_meet(options.groups, i, j)) continue;
      if (!visit({i, j, kind})) return cost;
    }
  }
  return cost;
}

}  // namespace sunder::planar
