// Barba & Langerman 2015, section 2: a triangle inside a, the hull of three of its vertices (T_P), against one around
// b, the intersection of the half-planes of three of its edges (T_Q, which can be unbounded).
//
// If the triangles are apart, then a line along an edge of one of them parts them, through a vertex v of the inner one.
// One chain of a at most is beyond it: all other vertices are dropped. If none is, the line parts a and b.
// If they have common points, then these are in the hull H of the three edges (so a and b meet), or they are all in one
// of the three pieces that H leaves of the outer triangle: the edges beside the other two are dropped.
//   - The invariant: with V the vertices and E the edges left, a and b meet iff the hull of V meets the hull of E. (The
//     paper says: meets an edge of E. Then b inside a would be lost.)
//   - Where the line has those vertices beyond it that were dropped before, the invariant says that a and b are apart.
//   - The common points are never in a piece that was dropped before. For a segment from there to common points of
//     before, in a piece that was kept, leads through that piece's hull, and through the diagonal of a that its chain
//     of vertices begins and ends with: but no inner triangle since then had points in the outer one, so neither has
//     this.
//   - Closed objects: the triangles are apart strictly, or have common points.
// A chain has at least one inner vertex (edge): one that has none is never beyond a line (never leaves a piece).
//
// All of this in doubles; of the common points nothing is stored but their heights over the lines.
#include <sunder/planar/pair/in_doubles.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_answer.h>

#include <optional>

namespace sunder::planar {

namespace {

using in_doubles::cross;
using in_doubles::dot;
using in_doubles::operator-;
using in_doubles::scaled;

// Heights of a point to the left of six lines: of the outer triangle's edges, and of the segments that lead from the
// end of each to the start of the next one.
using Heights = std::array<double, 6>;

// A convex polygon; its vertices are known by their heights alone.
struct Piece {
  std::array<Heights, 9> at{};  // three clips of a triangle leave six vertices; nine, whatever rounding does
  std::uint32_t size = 0;

  // What is not to the right of the line.
  Piece clipped(std::uint32_t line) const {
    Piece left;
    for (std::uint32_t k = 0; k < size; ++k) {
      const Heights &p = at[k], &q = at[k + 1 == size ? 0 : k + 1];
      if (p[line] >= 0) left.at[left.size++] = p;
      if ((p[line] >= 0) == (q[line] >= 0)) continue;
      const double part = p[line] / (p[line] - q[line]);
      Heights& cut = left.at[left.size++];
      for (std::uint32_t h = 0; h < 6; ++h) cut[h] = p[h] + part * (q[h] - p[h]);
      cut[line] = 0;
    }
    return left;
  }

  bool is_right_of(std::uint32_t line) const {
    for (std::uint32_t k = 0; k < size; ++k) {
      if (!(at[k][line] < 0)) return false;
    }
    return true;
  }
};

// Three places around a polygon, and the chains between them: 0 from the first to the second, and so on. Where the last
// chain was dropped, the first two are what is left. at[0] is a position; those behind it may go beyond n.
struct Places {
  std::array<std::uint32_t, 3> at{};
  bool whole = true;
  std::uint32_t n = 0;

  static Places around(std::uint32_t n) { return {{0, n / 3, n - n / 3}, true, n}; }

  std::uint32_t next(std::uint32_t k) const { return k == 2 ? 0 : k + 1; }
  std::uint32_t steps(std::uint32_t chain) const { return chain == 2 ? at[0] + n - at[2] : at[chain + 1] - at[chain]; }
  bool was_dropped(std::uint32_t chain) const { return chain == 2 && !whole; }
  bool has_inner(std::uint32_t chain) const { return steps(chain) > 1; }

  // Keeps one chain, with a new place in its middle.
  void keep(std::uint32_t chain) {
    const std::uint32_t count = steps(chain), first = at[chain] < n ? at[chain] : at[chain] - n;
    at = {first, first + count / 2, first + count};
    whole = false;
  }
};

// Moves what was read at the ends of a chain to the first and the last place, and reads the middle.
template <class Item, class Read>
void keep_chain(Places& places, std::array<Item, 3>& items, std::uint32_t chain, const Read& read) {
  const Item first = items[chain], last = items[places.next(chain)];
  places.keep(chain);
  items = {first, read(places.at[1]), last};
}

struct Edge {
  Point2 start, end;
};

template <class A, class B, class Holds>
class Triangles {
 public:
  Triangles(const A& a, const B& b, const Holds& holds, Cost& cost, StageTally& tally)
      : a_(a), b_(b), holds_(holds), cost_(cost), tally_(tally) {}

