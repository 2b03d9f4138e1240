#include <sunder/planar/object/discs.h>

#include <cmath>
#include <utility>

namespace sunder::planar {

namespace {

const char* what_is_wrong(const Disc& c) {
  if (!std::isfinite(c.center.x) || !std::isfinite(c.center.y))
    return "a coordinate is not finite; every number must be: repair the data";
  if (!std::isfinite(c.radius)) return "its radius is not finite; every number must be: repair the data";
  return c.radius < 0 ? "its radius is negative; give zero (a point) or more" : nullptr;
}

}  // namespace

Discs::Discs(std::vector<Disc> given) : MemberList(std::move(given), "circle", what_is_wrong) {}

}  // namespace sunder::planar
