// The oracle: every pair.
#include <sunder/planar/set/circles_any.h>

namespace sunder::planar {

CirclesAnswer circles_any_by_scan(const Circles& circles, const CirclesOptions& options) {
  CirclesAnswer answer;
  for (std::uint32_t i = 0; i < circles.size(); ++i) {
    for (std::uint32_t j = i + 1; j < circles.size(); ++j) {
      ++answer.cost.probes;
      const DiscContact kind = circle_circle(circles[i], circles[j]);
      if (!counts(kind, options.allowed) || may_meet(options.groups, i, j)) continue;
      answer.found = contact_of(i, j, kind);
      return answer;
    }
  }
  return answer;
}

}  // namespace sunder::planar