  // Does a proposal hold?
  bool propose() {
    scale_ = scale_near_one({a_.rounded(0), a_.rounded(of_a_.at[1]), a_.rounded(of_a_.at[2]), b_.rounded(0),
                             b_.rounded(of_b_.at[1]), b_.rounded(of_b_.at[2])});
    for (std::uint32_t k = 0; k < 3; ++k) inner_[k] = vertex(of_a_.at[k]), outer_[k] = edge(of_b_.at[k]);
    while (true) {
      ++cost_.iterations;
      const std::optional<bool> held = step();
      if (held) return *held;
    }
  }

 private:
  Point2 vertex(std::uint32_t k) {
    ++cost_.probes;
    return scaled(a_.rounded(position(a_, k)), scale_);
  }
  Edge edge(std::uint32_t k) {
    ++cost_.probes;
    const std::uint32_t start = position(b_, k);
    return {scaled(b_.rounded(start), scale_), scaled(b_.rounded(position(b_, start + 1)), scale_)};
  }

  // Over edge k of the outer triangle.
  double height(std::uint32_t k, const Point2& p) const {
    return cross(outer_[k].end - outer_[k].start, p - outer_[k].start);
  }

  // Drops a part of one of the chains, or ends the search.
  std::optional<bool> step() {
    Piece common;
    common.size = 3;
    for (std::uint32_t k = 0; k < 3; ++k) {
      for (std::uint32_t i = 0; i < 3; ++i) {
        common.at[i][k] = height(k, inner_[i]);
        const Point2 &from = outer_[k].end, &to = outer_[of_b_.next(k)].start;
        common.at[i][3 + k] = cross(to - from, inner_[i] - from);
      }
    }
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (common.is_right_of(k)) return beyond_outer_edge(k, common);
    }
    for (std::uint32_t k = 0; k < 3; ++k) common = common.clipped(k);
    return common.size == 0 ? beyond_inner_edge() : in_common(common);
  }

  // The inner triangle is to the right of edge k of the outer one.
  std::optional<bool> beyond_outer_edge(std::uint32_t k, const Piece& inner) {
    std::uint32_t v = 0;
    for (std::uint32_t i = 1; i < 3; ++i) {
      if (inner.at[i][k] > inner.at[v][k]) v = i;
    }
    const std::uint32_t behind = v, before = v == 0 ? 2 : v - 1;  // the chains that begin and end at v
    const Point2 along = outer_[k].end - outer_[k].start;
    const auto rises = [&](std::uint32_t neighbour) { return cross(along, vertex(neighbour) - inner_[v]) > 0; };
    const std::uint32_t at = position(a_, of_a_.at[v]);
    if (of_a_.has_inner(behind) && rises(at + 1)) return keep_vertices(behind);
    if (of_a_.has_inner(before) && rises(at + a_.size() - 1)) return keep_vertices(before);
    if (along_outer_edge(k, at)) return true;
    // As rounding may have it, a only just reaches over the edge.
    const std::uint32_t e = of_b_.at[k];
    return holds_(meet(std::array{at + a_.size() - 1, at, at + 1}, std::array{e, position(b_, e) + 1}));
  }

  // The line of edge k of the outer triangle parts a, of which v is nearest, and b: or one through v and that edge.
  bool along_outer_edge(std::uint32_t k, std::uint32_t v) {
    const std::uint32_t e = position(b_, of_b_.at[k]);
    return holds_(apart_by_edge_of_b(v, e)) || holds_(apart_at_vertices(v, e)) || holds_(apart_at_vertices(v, e + 1));
  }

  // The triangles are apart, but no edge of the outer one parts them.
  std::optional<bool> beyond_inner_edge() {
    std::uint32_t best = 3;
    double least = 0;
    for (std::uint32_t i = 0; i < 3; ++i) {
      const double reach = outer_reach(inner_[i], inner_[of_a_.next(i)]);
      if (best == 3 || reach < least) best = i, least = reach;
    }
    if (of_a_.has_inner(best)) return keep_vertices(best);
    return along_inner_edge(of_a_.at[best]);
  }

