#include <sunder/predicate/line/space_triangles.h>
#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <optional>

namespace sunder {

namespace {

// What the corners of a triangle span: three, two or one of them. Points are posed, or as they are.
template <class Point>
struct Spanned {
  std::array<Point, 3> corners;
  std::size_t count = 3;
  int axis = 2;  // of a triangle with area: along it the projection has area, too
};

Sign compare_coordinate(int axis, const Point3& a, const Point3& b, StageTally*) {
  const double p = a[static_cast<std::size_t>(axis)], q = b[static_cast<std::size_t>(axis)];
  return p < q ? Sign::positive : q < p ? Sign::negative : Sign::zero;
}

bool are_equal(const Point3& p, const Point3& q, StageTally*) { return p == q; }
// As they are given: images of different points may be equal, too.
bool are_same(const Point3& p, const Point3& q) { return p == q; }
bool are_same(const Posed3& p, const Posed3& q) { return p.pose == q.pose && p.point == q.point; }

bool are_equal(const Posed3& p, const Posed3& q, StageTally* tally) {
  if (are_same(p, q)) return true;
  for (int axis = 0; axis < 3; ++axis) {
    if (compare_coordinate(axis, p, q, tally) != Sign::zero) return false;
  }
  return true;
}

// Is p before q? The first coordinate that differs tells. Both are on one line with all others that are compared.
template <class Point>
bool is_before(const Point& p, const Point& q, StageTally* tally) {
  for (int axis = 0; axis < 3; ++axis) {
    const Sign sign = compare_coordinate(axis, p, q, tally);
    if (sign != Sign::zero) return sign == Sign::positive;
  }
  return false;
}

template <class Point>
std::optional<int> axis_with_area(const Point& a, const Point& b, const Point& c, StageTally* tally) {
  for (int axis = 2; axis >= 0; --axis) {
    if (orient_2d_along(axis, a, b, c, tally) != Sign::zero) return axis;
  }
  return std::nullopt;
}

template <class Point>
Spanned<Point> spanned(const std::array<Point, 3>& t, StageTally* tally) {
  Spanned<Point> result{t, 3, 2};
  if (are_same(t[0], t[1]) && are_same(t[0], t[2])) {
    result.count = 1;
    return result;
  }
  if (const auto axis = axis_with_area(t[0], t[1], t[2], tally)) {
    result.axis = *axis;
    return result;
  }
  // On one line: its ends.
  std::sort(result.corners.begin(), result.corners.end(),
            [&](const Point& p, const Point& q) { return is_before(p, q, tally); });
  result.corners[1] = result.corners[2];
  result.count = are_equal(result.corners[0], result.corners[1], tally) ? 1 : 2;
  return result;
}

// Does p lie on the segment from a to b? All three are on one line.
template <class Point>
bool is_between(const Point& a, const Point& b, const Point& p, StageTally* tally) {
  const bool forward = !is_before(b, a, tally);
  const Point &low = forward ? a : b, &high = forward ? b : a;
  return !is_before(p, low, tally) && !is_before(high, p, tally);
}

template <class Point>
bool are_on_a_line(const Point& a, const Point& b, const Point& c, StageTally* tally) {
  return !axis_with_area(a, b, c, tally);
}

// Does the triangle hold p? It has area, and p lies in its plane.
template <class Point>
bool holds_in_plane(const Spanned<Point>& t, const Point& p, StageTally* tally) {
  bool some_left = false, some_right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign sign = orient_2d_along(t.axis, t.corners[k], t.corners[k == 2 ? 0 : k + 1], p, tally);
    some_left = some_left || sign == Sign::positive;
    some_right = some_right || sign == Sign::negative;
  }
  return !some_left || !some_right;
}

// Two segments of one plane, of which the projection along the axis is one to one.
template <class Point>
bool segments_meet_in_plane(int axis, const Point& p, const Point& q, const Point& r, const Point& s,
                            StageTally* tally) {
  const Sign of_r = orient_2d_along(axis, p, q, r, tally), of_s = orient_2d_along(axis, p, q, s, tally);
  if (of_r == Sign::zero && of_s == Sign::zero) {
    return is_between(p, q, r, tally) || is_between(p, q, s, tally) || is_between(r, s, p, tally);
  }
  if (of_r == of_s) return false;
  const Sign of_p = orient_2d_along(axis, r, s, p, tally), of_q = orient_2d_along(axis, r, s, q, tally);
  return of_p != of_q;
}

// A segment in the plane of the triangle.
template <class Point>
bool meets_in_plane(const Spanned<Point>& t, const Point& p, const Point& q, StageTally* tally) {
  if (holds_in_plane(t, p, tally)) return true;  // if only q is in it, the segment meets an edge
  for (std::size_t k = 0; k < 3; ++k) {
    if (segments_meet_in_plane(t.axis, t.corners[k], t.corners[k == 2 ? 0 : k + 1], p, q, tally)) return true;
  }
  return false;
}

// Does the line through p and q meet the triangle? Requires that the line is not in the triangle's plane.
template <class Point>
bool line_goes_through(const Point& p, const Point& q, const std::array<Point, 3>& t, StageTally* tally) {
  bool some_left = false, some_right = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign sign = orient_3d(p, q, t[k], t[k == 2 ? 0 : k + 1], tally);
    some_left = some_left || sign == Sign::positive;
    some_right = some_right || sign == Sign::negative;
  }
  return !some_left || !some_right;
}

