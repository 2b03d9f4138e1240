// The search for the point x of D = A - B that is closest to the origin, which is not in D.
//
// Let n be the unit normal from x to the origin 0. The edge e* through which the ray of minkowski_difference_search.h
// leaves D has the origin strictly beyond it: D is in a half-plane n* . y < 0, with x = -|x| n in it, so n . n* > 0: n
// is within a right angle of the normal of e*. For an edge e of D that is within a right angle of e*, let P(e) be:
// going along e from its start s, one comes closer to the origin, e . (0 - s) > 0. If e comes before n (by its normal),
// P(e) is true, else false: where the origin is beyond e, because the gap along a normal, -h(normal), grows up to n and
// falls from there; where it is not, because then the support vertex v has normal . v >= 0 and n . v < 0, which leaves
// it on the side of n from which the gap goes on falling. So x is at the start V of the first edge for which P is
// false, or on the edge before it.
//
// The edges before e* and those after it, within a right angle, are searched alike. Again edges i of A and j of B in
// the middle of what is left are compared by direction; w = b_j - a_i. Let i come first. The start of edge i is some
// (i, j') with j' <= j, and the edges between are within a right angle of i: so i . (b_j' - a_i) >= i . w.
//   - i . w > 0: then P(i), and what is searched for comes after edge i of A.
//   - Else, where edge i has w on its outer side: the start of edge j is some (i', j) with i' > i, and w is turned from
//     edge i by a right angle or more to the outer side; edge j is turned a little the other way, so
//     j . (b_j - a_i') <= j . w <= 0: not P(j); what is searched for does not come after the start of edge j of B.
//   - Else the origin is not beyond edge i, which therefore comes after n: not P(i).
// When one window is empty its vertex is known; the edges left of the other one are compared with the two edges beside
// this vertex first.
#include <sunder/base/contract.h>
#include <sunder/number/root.h>
#include <sunder/planar/pair/minkowski_difference_search.h>
#include <sunder/planar/pair/polygon_polygon.h>
#include <sunder/planar/pair/polygon_polygon_distance.h>
#include <sunder/predicate/coordinates.h>

#include <cmath>
#include <optional>
#include <utility>

