#include <sunder/planar/pair/exact_image.h>
#include <sunder/planar/pair/line_search.h>
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/planar/pair/polygon_polygon_intersection.h>

#include <optional>
#include <utility>

namespace sunder::planar {

namespace {

// What edge `edge` of P has in common with Q: from where to where.
struct CutEdge {
  std::uint32_t edge = 0;
  CutEnds<CutEnd> ends;
};

// P is the one whose edges are cut, Q the one that cuts. All features are positions.
template <class P, class Q>
class Cutter {
 public:
  Cutter(const P& p, const Q& q, bool p_is_a, CommonPart& out, StageTally& tally)
      : p_(p), q_(q), p_is_a_(p_is_a), out_(out), tally_(tally) {}

  // Where the interiors meet. Requires three vertices of each at least. No corner is straight: where edges overlap,
  // both polygons are on their left, so that an end of one inside the other is a corner of the common part.
  void overlapping() {
    std::vector<CutEdge> pieces;
    for (std::uint32_t i = 0; i < p_.size(); ++i) {
      const PolygonCut::Evidence cut = cut_of(i);
      if (is_piece(cut)) pieces.push_back({i, *ends_of(cut)});
    }
    if (pieces.empty()) {  // Q is inside P
      for (std::uint32_t k = 0; k < q_.size(); ++k) add_vertex_of_q(k);
      return;
    }
    for (std::size_t k = 0; k < pieces.size(); ++k) {
      const CutEdge &piece = pieces[k], &next = pieces[k + 1 == pieces.size() ? 0 : k + 1];
      add(piece, piece.ends.first);
      const CutEnd &leaves = piece.ends.last, &enters = next.ends.first;
      const bool goes_on = leaves.own == OwnEnd::b && enters.own == OwnEnd::a &&  //
                           next.edge == position(p_, piece.edge + 1);
      if (goes_on || is_same(leaves, enters)) continue;
      add(piece, leaves);
      walk(leaves, enters);
    }
  }

  // Where they touch only, or one is a point or a segment: what the edges of P have in common with Q, a point or one
  // piece. Requires that all common points are on the boundary of P.
  void thin() {
    if (p_.size() == 1) return add_vertex_of_p(0);
    std::optional<CutEdge> point;
    for (std::uint32_t i = 0; i < (p_.size() == 2 ? 1 : p_.size()); ++i) {
      const PolygonCut::Evidence cut = cut_of(i);
      const std::optional<CutEnds<CutEnd>> ends = ends_of(cut);
      if (!ends) continue;
      if (is_piece(cut)) {
        add({i, *ends}, ends->first);
        add({i, *ends}, ends->last);
        return;
      }
      if (!point) point = CutEdge{i, *ends};
    }
    if (point) add(*point, point->ends.first);
  }

 private:
  static bool is_piece(const PolygonCut::Evidence& cut) {
    return std::holds_alternative<CutAlong>(cut) || std::holds_alternative<CutAcross>(cut);
  }

  PolygonCut::Evidence cut_of(std::uint32_t i) {
    Cost cost;
    const auto from = p_[i];
    const auto to = vertex_at(p_, i + 1);
    const auto furthest_left = [this](const auto& u, const auto& v, Cost& c, StageTally& tally) {
      return extreme_vertex_by_bisection(q_, u, v, c, tally);
    };
    const PolygonCut::Evidence of_line = cut_by_line(q_, from, to, furthest_left, cost, tally_);
    out_.cost.probes += cost.probes;
    return clip(q_, from, to, true, of_line, tally_);
  }

  void push(CommonCorner::Kind of_p, std::uint32_t in_p, std::uint32_t in_q) {
    CommonCorner corner{of_p, in_p, in_q};
    if (!p_is_a_) {
      std::swap(corner.a, corner.b);
      if (corner.kind != CommonCorner::Kind::crossing) {
        corner.kind = corner.kind == CommonCorner::Kind::vertex_of_a ? CommonCorner::Kind::vertex_of_b
                                                                     : CommonCorner::Kind::vertex_of_a;
      }
    }
    out_.found.push_back(corner);
  }
  void add_vertex_of_p(std::uint32_t k) { push(CommonCorner::Kind::vertex_of_a, p_.number(position(p_, k)), 0); }
  void add_vertex_of_q(std::uint32_t k) { push(CommonCorner::Kind::vertex_of_b, 0, q_.number(position(q_, k))); }

  void add(const CutEdge& piece, const CutEnd& end) {
    if (end.own == OwnEnd::a) return add_vertex_of_p(piece.edge);
    if (end.own == OwnEnd::b) return add_vertex_of_p(piece.edge + 1);
    if (end.place == Place::vertex) return add_vertex_of_q(end.feature);
    push(CommonCorner::Kind::crossing, edge_number(p_, piece.edge), edge_number(q_, end.feature));
  }

  // One point of Q's boundary: a vertex of it. (On one edge they differ: P goes on there, or comes back further along.)
  static bool is_same(const CutEnd& leaves, const CutEnd& enters) {
    return leaves.place == Place::vertex && enters.place == Place::vertex && leaves.feature == enters.feature;
  }

  // The vertices of Q between: where both are on one edge, none, because P comes back further along it.
  void walk(const CutEnd& leaves, const CutEnd& enters) {
    const std::uint32_t m = q_.size();
    std::uint32_t k = position(q_, leaves.feature + 1);
    const std::uint32_t end = enters.place == Place::edge ? position(q_, enters.feature + 1) : enters.feature;
    for (std::uint32_t steps = 0; k != end && steps < m; ++steps) {
      add_vertex_of_q(k);
      k = position(q_, k + 1);
    }
  }

  const P& p_;
  const Q& q_;
  bool p_is_a_;
  CommonPart& out_;
  StageTally& tally_;
};

template <class P, class Q>
void cut_with(const P& p, const Q& q, bool p_is_a, bool overlap, CommonPart& out, StageTally& tally) {
  Cutter<P, Q> cutter(p, q, p_is_a, out, tally);
  overlap ? cutter.overlapping() : cutter.thin();
}

}  // namespace

CommonPart polygon_polygon_intersection(const ConvexPolygon& a, const Pose& pose_a,  //
                                        const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b, [](const auto& in_a, const auto& in_b) {
    CommonPart out;
    StageTally tally;
    const Relation contact = contact_by_difference(in_a, in_b);
    if (contact != Relation::none) {
      const bool overlap = contact == Relation::overlapping && in_a.size() > 2 && in_b.size() > 2;
      if (in_a.size() <= in_b.size()) {
        cut_with(in_a, in_b, true, overlap, out, tally);
      } else {
        cut_with(in_b, in_a, false, overlap, out, tally);
      }
    }
    out.cost.exact += tally.exact;
    return out;
  });
}

ExactPoint2 exact_corner(const CommonCorner& corner, const ConvexPolygon& a, const Pose& pose_a, const ConvexPolygon& b,
                         const Pose& pose_b) {
  if (corner.kind == CommonCorner::Kind::vertex_of_a) return exact_vertex(a, pose_a, corner.a);
  if (corner.kind == CommonCorner::Kind::vertex_of_b) return exact_vertex(b, pose_b, corner.b);
  return exact_crossing(image(a, pose_a, corner.a), image(a, pose_a, a.next(corner.a)),  //
                        image(b, pose_b, corner.b), image(b, pose_b, b.next(corner.b)));
}

}  // namespace sunder::planar
