#include <sunder/base/contract.h>
#include <sunder/number/vector.h>
#include <sunder/predicate/along.h>
#include <sunder/predicate/orient.h>
#include <sunder/predicate/posed.h>
#include <sunder/solid/represent/hierarchy.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

// A vertex w is taken away with its star, whose rim is a cycle of at most most_degree vertices, and the hull of the
// others has a patch over the rim. No two that go at once are adjacent, so their patches have no triangle in common.
//
// P1. The patch has the rim's vertices and no others: what it covers of the old surface is the star, where no other
//     vertex is, and all vertices are extreme.
// P2. A triangle of the patch at an edge is one that no other vertex of the rim is above. It is found by going through
//     them, as around the edge they lie within half a turn.
// P3. Where several are in its plane, any of them will do: those of the rim in one plane are the corners of one convex
//     polygon, all of it in the patch. For the facet in that plane had w as a corner before, and the star's part of it
//     without w is convex; or there was no facet in that plane.
// P4. The four vertices of the tetrahedron stay, so there is always an inside.

namespace sunder::solid {

namespace {

constexpr std::uint32_t none = Hierarchy::none;

constexpr std::uint32_t after(std::uint32_t place) { return place == 2 ? 0 : place + 1; }
constexpr std::uint32_t before(std::uint32_t place) { return place == 0 ? 2 : place - 1; }

struct Face {
  std::array<std::uint32_t, 3> corner;    // counter-clockwise from outside
  std::array<std::uint32_t, 3> adjacent;  // beyond the edge from corner[i] to corner[i + 1]
  std::uint32_t beyond = none;            // the vertex whose going made it

  std::uint32_t place_of(std::uint32_t v) const { return corner[0] == v ? 0 : corner[1] == v ? 1 : 2; }
};

// A hierarchy in the making: takes vertex numbers, and holds ranks, the last that went first.
struct History {
  Hierarchy hierarchy;
  std::vector<std::uint32_t> rank;  // of a vertex

  History(std::span<const Point3> points, std::span<const std::uint32_t> last, std::span<const std::uint32_t> taken,
          std::vector<std::uint32_t> level_end)
      : rank(points.size()) {
    hierarchy.level_end = std::move(level_end);
    hierarchy.nodes.resize(points.size());
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      Hierarchy::Node& node = hierarchy.nodes[k];
      node.vertex = k < last.size() ? last[k] : taken[points.size() - 1 - k];
      node.at = points[node.vertex];
      rank[node.vertex] = k;
    }
  }

  void add(std::uint32_t to_star_of, const Hierarchy::Triangle& t) {
    Hierarchy::Node& node = hierarchy.nodes[rank[to_star_of]];
    node.around[node.size++] = {rank[t.a], t.b == none ? none : rank[t.b], t.beyond == none ? none : rank[t.beyond]};
  }
};

class Builder {
 public:
  Builder(std::span<const Point3> points, std::span<const std::uint32_t> facet_begin,
          std::span<const std::uint32_t> facet_vertices)
      : points_(points), face_of_(points.size(), none), degree_(points.size(), 0), blocked_(points.size(), 0) {
    const SizeRange of_identity{1, 1};
    images_are_tame_ = images_are_tame(of_identity, {}, size_range(points));
    stretch_ = {stretch_along(&Point3::x), stretch_along(&Point3::y), stretch_along(&Point3::z)};
    triangulate(facet_begin, facet_vertices);
    choose_tetrahedron();
  }

  Hierarchy run() {
    const std::uint32_t n = static_cast<std::uint32_t>(points_.size());
    for (std::uint32_t v = 0; v < n; ++v) middle_.push_back(middle_of(v));
    std::vector<std::uint32_t> here(n);
    std::iota(here.begin(), here.end(), 0u);
    std::vector<std::uint32_t> level_end;
    while (here.size() > 4) {
      level_end.push_back(static_cast<std::uint32_t>(here.size()));
      here = take_away(here);
    }
    level_end.push_back(4);
    std::reverse(level_end.begin(), level_end.end());
    return history(here, std::move(level_end));
  }