namespace sunder::planar {

namespace {

// The square of the distance of a point from a point, or from a line, exactly.
template <class V>
ExactFraction squared_from_point(const V& p, const V& q) {
  const auto d = coordinates<Dyadic>(q) - coordinates<Dyadic>(p);
  return {dot(d, d)};
}
template <class V>
ExactFraction squared_from_line(const V& p, const V& from, const V& to) {
  const auto e = coordinates<Dyadic>(to) - coordinates<Dyadic>(from);
  const Dyadic height = cross(e, coordinates<Dyadic>(p) - coordinates<Dyadic>(from));
  return {height * height, dot(e, e)};
}

// What is named by positions: edge_of_a, the edge of A from i; edge_of_b, that of B from j. Without `distance`.
template <class A, class B>
ClosestFeatures features(const A& a, std::uint32_t i, bool edge_of_a, const B& b, std::uint32_t j, bool edge_of_b) {
  ClosestFeatures out;
  i = position(a, i);
  j = position(b, j);
  const auto p = a[i];
  const auto q = b[j];
  out.edge_of_a = edge_of_a;
  out.edge_of_b = edge_of_b;
  out.squared = edge_of_a   ? squared_from_line(q, p, vertex_at(a, i + 1))
                : edge_of_b ? squared_from_line(p, q, vertex_at(b, j + 1))
                            : squared_from_point(p, q);
  // An edge begins, in the polygon's own order, at the end that a reflection leaves behind.
  const auto named = [](const auto& polygon, std::uint32_t k, bool edge) {
    const std::uint32_t start = polygon.number(k);
    if (!edge) return start;
    const std::uint32_t end = polygon.number(position(polygon, k + 1));
    return (start + 1 == polygon.size() ? 0 : start + 1) == end ? start : end;
  };
  out.a = named(a, i, edge_of_a);
  out.b = named(b, j, edge_of_b);
  return out;
}

// The windows low .. high - 1 of edges of A and of B, in order of direction, all within a right angle.
struct Windows {
  std::uint32_t low_a, high_a, low_b, high_b;
};

// Finds (i, j), the start of the first edge of D in the windows for which P is false; or their end.
template <class A, class B>
std::array<std::uint32_t, 2> first_start_not_closer(const A& a, const B& b, Windows w, Cost& cost, StageTally& tally) {
  const Windows all = w;
  const auto end = [](const auto& p, std::uint32_t k) { return vertex_at(p, position(p, k) + 1); };
  const auto a_first = [&](std::uint32_t i, std::uint32_t j) {
    ++cost.probes;
    return cross_2d(vertex_at(a, i), end(a, i), end(b, j), vertex_at(b, j), &tally) != Sign::negative;
  };
  const auto closer_along_a = [&](std::uint32_t i, std::uint32_t j) {
    ++cost.probes;
    return dot_2d(vertex_at(a, i), end(a, i), vertex_at(a, i), vertex_at(b, j), &tally) == Sign::positive;
  };
  const auto closer_along_b = [&](std::uint32_t i, std::uint32_t j) {
    ++cost.probes;
    return dot_2d(end(b, j), vertex_at(b, j), vertex_at(a, i), vertex_at(b, j), &tally) == Sign::positive;
  };
  while (w.low_a < w.high_a && w.low_b < w.high_b) {
    ++cost.iterations;
    const std::uint32_t i = w.low_a + (w.high_a - w.low_a) / 2, j = w.low_b + (w.high_b - w.low_b) / 2;
    if (a_first(i, j)) {
      if (closer_along_a(i, j)) {
        w.low_a = i + 1;
      } else if (cross_2d(vertex_at(a, i), end(a, i), vertex_at(a, i), vertex_at(b, j), &tally) == Sign::negative) {
        w.high_b = j;
      } else {
        w.high_a = i;
      }
    } else if (closer_along_b(i, j)) {
      w.low_b = j + 1;
    } else if (cross_2d(end(b, j), vertex_at(b, j), vertex_at(a, i), vertex_at(b, j), &tally) == Sign::negative) {
      w.high_a = i;
    } else {
      w.high_b = j;
    }
  }
  const std::uint32_t j = w.low_b;
  w.low_a = first_where(w.low_a, w.high_a, [&](std::uint32_t i) {
    ++cost.iterations;
    if (j > all.low_b && a_first(i, j - 1)) return false;  // before an edge for which P is true
    if (j < all.high_b && !a_first(i, j)) return true;     // after one for which it is false
    return !closer_along_a(i, j);
  });
  const std::uint32_t i = w.low_a;
  w.low_b = first_where(w.low_b, w.high_b, [&](std::uint32_t k) {
    ++cost.iterations;
    if (i > all.low_a && !a_first(i - 1, k)) return false;
    if (i < all.high_a && a_first(i, k)) return true;
    return !closer_along_b(i, k);
  });
  return {i, w.low_b};
}

template <class A, class B>
PolygonDistance distance_between(const A& a, const B& b) {
  PolygonDistance out;
  StageTally tally;
  Cost& cost = out.cost;
  PairCertificate certificate;
  const minkowski_difference_search::Found found = search_difference(a, 0, b, 0, certificate, cost, tally);
  const auto finish = [&](std::uint32_t i, bool edge_of_a, std::uint32_t j, bool edge_of_b) {
    ClosestFeatures closest = features(a, i, edge_of_a, b, j, edge_of_b);
    closest.distance = root(closest.squared);
    out.evidence = std::move(closest);
  };
  if (found.meet) {
    out.evidence = std::get<CommonVertices>(certificate);
  } else {
    const std::uint32_t i = found.edge_a, j = found.edge_b;
    if (found.chain_a.empty() && found.chain_b.empty()) {
      finish(i, false, j, false);
    } else {
      const auto end = [](const auto& p, std::uint32_t k) { return vertex_at(p, position(p, k) + 1); };
      // e*, from its start to its end in D.
      const auto from = found.of_a ? vertex_at(a, i) : end(b, j);
      const auto to = found.of_a ? end(a, i) : vertex_at(b, j);
      const auto is_near = [&](const auto& p, const auto& q) {
        ++cost.probes;
        return dot_2d(from, to, p, q, &tally) == Sign::positive;
      };
      const auto edge_of_a = [&](std::uint32_t k) { return is_near(vertex_at(a, k), end(a, k)); };
      const auto edge_of_b = [&](std::uint32_t k) { return is_near(end(b, k), vertex_at(b, k)); };
      // Does one come closer from the start of e* on, and beyond its end?
      const auto a_end = vertex_at(a, found.of_a ? position(a, i) + 1 : i);
      const auto b_end = vertex_at(b, found.of_a ? j : position(b, j) + 1);
      const bool after_start = dot_2d(from, to, vertex_at(a, i), vertex_at(b, j), &tally) == Sign::positive;
      const bool after_end = after_start && dot_2d(from, to, a_end, b_end, &tally) == Sign::positive;
      if (after_start && !after_end && dot_2d(from, to, a_end, b_end, &tally) == Sign::negative) {
        finish(i, found.of_a, j, !found.of_a);
      } else {
        Windows w{};
        if (after_start) {
          w.low_a = found.of_a ? i + 1 : i;
          w.low_b = found.of_a ? j : j + 1;
          w.high_a = first_where(w.low_a, found.chain_a.end, [&](std::uint32_t k) { return !edge_of_a(k); });
          w.high_b = first_where(w.low_b, found.chain_b.end, [&](std::uint32_t k) { return !edge_of_b(k); });
        } else {
          w.high_a = i;
          w.high_b = j;
          w.low_a = first_where(found.chain_a.begin, w.high_a, edge_of_a);
          w.low_b = first_where(found.chain_b.begin, w.high_b, edge_of_b);
        }
        const auto [s, t] = first_start_not_closer(a, b, w, cost, tally);
        // x is at (s, t), or inside the edge of D that ends there: which is the later one of the two.
        const bool has_a = s > w.low_a, has_b = t > w.low_b;
        bool is_a = has_a;
        if (has_a && has_b) {
          is_a = cross_2d(vertex_at(a, s - 1), end(a, s - 1), end(b, t - 1), vertex_at(b, t - 1), &tally) ==
                 Sign::negative;
        }
        bool on_edge = false;  // does one come closer back from (s, t)?
        if (is_a) {
          on_edge =
              dot_2d(vertex_at(a, s - 1), end(a, s - 1), vertex_at(a, s), vertex_at(b, t), &tally) == Sign::negative;
        } else if (has_b) {
          on_edge =
              dot_2d(end(b, t - 1), vertex_at(b, t - 1), vertex_at(a, s), vertex_at(b, t), &tally) == Sign::negative;
        }
        finish(on_edge && is_a ? s - 1 : s, on_edge && is_a, on_edge && !is_a ? t - 1 : t, on_edge && !is_a);
      }
    }
  }
  conclude(out, tally.exact);
  return out;
}

}  // namespace

PolygonDistance polygon_polygon_distance(const ConvexPolygon& a, const Pose& pose_a,  //
                                         const ConvexPolygon& b, const Pose& pose_b) {
  return with_placed(a, pose_a, b, pose_b,
                     [](const auto& in_a, const auto& in_b) { return distance_between(in_a, in_b); });
}

PolygonDistance polygon_polygon_distance_by_scan(const ConvexPolygon& polygon_a, const Pose& pose_a,
                                                 const ConvexPolygon& polygon_b, const Pose& pose_b) {
  const PairAnswer meeting = polygon_polygon_by_scan(polygon_a, pose_a, polygon_b, pose_b);
  PolygonDistance out{{}, meeting.decided_by, meeting.cost};
  if (const auto* common = std::get_if<CommonVertices>(&meeting.evidence)) {
    out.evidence = *common;
    return out;
  }
  std::optional<ClosestFeatures> best;
  const PosedPolygon a(polygon_a, pose_a), b(polygon_b, pose_b);
  StageTally tally;
  const auto try_one = [&](std::uint32_t i, bool edge_of_a, std::uint32_t j, bool edge_of_b) {
    ClosestFeatures other = features(a, i, edge_of_a, b, j, edge_of_b);
    if (!best || other.squared < best->squared) best = std::move(other);
  };
  // The foot of p on the edge from q to r is inside it.
  const auto faces = [&](const Posed2& p, const Posed2& q, const Posed2& r) {
    return dot_2d(q, r, q, p, &tally) == Sign::positive && dot_2d(r, q, r, p, &tally) == Sign::positive;
  };
  for (std::uint32_t i = 0; i < a.size(); ++i) {
    for (std::uint32_t j = 0; j < b.size(); ++j) {
      try_one(i, false, j, false);
      if (a.size() > 1 && faces(b[j], a[i], vertex_at(a, i + 1))) try_one(i, true, j, false);
      if (b.size() > 1 && faces(a[i], b[j], vertex_at(b, j + 1))) try_one(i, false, j, true);
    }
  }
  best->distance = root(best->squared);
  out.evidence = *std::move(best);
  out.cost.exact += tally.exact;
  return out;
}

Sign compare_distance(const PolygonDistance& distance, double radius) {
  SUNDER_REQUIRE(std::isfinite(radius) && radius >= 0);
  const ClosestFeatures* closest = closest_of(distance);
  if (closest == nullptr) return radius > 0 ? Sign::negative : Sign::zero;
  if (closest->distance.low > radius) return Sign::positive;
  if (closest->distance.high < radius) return Sign::negative;
  return compare_root(closest->squared, radius);
}

}  // namespace sunder::planar
