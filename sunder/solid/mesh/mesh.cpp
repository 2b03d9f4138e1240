#include <sunder/solid/mesh/mesh.h>

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/base/names.h>
#include <sunder/near/box_tree.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/mesh/face_triangles.h>
#include <sunder/solid/mesh/mesh_sides.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>
#include <type_traits>
#include <utility>

namespace sunder::solid {

namespace {

// Which numbers belong together. Also called: union-find.
class Joined {
 public:
  explicit Joined(std::size_t size) : parent_(size) { std::iota(parent_.begin(), parent_.end(), 0u); }

  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  void join(std::uint32_t i, std::uint32_t j) {
    i = find(i);
    j = find(j);
    parent_[std::max(i, j)] = std::min(i, j);
  }

 private:
  std::vector<std::uint32_t> parent_;
};

// An edge, or a part of one: how often triangles go from its lower to its higher end, and back.
struct EdgeCount {
  std::uint32_t low = 0, high = 0;
  std::int64_t there = 0, back = 0;

  std::pair<std::uint32_t, std::uint32_t> ends() const { return {low, high}; }
  bool is_balanced() const { return there == back; }
  bool is_even() const { return (there + back) % 2 == 0; }
};

// Those of equal ends as one.
void merge(std::vector<EdgeCount>& edges) {
  std::sort(edges.begin(), edges.end(), [](const EdgeCount& e, const EdgeCount& f) { return e.ends() < f.ends(); });
  std::size_t kept = 0;
  for (const EdgeCount& e : edges) {
    if (kept > 0 && edges[kept - 1].ends() == e.ends()) {
      edges[kept - 1].there += e.there;
      edges[kept - 1].back += e.back;
    } else {
      edges[kept++] = e;
    }
  }
  edges.resize(kept);
}

// The edges that are not balanced, in the order of their ends: all are put with their lower end, where those of equal
// ends are counted.
std::vector<EdgeCount> unbalanced_edges(std::size_t points, std::span<const Mesh::Triangle> triangles) {
  const auto for_each_edge = [&](const auto& of_edge) {
    for (const auto& [a, b, c] : triangles) {
      if (a != b) of_edge(a, b);
      if (b != c) of_edge(b, c);
      if (c != a) of_edge(c, a);
    }
  };
  std::vector<std::size_t> end(points + 1, 0);  // of those of each point; at first where they begin
  for_each_edge([&](std::uint32_t from, std::uint32_t to) { ++end[std::min(from, to) + 1]; });
  std::partial_sum(end.begin(), end.end(), end.begin());
  std::vector<std::uint32_t> others(end.back());  // twice the higher end, and 1 where the edge comes back from there
  for_each_edge([&](std::uint32_t from, std::uint32_t to) {
    others[end[std::min(from, to)]++] = 2 * std::max(from, to) + (from < to ? 0 : 1);
  });
  std::vector<EdgeCount> edges;
  std::size_t first = 0;
  for (std::uint32_t low = 0; low < points; ++low) {
    std::sort(others.begin() + static_cast<std::ptrdiff_t>(first),
              others.begin() + static_cast<std::ptrdiff_t>(end[low]));
    while (first < end[low]) {
      EdgeCount edge{low, others[first] / 2, 0, 0};
      for (; first < end[low] && others[first] / 2 == edge.high; ++first)
        ++(others[first] % 2 == 0 ? edge.there : edge.back);
      if (!edge.is_balanced()) edges.push_back(edge);
    }
  }
  return edges;
}

struct EdgeCut {
  std::uint32_t edge, point;
};

// Cuts each edge at the ends of others on its line that lie inside it. The edges are those that are not balanced.
std::vector<EdgeCut> cuts_of(std::span<const Point3> points, std::span<const EdgeCount> edges) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;  // one of an edge, and the other one
  std::vector<Box3> boxes;
  for (const EdgeCount& e : edges) {
    ends.emplace_back(e.low, e.high);
    ends.emplace_back(e.high, e.low);
    boxes.push_back(hull(Box3{points[e.low], points[e.low]}, {points[e.high], points[e.high]}));
  }
  std::sort(ends.begin(), ends.end());
  std::vector<EdgeCut> cuts;
  if (edges.empty()) return cuts;
  const BoxTree tree(boxes);
  for (auto begin = ends.begin(), end = begin; begin != ends.end(); begin = end) {
    may_be_interrupted(100);
    const std::uint32_t p = begin->first;
    end = std::find_if(begin, ends.end(), [p](const auto& each) { return each.first != p; });
    tree.for_each_meeting({points[p], points[p]}, BoxTree::no_group, [&](std::uint32_t k) {
      const EdgeCount& e = edges[k];
      const auto is_on_line = [&](std::uint32_t q) { return are_collinear(points[e.low], points[e.high], points[q]); };
      if (p == e.low || p == e.high || !is_on_line(p)) return;
      // On its line and in its box, it is inside the edge.
      if (std::any_of(begin, end, [&](const auto& each) { return is_on_line(each.second); })) cuts.push_back({k, p});
    });
  }
  return cuts;
}

// The parts of the edges between their cuts, merged.
std::vector<EdgeCount> cut_edges(std::span<const Point3> points, std::span<const EdgeCount> edges,
                                 std::vector<EdgeCut> cuts) {
  const auto is_before = [&](const Point3& from, const Point3& p, const Point3& q) {  // on one line, from its end
    for (std::size_t c = 0; c < 3; ++c) {
      if (p[c] != q[c]) return (p[c] < q[c]) == (from[c] <= p[c]);
    }
    return false;
  };
  std::sort(cuts.begin(), cuts.end(), [&](const EdgeCut& a, const EdgeCut& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    return is_before(points[edges[a.edge].low], points[a.point], points[b.point]);
  });
  std::vector<EdgeCount> parts;
  std::size_t next = 0;
  for (std::uint32_t k = 0; k < edges.size(); ++k) {
    std::uint32_t from = edges[k].low;
    const auto add = [&](std::uint32_t to) {
      const bool is_same = from < to;
      parts.push_back({std::min(from, to), std::max(from, to), is_same ? edges[k].there : edges[k].back,
                       is_same ? edges[k].back : edges[k].there});
      from = to;
    };
    for (; next < cuts.size() && cuts[next].edge == k; ++next) add(cuts[next].point);
    add(edges[k].high);
  }
  merge(parts);
  return parts;
}

// Throws Error where a number is not finite, or a face names no vertex.
void require_whole(const MeshView& given) {
  for (const Point3& p : given.vertices) {
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    throw Error(ErrorCode::bad_value, "a coordinate is not finite; give finite ones",
                "vertex " + std::to_string(&p - given.vertices.data()));
  }
  for (std::uint32_t face = 0; face < given.polygon_count(); ++face) {
    const std::span<const std::uint32_t> corners = given.polygon(face);
    if (corners.empty())
      throw Error(ErrorCode::bad_shape, "it has no corner; leave it out", "face " + std::to_string(face));
    for (const std::uint32_t corner : corners) {
      if (corner < given.vertices.size()) continue;
      throw Error(ErrorCode::bad_shape, "it names vertex " + std::to_string(corner) + ", which is not there",
                  "face " + std::to_string(face));
    }
  }
}

}  // namespace

