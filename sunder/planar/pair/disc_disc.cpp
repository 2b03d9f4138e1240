#include <sunder/base/names.h>
#include <sunder/planar/pair/disc_disc.h>
#include <sunder/predicate/disc/discs.h>

namespace sunder::planar {

std::string_view name_of(DiscContact kind) {
  return name_in<DiscContact::inside>({"none", "touching", "overlapping", "inside"}, kind);
}

DiscContact disc_disc(const Disc& c, const Disc& d, StageTally* tally) {
  switch (distance_against_sum(c.center, c.radius, d.center, d.radius, tally)) {
    case Sign::positive: return DiscContact::none;
    case Sign::zero: return DiscContact::touching;
    case Sign::negative: break;
  }
  const Sign nested = distance_against_difference(c.center, c.radius, d.center, d.radius, tally);
  return nested == Sign::positive ? DiscContact::overlapping : DiscContact::inside;
}

// c + (d - c) r / (r + s).
ExactPoint2 common_point(const Disc& c, const Disc& d) {
  if (c.center == d.center || disc_disc(c, d) == DiscContact::inside) {
    return exactly(d.radius < c.radius ? d.center : c.center);
  }
  const Dyadic r(c.radius), s(d.radius);  // not both zero, as the centres differ
  const auto part = [&](double from, double to) { return Dyadic(from) * s + Dyadic(to) * r; };
  return {part(c.center.x, d.center.x), part(c.center.y, d.center.y), r + s};
}

Point2 common_point_rounded(const Disc& c, const Disc& d) { return nearest(common_point(c, d)); }

}  // namespace sunder::planar