 private:
  // The fan from the first vertex of each facet.
  void triangulate(std::span<const std::uint32_t> facet_begin, std::span<const std::uint32_t> facet_vertices) {
    faces_.reserve(2 * points_.size());
    for (std::size_t f = 0; f + 1 < facet_begin.size(); ++f) {
      const auto cycle = facet_vertices.subspan(facet_begin[f], facet_begin[f + 1] - facet_begin[f]);
      for (std::size_t k = 1; k + 1 < cycle.size(); ++k) {
        const std::uint32_t t = static_cast<std::uint32_t>(faces_.size());
        faces_.push_back(
            {{cycle[0], cycle[k], cycle[k + 1]}, {k > 1 ? t - 1 : none, none, k + 2 < cycle.size() ? t + 1 : none}});
        enter(t);
      }
    }
    link_facets();
  }

  // A face that is new, with its corners.
  void enter(std::uint32_t t) {
    for (const std::uint32_t v : faces_[t].corner) {
      face_of_[v] = t;
      ++degree_[v];
    }
  }

  // Each edge between two facets is there once from each: they are brought together at its lower end.
  void link_facets() {
    struct Edge {
      std::uint32_t to, face, place;
    };
    const auto for_each_edge = [&](const auto& take) {
      for (std::uint32_t t = 0; t < faces_.size(); ++t) {
        for (const std::uint32_t place : {0u, 1u, 2u}) {
          if (faces_[t].adjacent[place] != none) continue;
          const auto [from, to] = std::minmax(faces_[t].corner[place], faces_[t].corner[after(place)]);
          take(from, Edge{to, t, place});
        }
      }
    };
    std::vector<std::uint32_t> begin(points_.size() + 1, 0);
    for_each_edge([&](std::uint32_t from, const Edge&) { ++begin[from + 1]; });
    std::partial_sum(begin.begin(), begin.end(), begin.begin());
    std::vector<Edge> edges(begin.back());
    std::vector<std::uint32_t> end(begin.begin(), begin.end() - 1);
    for_each_edge([&](std::uint32_t from, const Edge& edge) { edges[end[from]++] = edge; });
    for (std::size_t v = 0; v < points_.size(); ++v) {
      const auto first = edges.begin() + begin[v], last = edges.begin() + begin[v + 1];
      std::sort(first, last, [](const Edge& a, const Edge& b) { return a.to < b.to; });
      for (auto edge = first; edge != last; edge += 2) {
        faces_[edge[0].face].adjacent[edge[0].place] = edge[1].face;
        faces_[edge[1].face].adjacent[edge[1].place] = edge[0].face;
      }
    }
  }

