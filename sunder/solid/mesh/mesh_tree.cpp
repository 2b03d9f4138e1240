#include <sunder/base/contract.h>
#include <sunder/base/lanes.h>
#include <sunder/solid/mesh/mesh_tree.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sunder::solid {

namespace {

using Matrix = std::array<std::array<double, 3>, 3>;  // symmetric, of which the upper half is used

// How corners of triangles are spread: their mean, and the sum of products of coordinates about it, each triangle counted
// by its area, and a little besides.
struct Spread {
  double weight = 0;
  Point3 mean;
  Matrix sum{};

  // Of both together. Source: Chan, Golub, LeVeque 1979 (updating formulas for variances).
  friend Spread together(const Spread& a, const Spread& b) {
    Spread all = a;
    all.weight = a.weight + b.weight;
    const double part = b.weight / all.weight;
    const Point3 way{b.mean.x - a.mean.x, b.mean.y - a.mean.y, b.mean.z - a.mean.z};
    for (std::size_t c = 0; c < 3; ++c) {
      all.mean[c] += part * way[c];
      for (std::size_t d = c; d < 3; ++d) all.sum[c][d] += b.sum[c][d] + a.weight * part * way[c] * way[d];
    }
    return all;
  }
};

Spread spread_of(const std::array<Point3, 3>& triangle) {
  const auto& [p, q, r] = triangle;
  const Point3 u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z}, n = cross(u, v);
  const double weight = std::sqrt(dot(n, n)) + 0x1p-40;
  Spread of;
  of.weight = 3 * weight;
  for (std::size_t c = 0; c < 3; ++c) {
    of.mean[c] = p[c] + (u[c] + v[c]) / 3;
    for (std::size_t d = c; d < 3; ++d)
      of.sum[c][d] = weight * (u[c] * u[d] + v[c] * v[d] - (u[c] + v[c]) * (u[d] + v[d]) / 3);
  }
  return of;
}

// The directions in which two symmetric matrices are about diagonal: Jacobi's rotations, both at once. What is left
// beside the diagonal, as a part of all on it, does not make boxes larger to speak of.
std::array<std::array<Point3, 3>, 2> principal_axes(const Matrix& first, const Matrix& second) {
  constexpr double diagonal = 0x1p-10;
  const auto trace = [](const Matrix& of) { return of[0][0] + of[1][1] + of[2][2]; };
  const auto part = [](double size) { return size > 0x1p-900 ? 1 / size : 0; };
  const Lanes parts{part(trace(first)), part(trace(second))};
  std::array<std::array<Lanes, 3>, 3> m, axes;
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < 3; ++j) {
      m[i][j] = Lanes{first[i][j], second[i][j]} * parts;
      axes[i][j] = Lanes{i == j ? 1.0 : 0.0, i == j ? 1.0 : 0.0};
    }
  }
  const auto turn = [&](std::size_t i, std::size_t j) {
    const std::size_t k = 3 - i - j;
    const Lanes off = 2 * m[i][j], apart = m[j][j] - m[i][i], turned = root_of(apart * apart + off * off),
                along = absolute(apart) + turned + 0x1p-400,  // 0 never, so as to be divided by
        part_of = 1 / root_of(along * along + off * off), cosine = along * part_of,
                sign = apart < 0 ? Lanes{-1, -1} : Lanes{1, 1}, sine = sign * off * part_of,
                moved = sign * (turned - absolute(apart)) / 2;
    m[i][i] -= moved;
    m[j][j] += moved;
    m[i][j] = Lanes{0, 0};
    Lanes &of_i = m[std::min(i, k)][std::max(i, k)], &of_j = m[std::min(j, k)][std::max(j, k)];
    const Lanes at_i = of_i, at_j = of_j;
    of_i = cosine * at_i - sine * at_j;
    of_j = sine * at_i + cosine * at_j;
    for (std::size_t c = 0; c < 3; ++c) {
      const Lanes u = axes[i][c], v = axes[j][c];
      axes[i][c] = cosine * u - sine * v;
      axes[j][c] = sine * u + cosine * v;
    }
  };
  for (int sweep = 0; sweep < 8; ++sweep) {
    if (greater_lane(greater_of(greater_of(absolute(m[0][1]), absolute(m[0][2])), absolute(m[1][2]))) < diagonal) break;
    turn(0, 1);
    turn(0, 2);
    turn(1, 2);
  }
  std::array<std::array<Point3, 3>, 2> result;
  for (std::size_t lane = 0; lane < 2; ++lane) {
    for (std::size_t k = 0; k < 3; ++k) result[lane][k] = {axes[k][0][lane], axes[k][1][lane], axes[k][2][lane]};
  }
  return result;
}

