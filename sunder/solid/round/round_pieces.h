// A placed body with a radius in doubles, for proposals: the nearest point of it in closed form, and the smooth pieces
// of its surface with their second derivatives. Nothing here decides anything; but a nearest point of a core and the
// combination of vertices that makes it have to agree, as predicate/disc/round_image.h says. For the sources of solid/round.
#pragma once

#include <sunder/predicate/disc/round_image.h>
#include <sunder/solid/round/round_round.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid::round_quick {

using V = Vector3<double>;

inline V sum(const V& p, double by, const V& q) { return {p.x + by * q.x, p.y + by * q.y, p.z + by * q.z}; }
inline double length(const V& v) { return std::sqrt(dot(v, v)); }
inline Point3 point(const V& v) { return {v.x, v.y, v.z}; }
inline V vector(const Point3& p) { return {p.x, p.y, p.z}; }

// The image of a point; and the size of a core, as predicate/disc/round_image.h has it.
inline V image_of(const Affine3& pose, const Point3& p) {
  const auto& m = pose.linear;
  const auto& t = pose.translation;
  return {m[0] * p.x + m[1] * p.y + m[2] * p.z + t[0], m[3] * p.x + m[4] * p.y + m[5] * p.z + t[1],
          m[6] * p.x + m[7] * p.y + m[8] * p.z + t[2]};
}
inline double size_of(const RoundBody& body, const Pose& at) {
  return std::max(at.linear_range().greatest * body.greatest(), at.translation_range().greatest);
}

// A body in its place, in doubles. What is said of its core is of a curved body said of itself.
struct Side {
  const RoundBody& body;
  const Affine3& pose;
  RoundImage image;

  Side(const RoundBody& of, const Pose& at) : body(of), pose(at.affine()) { set(at); }

  bool is_curved() const { return body.is_curved(); }
  bool is_ball() const { return !is_curved() && image.ends == 1; }
  bool is_capsule() const { return !is_curved() && image.ends == 2; }
  bool is_box() const { return body.box() != nullptr; }
  double radius() const { return is_curved() ? 0 : image.radius; }  // around the core

  V turned(const V& v) const {
    const auto& m = pose.linear;
    return {m[0] * v.x + m[1] * v.y + m[2] * v.z, m[3] * v.x + m[4] * v.y + m[5] * v.z,
            m[6] * v.x + m[7] * v.y + m[8] * v.z};
  }
  V pulled(const V& v) const {
    const auto& m = pose.linear;
    return {m[0] * v.x + m[3] * v.y + m[6] * v.z, m[1] * v.x + m[4] * v.y + m[7] * v.z,
            m[2] * v.x + m[5] * v.y + m[8] * v.z};
  }
  V translation() const { return {pose.translation[0], pose.translation[1], pose.translation[2]}; }

  V middle() const {
    if (image.kind == RoundKind::cone) return sum(image.from, 0.25 * image.length, image.axis);
    if (image.kind == RoundKind::cylinder) return sum(image.from, 0.5 * image.length, image.axis);
    if (image.ends == 1) return image.from;
    if (image.ends == 2) return sum(image.from, 0.5, image.axis);
    if (const AxisBox* box = body.axis_box()) {
      const auto& [low, high] = box->range;
      return sum(translation(), 0.5, turned({low.x + high.x, low.y + high.y, low.z + high.z}));
    }
    return sum(translation(), 1, turned(vector(body.core().search_graph().middle)));
  }

 private:
  void set(const Pose& at) {
    const double size = size_of(body, at);
    const std::span<const Point3> ends = body.ends();
    if (!ends.empty()) {
      set_image(image, body.kind(), pose, ends.data(), static_cast<std::uint32_t>(ends.size()), body.radius(), size,
                at.linear_range().greatest);
    } else if (const AxisBox* box = body.axis_box()) {
      set_image(image, pose, box->range.data(), body.radius(), size, at.linear_range().greatest);
    } else {
      const SearchGraph& graph = body.core().search_graph();
      set_image(image, pose, graph.all.data(), graph.padded, body.radius(), size, at.linear_range().greatest);
      if (graph.padded == 0) image.is_tame = false;  // of many vertices
    }
  }
};