  // Four vertices that span space, far from each other as far as doubles tell.
  void choose_tetrahedron() {
    const std::uint32_t n = static_cast<std::uint32_t>(points_.size());
    const auto furthest = [&](const auto& distance) {
      std::uint32_t best = 0;
      for (std::uint32_t v = 1; v < n; ++v) {
        if (distance(points_[v]) > distance(points_[best])) best = v;
      }
      return best;
    };
    const auto from = [](const Point3& a, const Point3& b) { return Point3{b.x - a.x, b.y - a.y, b.z - a.z}; };
    const auto length = [](const Point3& a) { return a.x * a.x + a.y * a.y + a.z * a.z; };
    const auto normal = [](const Point3& a, const Point3& b) {
      return Point3{a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
    };
    const std::uint32_t a = furthest([](const Point3& p) { return -p.x; });
    const std::uint32_t b = furthest([&](const Point3& p) { return length(from(points_[a], p)); });
    const Point3 ab = from(points_[a], points_[b]);
    const std::uint32_t c = furthest([&](const Point3& p) { return length(normal(ab, from(points_[a], p))); });
    const Point3 abc = normal(ab, from(points_[a], points_[c]));
    const std::uint32_t d = furthest([&](const Point3& p) {
      const Point3 q = from(points_[a], p);
      return std::fabs(abc.x * q.x + abc.y * q.y + abc.z * q.z);
    });
    tetrahedron_ = {a, b, c, d};
    if (orient_3d(points_[a], points_[b], points_[c], points_[d]) != Sign::zero) return;
    // The first facet, and the first vertex outside of its plane.
    const auto& [i, j, k] = faces_[0].corner;
    for (std::uint32_t v = 0; v < n; ++v) {
      if (orient_3d(points_[i], points_[j], points_[k], points_[v]) != Sign::zero) {
        tetrahedron_ = {i, j, k, v};
        return;
      }
    }
    SUNDER_REQUIRE(false);  // no interior
  }

  // A power of two.
  double stretch_along(double Point3::* axis) const {
    const auto [low, high] = std::minmax_element(points_.begin(), points_.end(),
                                                 [&](const Point3& p, const Point3& q) { return p.*axis < q.*axis; });
    const double size = (*high).*axis - (*low).*axis;
    return size > 0 && std::isfinite(size) ? std::ldexp(1.0, std::clamp(-std::ilogb(size), -1022, 1022)) : 1;
  }

  struct Middle {
    Point3 direction;
    std::uint32_t face = none;  // none: it is the direction
    std::array<std::uint32_t, 2> with{};
  };

  // Of the polyhedron with its axes stretched, so that it is about 1 long along each.
  Vector3<double> normal_of(std::uint32_t t) const {
    const auto& [i, j, k] = faces_[t].corner;
    return cross(edge(i, j), edge(i, k));
  }
  Vector3<double> edge(std::uint32_t from, std::uint32_t to) const {
    const Point3 &p = points_[from], &q = points_[to];
    return {(q.x - p.x) * stretch_.x, (q.y - p.y) * stretch_.y, (q.z - p.z) * stretch_.z};
  }
  Point3 of_polyhedron(const Vector3<double>& normal) const {
    return {normal.x * stretch_.x, normal.y * stretch_.y, normal.z * stretch_.z};
  }

  // The mean of the normals about v, if all of its neighbours are less far along it.
  Middle middle_of(std::uint32_t v) const {
    Vector3<double> sum{0, 0, 0};
    for_each_around(v, [&](std::uint32_t t, std::uint32_t) {
      const Vector3<double> n = normal_of(t);
      const double scale = 1 / std::sqrt(dot(n, n));
      sum = {sum.x + n.x * scale, sum.y + n.y * scale, sum.z + n.z * scale};
    });
    Middle middle{of_polyhedron(sum)};
    if (make_tame(middle.direction)) {
      const WorldDirection along_sum(middle.direction);
      const Affine3 identity;
      Along along(along_sum, identity, images_are_tame_);
      bool is_furthest = true;
      for_each_around(v, [&](std::uint32_t t, std::uint32_t place) {
        const Point3& neighbour = points_[faces_[t].corner[after(place)]];
        is_furthest = is_furthest && along.compare(points_[v], neighbour) == Sign::negative;
      });
      if (is_furthest) return middle;
    }
    const Face& face = faces_[face_of_[v]];
    const std::uint32_t place = face.place_of(v);
    const Vector3<double> n = normal_of(face_of_[v]);
    return {of_polyhedron(n), face_of_[v], {face.corner[after(place)], face.corner[before(place)]}};
  }

  // Takes an independent set of low degrees away; returns those that stay.
  std::vector<std::uint32_t> take_away(const std::vector<std::uint32_t>& here) {
    std::array<std::vector<std::uint32_t>, Hierarchy::most_degree + 1> by_degree;
    for (const std::uint32_t v : here) {
      if (degree_[v] <= Hierarchy::most_degree && !is_in_tetrahedron(v)) by_degree[degree_[v]].push_back(v);
    }
    ++round_;
    gone_.clear();
    for (const std::vector<std::uint32_t>& some : by_degree) {
      for (const std::uint32_t v : some) {
        if (blocked_[v] == round_) continue;
        gone_.push_back(v);
        blocked_[v] = round_;
        for_each_around(
            v, [&](std::uint32_t t, std::uint32_t place) { blocked_[faces_[t].corner[after(place)]] = round_; });
      }
    }
    for (const std::uint32_t v : gone_) take_away(v);
    std::vector<std::uint32_t> stay;
    for (const std::uint32_t v : here) {
      if (face_of_[v] != none) stay.push_back(v);
    }
    return stay;
  }

  // Calls take(face, place of v in it) counter-clockwise about v.
  template <class Take>
  void for_each_around(std::uint32_t v, const Take& take) const {
    std::uint32_t t = face_of_[v];
    do {
      const std::uint32_t place = faces_[t].place_of(v);
      take(t, place);
      t = faces_[t].adjacent[before(place)];
    } while (t != face_of_[v]);
  }

  void take_away(std::uint32_t w) {
    rim_.clear();
    beyond_rim_.clear();
    free_.clear();
    for_each_around(w, [&](std::uint32_t t, std::uint32_t place) {
      const Face& face = faces_[t];
      rim_.push_back(face.corner[after(place)]);
      beyond_rim_.push_back(face.adjacent[after(place)]);
      free_.push_back(t);
      triangles_.push_back({face.corner[after(place)], face.corner[before(place)], face.beyond});
    });
    taken_.push_back(w);
    end_.push_back(static_cast<std::uint32_t>(triangles_.size()));
    face_of_[w] = none;
    for (const std::uint32_t v : rim_) degree_[v] -= 2;
    const std::uint32_t last = static_cast<std::uint32_t>(rim_.size() - 1);
    link_beyond(last, fill(w, 0, last, beyond_rim_[last]));
  }

  // Edge i of the rim, from rim_[i] to the next, has this triangle inside.
  void link_beyond(std::uint32_t i, std::uint32_t inside) {
    Face& beyond = faces_[beyond_rim_[i]];
    beyond.adjacent[beyond.place_of(rim_[i + 1 < rim_.size() ? i + 1 : 0])] = inside;
  }

  // Fills the polygon rim_[i], ..., rim_[j], whose last edge, from rim_[j] to rim_[i], has `outer` beyond it. Returns
  // the triangle inside that edge, or what is beyond an edge of the rim.
  std::uint32_t fill(std::uint32_t w, std::uint32_t i, std::uint32_t j, std::uint32_t outer) {
    if (j == i + 1) {
      link_beyond(i, outer);
      return beyond_rim_[i];
    }
    std::uint32_t apex = i + 1;
    for (std::uint32_t k = i + 2; k < j; ++k) {
      if (is_above(rim_[j], rim_[i], rim_[apex], rim_[k])) apex = k;
    }
    const std::uint32_t t = free_.back();
    free_.pop_back();
    faces_[t] = {{rim_[j], rim_[i], rim_[apex]}, {outer, none, none}, w};
    enter(t);
    faces_[t].adjacent[1] = fill(w, i, apex, t);
    faces_[t].adjacent[2] = fill(w, apex, j, t);
    return t;
  }

  // Is x above the plane of a, b, c: on the side from which they are counter-clockwise?
  bool is_above(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t x) const {
    return orient_3d(points_[a], points_[b], points_[c], points_[x]) == Sign::positive;
  }

  bool is_in_tetrahedron(std::uint32_t v) const {
    return std::find(tetrahedron_.begin(), tetrahedron_.end(), v) != tetrahedron_.end();
  }

  Hierarchy history(const std::vector<std::uint32_t>& last, std::vector<std::uint32_t> level_end) const {
    History made(points_, last, taken_, std::move(level_end));
    for (Hierarchy::Node& node : made.hierarchy.nodes) {
      const Middle& middle = middle_[node.vertex];
      node.middle = middle.direction;
      if (middle.face == none) continue;
      node.middle_triangle = {made.rank[middle.with[0]], made.rank[middle.with[1]]};
    }
    // Of the tetrahedron: the triangle without its last vertex, and those about that one.
    const std::uint32_t top = last[3];
    const Face& base = faces_[faces_[face_of_[top]].adjacent[after(faces_[face_of_[top]].place_of(top))]];
    const std::uint32_t place = base.place_of(last[2]);
    made.add(last[2], {base.corner[after(place)], base.corner[before(place)], base.beyond});
    for_each_around(top, [&](std::uint32_t t, std::uint32_t at) {
      made.add(top, {faces_[t].corner[after(at)], faces_[t].corner[before(at)], faces_[t].beyond});
    });
    std::uint32_t t = 0;
    for (std::size_t k = 0; k < taken_.size(); ++k) {
      for (; t < end_[k]; ++t) made.add(taken_[k], triangles_[t]);
    }
    return std::move(made.hierarchy);
  }

  std::span<const Point3> points_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> face_of_;  // a face at each vertex; none where it went
  std::vector<std::uint32_t> degree_;
  std::vector<Middle> middle_;
  bool images_are_tame_;
  Point3 stretch_;
  std::array<std::uint32_t, 4> tetrahedron_{};

  std::vector<std::uint32_t> blocked_;  // the round in which a vertex or a neighbour of it went
  std::uint32_t round_ = 0;
  std::vector<std::uint32_t> gone_, rim_, beyond_rim_, free_;

  std::vector<std::uint32_t> taken_;              // in the order in which they went
  std::vector<std::uint32_t> end_;                // of the star of each
  std::vector<Hierarchy::Triangle> triangles_{};  // of the stars, with vertex numbers
};

// Of a polygon: every second vertex goes. The star of a vertex: the edges from the vertex before and to the one after.
Hierarchy flat_history(std::span<const Point3> points, std::span<const std::uint32_t> cycle) {
  struct Corner {
    std::uint32_t vertex, beyond;  // of the edge to the next
  };
  std::vector<Corner> here;
  for (const std::uint32_t v : cycle) here.push_back({v, none});
  std::vector<std::uint32_t> taken, level_end;
  std::vector<Hierarchy::Triangle> edges;
  while (here.size() > 3) {
    level_end.push_back(static_cast<std::uint32_t>(here.size()));
    std::vector<Corner> stay;
    const std::size_t going = std::min(here.size() / 2, here.size() - 3);
    for (std::size_t k = 0; k < here.size(); ++k) {
      if (k % 2 == 0 || k / 2 >= going) {
        stay.push_back(here[k]);
        continue;
      }
      edges.push_back({here[k - 1].vertex, none, here[k - 1].beyond});
      edges.push_back({here[k + 1 < here.size() ? k + 1 : 0].vertex, none, here[k].beyond});
      taken.push_back(here[k].vertex);
      stay.back().beyond = here[k].vertex;
    }
    here = std::move(stay);
  }
  level_end.push_back(3);
  std::reverse(level_end.begin(), level_end.end());
  std::vector<std::uint32_t> last;
  for (const Corner& corner : here) last.push_back(corner.vertex);
  History made(points, last, taken, std::move(level_end));
  for (const std::size_t k : {0u, 1u, 2u}) {  // each vertex of the triangle has both of its edges
    const Corner &previous = here[(k + 2) % 3], &next = here[(k + 1) % 3];
    made.add(here[k].vertex, {previous.vertex, none, previous.beyond});
    made.add(here[k].vertex, {next.vertex, none, here[k].beyond});
  }
  for (std::size_t k = 0; k < edges.size(); ++k) made.add(taken[k / 2], edges[k]);
  return std::move(made.hierarchy);
}

}  // namespace

std::size_t Hierarchy::memory() const {
  return nodes.capacity() * sizeof(Node) + level_end.capacity() * sizeof(level_end[0]);
}

Hierarchy make_hierarchy(std::span<const Point3> vertices, std::span<const std::uint32_t> facet_begin,
                         std::span<const std::uint32_t> facet_vertices) {
  if (facet_begin.size() == 3) return flat_history(vertices, facet_vertices.first(facet_begin[1]));
  return Builder(vertices, facet_begin, facet_vertices).run();
}

}  // namespace sunder::solid