using Ends = std::array<Point3, 2>;  // the least and the greatest coordinates, along some axes

Ends hull_of(const Ends& a, const Ends& b) {
  Ends all = a;
  for (std::size_t c = 0; c < 3; ++c) {
    all[0][c] = std::min(a[0][c], b[0][c]);
    all[1][c] = std::max(a[1][c], b[1][c]);
  }
  return all;
}

double volume(const Ends& ends) {  // and a little for flat ones
  const auto side = [&](std::size_t c) { return ends[1][c] - ends[0][c] + 0x1p-20; };
  return side(0) * side(1) * side(2);
}

Ends ends_along(const std::array<Point3, 3>& axes, std::span<const Point3> points) {
  Ends ends;
  for (std::size_t k = 0; k < 3; ++k) {
    ends[0][k] = ends[1][k] = dot(axes[k], points[0]);
    for (const Point3& p : points) {
      ends[0][k] = std::min(ends[0][k], dot(axes[k], p));
      ends[1][k] = std::max(ends[1][k], dot(axes[k], p));
    }
  }
  return ends;
}

// Points, by their coordinates.
struct Columns {
  std::vector<double> x, y, z;

  std::size_t size() const { return x.size(); }
  void reserve(std::size_t size) {
    for (std::vector<double>* column : {&x, &y, &z}) column->reserve(size);
  }
  void push_back(const Point3& p) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  // The same of those from `first` to before `end`, two at once; the last one by itself, too.
  Ends ends_along(const std::array<Point3, 3>& axes, std::size_t first, std::size_t end) const {
    const auto both = [](double t) { return Lanes{t, t}; };
    std::array<Lanes, 3> low, high;
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = high[k] = both(axes[k].x * x[first] + axes[k].y * y[first] + axes[k].z * z[first]);
    }
    for (std::size_t i = first; i + 1 < end; i += 2) {
      const Lanes at_x = lanes_at(&x[i]), at_y = lanes_at(&y[i]), at_z = lanes_at(&z[i]);
      for (std::size_t k = 0; k < 3; ++k) {
        const Lanes at = both(axes[k].x) * at_x + both(axes[k].y) * at_y + both(axes[k].z) * at_z;
        low[k] = smaller_of(low[k], at);
        high[k] = greater_of(high[k], at);
      }
    }
    Ends ends;
    for (std::size_t k = 0; k < 3; ++k) {
      const double last = axes[k].x * x[end - 1] + axes[k].y * y[end - 1] + axes[k].z * z[end - 1];
      ends[0][k] = std::min({low[k][0], low[k][1], last});
      ends[1][k] = std::max({high[k][0], high[k][1], last});
    }
    return ends;
  }
};

// The next number of single precision above one that is positive.
float next_above(float x) { return std::bit_cast<float>(std::bit_cast<std::uint32_t>(x) + 1); }