// The point of a core that is nearest to another: what makes it.
struct Nearest {
  V at;
  RoundCombination made{};  // of hulls
};

inline void put(RoundCombination& made, std::uint32_t vertex, double weight) {
  if (!(weight > 0)) return;
  const std::size_t last = made.count();
  made.vertices[last] = vertex;
  made.weights[last] = weight;
}

// The point of a segment, from 0 to 1.
inline Nearest on_segment(const RoundImage& image, double t) {
  Nearest found{};
  const double rest = 1 - t;
  put(found.made, 0, rest);
  put(found.made, 1, t);
  found.at = {rest * image.from.x + t * image.to.x, rest * image.from.y + t * image.to.y,
              rest * image.from.z + t * image.to.z};
  return found;
}

// A corner of a box, as it is in its frame; and the number of the vertex. Requires that it is a box.
struct Corner {
  V at;
  std::uint32_t vertex;
};
inline Corner corner_of(const AxisBox& box, std::uint32_t place) {
  const auto& range = box.range;
  return {{range[place & 1].x, range[place >> 1 & 1].y, range[place >> 2].z}, box.corners[place]};
}
inline Corner corner_of(const RoundBody& body, std::uint32_t place) {
  const std::uint32_t vertex = body.box()->corners[place];
  return {vector(body.core().search_graph().vertices[vertex]), vertex};
}

// In a box, of the corner at `place` 0 and those after it in the order of the coordinates, of which the greatest comes
// first: a simplex that holds the point. Source: Freudenthal 1942; Kuhn 1960.
inline Nearest in_box(const Side& side, const V& x) {
  const V local = side.pulled(x - side.translation());
  std::array<double, 3> part;  // from 0 to 1 along each side
  const AxisBox* along_axes = side.body.axis_box();
  if (along_axes != nullptr) {
    const V from = local - vector(along_axes->range[0]);
    const auto& over = along_axes->over_side;
    part = {std::clamp(from.x * over[0], 0.0, 1.0), std::clamp(from.y * over[1], 0.0, 1.0),
            std::clamp(from.z * over[2], 0.0, 1.0)};
  } else {
    const RoundBox& box = *side.body.box();
    const V from = local - vector(box.middle);
    for (std::size_t k = 0; k < 3; ++k) {
      part[k] = std::clamp(0.5 + 0.5 * box.over_half2[k] * dot(from, vector(box.half[k])), 0.0, 1.0);
    }
  }
  const auto& [x0, x1, x2] = part;
  // In order, without a branch, because any order is as likely.
  const unsigned less01 = x0 < x1 ? 1 : 0, less02 = x0 < x2 ? 1 : 0, less12 = x1 < x2 ? 1 : 0;
  const unsigned rank0 = less01 + less02, rank1 = 1 - less01 + less12, rank2 = 2 - less02 - less12;
  const auto of_rank = [&](unsigned rank) {
    return (rank0 == rank ? 1u : 0u) | (rank1 == rank ? 2u : 0u) | (rank2 == rank ? 4u : 0u);
  };
  const double most = std::max(std::max(x0, x1), x2), least = std::min(std::min(x0, x1), x2);
  const double middle = std::max(std::min(x0, x1), std::min(std::max(x0, x1), x2));
  const unsigned first = of_rank(0);
  const std::array<std::uint32_t, 4> place{0, first, first | of_rank(1), 7};
  const std::array<double, 4> weight{1 - most, most - middle, middle - least, least};
  // Of these vertices as they are.
  Nearest found{};
  V total{0, 0, 0};
  std::size_t count = 0;
  for (std::size_t k = 0; k < 4; ++k) {
    const Corner corner = along_axes != nullptr ? corner_of(*along_axes, place[k]) : corner_of(side.body, place[k]);
    total = sum(total, weight[k], corner.at);
    found.made.vertices[count] = corner.vertex;
    found.made.weights[count] = weight[k];
    if (weight[k] > 0) ++count;
  }
  const double all = (weight[0] + weight[1]) + (weight[2] + weight[3]);
  found.at = sum(side.translation(), 1, side.turned({total.x / all, total.y / all, total.z / all}));
  return found;
}

