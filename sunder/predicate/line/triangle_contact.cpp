#include <sunder/predicate/line/triangle_contact.h>

#include <sunder/predicate/point/orient.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <utility>

namespace sunder {

namespace {

constexpr std::size_t next(std::size_t k) { return k == 2 ? 0 : k + 1; }

// Which corners they share: corner t[of_t[k]] is u[of_u[k]] for k < shared; the others follow.
struct Paired {
  std::array<std::uint8_t, 3> of_t{0, 1, 2}, of_u{0, 1, 2};
  std::size_t shared = 0;

  Paired(const Triangle3& t, const Triangle3& u) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t j = shared; j < 3; ++j) {
        if (t[of_t[i]] != u[of_u[j]]) continue;
        std::swap(of_t[shared], of_t[i]);
        std::swap(of_u[shared], of_u[j]);
        ++shared;
        break;
      }
    }
  }
};

bool segment_meets(const Point3& p, const Point3& q, const PlaneTriangle& t, StageTally* tally) {
  return sunder::segment_meets(p, t.side(p), q, t.side(q), t.corners, tally);
}

// Two that share an edge, a b, and are in one plane, with their third corners: are they on one side of it?
bool are_on_one_side(const Point3& a, const Point3& b, const Point3& of_t, const Point3& of_u, StageTally* tally) {
  for (int axis = 0; axis < 3; ++axis) {
    const Sign side = orient_2d_along(axis, a, b, of_t, tally);
    if (side != Sign::zero) return side == orient_2d_along(axis, a, b, of_u, tally);
  }
  return false;  // without area
}

// They share one. What they have in common besides goes on from there to where it leaves one of the two, which is across
// from that corner.
bool have_more_than_a_corner(const PlaneTriangle& t, const PlaneTriangle& u, const Paired& pair, StageTally* tally) {
  const Point3 &u1 = u.corners[pair.of_u[1]], &u2 = u.corners[pair.of_u[2]];
  const Sign of_u1 = t.side(u1), of_u2 = t.side(u2);
  if (of_u1 == of_u2 && of_u1 != Sign::zero) return false;
  const Point3 &t1 = t.corners[pair.of_t[1]], &t2 = t.corners[pair.of_t[2]];
  const Sign of_t1 = u.side(t1), of_t2 = u.side(t2);
  if (of_t1 == of_t2 && of_t1 != Sign::zero) return false;
  return sunder::segment_meets(u1, of_u1, u2, of_u2, t.corners, tally) ||
         sunder::segment_meets(t1, of_t1, t2, of_t2, u.corners, tally);
}

// Are all corners of u on one side of the plane of t?
bool are_beyond(const PlaneTriangle& t, const PlaneTriangle& u) {
  const Sign side = t.side(u.corners[0]);
  return side != Sign::zero && t.side(u.corners[1]) == side && t.side(u.corners[2]) == side;
}

// Is p between a and b, on one line with them?
bool is_inside_edge(const Point3& a, const Point3& b, const Point3& p, StageTally* tally) {
  for (std::size_t c = 0; c < 3; ++c) {
    if ((p[c] < a[c] && p[c] < b[c]) || (p[c] > a[c] && p[c] > b[c])) return false;
  }
  return p != a && p != b && are_collinear(a, b, p, tally);
}

// Requires that the corner u[k] is inside the edge of t across from t[i]. Is what t and u have in common no more than that
// corner, or a part of an edge of each?
bool ends_inside(const PlaneTriangle& of_t, std::size_t i, const PlaneTriangle& of_u, std::size_t k,
                 StageTally* tally) {
  const Triangle3 &t = of_t.corners, &u = of_u.corners;
  const Point3 &a = t[next(i)], &b = t[next(next(i))], &across = t[i];
  for (const std::size_t j : {next(k), next(next(k))}) {
    if (!are_collinear(a, b, u[j], tally)) continue;
    // An edge of each on one line: they have more in common only in one plane, on one side of it.
    const Point3& other = u[3 - k - j];
    return of_t.side(other) != Sign::zero || !are_on_one_side(a, b, across, other, tally);
  }
  // A common part that goes on from the corner leaves u across from it, or t through another edge.
  return !segment_meets(u[next(k)], u[next(next(k))], of_t, tally) && !segment_meets(a, across, of_u, tally) &&
         !segment_meets(b, across, of_u, tally);
}

// Is what they have in common, besides corners and edges of both, a T-junction? Requires that there is something.
bool is_t_junction(const PlaneTriangle& t, const PlaneTriangle& u, StageTally* tally) {
  for (const auto& [edges_of, corners_of] : {std::pair(&t, &u), std::pair(&u, &t)}) {
    for (std::size_t i = 0; i < 3; ++i) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Point3 &a = edges_of->corners[next(i)], &b = edges_of->corners[next(next(i))];
        if (is_inside_edge(a, b, corners_of->corners[k], tally))
          return ends_inside(*edges_of, i, *corners_of, k, tally);
      }
    }
  }
  return false;
}

