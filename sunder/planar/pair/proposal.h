// What the methods that search in doubles share: coordinates of a size that they can square, and the way from a pair of
// vertices to a certificate.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/planar/pair/difference_search.h>
#include <sunder/planar/pair/evidence.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <initializer_list>

namespace sunder::planar {

// A power of two that brings these coordinates near 1, so that products neither overflow nor underflow; 1 where that
// would not help (all are zero, or one is no number). Scaling the objects by a power of two does not change a search.
inline double scale_near_one(std::initializer_list<Point2> points) {
  double greatest = 0;
  for (const Point2& p : points) greatest = std::max({greatest, std::fabs(p.x), std::fabs(p.y)});
  if (!(greatest > 0) || std::isinf(greatest)) return 1;
  constexpr std::uint64_t bias = 1023, least = bias - 1000, most = bias + 1000;  // 2^e is stored as e + bias
  const std::uint64_t stored = std::clamp(std::bit_cast<std::uint64_t>(greatest) >> 52, least, most);
  return std::bit_cast<double>((2 * bias - stored) << 52);
}

namespace in_doubles {
inline Point2 scaled(const Point2& p, double scale) { return {p.x * scale, p.y * scale}; }
inline Point2 operator-(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }
inline double cross(const Point2& u, const Point2& v) { return u.x * v.y - u.y * v.x; }
inline double dot(const Point2& u, const Point2& v) { return u.x * v.x + u.y * v.y; }
}  // namespace in_doubles

// Does an edge at vertex i of a or at vertex j of b part the two, with the other vertex nearest to it? Fills in the
// certificate. Where some line parts a and b strictly and is nearest to i and j among their vertices, the answer is
// yes: the origin is outside the cone of A - B at its vertex i - j, hence beyond one of the two edges there.
template <class A, class B>
bool propose_apart(const A& a, std::uint32_t i, const B& b, std::uint32_t j, PairCertificate& certificate,
                   StageTally& tally) {
  i = position(a, i), j = position(b, j);
  for (const std::uint32_t edge : {i, position(a, i + a.size() - 1)}) {
    if (!parts(a, edge, b, j, tally)) continue;
    fill_apart_by_edge_of_a(a, edge, b, j, certificate);
    return true;
  }
  for (const std::uint32_t edge : {j, position(b, j + b.size() - 1)}) {
    if (!parts(b, edge, a, i, tally)) continue;
    fill_apart_by_edge_of_b(a, i, b, edge, certificate);
    return true;
  }
  return false;
}

// By a search whose proposals are checked: search(certificate, cost, tally) is false where none of them held. Then, and
// where a polygon is a point or a segment, the exact search decides.
template <class A, class B, class Search>
PairAnswer answer_by_proposal(const A& a, const B& b, const Search& search) {
  PairAnswer answer;
  StageTally tally;
  const bool flat = a.size() < 3 || b.size() < 3;
  const bool held = !flat && search(answer.evidence, answer.cost, tally);
  if (!held) {
    answer.evidence = {};
    search_difference(a, 0, b, 0, answer.evidence, answer.cost, tally);
  }
  answer.cost.exact = tally.exact;
  answer.decided_by = !held && !flat     ? DecidedBy::finishing
                      : tally.exact == 0 ? DecidedBy::filter
                                         : DecidedBy::evidence;
  return answer;
}

}  // namespace sunder::planar
