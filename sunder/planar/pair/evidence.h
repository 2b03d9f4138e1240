// From features to a certificate, for sequences of vertices: each function checks exactly what should be true of them,
// and fills in the certificate where it is. Where it is not, nothing is known.
#pragma once

#include <sunder/certificate/pair.h>
#include <sunder/planar/pair/edge_runs.h>
#include <sunder/planar/pair/proposal.h>
#include <sunder/predicate/line/triangles.h>

#include <array>
#include <bit>

namespace sunder::planar {

namespace evidence {

// p is on the segment ab, its ends included.
template <class V>
bool on_segment(const V& p, const V& a, const V& b, StageTally& tally) {
  return cross_2d(a, b, a, p, &tally) == Sign::zero && dot_2d(a, p, b, p, &tally) != Sign::positive;
}

template <class V>
bool equal(const V& p, const V& q, StageTally& tally) {
  return dot_2d(p, q, p, q, &tally) == Sign::zero;
}

// Some of three corners.
struct Few {
  std::array<std::uint32_t, 3> at{};
  std::uint8_t count = 0;

  operator Corners() const { return {at.data(), count}; }
};

// The edges of the hull of some corners, in order: three, one or none.
inline std::uint32_t edges(Corners of) { return of.size() == 3 ? 3 : static_cast<std::uint32_t>(of.size() - 1); }
inline std::array<std::uint32_t, 2> edge(Corners of, std::uint32_t e) {
  return e == 2 ? std::array{of[0], of[2]} : std::array{of[e], of[e + 1]};
}

// Each position once, in ascending order: counter-clockwise.
template <class Sequence>
Few in_order(const Sequence& p, Corners corners) {
  Few few;
  for (const std::uint32_t c : corners) {
    const std::uint32_t at = position(p, c);
    std::uint8_t k = few.count;
    while (k > 0 && few.at[k - 1] > at) --k;
    if (k > 0 && few.at[k - 1] == at) continue;
    for (std::uint8_t l = few.count; l > k; --l) few.at[l] = few.at[l - 1];
    few.at[k] = at;
    ++few.count;
  }
  return few;
}

// The least set of corners, given in order, whose hull holds p; empty where the hull of all does not.
template <class Sequence>
Few corners_around(const typename Sequence::Vertex& p, const Sequence& q, Corners corners, StageTally& tally) {
  if (corners.size() == 3) {
    const auto &a = q[corners[0]], &b = q[corners[1]], &c = q[corners[2]];
    const Sign ab = cross_2d(a, b, a, p, &tally);
    if (ab == Sign::negative) return {};
    const Sign bc = cross_2d(b, c, b, p, &tally);
    if (bc == Sign::negative) return {};
    const Sign ca = cross_2d(c, a, c, p, &tally);
    if (ca == Sign::negative) return {};
    // On the lines of two edges: in their corner. On that of one: inside it.
    if (ab == Sign::zero) {
      if (bc == Sign::zero) return {{corners[1]}, 1};
      if (ca == Sign::zero) return {{corners[0]}, 1};
      return {{corners[0], corners[1]}, 2};
    }
    if (bc == Sign::zero) return ca == Sign::zero ? Few{{corners[2]}, 1} : Few{{corners[1], corners[2]}, 2};
    if (ca == Sign::zero) return {{corners[0], corners[2]}, 2};
    return {{corners[0], corners[1], corners[2]}, 3};
  }
  for (const std::uint32_t c : corners) {
    if (equal(p, vertex_at(q, c), tally)) return {{c}, 1};
  }
  for (std::size_t i = 0; i < corners.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      if (on_segment(p, vertex_at(q, corners[j]), vertex_at(q, corners[i]), tally))
        return {{corners[j], corners[i]}, 2};
    }
  }
  return {};
}

}  // namespace evidence

// Fills in that these corners of a and of b have a common point in their hulls: at most four.
template <class A, class B>
bool fill_meet(const A& a, Corners of_a, const B& b, Corners of_b, PairCertificate& certificate) {
  CommonVertices& found = certificate.emplace<CommonVertices>();
  found.count_a = static_cast<std::uint8_t>(of_a.size());
  found.count_b = static_cast<std::uint8_t>(of_b.size());
  std::size_t k = 0;
  for (const std::uint32_t c : of_a) found.vertices[k++] = a.number(c);
  for (const std::uint32_t c : of_b) found.vertices[k++] = b.number(c);
  return true;
}

// Three corners of each, counter-clockwise: do these triangles meet, by signs that their first stages decide? Fills in
// at most four vertices. False tells nothing where a sign is left open, or zero.
template <class A, class B>
bool check_triangles(const A& a, Corners of_a, const B& b, Corners of_b, PairCertificate& certificate,
                     StageTally& tally) {
  const TriangleSides sides = sides_of_triangles(std::array{a[of_a[0]], a[of_a[1]], a[of_a[2]]},
                                                 std::array{b[of_b[0]], b[of_b[1]], b[of_b[2]]});
  if (!sides.sure) return false;
  tally.rounded += 18;
  const auto first_bit = [](std::uint32_t bits) { return static_cast<std::uint32_t>(std::countr_zero(bits)); };
  if (const std::uint32_t in_a = sides.inside_first(); in_a != 0) {
    return fill_meet(a, of_a, b, of_b.subspan(first_bit(in_a), 1), certificate);
  }
  if (const std::uint32_t in_b = sides.inside_second(); in_b != 0) {
    return fill_meet(a, of_a.subspan(first_bit(in_b) / 3, 1), b, of_b, certificate);
  }
  const std::uint32_t crossings = sides.crossings();
  if (crossings == 0) return false;
  const std::uint32_t at = first_bit(crossings);
  return fill_meet(a, evidence::edge(of_a, at / 3), b, evidence::edge(of_b, at % 3), certificate);
}

