// The bound of the error. Let u = 2^-53, S be the greatest coordinate of a body and T the greatest number of its
// translation; entries m of its linear part L are at most 1 + 2^-20, a direction d is tame, so at most 1 in each
// component. All sums are of three products, each within 3 u of the sum of their sizes.
//   e = L_a d, rounded, so |e_i| <= 3.01, and within 10 u of L_a d. Along e, a vertex v of A is at (L_a^T e) v + e t_a,
//   where L_a^T e = d + R d + L_a^T (e - L_a d), R = L_a^T L_a - 1, whose rows have sums of sizes of at most
//   `departure` and 39 u for their rounding. So it is at most d v + e t_a, and beyond that 3 S (departure + 39 u + 31
//   u). `reach` is d v, within 10 u S. f = L_b^T e, rounded, within 28 u, and |f_j| <= 9.1. A vertex w of B: f w,
//   within 84 u S for f and 83 u S for rounding; of the box, whose middle is at most S and whose half at most 2 S,
//   within 420 u S in all. e (t_b - t_a) is within 37 u (T_a + T_b); the last sum of three numbers within 3 u (82 S_b +
//   10 (T_a + T_b) + 3 S_a).
// Together at most 3 departure S + 1024 u (S + T) for each of the two, the rounding of this included.
// Nothing underflows: where images are tame (predicate/posed.h) and entries are zero or at least 2^-200, d is a
// multiple of 2^-112, e of 2^-364, f of 2^-616, and a product of f and a coordinate of 2^-869. Where a distance is
// asked for, the gap along e has to be more than |e| times that: |e| is rounded within 3 u of itself, the product and
// the sum another 2 u; 2^-46 is 128 u. A distance below 2^-200 counts as that, so that the product does not underflow
// either.
#include <sunder/base/contract.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/pair/kept_partings.h>
#include <sunder/solid/search/search_vector.h>
#include <sunder/solid/search/sure_support.h>

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace sunder::solid {

namespace {

Point3 turned(const Affine3& pose, const Point3& d) {
  const auto& m = pose.linear;
  return {m[0] * d.x + m[1] * d.y + m[2] * d.z, m[3] * d.x + m[4] * d.y + m[5] * d.z,
          m[6] * d.x + m[7] * d.y + m[8] * d.z};
}

Point3 turned_back(const Affine3& pose, const Point3& e) {
  const auto& m = pose.linear;
  return {m[0] * e.x + m[3] * e.y + m[6] * e.z, m[1] * e.x + m[4] * e.y + m[7] * e.z,
          m[2] * e.x + m[5] * e.y + m[8] * e.z};
}

// How much L^T L differs from 1: the greatest sum of a row's sizes.
double departure_from_rotation(const std::array<double, 9>& m) {
  const auto of = [&](std::size_t j, std::size_t k) { return m[j] * m[k] + m[3 + j] * m[3 + k] + m[6 + j] * m[6 + k]; };
  const double xy = std::fabs(of(0, 1)), yz = std::fabs(of(1, 2)), zx = std::fabs(of(2, 0));
  const double xx = std::fabs(of(0, 0) - 1), yy = std::fabs(of(1, 1) - 1), zz = std::fabs(of(2, 2) - 1);
  return std::max(xx + xy + zx, std::max(xy + yy + yz, zx + yz + zz));
}

bool part_along(const RigidlyPlaced& a, const RigidlyPlaced& b, KeptParting& kept, double error, double least,
                const Point3& way) {
  const Point3 e = turned(a.pose, kept.direction), f = turned_back(b.pose, e);
  const double least_gap = least == 0 ? error : error + least * std::sqrt(dot(e, e)) * (1 + 0x1p-46);
  const double between = dot(e, way) - kept.reach;
  const double beside = std::fabs(f.x) * b.half.x + std::fabs(f.y) * b.half.y + std::fabs(f.z) * b.half.z;
  if ((dot(f, b.middle) - beside) + between > least_gap) return true;
  // Other vertices only come nearer.
  if (!(dot(f, b.graph->vertices[kept.near_b]) + between > least_gap)) return false;
  return surely_least_along(*b.graph, f, kept.near_b) + between > least_gap;
}

bool keep_along(const SearchGraph& graph, const Point3& direction, std::uint32_t extreme_a, std::uint32_t near_b,
                std::span<KeptParting> kept) {
  constexpr std::size_t most = 512;
  SUNDER_REQUIRE(extreme_a < graph.vertices.size());
  const VertexBlock block = graph.block(graph.place[extreme_a]);
  double reach = dot(direction, graph.vertices[extreme_a]);
  if (block.padded() == 0 || block.count() > most_around ||
      !is_surely_least(block, negated(direction), sure_rounding * graph.sizes.greatest)) {
    if (graph.vertices.size() > most) return false;
    for (const Point3& v : graph.vertices) reach = std::max(reach, dot(direction, v));
  }
  if (!std::isfinite(reach)) return false;
  std::copy_backward(kept.begin(), kept.end() - 1, kept.end());
  kept.front() = {direction, reach, near_b};
  return true;
}

}  // namespace

RigidlyPlaced::RigidlyPlaced(const ConvexPolyhedron& body) : graph(&body.search_graph()) {
  const Point3 &low = graph->low, &high = graph->high;
  for (std::size_t j = 0; j < 3; ++j) {
    middle[j] = 0.5 * (low[j] + high[j]);
    half[j] = std::max(high[j] - middle[j], middle[j] - low[j]) * (1 + 0x1p-51);
  }
}

void RigidlyPlaced::place(const Pose& at) {
  pose = at.affine();
  const SizeRange &linear = at.linear_range(), &translation = at.translation_range();
  const bool holds =
      linear.least >= 0x1p-200 && linear.greatest <= 1 + 0x1p-20 && images_are_tame(linear, translation, graph->sizes);
  const double size = graph->sizes.greatest;
  error = holds ? 3 * departure_from_rotation(pose.linear) * size + sure_rounding * (size + translation.greatest)
                : std::numeric_limits<double>::infinity();
}

bool part_again(const RigidlyPlaced& a, const RigidlyPlaced& b, std::span<KeptParting> kept, double least) {
  SUNDER_REQUIRE(least >= 0);
  const double error = a.error + b.error;
  if (!std::isfinite(error)) return false;
  if (least > 0) least = std::max(least, 0x1p-200);
  const auto &s = a.pose.translation, &t = b.pose.translation;
  const Point3 way{t[0] - s[0], t[1] - s[1], t[2] - s[2]};
  for (std::size_t k = 0; k < kept.size() && std::isfinite(kept[k].reach); ++k) {
    if (!part_along(a, b, kept[k], error, least, way)) continue;
    const KeptParting held = kept[k];
    for (std::size_t i = k; i > 0; --i) kept[i] = kept[i - 1];
    kept[0] = held;
    return true;
  }
  return false;
}

bool keep_parting(const ConvexPolyhedron& a, const Point3& direction, std::uint32_t extreme_a, std::uint32_t near_b,
                  std::span<KeptParting> kept) {
  return keep_along(a.search_graph(), direction, extreme_a, near_b, kept);
}

bool keep_parting_of_world(const RigidlyPlaced& a, const Point3& direction, std::span<KeptParting> kept) {
  Point3 d = turned_back(a.pose, direction);
  if (!make_tame(d)) return false;
  std::uint32_t extreme = 0;
  (void)surely_least_along(*a.graph, negated(d), extreme);
  return keep_along(*a.graph, d, extreme, 0, kept);
}

}  // namespace sunder::solid
