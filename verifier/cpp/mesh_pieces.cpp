// Which triangles of a mesh belong together, and which of them bound an inside: docs/claims.md, "Meshes".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/sentences.h>
#include <verifier/cpp/tables.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <numeric>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// Numbers that are in one class with others.
class Classes {
 public:
  explicit Classes(std::size_t count) : next_(count) { std::iota(next_.begin(), next_.end(), std::size_t{0}); }

  std::size_t of(std::size_t k) {
    std::size_t top = k;
    while (next_[top] != top) top = next_[top];
    while (next_[k] != top) k = std::exchange(next_[k], top);
    return top;
  }
  void unite(std::size_t i, std::size_t j) { next_[of(i)] = of(j); }

 private:
  std::vector<std::size_t> next_;
};

// How often triangles go along an edge from its first point to its last, and back.
struct Edge {
  std::size_t first, last;
  std::int64_t there = 0, back = 0;
};

// An edge on its line: from one place to another, with a point of it.
struct Stretch {
  Integer from, to;
  std::int64_t there, back;
  std::size_t point;
};

// Those along which triangles do not go as often there as back.
std::vector<Edge> uneven_edges(const std::vector<MeshTriangle>& triangles) {
  std::vector<Edge> edges;
  for (const MeshTriangle& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t i = t[k], j = t[after(k, 3)];
      if (i < j) edges.push_back({i, j, 1, 0});
      if (i > j) edges.push_back({j, i, 0, 1});
    }
  }
  const auto ends = [](const Edge& edge) { return std::pair(edge.first, edge.last); };
  std::sort(edges.begin(), edges.end(), [&](const Edge& e, const Edge& f) { return ends(e) < ends(f); });
  std::vector<Edge> uneven;
  for (auto edge = edges.begin(); edge != edges.end();) {
    Edge sum{edge->first, edge->last};
    for (; edge != edges.end() && ends(*edge) == ends(sum); ++edge) {
      sum.there += edge->there;
      sum.back += edge->back;
    }
    if (sum.there != sum.back) uneven.push_back(sum);
  }
  return uneven;
}

// A direction of a line, and the vector product with it of a point on the line: the same for all its edges.
std::pair<Integers, Integers> line_through(const Integers& p, const Integers& q) {
  Integers way = reduced(minus(q, p));
  const auto first = std::find_if(way.begin(), way.end(), [](const Integer& n) { return n != 0; });
  if (*first < 0) way = opposite(std::move(way));
  Integers moment = cross(p, way);
  return {std::move(way), std::move(moment)};
}

std::map<std::pair<Integers, Integers>, std::vector<Stretch>> by_lines(const std::vector<Edge>& edges,
                                                                       const std::vector<Integers>& points) {
  std::map<std::pair<Integers, Integers>, std::vector<Stretch>> lines;
  for (const Edge& edge : edges) {
    auto line = line_through(points[edge.first], points[edge.last]);
    Stretch stretch{dot(line.first, points[edge.first]), dot(line.first, points[edge.last]), edge.there, edge.back,
                    edge.first};
    if (stretch.to < stretch.from) {
      std::swap(stretch.from, stretch.to);
      std::swap(stretch.there, stretch.back);
    }
    lines[std::move(line)].push_back(std::move(stretch));
  }
  return lines;
}

// Unites edges that have a part in common.
void unite_overlapping(std::vector<Stretch>& on_line, Classes& classes) {
  std::sort(on_line.begin(), on_line.end(), [](const Stretch& s, const Stretch& t) { return s.from < t.from; });
  const Stretch* furthest = on_line.data();
  for (const Stretch& stretch : on_line) {
    if (stretch.from < furthest->to) classes.unite(stretch.point, furthest->point);
    if (stretch.to > furthest->to) furthest = &stretch;
  }
}

enum Kind : std::uint8_t { oriented, unoriented, open };

// The worst kind of a part of the edges on a line, for each of the points that they know.
void judge(const std::vector<Stretch>& on_line, Classes& classes, std::map<std::size_t, Kind>& kinds) {
  std::map<Integer, std::vector<std::pair<const Stretch*, int>>> places;
  for (const Stretch& stretch : on_line) {
    places[stretch.from].emplace_back(&stretch, 1);
    places[stretch.to].emplace_back(&stretch, -1);
  }
  std::int64_t there = 0, back = 0;
  for (const auto& [place, changes] : places) {
    for (const auto& [stretch, way] : changes) {
      there += way * stretch->there;
      back += way * stretch->back;
    }
    if (there == back) continue;
    Kind& kind = kinds[classes.of(changes.front().first->point)];
    kind = std::max(kind, (there + back) % 2 == 0 ? unoriented : open);
  }
}

}  // namespace

MeshPieces pieces_of(std::vector<MeshTriangle> triangles, const std::vector<Integers>& points) {
  Classes classes(points.size());
  for (const MeshTriangle& t : triangles) {
    classes.unite(t[0], t[1]);
    classes.unite(t[0], t[2]);
  }
  auto lines = by_lines(uneven_edges(triangles), points);
  for (auto& [line, on_line] : lines) unite_overlapping(on_line, classes);
  std::map<std::size_t, Kind> kinds;
  for (const auto& [line, on_line] : lines) judge(on_line, classes, kinds);
  MeshPieces result;
  for (const MeshTriangle& t : triangles) {
    const std::size_t piece = classes.of(t[0]);
    const auto kind = kinds.find(piece);
    result.piece.push_back(piece);
    result.is_closed.push_back(kind == kinds.end() || kind->second != open);
    if (result.is_closed.back()) ++result.closed;
  }
  result.by_winding =
      std::none_of(kinds.begin(), kinds.end(), [](const auto& kind) { return kind.second == unoriented; });
  result.triangles = std::move(triangles);
  return result;
}

std::string MeshBody::title() const {
  const char* const one = is_image() ? "mapped triangle" : "triangle";
  const std::size_t open = pieces->triangles.size() - pieces->closed;
  std::string text;
  if (pieces->closed > 0) {
    text =
        std::string(pieces->by_winding ? "the solid of " : "the solid, by parity, of ") + counted(pieces->closed, one);
  }
  if (open > 0) text += (text.empty() ? "the surface of " : " and the surface of ") + counted(open, one);
  return text + " of " + quoted;
}

}  // namespace sunder_verifier