std::string_view name_of(PieceKind kind) { return name_in<PieceKind::open>({"oriented", "unoriented", "open"}, kind); }

Mesh::Mesh(const MeshView& given) {
  if (given.polygon_count() == 0) throw Error(ErrorCode::bad_shape, "the mesh has no face; give one that has");
  require_whole(given);
  const MeshCorners topology(given);
  std::vector<std::uint32_t> number(given.vertices.size(), 0);  // of a point, plus 1; 0: not a corner yet
  const auto point_of = [&](std::uint32_t vertex) {
    if (number[vertex] == 0) {
      points_.push_back(given.vertices[vertex]);
      number[vertex] = static_cast<std::uint32_t>(points_.size());
    }
    return number[vertex] - 1;
  };
  triangles_.reserve(given.polygon_count());
  face_of_.reserve(given.polygon_count());
  std::vector<std::uint32_t> corners;
  for (std::uint32_t face = 0; face < given.polygon_count(); ++face) {
    may_be_interrupted(10);
    corners.clear();
    for (const std::uint32_t v : topology.corners_of(face)) corners.push_back(point_of(v));
    if (corners.size() < 3) {
      triangles_.push_back({corners.front(), corners.back(), corners.back()});
    } else if (corners.size() == 3) {
      triangles_.push_back({corners[0], corners[1], corners[2]});
    } else {
      const FaceTriangles of_face = face_triangles(points_, corners);
      triangles_.insert(triangles_.end(), of_face.triangles.begin(), of_face.triangles.end());
      if (of_face.crosses_itself) crossing_faces_.push_back(face);
    }
    face_of_.resize(triangles_.size(), face);
  }
  find_pieces();
  sizes_ = size_range(points_);
  std::vector<std::uint32_t> order;
  tree_ = MeshTree(points_, triangles_, order);
  const auto in_order = [&order](const auto& items) {
    std::remove_cvref_t<decltype(items)> result;
    result.reserve(items.size());
    for (const std::uint32_t k : order) result.push_back(items[k]);
    return result;
  };
  triangles_ = in_order(triangles_);
  face_of_ = in_order(face_of_);
  piece_of_ = in_order(piece_of_);
  for (std::uint32_t t = static_cast<std::uint32_t>(triangles_.size()); t-- > 0;) pieces_[piece_of_[t]].first = t;
  find_repeated();
}