inline Nearest in_cylinder(const RoundImage& image, const V& x) {
  const V from = x - image.from;
  const double along = dot(from, image.axis);
  const V across = sum(from, -along, image.axis);
  const double by = std::min(image.radius / length(across), 1.0);  // on the axis: of infinity
  return {sum(sum(image.from, std::clamp(along, 0.0, image.length), image.axis), by, across)};
}

// In the half plane of the axis and the point: of the triangle of base, rim and apex.
inline Nearest in_cone(const RoundImage& image, const V& x) {
  const V from = x - image.from;
  const double along = dot(from, image.axis), l = image.length, r = image.radius;
  const V across = sum(from, -along, image.axis);
  const double far = length(across);
  double up = along, out = far;
  if (r * along + l * (far - r) > 0) {  // beyond the side
    const double t = std::clamp((l * along - r * (far - r)) / (l * l + r * r), 0.0, 1.0);
    up = t * l;
    out = (1 - t) * r;
    if (along < 0) {
      up = 0;
      out = std::min(far, r);
    }
  } else if (along < 0) {
    up = 0;
    out = std::min(far, r);
  }
  return {sum(sum(image.from, up, image.axis), far > 0 ? out / far : 0, across)};
}

// On the way from the centre.
inline Nearest in_ellipsoid(const Side& side, const V& x) {
  const RoundImage& of = side.image;
  const auto& m = side.pose.linear;
  const V p{m[0], m[3], m[6]}, q{m[1], m[4], m[7]}, r{m[2], m[5], m[8]};
  const V way = x - of.from, of_p = cross(q, r);
  const double far = length({dot(of_p, way), dot(cross(r, p), way), dot(cross(p, q), way)});
  const double reach = of.radius * std::fabs(dot(p, of_p));
  return {sum(of.from, far > reach ? reach / far : 1, way)};
}

inline bool has_nearest(const Side& side) {
  return side.is_ball() || side.is_capsule() || (side.is_curved() && side.image.kind != RoundKind::ellipsoid) ||
         side.is_box();
}

// Requires has_nearest.
inline Nearest nearest_in(const Side& side, const V& x) {
  const RoundImage& image = side.image;
  if (image.kind == RoundKind::cylinder) return in_cylinder(image, x);
  if (image.kind == RoundKind::cone) return in_cone(image, x);
  if (side.is_ball()) return {image.from, {{0}, {1}}};
  if (!side.is_capsule()) return in_box(side, x);
  return on_segment(image, std::clamp(dot(x - image.from, image.axis) / dot(image.axis, image.axis), 0.0, 1.0));
}

// The point of a body that is nearest; of an ellipsoid, on the way from its centre. Requires as much of hulls.
inline Nearest nearest_or_towards(const Side& side, const V& x) {
  return side.image.kind == RoundKind::ellipsoid ? in_ellipsoid(side, x) : nearest_in(side, x);
}

// Where segments are nearest to each other: of the first, from 0 to 1. Source: Ericson 2005, section 5.1.9.
inline double nearest_of_segments(const RoundImage& a, const RoundImage& b) {
  const V way = a.from - b.from;
  const double aa = dot(a.axis, a.axis), bb = dot(b.axis, b.axis), ab = dot(a.axis, b.axis);
  const double of_a = dot(a.axis, way), of_b = dot(b.axis, way);
  const double across = aa * bb - ab * ab;
  const double s = across > 0 ? std::clamp((ab * of_b - of_a * bb) / across, 0.0, 1.0) : 0;
  const double t = std::clamp((ab * s + of_b) / bb, 0.0, 1.0);
  return std::clamp((ab * t - of_a) / aa, 0.0, 1.0);
}

