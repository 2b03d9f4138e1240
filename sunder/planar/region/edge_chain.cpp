#include <sunder/base/interruption.h>
#include <sunder/planar/region/edge_chain.h>
#include <sunder/planar/region/merge_in_pairs.h>
#include <sunder/predicate/line/height_order.h>

#include <utility>

namespace sunder::planar {

namespace {

bool is_lower_number(const EdgePiece& p, const EdgePiece& q) {
  return p.polygon < q.polygon || (p.polygon == q.polygon && p.edge < q.edge);
}

// Appends to the chain that begins at `start`.
void push(std::vector<EdgePiece>& out, std::size_t start, const EdgePiece& piece, const Enclosure2& begin) {
  if (out.size() > start && out.back().polygon == piece.polygon && out.back().edge == piece.edge) return;
  out.push_back(piece);
  out.back().begin = begin;
}

}  // namespace

void EdgeChains::append(std::uint32_t polygon, Boundary boundary, std::vector<EdgePiece>& out) {
  const ConvexPolygon& p = polygons_[polygon];
  const bool is_upper = boundary == Boundary::upper;
  const std::size_t start = out.size();
  for (std::uint32_t v = p.leftmost(); v != p.rightmost();) {
    ++probes_;
    const std::uint32_t next = is_upper ? p.previous(v) : p.next(v);
    Point2 a = p[v], b = p[next];
    const std::uint32_t edge = is_upper ? next : v;
    v = next;
    if (a.x == b.x || b.x <= between_.low) continue;
    if (a.x >= between_.high) break;
    if (!is_upper) {
      a.y = -a.y;
      b.y = -b.y;
    }
    push(out, start, {a, b, polygon, edge, {}}, {a.x, a.y});
  }
}

void EdgeChains::merge(std::span<const EdgePiece> p, std::span<const EdgePiece> q, std::vector<EdgePiece>& out) {
  const std::size_t start = out.size();
  // Where the piece that serves begins, if it is that of p, and that of q.
  Enclosure2 begin_p, begin_q;
  std::size_t i = 0, k = 0;
  // The sign of p - q where the stretch begins, and where it ends.
  Sign at_begin = height_order(p[0].a, p[0].b, q[0].a, q[0].b, between_.low, &tally_);
  for (;;) {
    may_be_interrupted(10);
    ++probes_;
    const EdgePiece &of_p = p[i], &of_q = q[k];
    const bool more_p = i + 1 < p.size(), more_q = k + 1 < q.size(), is_last = !more_p && !more_q;
    const Sign order = is_last   ? Sign::zero
                       : !more_q ? Sign::negative
                       : !more_p ? Sign::positive
                                 : compare_x(beginning(p, i + 1), beginning(q, k + 1), &tally_);
    const Sign at_end = is_last                   ? height_order(of_p.a, of_p.b, of_q.a, of_q.b, between_.high, &tally_)
                        : order != Sign::positive ? orient_2d(of_q.a, of_q.b, beginning(p, i + 1), &tally_)
                                                  : -orient_2d(of_p.a, of_p.b, beginning(q, k + 1), &tally_);
    const Sign before = at_begin != Sign::zero ? at_begin : at_end;
    const bool p_serves = before == Sign::zero ? is_lower_number(of_p, of_q) : before == Sign::negative;
    push(out, start, p_serves ? of_p : of_q, p_serves ? begin_p : begin_q);
    if (at_begin * at_end == Sign::negative) {
      const EdgePiece &left = p_serves ? of_p : of_q, &right = p_serves ? of_q : of_p;
      push(out, start, right, line_point(Crossing{left.a, left.b, right.a, right.b}).in);
    }
    if (is_last) return;
    if (order != Sign::positive) begin_p = p[++i].begin;
    if (order != Sign::negative) begin_q = q[++k].begin;
    if (order == Sign::negative) begin_q = begin_p;
    if (order == Sign::positive) begin_p = begin_q;
    at_begin = at_end;
  }
}

std::vector<EdgePiece> EdgeChains::merge_all(std::vector<EdgePiece> chains, std::vector<std::size_t> ends) {
  return merged_in_pairs(std::move(chains), std::move(ends),
                         [this](const auto& p, const auto& q, auto& out) { merge(p, q, out); });
}

std::vector<EdgePiece> EdgeChains::divide(std::span<const std::uint32_t> polygons, Boundary boundary) {
  std::vector<EdgePiece> chains;
  std::vector<std::size_t> ends;
  for (const std::uint32_t polygon : polygons) {
    append(polygon, boundary, chains);
    ends.push_back(chains.size());
  }
  return merge_all(std::move(chains), std::move(ends));
}

std::vector<EdgePiece> EdgeChains::divide_edges(std::span<const std::uint32_t> polygons, Boundary boundary) {
  std::vector<EdgePiece> edges;
  std::vector<std::size_t> ends;
  for (const std::uint32_t polygon : polygons) append(polygon, boundary, edges);
  for (std::size_t k = 0; k < edges.size(); ++k) ends.push_back(k + 1);
  return merge_all(std::move(edges), std::move(ends));
}

}  // namespace sunder::planar