// A segment whose ends are on these sides of the plane of the triangle, which has area.
template <class Point>
bool meets(const Spanned<Point>& t, const Point& p, Sign of_p, const Point& q, Sign of_q, StageTally* tally) {
  if (of_p == Sign::zero && of_q == Sign::zero) return meets_in_plane(t, p, q, tally);
  return of_p != of_q && line_goes_through(p, q, t.corners, tally);
}

template <class Point>
std::array<Sign, 3> sides(const Spanned<Point>& of, const Spanned<Point>& corners, StageTally* tally) {
  std::array<Sign, 3> result;
  for (std::size_t k = 0; k < 3; ++k) {
    result[k] = orient_3d(of.corners[0], of.corners[1], of.corners[2], corners.corners[k], tally);
  }
  return result;
}

// Do edges of u meet t, which has area?
template <class Point>
bool edges_meet(const Spanned<Point>& t, const Spanned<Point>& u, const std::array<Sign, 3>& sides_of_u,
                StageTally* tally) {
  const std::size_t edges = u.count == 3 ? 3 : 1;
  for (std::size_t k = 0; k < edges; ++k) {
    const std::size_t next = k == 2 ? 0 : k + 1;
    if (meets(t, u.corners[k], sides_of_u[k], u.corners[next], sides_of_u[next], tally)) return true;
  }
  return false;
}

// Segments and points.
template <class Point>
bool thin_meet(const Spanned<Point>& t, const Spanned<Point>& u, StageTally* tally) {
  const Point &p = t.corners[0], &q = t.corners[1], &r = u.corners[0], &s = u.corners[1];
  if (t.count == 1) {
    return u.count == 1 ? are_equal(p, r, tally) : are_on_a_line(r, s, p, tally) && is_between(r, s, p, tally);
  }
  if (u.count == 1) return are_on_a_line(p, q, r, tally) && is_between(p, q, r, tally);
  if (orient_3d(p, q, r, s, tally) != Sign::zero) return false;
  auto axis = axis_with_area(p, q, r, tally);
  if (!axis) axis = axis_with_area(p, q, s, tally);
  // All on one line: any axis along which it is no point, by the ends alone.
  if (!axis) return is_between(p, q, r, tally) || is_between(p, q, s, tally) || is_between(r, s, p, tally);
  return segments_meet_in_plane(*axis, p, q, r, s, tally);
}

bool all_are(const std::array<Sign, 3>& signs, Sign sign) { return signs == std::array{sign, sign, sign}; }

template <class Point>
bool do_meet(const std::array<Point, 3>& first, const std::array<Point, 3>& second, StageTally* tally) {
  const Spanned<Point> t = spanned(first, tally), u = spanned(second, tally);
  if (t.count < 3 && u.count < 3) return thin_meet(t, u, tally);
  if (t.count < 3) return edges_meet(u, t, sides(u, t, tally), tally);
  const std::array<Sign, 3> of_u = sides(t, u, tally);
  if (all_are(of_u, Sign::positive) || all_are(of_u, Sign::negative)) return false;
  if (edges_meet(t, u, of_u, tally)) return true;
  if (u.count < 3) return false;
  const std::array<Sign, 3> of_t = sides(u, t, tally);
  return edges_meet(u, t, of_t, tally);
}

}  // namespace

bool triangles_meet(const PosedTriangle& t, const PosedTriangle& u, StageTally* tally) { return do_meet(t, u, tally); }
bool triangles_meet(const Triangle3& t, const Triangle3& u, StageTally* tally) { return do_meet(t, u, tally); }

bool segment_meets(const Point3& p, Sign of_p, const Point3& q, Sign of_q, const Triangle3& t, StageTally* tally) {
  if (of_p == Sign::zero && of_q == Sign::zero) return triangles_meet(Triangle3{p, q, q}, t, tally);
  return of_p != of_q && line_goes_through(p, q, t, tally);
}

TriangleCrossing crossing_of(const Posed3& p, const Posed3& q, const PosedTriangle& t, StageTally* tally) {
  const Sign of_p = orient_3d(t[0], t[1], t[2], p, tally), of_q = orient_3d(t[0], t[1], t[2], q, tally);
  if (of_p == of_q && of_p != Sign::zero) return TriangleCrossing::none;
  if (of_p == Sign::zero || of_q == Sign::zero) {
    return triangles_meet({p, q, q}, t, tally) ? TriangleCrossing::touch : TriangleCrossing::none;
  }
  bool some_left = false, some_right = false, some_zero = false;
  for (std::size_t k = 0; k < 3; ++k) {
    const Sign sign = orient_3d(p, q, t[k], t[k == 2 ? 0 : k + 1], tally);
    some_left = some_left || sign == Sign::positive;
    some_right = some_right || sign == Sign::negative;
    some_zero = some_zero || sign == Sign::zero;
  }
  if (some_left && some_right) return TriangleCrossing::none;
  if (some_zero) return TriangleCrossing::touch;
  return of_q == Sign::positive ? TriangleCrossing::positive : TriangleCrossing::negative;
}

}  // namespace sunder