// ---- For the other pairs: a short search, and Newton's method on what it has found.

// The point of a core that is furthest along a direction, and the smooth piece of the surface that it is of: a vertex,
// the rim of base (0) or top (1), an apex (1), an ellipsoid (0).
struct Far {
  V at{};
  std::uint32_t piece = 0;
};

inline V image(const Side& side, std::uint32_t vertex) {
  return sum(side.translation(), 1, side.turned(vector(side.body.core().search_graph().vertices[vertex])));
}

inline bool is_vertex(const Side& side, std::uint32_t piece) {
  return !side.is_curved() || (side.image.kind == RoundKind::cone && piece == 1);
}

// Of a rim, from its centre.
inline V far_on_rim(const RoundImage& of, const V& d) {
  const V across = sum(d, -dot(d, of.axis), of.axis);
  const double far2 = dot(across, across), by = far2 > 0 ? of.radius / std::sqrt(far2) : 0;
  return {by * across.x, by * across.y, by * across.z};
}

// Of one piece.
inline V far_on(const Side& side, std::uint32_t piece, const V& d) {
  const RoundImage& of = side.image;
  if (!side.is_curved()) return of.ends == 0 ? image(side, piece) : piece == 0 ? of.from : of.to;
  if (is_vertex(side, piece)) return of.to;
  if (of.kind == RoundKind::ellipsoid) {
    const V e = side.pulled(d);
    return sum(of.from, of.radius / length(e), side.turned(e));
  }
  return sum(piece == 0 ? of.from : of.to, 1, far_on_rim(of, d));
}

inline Far far_along(const Side& side, const V& d) {
  const RoundImage& of = side.image;
  if (of.kind == RoundKind::cylinder || (of.ends == 2 && !side.is_curved())) {
    const std::uint32_t piece = dot(d, of.axis) > 0 ? 1 : 0;
    return {far_on(side, piece, d), piece};
  }
  if (of.kind == RoundKind::cone) {
    const V rim = far_on(side, 0, d);
    return dot(d, of.to - rim) > 0 ? Far{of.to, 1} : Far{rim, 0};
  }
  if (of.ends == 1) return {far_on(side, 0, d), 0};
  const V e = side.pulled(d);
  if (const AxisBox* box = side.body.axis_box()) {
    const auto bit = [](double x, std::uint32_t k) { return std::uint32_t{x > 0} << k; };
    const Corner corner = corner_of(*box, bit(e.x, 0) | bit(e.y, 1) | bit(e.z, 2));
    return {sum(side.translation(), 1, side.turned(corner.at)), corner.vertex};
  }
  std::uint32_t vertex = 0;
  if (const RoundBox* box = side.body.box()) {
    std::size_t place = 0;
    for (std::size_t k = 0; k < 3; ++k) place |= std::size_t{dot(e, vector(box->half[k])) > 0} << k;
    vertex = box->corners[place];
  } else {
    const double *x = of.all, *y = x + of.count, *z = y + of.count;
    double furthest = e.x * x[0] + e.y * y[0] + e.z * z[0];
    const std::uint32_t n = static_cast<std::uint32_t>(side.body.core().search_graph().vertices.size());
    for (std::uint32_t j = 1; j < n; ++j) {
      const double far = e.x * x[j] + e.y * y[j] + e.z * z[j];
      if (far > furthest) {
        furthest = far;
        vertex = j;
      }
    }
  }
  return {image(side, vertex), vertex};
}

// How the furthest point of a piece turns with the direction, of length 1: the second derivative of its reach, in the
// plane of the directions s and t.
struct Bend {
  double ss = 0, st = 0, tt = 0;
  void add(double by, const Bend& other) {
    ss += by * other.ss;
    st += by * other.st;
    tt += by * other.tt;
  }
};

