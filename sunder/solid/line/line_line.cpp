#include <sunder/base/names.h>
#include <sunder/predicate/line/arrows.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/line/line_line.h>

#include <algorithm>
#include <optional>
#include <utility>

namespace sunder::solid {

namespace {

// Without the coordinate `axis`.
Point2 along(int axis, const Point3& p) {
  if (axis == 0) return {p.y, p.z};
  if (axis == 1) return {p.z, p.x};
  return {p.x, p.y};
}

// Two of them, and the signs that were asked for.
class Two {
 public:
  Two(const Linear& p, const Linear& q) : p_(p), q_(q) {}

  FlatCommon answer() {
    FlatCommon common{p_.is_point() || q_.is_point() ? with_point() : lines()};
    common.cost.probes = probes_;
    conclude(common, tally_.exact);
    return common;
  }

 private:
  static FlatContact nothing() { return {}; }

  Sign cross(int axis, const Point3& a, const Point3& b, const Point3& c, const Point3& d) {
    ++probes_;
    return cross_2d(along(axis, a), along(axis, b), along(axis, c), along(axis, d), &tally_);
  }
  Sign turn(int axis, const Point3& a, const Point3& b, const Point3& c) {
    ++probes_;
    return orient_2d(along(axis, a), along(axis, b), along(axis, c), &tally_);
  }
  bool is_on_line(const Linear& line, const Point3& p) {
    for (const int axis : {0, 1, 2}) {
      if (turn(axis, line.a, line.b, p) != Sign::zero) return false;
    }
    return true;
  }

  FlatContact with_point() {
    const Linear &point = p_.is_point() ? p_ : q_, &other = p_.is_point() ? q_ : p_;
    if (other.is_point()) {
      if (!(point.a == other.a)) return nothing();
      return {FlatKind::point, Relation::overlapping};
    }
    if (!is_on_line(other, point.a)) return nothing();
    return collinear();
  }

  FlatContact lines() {
    ++probes_;
    if (orient_3d(p_.a, p_.b, q_.a, q_.b, &tally_) != Sign::zero) return nothing();
    for (const int axis : {0, 1, 2}) {
      const Sign s = cross(axis, p_.a, p_.b, q_.a, q_.b);
      if (s != Sign::zero) return crossing(axis, s);
    }
    return is_on_line(p_, q_.a) ? collinear() : nothing();
  }

  // Where on a linear thing the line of the other one crosses it.
  enum class Place : std::uint8_t { outside, end, inside };

  // s: positive where the line of x crosses l from its right to its left.
  Place place(int axis, const Linear& l, const Linear& x, Sign s) {
    const auto side = [&](const Point3& p) { return s * turn(axis, x.a, x.b, p); };
    const Sign begin = l.begins ? side(l.a) : Sign::negative, end = l.ends ? side(l.b) : Sign::positive;
    if (begin == Sign::positive || end == Sign::negative) return Place::outside;
    return begin == Sign::zero || end == Sign::zero ? Place::end : Place::inside;
  }

  // In one plane, and not parallel; s: the sign of the cross product of their directions, seen along the axis.
  FlatContact crossing(int axis, Sign s) {
    const Place on_p = place(axis, p_, q_, -s);
    if (on_p == Place::outside) return nothing();
    const Place on_q = place(axis, q_, p_, s);
    if (on_q == Place::outside) return nothing();
    const bool inside = on_p == Place::inside && on_q == Place::inside;
    return {FlatKind::point, inside ? Relation::overlapping : Relation::touching};
  }

  // On one line, of which a coordinate tells the order; they are intervals of it.
  FlatContact collinear() const {
    const Linear& line = p_.is_point() ? q_ : p_;
    const std::size_t axis = line.a.x != line.b.x ? 0 : line.a.y != line.b.y ? 1 : 2;
    struct Interval {
      std::optional<double> low, high;
    };
    const auto interval = [axis](const Linear& l) {
      const auto end = [&](bool is_end, const Point3& p) { return is_end ? std::optional(p[axis]) : std::nullopt; };
      Interval i{end(l.begins, l.a), end(l.ends, l.b)};
      if (l.a[axis] > l.b[axis]) std::swap(i.low, i.high);
      return i;
    };
    const Interval p = interval(p_), q = interval(q_);
    Interval both = p;
    if (q.low && (!both.low || *q.low > *both.low)) both.low = q.low;
    if (q.high && (!both.high || *q.high < *both.high)) both.high = q.high;
    if (!both.low || !both.high) {
      return {both.low || both.high ? FlatKind::ray : FlatKind::line, Relation::overlapping};
    }
    if (*both.low > *both.high) return nothing();
    if (*both.low < *both.high) return {FlatKind::segment, Relation::overlapping};
    const auto is_inside = [&](const Linear& l, const Interval& i) {
      return l.is_point() || ((!i.low || *i.low < *both.low) && (!i.high || *i.high > *both.high));
    };
    return {FlatKind::point, is_inside(p_, p) && is_inside(q_, q) ? Relation::overlapping : Relation::touching};
  }

  const Linear &p_, &q_;
  StageTally tally_;
  std::uint32_t probes_ = 0;
};

}  // namespace

std::string_view name_of(FlatKind kind) {
  return name_in<FlatKind::plane>({"nothing", "point", "segment", "ray", "line", "plane"}, kind);
}

FlatCommon linear_linear(const Linear& p, const Linear& q) { return Two(p, q).answer(); }

FlatCommon line_line(const Line& a, const Line& b) { return linear_linear(a, b); }
FlatCommon line_ray(const Line& a, const Ray& b) { return linear_linear(a, b); }
FlatCommon line_segment(const Line& a, const Segment& b) { return linear_linear(a, b); }
FlatCommon ray_ray(const Ray& a, const Ray& b) { return linear_linear(a, b); }
FlatCommon ray_segment(const Ray& a, const Segment& b) { return linear_linear(a, b); }
FlatCommon segment_segment(const Segment& a, const Segment& b) { return linear_linear(a, b); }
FlatCommon line_point(const Line& a, const Point3& b) { return linear_linear(a, b); }
FlatCommon ray_point(const Ray& a, const Point3& b) { return linear_linear(a, b); }
FlatCommon segment_point(const Segment& a, const Point3& b) { return linear_linear(a, b); }

}  // namespace sunder::solid