// Which corners of one triangle are surely above the plane of another one, and which below it: bit k tells of corner k.
struct SureSides {
  unsigned above = 0, below = 0;

  SureSides(const PlaneTriangle& plane_of, const Triangle3& corners) {
    for (unsigned k = 0; k < 3; ++k) {
      const unsigned bits = plane_of.plane.sure_bits(plane_of.corners[0], corners[k]);
      above |= (bits & 1) << k;
      below |= (bits >> 1) << k;
    }
  }
  bool are_one(unsigned corners) const { return (above & corners) == corners || (below & corners) == corners; }
  bool are_known(unsigned corners) const { return ((above | below) & corners) == corners; }
  bool is_above(std::size_t k) const { return (above >> k & 1) != 0; }
};

// The one of three corners that is alone on its side of the plane. Requires that none is on the plane, and that they
// are not all on one side.
std::size_t lone_corner(const SureSides& sides) {
  return static_cast<std::size_t>(std::countr_zero(std::has_single_bit(sides.above) ? sides.above : sides.below));
}

// From this corner on, in their order or against it.
Triangle3 corners_from(const Triangle3& t, std::size_t k, bool is_in_order) {
  const Point3 &b = t[next(k)], &c = t[next(next(k))];
  return {t[k], is_in_order ? b : c, is_in_order ? c : b};
}

// Each plane parts the other triangle, and has no corner of it. So each triangle has a segment of the line along which the
// planes cross, which goes from one edge at its lone corner to the other one. Turned so that each sees the other's lone
// corner above, these segments go opposite ways, and the two signs tell that neither ends before the other begins.
// Source: Guigue, Devillers 2003, "Fast and robust triangle-triangle overlap test using orientation predicates".
bool do_segments_meet(const Triangle3& t, const Triangle3& u, const SureSides& of_t, const SureSides& of_u,
                      StageTally* tally) {
  const std::size_t i = lone_corner(of_t), j = lone_corner(of_u);
  const auto [a, b, c] = corners_from(t, i, of_u.is_above(j));
  const auto [p, q, r] = corners_from(u, j, of_t.is_above(i));
  return orient_3d(a, b, p, q, tally) != Sign::positive && orient_3d(a, c, p, r, tally) != Sign::negative;
}

}  // namespace

TriangleContact triangle_contact(const PlaneTriangle& t, const PlaneTriangle& u, const SharedCorners& shared,
                                 StageTally* tally) {
  const unsigned rest_of_t = 7 & ~shared.of_t, rest_of_u = 7 & ~shared.of_u;
  if (rest_of_t == 0) return TriangleContact::crossing;
  const SureSides of_t(u, t.corners), of_u(t, u.corners);
  if (of_t.are_one(rest_of_t) || of_u.are_one(rest_of_u)) return TriangleContact::proper;
  if (!of_t.are_known(rest_of_t) || !of_u.are_known(rest_of_u)) return exact_triangle_contact(t, u, tally);
  // They share at most one corner, and no corner is on an edge of the other triangle: there is no T-junction.
  if (shared.of_t == 0) {
    return do_segments_meet(t.corners, u.corners, of_t, of_u, tally) ? TriangleContact::crossing
                                                                     : TriangleContact::proper;
  }
  // The planes cross along a line through the corner that they share. The edge of each triangle across from that corner
  // crosses this line, and they have more in common iff both do so to the same side of the corner. That is so iff the
  // corner of t that comes next is on the same side of the plane of u as the last corner of u of the plane of t.
  const std::size_t i = next(static_cast<std::size_t>(std::countr_zero(shared.of_t)));
  const std::size_t j = next(next(static_cast<std::size_t>(std::countr_zero(shared.of_u))));
  return of_t.is_above(i) == of_u.is_above(j) ? TriangleContact::crossing : TriangleContact::proper;
}

TriangleContact exact_triangle_contact(const PlaneTriangle& t, const PlaneTriangle& u, StageTally* tally) {
  const Paired pair(t.corners, u.corners);
  const auto of_t = [&](std::size_t k) -> const Point3& { return t.corners[pair.of_t[k]]; };
  bool is_more = true;  // of equal ones
  if (pair.shared == 0) {
    is_more = !are_beyond(t, u) && !are_beyond(u, t) && triangles_meet(t.corners, u.corners, tally);
  } else if (pair.shared == 1) {
    is_more = have_more_than_a_corner(t, u, pair, tally);
  } else if (pair.shared == 2) {
    const Point3& other = u.corners[pair.of_u[2]];
    is_more = t.side(other) == Sign::zero && are_on_one_side(of_t(0), of_t(1), of_t(2), other, tally);
  }
  if (!is_more) return TriangleContact::proper;
  return pair.shared < 2 && is_t_junction(t, u, tally) ? TriangleContact::t_junction : TriangleContact::crossing;
}

}  // namespace sunder
