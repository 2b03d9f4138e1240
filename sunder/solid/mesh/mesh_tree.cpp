#include <sunder/base/contract.h>
#include <sunder/solid/mesh/mesh_tree.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>

namespace sunder::solid {

namespace {

Box3 box_of_none() {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  return {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
}

}  // namespace

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;

// How corners of triangles are spread about their mean: the sum of products of coordinates, each triangle counted by
// its area, and a little besides. Where that is not finite, it is not asked for.
Matrix spread(std::span<const Point3> corners) {
  Matrix sum{};
  Point3 mean;
  double weights = 0;
  for (const bool is_second : {false, true}) {
    for (std::size_t k = 0; k < corners.size(); k += 3) {
      const Point3 &p = corners[k], &q = corners[k + 1], &r = corners[k + 2];
      const Point3 n = cross({q.x - p.x, q.y - p.y, q.z - p.z}, {r.x - p.x, r.y - p.y, r.z - p.z});
      const double weight = std::sqrt(dot(n, n)) + 0x1p-40;
      for (std::size_t i = k; i < k + 3; ++i) {
        const Point3& at = corners[i];
        if (!is_second) {
          weights += weight;
          for (std::size_t c = 0; c < 3; ++c) mean[c] += weight * at[c];
          continue;
        }
        for (std::size_t c = 0; c < 3; ++c) {
          for (std::size_t d = c; d < 3; ++d) sum[c][d] += weight * (at[c] - mean[c]) * (at[d] - mean[d]);
        }
      }
    }
    if (!is_second) mean = {mean.x / weights, mean.y / weights, mean.z / weights};
  }
  return sum;
}

// The directions in which a symmetric matrix, of which the upper half is given, is about diagonal: Jacobi's rotations.
std::array<Point3, 3> principal_axes(Matrix m) {
  std::array<Point3, 3> axes{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
  const double size = m[0][0] + m[1][1] + m[2][2];
  for (int turn = 0; turn < 24; ++turn) {
    const std::size_t i = turn % 3 == 2 ? 1 : 0, j = turn % 3 == 0 ? 1 : 2, k = 3 - i - j;
    const double off = m[i][j];
    if (!(std::fabs(off) > size * 0x1p-40)) continue;
    const double theta = (m[j][j] - m[i][i]) / (2 * off);
    const double t = (theta < 0 ? -1 : 1) / (std::fabs(theta) + std::sqrt(theta * theta + 1));
    const double cosine = 1 / std::sqrt(t * t + 1), sine = t * cosine;
    m[i][i] -= t * off;
    m[j][j] += t * off;
    m[i][j] = 0;
    double &of_i = m[std::min(i, k)][std::max(i, k)], &of_j = m[std::min(j, k)][std::max(j, k)];
    const double at_i = of_i, at_j = of_j;
    of_i = cosine * at_i - sine * at_j;
    of_j = sine * at_i + cosine * at_j;
    for (std::size_t c = 0; c < 3; ++c) {
      const double u = axes[i][c], v = axes[j][c];
      axes[i][c] = cosine * u - sine * v;
      axes[j][c] = sine * u + cosine * v;
    }
  }
  return axes;
}

double volume(const std::array<Point3, 2>& ends) {  // and a little for flat ones
  const auto side = [&](std::size_t c) { return ends[1][c] - ends[0][c] + 0x1p-20; };
  return side(0) * side(1) * side(2);
}

// From where to where they go along each axis.
std::array<Point3, 2> ends_along(const std::array<Point3, 3>& axes, std::span<const Point3> corners) {
  std::array<Point3, 2> ends;
  for (std::size_t k = 0; k < 3; ++k) ends[0][k] = ends[1][k] = dot(axes[k], corners[0]);
  for (const Point3& p : corners) {
    for (std::size_t k = 0; k < 3; ++k) {
      const double at = dot(axes[k], p);
      ends[0][k] = std::min(ends[0][k], at);
      ends[1][k] = std::max(ends[1][k], at);
    }
  }
  return ends;
}

// Axes in single precision. Numbers are at most 2 in size, and what is rounded is off by less than a part in 2^46.
OrientedBox box_along(const std::array<Point3, 3>& axes, const std::array<Point3, 2>& ends) {
  OrientedBox box;
  std::array<double, 3> at{};  // along each axis
  for (std::size_t k = 0; k < 3; ++k) {
    box.x[k] = static_cast<float>(axes[k].x);
    box.y[k] = static_cast<float>(axes[k].y);
    box.z[k] = static_cast<float>(axes[k].z);
    at[k] = ends[0][k] / 2 + ends[1][k] / 2;
  }
  box.x[3] = static_cast<float>(axes[0].x * at[0] + axes[1].x * at[1] + axes[2].x * at[2]);
  box.y[3] = static_cast<float>(axes[0].y * at[0] + axes[1].y * at[1] + axes[2].y * at[2]);
  box.z[3] = static_cast<float>(axes[0].z * at[0] + axes[1].z * at[1] + axes[2].z * at[2]);
  const Point3 kept{static_cast<double>(box.x[3]), static_cast<double>(box.y[3]), static_cast<double>(box.z[3])};
  for (std::size_t k = 0; k < 3; ++k) {
    const double middle_at = dot(axes[k], kept);
    const double half = std::max(ends[1][k] - middle_at, middle_at - ends[0][k]) + 0x1p-45;
    box.half[k] = std::nextafter(static_cast<float>(half), 8.0F);
  }
  return box;
}

// As single precision keeps it, of length 1; the other one where it has no length.
Point3 axis_along(const Point3& way, const Point3& other) {
  const double length = std::sqrt(dot(way, way));
  if (!(length > 0x1p-300)) return other;
  const auto rounded = [&](double x) { return static_cast<double>(static_cast<float>(x / length)); };
  return {rounded(way.x), rounded(way.y), rounded(way.z)};
}

// Along the axes of the tree, or those of how the triangles are spread, if that is smaller.
OrientedBox box_around(std::span<const Point3> corners) {
  const std::array<Point3, 3> given{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
  std::array<Point3, 3> spread_along = principal_axes(spread(corners));
  for (Point3& axis : spread_along) axis = axis_along(axis, axis);
  const std::array<Point3, 2> ends = ends_along(given, corners), there = ends_along(spread_along, corners);
  return volume(there) < 0.7 * volume(ends) ? box_along(spread_along, there) : box_along(given, ends);
}

}  // namespace

MeshTree::MeshTree(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::vector<std::uint32_t>& order)
    : size_(triangles.size()) {
  SUNDER_REQUIRE(triangles.size() < std::size_t{1} << 31);
  order.resize(triangles.size());
  std::iota(order.begin(), order.end(), 0u);
  std::vector<Box3> boxes(triangles.size(), box_of_none());
  std::vector<Point3> middles(triangles.size());
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (const std::uint32_t corner : triangles[t]) boxes[t] = hull(boxes[t], {points[corner], points[corner]});
    for (std::size_t c = 0; c < 3; ++c) middles[t][c] = boxes[t].low[c] / 2 + boxes[t].high[c] / 2;
  }
  box_ = box_of_none();
  for (const Box3& box : boxes) box_ = hull(box_, box);
  double half = 0;
  for (std::size_t c = 0; c < 3 && !boxes.empty(); ++c) {
    middle_[c] = box_.low[c] / 2 + box_.high[c] / 2;
    half = std::max(half, box_.high[c] / 2 - box_.low[c] / 2);
  }
  unit_ = std::ldexp(1.0, half > 0x1p-1000 ? std::min(std::ilogb(half) + 1, 1023) : -1000);
  nodes_.resize(2 * std::bit_ceil(std::max<std::size_t>(1, (triangles.size() + leaf_size - 1) / leaf_size)));
  split(middles, order, 0, leaves());
  for (std::size_t leaf = leaves(); leaf < nodes_.size(); ++leaf) {
    const auto [first, end] = this->triangles(leaf);
    std::sort(order.begin() + first, order.begin() + end);
  }
  std::vector<Point3> corners;  // of all triangles in their order, in units of the tree
  corners.reserve(3 * triangles.size());
  for (const std::uint32_t t : order) {
    for (const std::uint32_t corner : triangles[t]) {
      Point3 p;
      for (std::size_t c = 0; c < 3; ++c) p[c] = (points[corner][c] - middle_[c]) / unit_;
      corners.push_back(p);
    }
  }
  double furthest = 0;  // squared
  for (const Point3& p : corners) furthest = std::max(furthest, dot(p, p));
  radius_ = std::sqrt(furthest) * unit_;
  for (std::size_t node = 1; node < nodes_.size(); ++node) {
    const TriangleRange range = this->triangles(node);
    if (range.size() == 0) continue;
    nodes_[node] = box_around(std::span(corners).subspan(3 * range.first, 3 * std::size_t{range.size()}));
  }
}

OrientedBox MeshTree::box_around_triangle(const std::array<Point3, 3>& given) const {
  std::array<Point3, 3> corners;
  for (std::size_t k = 0; k < 3; ++k) {
    for (std::size_t c = 0; c < 3; ++c) corners[k][c] = (given[k][c] - middle_[c]) / unit_;
  }
  const auto way = [&](std::size_t i, std::size_t j) {
    return Point3{corners[j].x - corners[i].x, corners[j].y - corners[i].y, corners[j].z - corners[i].z};
  };
  const std::array<Point3, 3> sides{way(0, 1), way(1, 2), way(2, 0)};
  const Point3 longest = *std::max_element(sides.begin(), sides.end(),
                                           [](const Point3& u, const Point3& v) { return dot(u, u) < dot(v, v); });
  std::array<Point3, 3> axes{axis_along(longest, {1, 0, 0}), {}, {}};
  const Point3 across = std::fabs(axes[0].x) < 0.6 ? Point3{1, 0, 0} : Point3{0, 1, 0};
  const Point3 normal = cross(axes[0], axis_along(cross(sides[0], sides[1]), across));
  axes[1] = axis_along(normal, across);
  axes[2] = axis_along(cross(axes[0], axes[1]), across);
  return box_along(axes, ends_along(axes, corners));
}

void MeshTree::split(std::span<const Point3> middles, std::vector<std::uint32_t>& order, std::size_t first_leaf,
                     std::size_t leaves) {
  const auto at = [&](std::size_t leaf) { return order.begin() + static_cast<std::ptrdiff_t>(begin_of(leaf)); };
  if (leaves < 2) return;
  const auto begin = at(first_leaf), middle = at(first_leaf + leaves / 2), end = at(first_leaf + leaves);
  if (end - begin < 2) return;
  std::size_t axis = 0;
  double most = -1;
  for (std::size_t c = 0; c < 3; ++c) {
    const auto less = [&](std::uint32_t s, std::uint32_t t) { return middles[s][c] < middles[t][c]; };
    const auto [least, greatest] = std::minmax_element(begin, end, less);
    const double spread = middles[*greatest][c] / 2 - middles[*least][c] / 2;  // halves do not overflow
    if (spread > most) most = spread, axis = c;
  }
  if (middle != end) {
    std::nth_element(begin, middle, end, [&](std::uint32_t s, std::uint32_t t) {
      return middles[s][axis] != middles[t][axis] ? middles[s][axis] < middles[t][axis] : s < t;
    });
  }
  split(middles, order, first_leaf, leaves / 2);
  split(middles, order, first_leaf + leaves / 2, leaves / 2);
}

}  // namespace sunder::solid