// Have the hulls of these corners of a and of b a common point? Fills in at most four vertices.
template <class A, class B>
bool check_meet(const A& a, Corners from_a, const B& b, Corners from_b, PairCertificate& certificate,
                StageTally& tally) {
  const evidence::Few few_a = evidence::in_order(a, from_a), few_b = evidence::in_order(b, from_b);
  const Corners of_a = few_a, of_b = few_b;
  const auto fill = [&](Corners in_a, Corners in_b) { return fill_meet(a, in_a, b, in_b, certificate); };
  for (std::size_t k = 0; k < of_b.size(); ++k) {
    const evidence::Few few = evidence::corners_around(b[of_b[k]], a, of_a, tally);
    if (few.count > 0) return fill(few, of_b.subspan(k, 1));
  }
  for (std::size_t k = 0; k < of_a.size(); ++k) {
    const evidence::Few few = evidence::corners_around(a[of_a[k]], b, of_b, tally);
    if (few.count > 0) return fill(of_a.subspan(k, 1), few);
  }
  // No corner of one is in the hull of the other: if they meet, then two edges cross inside both.
  for (std::uint32_t e = 0; e < evidence::edges(of_a); ++e) {
    for (std::uint32_t f = 0; f < evidence::edges(of_b); ++f) {
      const auto in_a = evidence::edge(of_a, e), in_b = evidence::edge(of_b, f);
      const auto &p = a[in_a[0]], &q = a[in_a[1]];
      const auto &r = b[in_b[0]], &s = b[in_b[1]];
      const auto part = [&](const auto& t, const auto& u, const auto& v, const auto& w) {
        return cross_2d(t, u, t, v, &tally) * cross_2d(t, u, t, w, &tally) == Sign::negative;
      };
      if (part(p, q, r, s) && part(r, s, p, q)) return fill(in_a, in_b);
    }
  }
  return false;
}

// Has edge i of a all of a on its left and all of b strictly on its right? `near` is the vertex of b that should be
// nearest to it. Looks at the edges beside this vertex only, which is enough: b is convex.
template <class A, class B>
bool parts(const A& a, std::uint32_t i, const B& b, std::uint32_t near, StageTally& tally) {
  if (a.size() == 1) return false;
  const auto &p = vertex_at(a, i), &q = vertex_at(a, position(a, i) + 1);
  if (cross_2d(p, q, p, vertex_at(b, near), &tally) != Sign::negative) return false;
  if (b.size() == 1) return true;
  const std::uint32_t at = position(b, near);
  const auto& v = vertex_at(b, at);
  return cross_2d(p, q, v, vertex_at(b, at + 1), &tally) != Sign::positive &&
         cross_2d(p, q, v, vertex_at(b, at + b.size() - 1), &tally) != Sign::positive;
}

template <class A, class B>
Separation apart_by_edge_of_a(const A& a, std::uint32_t i, const B& b, std::uint32_t near) {
  const std::uint32_t at = position(a, i), next = position(a, at + 1);
  return {{.kind = Direction::Kind::side_of_a, .index = {a.number(at), a.number(next)}},
          a.number(at),
          b.number(position(b, near))};
}
template <class A, class B>
Separation apart_by_edge_of_b(const A& a, std::uint32_t near, const B& b, std::uint32_t j) {
  const std::uint32_t at = position(b, j), next = position(b, at + 1);
  return {{.kind = Direction::Kind::side_of_b, .reversed = true, .index = {b.number(at), b.number(next)}},
          a.number(position(a, near)),
          b.number(at)};
}

// Does an edge at vertex i of a or at vertex j of b part the two, with the other vertex nearest to it? Fills in the
// certificate. Where some line parts a and b strictly and is nearest to i and j among their vertices, the answer is
// yes: the origin is outside the cone of A - B at its vertex i - j, hence beyond one of the two edges there.
template <class A, class B>
bool parts_at(const A& a, std::uint32_t i, const B& b, std::uint32_t j, PairCertificate& certificate,
              StageTally& tally) {
  i = position(a, i), j = position(b, j);
  for (const std::uint32_t edge : {i, position(a, i + a.size() - 1)}) {
    if (!parts(a, edge, b, j, tally)) continue;
    certificate = apart_by_edge_of_a(a, edge, b, j);
    return true;
  }
  for (const std::uint32_t edge : {j, position(b, j + b.size() - 1)}) {
    if (!parts(b, edge, a, i, tally)) continue;
    certificate = apart_by_edge_of_b(a, i, b, edge);
    return true;
  }
  return false;
}

}  // namespace sunder::planar