// Of a curved body, along a direction of length 1: where its rims or its ellipsoid are furthest, from their centres,
// and how they bend. Both rims of a cylinder are alike.
struct Turn {
  V out{0, 0, 0};
  Bend bend;
  bool has_bend = true;  // false: the rims are as good as across the direction
};
inline Turn turn_of(const Side& side, const V& d, const V& s, const V& t) {
  if (!side.is_curved()) return {};
  const RoundImage& of = side.image;
  if (of.kind == RoundKind::ellipsoid) {
    const V e = side.pulled(d), es = side.pulled(s), et = side.pulled(t);
    const double far2 = dot(e, e), by = of.radius / std::sqrt(far2), is = dot(es, e), it = dot(et, e), over = 1 / far2;
    return {sum({0, 0, 0}, by, side.turned(e)),
            {by * (dot(es, es) - is * is * over), by * (dot(es, et) - is * it * over),
             by * (dot(et, et) - it * it * over)}};
  }
  const double is = dot(of.axis, s), it = dot(of.axis, t), far2 = is * is + it * it;  // of the axis x d
  if (!(far2 > 0x1p-40)) return {far_on_rim(of, d), {}, false};
  const double by = of.radius / std::sqrt(far2), bent = by / far2, along = by * dot(d, of.axis);
  return {{by * d.x - along * of.axis.x, by * d.y - along * of.axis.y, by * d.z - along * of.axis.z},
          {bent * it * it, -bent * is * it, bent * is * is}};
}

// How far d has to turn towards `up`, which is perpendicular to it and of length 1, until the other rim, or apex or
// rim, reaches as far: there the cosine with the axis is that of the normal of the side.
inline double until_other(const Side& side, const V& d, const V& up) {
  const RoundImage& of = side.image;
  if (of.kind != RoundKind::cylinder && of.kind != RoundKind::cone) return HUGE_VAL;
  const double along = dot(d, of.axis), gain = dot(up, of.axis), size = std::hypot(along, gain);
  const double cosine = of.kind == RoundKind::cylinder ? 0 : of.radius / std::hypot(of.radius, of.length);
  if (!(cosine < size)) return HUGE_VAL;
  const double top = std::atan2(gain, along),
               half = std::acos(cosine / size);  // beyond it from top - half to top + half
  return along > cosine ? top + half : top > half ? top - half : HUGE_VAL;
}

inline V axis_towards(const Side& side, const V& up) {
  const V& axis = side.image.axis;
  return dot(up, axis) > 0 ? axis : V{} - axis;
}

// And until it is along the axis.
inline double until_axis(const Side& side, const V& d, const V& up) {
  if (side.image.kind == RoundKind::ellipsoid) return HUGE_VAL;
  const V axis = axis_towards(side, up);
  return std::atan2(dot(up, axis), dot(d, axis));
}

// Two directions that are perpendicular to d, of length 1, and to each other. Source: Duff et al. 2017.
inline std::pair<V, V> frame_across(const V& d) {
  const double sign = std::copysign(1.0, d.z), by = -1 / (sign + d.z), xy = d.x * d.y * by;
  return {{1 + sign * d.x * d.x * by, sign * xy, -sign * d.x}, {xy, sign + d.y * d.y * by, -d.y}};
}

// Pieces of one body: those that reach furthest, together.
struct Pieces {
  std::array<std::uint32_t, 4> piece{};
  std::array<double, 4> weight{};  // of the point where the bodies are nearest
  std::array<V, 4> at{};
  std::size_t count = 0;

  bool has(std::uint32_t p) const { return std::find(piece.data(), piece.data() + count, p) != piece.data() + count; }
  std::size_t least() const {
    return static_cast<std::size_t>(std::min_element(weight.data(), weight.data() + count) - weight.data());
  }
  void drop(std::size_t k) {
    --count;
    piece[k] = piece[count];
    weight[k] = weight[count];
    at[k] = at[count];
  }
};

}  // namespace sunder::solid::round_quick