  // How far to the left of the line of p and q the outer triangle reaches: a distance, up to a factor of two.
  double outer_reach(const Point2& p, const Point2& q) const {
    const Point2 along = q - p;
    for (std::uint32_t k = 0; k < 3; ++k) {  // the corner behind edge k
      const Edge &here = outer_[k], &next = outer_[of_b_.next(k)];
      const Point2 d = here.end - here.start, e = next.end - next.start;
      const double turn = cross(d, e);
      if (!(turn > 0 && cross(d, along) <= 0 && cross(along, e) <= 0)) continue;
      const double further = cross(next.start - here.end, e) / turn;
      const double reach = cross(along, here.end - p) + further * cross(along, d);
      return reach / (std::fabs(along.x) + std::fabs(along.y));
    }
    return HUGE_VAL;
  }

  // Edge i of a has all of b to its right? `near` becomes the vertex of b that is furthest to its left.
  bool parts_along(std::uint32_t i, std::uint32_t& near) {
    i = position(a_, i);
    near = position(b_, edges_to_left(b_, a_[i], vertex_at(a_, i + 1), cost_, tally_).end);
    return holds_(apart_by_edge_of_a(i, near));
  }

  // It has, or, as rounding may have it, b only just reaches over the edge.
  bool along_inner_edge(std::uint32_t i) {
    std::uint32_t near = 0;
    return parts_along(i, near) || holds_(meet(std::array{i, i + 1}, std::array{near + b_.size() - 1, near, near + 1}));
  }

  std::optional<bool> keep_vertices(std::uint32_t chain) {
    if (of_a_.was_dropped(chain)) return beyond_dropped();
    keep_chain(of_a_, inner_, chain, [this](std::uint32_t k) { return vertex(k); });
    return {};
  }

  // b is beyond the line of before, which had only kept vertices beyond it, and beyond this one, which has only dropped
  // ones: in one of the four sectors between the two, while a goes through the other three. The edge parts them that is
  // at this end of the chain or at that one, whichever is on the side where the lines meet.
  bool beyond_dropped() {
    std::uint32_t near = 0;
    return parts_along(of_a_.at[0], near) || parts_along(of_a_.at[2] - 1, near);
  }

  // The triangles have these common points.
  std::optional<bool> in_common(const Piece& common) {
    for (std::uint32_t k = 0; k < 3; ++k) {
      if (!of_b_.has_inner(k) || of_b_.was_dropped(k) || !common.is_right_of(3 + k)) continue;
      keep_chain(of_b_, outer_, k, [this](std::uint32_t e) { return edge(e); });
      return {};
    }
    return meet_here() || apart_here();
  }

  // The inner triangle meets the hull of the three edges.
  bool meet_here() {
    std::array<std::uint32_t, 6> h{};
    for (std::uint32_t k = 0; k < 3; ++k) {
      h[2 * k] = position(b_, of_b_.at[k]);
      h[2 * k + 1] = position(b_, h[2 * k] + 1);
    }
    for (std::uint32_t k = 1; k + 1 < 6; ++k) {
      if (h[k] != h[k + 1] && holds_(meet(of_a_.at, std::array{h[0], h[k], h[k + 1]}))) return true;
    }
    return false;
  }

  // Rounding found common points where there are none: parted by a last bit only?
  bool apart_here() {
    for (std::uint32_t k = 0; k < 3; ++k) {
      std::uint32_t v = 0;
      for (std::uint32_t i = 1; i < 3; ++i) {
        if (height(k, inner_[i]) > height(k, inner_[v])) v = i;
      }
      if (along_outer_edge(k, position(a_, of_a_.at[v]))) return true;
    }
    for (std::uint32_t i = 0; i < 3; ++i) {
      if (!of_a_.has_inner(i) && along_inner_edge(of_a_.at[i])) return true;
    }
    return false;
  }

  const A& a_;
  const B& b_;
  const Holds& holds_;
  Cost& cost_;
  StageTally& tally_;
  double scale_ = 1;
  Places of_a_ = Places::around(a_.size()), of_b_ = Places::around(b_.size());
  std::array<Point2, 3> inner_{};
  std::array<Edge, 3> outer_{};
};

}  // namespace

PairAnswer polygon_polygon_by_triangles(const ConvexPolygon& a, const Pose& pose_a,  //
                                        const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    return answer_by(in_a, in_b, [&](const auto& holds, Cost& cost, StageTally& tally) {
      return Triangles(in_a, in_b, holds, cost, tally).propose();
    });
  });
}

}  // namespace sunder::planar