// Axes in single precision. Numbers are at most 2 in size, and what is rounded is off by less than a part in 2^46.
OrientedBox box_along(const std::array<Point3, 3>& axes, const Ends& ends) {
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
    box.half[k] = next_above(static_cast<float>(half));
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

// Makes the boxes of all nodes, from the leaves upwards: how triangles are spread, and how far they go along the axes of
// the tree, is put together from both halves of a node. Only along its own axes all points below it are looked at.
class BoxesUpwards {
 public:
  // Of the tree its shape, its middle and its unit are known.
  BoxesUpwards(const MeshTree& tree, std::span<const Point3> points,
               std::span<const std::array<std::uint32_t, 3>> triangles, std::span<const std::uint32_t> order,
               std::vector<OrientedBox>& boxes)
      : tree_(tree), triangles_(triangles), order_(order), boxes_(boxes), seen_(points.size(), none) {
    points_.reserve(points.size());
    const Point3& middle = tree.middle();
    for (const Point3& p : points) {
      points_.push_back(
          {(p.x - middle.x) / tree.unit(), (p.y - middle.y) / tree.unit(), (p.z - middle.z) / tree.unit()});
      furthest_ = std::max(furthest_, dot(points_.back(), points_.back()));
    }
    columns_.reserve(3 * triangles.size());
  }

  // Returns how far the furthest point is from the middle, squared.
  double run() {
    const Below all = below(1);
    make_boxes(all, all, 1, 1);
    return furthest_;
  }

 private:
  static constexpr std::uint32_t none = 0xffffffff;

  // What is below a node.
  struct Below {
    std::size_t first = 0, end = 0;  // points
    Ends ends;                       // along the axes of the tree
    Spread spread;
  };

  Below below(std::size_t node) {
    if (tree_.is_leaf(node)) return leaf(node);
    const Below a = below(2 * node), b = below(2 * node + 1);
    make_boxes(a, b, 2 * node, 2 * node + 1);
    return {a.first, b.end, hull_of(a.ends, b.ends), together(a.spread, b.spread)};
  }

  Below leaf(std::size_t node) {
    Below made;
    made.first = columns_.size();
    const TriangleRange range = tree_.triangles(node);
    for (std::uint32_t place = range.first; place < range.end; ++place) {
      std::array<Point3, 3> corners;
      for (std::size_t k = 0; k < 3; ++k) {
        const std::uint32_t number = triangles_[order_[place]][k];
        corners[k] = points_[number];
        if (std::exchange(seen_[number], range.first) != range.first) columns_.push_back(corners[k]);
      }
      const auto& [p, q, r] = corners;
      const Ends of_triangle = hull_of(hull_of({p, p}, {q, q}), {r, r});
      const bool is_first = place == range.first;
      made.ends = is_first ? of_triangle : hull_of(made.ends, of_triangle);
      made.spread = is_first ? spread_of(corners) : together(made.spread, spread_of(corners));
    }
    made.end = columns_.size();
    return made;
  }

  // Along the axes of the tree, or those of how the triangles are spread, if that is smaller.
  void make_boxes(const Below& a, const Below& b, std::size_t node_a, std::size_t node_b) {
    const auto axes = principal_axes(a.spread.sum, b.spread.sum);
    make_box(a, axes[0], node_a);
    make_box(b, axes[1], node_b);
  }
  void make_box(const Below& of, std::array<Point3, 3> axes, std::size_t node) {
    if (of.first == of.end) return;
    for (Point3& axis : axes) {
      for (std::size_t c = 0; c < 3; ++c) axis[c] = static_cast<double>(static_cast<float>(axis[c]));
    }
    const Ends there = columns_.ends_along(axes, of.first, of.end);
    const std::array<Point3, 3> given{Point3{1, 0, 0}, Point3{0, 1, 0}, Point3{0, 0, 1}};
    boxes_[node] = volume(there) < 0.7 * volume(of.ends) ? box_along(axes, there) : box_along(given, of.ends);
  }

  const MeshTree& tree_;
  std::vector<Point3> points_;  // in units of the tree
  std::span<const std::array<std::uint32_t, 3>> triangles_;
  std::span<const std::uint32_t> order_;
  std::vector<OrientedBox>& boxes_;
  std::vector<std::uint32_t> seen_;  // of each point, the first triangle of the last leaf that has it
  Columns columns_;                  // of each leaf those that its triangles have, once, in units of the tree
  double furthest_ = 0;
};

// The middle of a triangle's box. They are moved as they are sorted, so that what is compared lies side by side.
struct Middle {
  Point3 at;
  std::uint32_t triangle;
};

// So that those before `middle` are the least ones along the axis.
template <double Point3::* axis>
void halve(std::span<Middle> all, std::span<Middle>::iterator middle) {
  std::nth_element(all.begin(), middle, all.end(), [](const Middle& s, const Middle& t) {
    const double a = s.at.*axis, b = t.at.*axis;
    return a != b ? a < b : s.triangle < t.triangle;
  });
}

// Sorts what some leaves hold by these leaves, of which leaf l begins at begin_of(l): halves it across the axis along
// which it is spread most, again and again.
template <class BeginOf>
void sort_by_leaves(std::span<Middle> all, const BeginOf& begin_of, std::size_t first_leaf, std::size_t leaves) {
  if (leaves < 2) return;
  const std::size_t begin = begin_of(first_leaf);
  const std::span<Middle> here = all.subspan(begin, begin_of(first_leaf + leaves) - begin);
  const auto middle = here.begin() + static_cast<std::ptrdiff_t>(begin_of(first_leaf + leaves / 2) - begin);
  if (middle != here.end()) {
    Point3 low = here[0].at, high = low;
    for (const Middle& m : here) {
      low = {std::min(low.x, m.at.x), std::min(low.y, m.at.y), std::min(low.z, m.at.z)};
      high = {std::max(high.x, m.at.x), std::max(high.y, m.at.y), std::max(high.z, m.at.z)};
    }
    const Point3 extent{high.x / 2 - low.x / 2, high.y / 2 - low.y / 2, high.z / 2 - low.z / 2};  // does not overflow
    if (extent.z > extent.x && extent.z > extent.y) {
      halve<&Point3::z>(here, middle);
    } else if (extent.y > extent.x) {
      halve<&Point3::y>(here, middle);
    } else {
      halve<&Point3::x>(here, middle);
    }
  }
  sort_by_leaves(all, begin_of, first_leaf, leaves / 2);
  sort_by_leaves(all, begin_of, first_leaf + leaves / 2, leaves / 2);
}

}  // namespace

