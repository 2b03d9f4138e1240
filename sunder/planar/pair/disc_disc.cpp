#include <sunder/planar/pair/disc_disc.h>
#include <sunder/predicate/discs.h>

namespace sunder::planar {

std::string_view name_of(DiscContact kind) {
  switch (kind) {
    case DiscContact::none: return "none";
    case DiscContact::touching: return "touching";
    case DiscContact::overlapping: return "overlapping";
    case DiscContact::inside: return "inside";
  }
  return "";
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
  const auto whole = [](const Point2& p) { return ExactPoint2{Dyadic(p.x), Dyadic(p.y), Dyadic(1)}; };
  if (c.center == d.center || disc_disc(c, d) == DiscContact::inside) {
    return whole(d.radius < c.radius ? d.center : c.center);
  }
  const Dyadic r(c.radius), s(d.radius);  // not both zero, as the centres differ
  const auto part = [&](double from, double to) { return Dyadic(from) * s + Dyadic(to) * r; };
  return {part(c.center.x, d.center.x), part(c.center.y, d.center.y), r + s};
}

Point2 common_point_rounded(const Disc& c, const Disc& d) {
  const ExactPoint2 p = common_point(c, d);
  return {nearest_ratio(p.x, p.denominator), nearest_ratio(p.y, p.denominator)};
}

}  // namespace sunder::planar
