#include <sunder/predicate/point/plane_side.h>
#include <sunder/solid/line/plane_line.h>

namespace sunder::solid {

FlatCommon plane_linear(const Plane& plane, const Linear& linear) {
  StageTally tally;
  FlatCommon common;
  static const Affine3 identity;
  const auto side = [&](const Point3& p) {
    ++common.cost.probes;
    return side_of_plane(plane.normal, plane.point, plane.offset, posed(p, identity), &tally);
  };
  const FlatKind whole = linear.is_point() ? FlatKind::point
                         : linear.ends     ? FlatKind::segment
                         : linear.begins   ? FlatKind::ray
                                           : FlatKind::line;
  const Sign a = side(linear.a), b = linear.is_point() ? a : side(linear.b);
  const auto found = [&](FlatKind kind, Relation contact) {
    common.evidence = {kind, contact};
    conclude(common, tally.exact);
    return common;
  };
  if (a == Sign::zero && b == Sign::zero) return found(whole, Relation::overlapping);
  if ((a == Sign::zero && linear.begins) || (b == Sign::zero && linear.ends)) {
    return found(FlatKind::point, Relation::touching);
  }
  const bool opposite = a * b != Sign::positive;  // the plane is between the two points, or in one that is no end
  if (opposite) return found(FlatKind::point, Relation::overlapping);
  if (linear.ends) return found(FlatKind::nothing, Relation::none);
  // How the line rises: normal . (b - a), as the height of b over the plane through a.
  ++common.cost.probes;
  const Sign rise = side_of_plane(plane.normal, linear.a, 0, posed(linear.b, identity), &tally);
  const bool hits = linear.begins ? rise * a == Sign::negative : rise != Sign::zero;
  return found(hits ? FlatKind::point : FlatKind::nothing, hits ? Relation::overlapping : Relation::none);
}

FlatCommon plane_line(const Plane& plane, const Line& line) { return plane_linear(plane, line); }
FlatCommon plane_ray(const Plane& plane, const Ray& ray) { return plane_linear(plane, ray); }
FlatCommon plane_segment(const Plane& plane, const Segment& segment) { return plane_linear(plane, segment); }
FlatCommon plane_point(const Plane& plane, const Point3& point) { return plane_linear(plane, point); }

}  // namespace sunder::solid