MeshTree::MeshTree(std::span<const Point3> points, std::span<const std::array<std::uint32_t, 3>> triangles,
                   std::vector<std::uint32_t>& order)
    : size_(triangles.size()) {
  SUNDER_REQUIRE(triangles.size() < std::size_t{1} << 31);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  box_ = {{infinity, infinity, infinity}, {-infinity, -infinity, -infinity}};
  std::vector<Middle> middles;
  middles.reserve(triangles.size());
  for (std::uint32_t t = 0; t < triangles.size(); ++t) {
    const Point3 &p = points[triangles[t][0]], &q = points[triangles[t][1]], &r = points[triangles[t][2]];
    const Box3 box = hull(hull(Box3{p, p}, Box3{q, q}), Box3{r, r});
    box_ = hull(box_, box);
    middles.push_back(
        {{box.low.x / 2 + box.high.x / 2, box.low.y / 2 + box.high.y / 2, box.low.z / 2 + box.high.z / 2}, t});
  }
  double half = 0;
  for (std::size_t c = 0; c < 3 && !triangles.empty(); ++c) {
    middle_[c] = box_.low[c] / 2 + box_.high[c] / 2;
    half = std::max(half, box_.high[c] / 2 - box_.low[c] / 2);
  }
  unit_ = std::ldexp(1.0, half > 0x1p-1000 ? std::min(std::ilogb(half) + 1, 1023) : -1000);
  nodes_.resize(2 * std::bit_ceil(std::max<std::size_t>(1, (triangles.size() + leaf_size - 1) / leaf_size)));
  sort_by_leaves(std::span(middles), [&](std::size_t leaf) { return begin_of(leaf); }, 0, leaves());
  order.resize(triangles.size());
  std::transform(middles.begin(), middles.end(), order.begin(), [](const Middle& m) { return m.triangle; });
  for (std::size_t leaf = 0; leaf < leaves(); ++leaf) {
    std::sort(order.begin() + begin_of(leaf), order.begin() + begin_of(leaf + 1));
  }
  radius_ = std::sqrt(BoxesUpwards(*this, points, triangles, order, nodes_).run()) * unit_;
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

}  // namespace sunder::solid
