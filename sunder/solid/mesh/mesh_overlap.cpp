#include <sunder/base/interruption.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/mesh/mesh_mesh_internal.h>
#include <sunder/solid/mesh/mesh_overlap.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <initializer_list>
#include <limits>
#include <optional>
#include <variant>

namespace sunder::solid {

namespace {

Point3 image_about(const PlacedMesh& placed, std::uint32_t point) {
  const Vector3<double> at = rounded_image(placed.at(point));
  return {at.x, at.y, at.z};
}

// Across a triangle, of length 1; zero, where floating point finds no length.
Point3 normal_about(const PlacedMesh& placed, std::uint32_t triangle) {
  const Mesh::Triangle& corners = placed.mesh().triangles()[triangle];
  const Point3 p = image_about(placed, corners[0]), u = minus(image_about(placed, corners[1]), p),
               v = minus(image_about(placed, corners[2]), p);
  const Point3 n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
  const double length = std::hypot(n.x, n.y, n.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {n.x / length, n.y / length, n.z / length};
}

Point3 middle_about(const PlacedMesh& placed, std::uint32_t triangle) {
  Point3 middle;
  for (const std::uint32_t corner : placed.mesh().triangles()[triangle]) {
    const Point3 p = image_about(placed, corner);
    for (std::size_t c = 0; c < 3; ++c) middle[c] += p[c] / 3;
  }
  return middle;
}

bool is_finite(const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

// About the way from one to the other, of length 1 at most.
Point3 way_to(const Point3& from, const Point3& to) {
  const Point3 way = minus(to, from);
  const double length = std::hypot(way.x, way.y, way.z);
  if (!(length > 0) || !std::isfinite(length)) return {};
  return {way.x / length, way.y / length, way.z / length};
}

double longest_edge(const PlacedMesh& placed, std::uint32_t triangle) {
  double longest = 0;
  const Mesh::Triangle& corners = placed.mesh().triangles()[triangle];
  for (std::size_t k = 0; k < 3; ++k) {
    const Point3 edge = minus(image_about(placed, corners[k]), image_about(placed, corners[(k + 1) % 3]));
    longest = std::max(longest, std::hypot(edge.x, edge.y, edge.z));
  }
  return longest;
}

class PointSearch {
 public:
  PointSearch(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b)
      : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), placed_a_(a, pose_a), placed_b_(b, pose_b) {}

  // Near what two triangles have in common: into either mesh, as far as their triangles tell, and to the middles of both.
  // Beside the middle of each, where they are in one plane.
  void near(const MeetingTriangles& meeting) {
    const Point3 u = normal_about(placed_a_, meeting.of_a), v = normal_about(placed_b_, meeting.of_b);
    const std::optional<Point3> middle = middle_of_crossing(meeting, u, v);
    if (!middle) {
      beside_middle(placed_a_, meeting.of_a);
      beside_middle(placed_b_, meeting.of_b);
      return;
    }
    const Point3 at = *middle, to_a = way_to(at, middle_about(placed_a_, meeting.of_a)),
                 to_b = way_to(at, middle_about(placed_b_, meeting.of_b));
    const double size = std::min(longest_edge(placed_a_, meeting.of_a), longest_edge(placed_b_, meeting.of_b));
    // Between the planes of both there are four wedges. Along the middle of one, so that thin ones are found, too.
    const Point3 sum{u.x + v.x, u.y + v.y, u.z + v.z}, across = minus(u, v);
    const double times_sum = 1 / std::max(std::sqrt(dot(sum, sum)), 0x1p-20), off = std::min(1.0, 1 / times_sum) / 16;
    Ways ways;
    for (std::size_t c = 0; c < 3; ++c) {
      const double aside = off * (to_a[c] + to_b[c]);
      ways[0][c] = aside - times_sum * sum[c];
      ways[1][c] = aside - across[c];
      ways[2][c] = aside + across[c];
      ways[3][c] = aside + times_sum * sum[c];
    }
    look_beside(at, ways, size, {3, 13, 30});
  }

  // Near a corner of one that is inside of the other: to the middle of a triangle that has it, and to either side.
  void near(const PointWithin& within) {
    const PlacedMesh& of = within.is_of_a ? placed_a_ : placed_b_;
    const auto triangles = of.mesh().triangles();
    const auto has_corner = [&](const Mesh::Triangle& t) {
      return std::find(t.begin(), t.end(), within.point) != t.end();
    };
    const auto found = std::find_if(triangles.begin(), triangles.end(), has_corner) - triangles.begin();
    const auto triangle = static_cast<std::uint32_t>(found);
    const Point3 at = image_about(of, within.point), n = normal_about(of, triangle);
    const Point3 way = way_to(at, middle_about(of, triangle));
    Ways ways{};
    for (std::size_t c = 0; c < 3; ++c) {
      ways[0][c] = way[c] - n[c] / 8;
      ways[3][c] = way[c] + n[c] / 8;
    }
    look_beside(at, ways, longest_edge(of, triangle), {3, 13, 30});
  }

  // Beside the middles of triangles of one, for a point that is inside of it alone.
  void beside_middles(bool is_of_a) {
    const PlacedMesh &of = is_of_a ? placed_a_ : placed_b_, &other = is_of_a ? placed_b_ : placed_a_;
    const bool& is_found = is_of_a ? points_.found.only_a : points_.found.only_b;
    const auto all = static_cast<std::uint32_t>(of.mesh().triangles().size()), triangles = std::min(16u, all);
    const double size = longest_side(of.node_box(1));
    for (std::uint32_t k = 0; k < triangles && !is_found; ++k) {
      const auto t = static_cast<std::uint32_t>(std::uint64_t{k} * all / triangles);
      const Point3 at = middle_about(of, t), n = normal_about(of, t);
      if (!is_finite(at) || mesh_point(other.mesh(), other.pose(), at).place != MeshPlace::outside) continue;
      look_beside(at, {Point3{-n.x, -n.y, -n.z}, {}, {}, n}, size, {4, 16, 28, 40});
    }
  }

  const PointsInside& points() const { return points_; }

 private:
  void beside_middle(const PlacedMesh& of, std::uint32_t triangle) {
    const Point3 n = normal_about(of, triangle);
    look_beside(middle_about(of, triangle), {Point3{-n.x, -n.y, -n.z}, {}, {}, n}, longest_edge(of, triangle), {3, 13});
  }

  // The first and the last may go into both, the others to either side of one. Those that are zero are not gone.
  using Ways = std::array<Point3, 4>;

  // Steps are the size times 2^-exponent.
  void look_beside(const Point3& at, const Ways& ways, double size, std::initializer_list<int> exponents) {
    std::array<bool, 4> has_told{};
    for (const int exponent : exponents) {
      const double step = std::ldexp(size, -exponent);
      for (const std::size_t k : {0u, 1u, 2u, 3u}) {
        const Point3& way = ways[k];
        if ((has_told[k] && k % 3 != 0) || dot(way, way) == 0) continue;
        has_told[k] = tells({at.x + step * way.x, at.y + step * way.y, at.z + step * way.z});
        if (points_.found.are_all()) return;
      }
    }
  }

  // About the middle of the segment that two triangles have in common, whose normals are given; nothing, where they are
  // about in one plane, or floating point finds none.
  std::optional<Point3> middle_of_crossing(const MeetingTriangles& meeting, const Point3& u, const Point3& v) const {
    const Point3 along = cross(u, v);
    if (!(dot(along, along) > 0x1p-20)) return std::nullopt;
    const Part a = part_in_plane(placed_a_, meeting.of_a, v, image_about(placed_b_, first_corner(b_, meeting.of_b)),
                                 along),
               b = part_in_plane(placed_b_, meeting.of_b, u, image_about(placed_a_, first_corner(a_, meeting.of_a)),
                                 along);
    const double from = std::max(a.low, b.low), to = std::min(a.high, b.high);
    if (!(from <= to && a.low < a.high)) return std::nullopt;
    const double t = ((from + to) / 2 - a.low) / (a.high - a.low);
    Point3 middle;
    for (std::size_t c = 0; c < 3; ++c) middle[c] = a.from[c] + t * (a.to[c] - a.from[c]);
    return middle;
  }

  // What of a triangle is in a plane, and how far its ends are along a way.
  struct Part {
    Point3 from, to;
    double low = std::numeric_limits<double>::infinity(), high = -std::numeric_limits<double>::infinity();
  };
  static Part part_in_plane(const PlacedMesh& placed, std::uint32_t triangle, const Point3& normal, const Point3& point,
                            const Point3& along) {
    Part part;
    const Mesh::Triangle& corners = placed.mesh().triangles()[triangle];
    for (std::size_t k = 0; k < 3; ++k) {
      const Point3 p = image_about(placed, corners[k]), q = image_about(placed, corners[(k + 1) % 3]);
      const double s = dot(normal, minus(p, point)), t = dot(normal, minus(q, point));
      if ((s < 0) == (t < 0)) continue;
      Point3 at;
      for (std::size_t c = 0; c < 3; ++c) at[c] = p[c] + s / (s - t) * (q[c] - p[c]);
      const double height = dot(along, at);
      if (height < part.low) part.low = height, part.from = at;
      if (height > part.high) part.high = height, part.to = at;
    }
    return part;
  }
  static std::uint32_t first_corner(const Mesh& mesh, std::uint32_t triangle) { return mesh.triangles()[triangle][0]; }

  // Is it inside of one?
  bool tells(const Point3& p) {
    may_be_interrupted(10);
    if (!is_finite(p)) return false;
    const MeshPlace in_a = mesh_point(a_, pose_a_, p).place;
    if (in_a == MeshPlace::on) return false;
    const MeshPlace in_b = mesh_point(b_, pose_b_, p).place;
    if (in_b == MeshPlace::on || in_a == in_b) {
      if (in_a != MeshPlace::inside || in_b != MeshPlace::inside) return false;
      if (!points_.in_both) points_.in_both = p;
      points_.found.both = true;
      return true;
    }
    (in_a == MeshPlace::inside ? points_.found.only_a : points_.found.only_b) = true;
    return true;
  }

  const Mesh &a_, &b_;
  const Pose &pose_a_, &pose_b_;
  PlacedMesh placed_a_, placed_b_;
  PointsInside points_;
};

}  // namespace

PointsInside points_inside(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b,
                           const MeshEvidence& evidence) {
  if (!a.has_inside() || !b.has_inside()) return {};
  PointSearch search(a, pose_a, b, pose_b);
  if (const auto* within = std::get_if<PointWithin>(&evidence)) search.near(*within);
  if (const auto* meeting = std::get_if<MeetingTriangles>(&evidence)) search.near(*meeting);
  if (!a.is_closed() || !b.is_closed()) {
    int pairs = 4;
    Cost cost;
    StageTally tally;
    const auto look = [&](const MeetingTriangles& meeting) {
      search.near(meeting);
      return search.points().found.both || --pairs == 0;
    };
    if (!search.points().found.both)
      any_meeting_triangles(PlacedMesh(a, pose_a), PlacedMesh(b, pose_b), cost, tally, look);
    return search.points();
  }
  for (const bool is_of_a : {true, false}) search.beside_middles(is_of_a);
  return search.points();
}

bool has_inside_beside(const Mesh& mesh, const Pose& pose, std::uint32_t triangle) {
  const PlacedMesh placed(mesh, pose);
  const Point3 at = middle_about(placed, triangle), n = normal_about(placed, triangle);
  const double step = std::ldexp(longest_side(placed.node_box(1)), -30);
  for (const double way : {-step, step}) {
    const Point3 p{at.x + way * n.x, at.y + way * n.y, at.z + way * n.z};
    if (is_finite(p) && mesh_point(mesh, pose, p).place == MeshPlace::inside) return true;
  }
  return false;
}

}  // namespace sunder::solid