// Triangles are kept by a number that their corners make, and compared with those of the same number.
void Mesh::find_repeated() {
  constexpr std::uint32_t none = 0xffffffff;
  const std::size_t all = triangles_.size();
  std::vector<std::uint32_t> last_of(all, none), before(all, none);
  const auto sorted = [](Triangle t) {
    std::sort(t.begin(), t.end());
    return t;
  };
  for (std::uint32_t t = 0; t < all; ++t) {
    const Triangle corners = sorted(triangles_[t]);
    const auto& [i, j, k] = corners;
    has_needles_ = has_needles_ || are_collinear(points_[i], points_[j], points_[k]);
    if (i == j || j == k) continue;
    std::uint64_t number = i;
    for (const std::uint64_t corner : {j, k}) number = number * 0x9e3779b97f4a7c15 + (number >> 32) + corner;
    std::uint32_t& last = last_of[(number >> 32 ^ number) % all];
    std::uint32_t other = last;
    while (other != none && sorted(triangles_[other]) != corners) other = before[other];
    if (other != none) repeated_triangles_.push_back(t);
    before[t] = std::exchange(last, t);
  }
}

// By their points; then what kind each is.
void Mesh::find_pieces() {
  const std::vector<EdgeCount> edges = unbalanced_edges(points_.size(), triangles_);
  const std::vector<EdgeCut> cuts = cuts_of(points_, edges);
  Joined joined(points_.size());
  for (const Triangle& t : triangles_) {
    joined.join(t[0], t[1]);
    joined.join(t[0], t[2]);
  }
  for (const EdgeCut& cut : cuts) joined.join(edges[cut.edge].low, cut.point);
  constexpr std::uint32_t none = 0xffffffff;
  std::vector<std::uint32_t> piece_of_root(points_.size(), none);
  piece_of_.reserve(triangles_.size());
  for (std::uint32_t t = 0; t < triangles_.size(); ++t) {
    std::uint32_t& piece = piece_of_root[joined.find(triangles_[t][0])];
    if (piece == none) {
      piece = static_cast<std::uint32_t>(pieces_.size());
      pieces_.push_back({PieceKind::oriented, t, 0, 0, 0});
    }
    piece_of_.push_back(piece);
    ++pieces_[piece].triangles;
  }
  const auto piece_at = [&](std::uint32_t point) -> Piece& { return pieces_[piece_of_root[joined.find(point)]]; };
  for (const EdgeCut& cut : cuts) ++piece_at(cut.point).t_junctions;
  for (const EdgeCount& e : cut_edges(points_, edges, cuts)) {
    Piece& piece = piece_at(e.low);
    if (!e.is_even()) ++piece.open_edges;
    if (!e.is_balanced()) piece.kind = std::max(piece.kind, e.is_even() ? PieceKind::unoriented : PieceKind::open);
  }
  is_by_winding_ = std::none_of(pieces_.begin(), pieces_.end(),
                                [](const Piece& piece) { return piece.kind == PieceKind::unoriented; });
}

bool Mesh::is_closed() const {
  return std::none_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.kind == PieceKind::open; });
}

bool Mesh::has_inside() const {
  return std::any_of(pieces_.begin(), pieces_.end(), [](const Piece& p) { return p.kind != PieceKind::open; });
}

Mesh mesh_of(const ConvexPolyhedron& body) {
  std::vector<std::uint32_t> begin{0}, corners;
  const auto end_face = [&] { begin.push_back(static_cast<std::uint32_t>(corners.size())); };
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    corners.insert(corners.end(), facet.begin(), facet.end());
    end_face();
  }
  if (body.facet_count() == 0) {
    for (std::uint32_t v = 0; v < body.vertices().size(); ++v) corners.push_back(v);
    end_face();
  }
  return Mesh(MeshView{body.vertices(), begin, corners});
}

}  // namespace sunder::solid
