// The oracle: of all pairs of a vertex, an edge or a triangle of the one body and of the other, four vertices in all at
// most, those that face each other and are the least distance apart. Shares nothing with the search: the nearest points
// of two flats come from the normal equations (e_i e_j) s = (e_i r), by determinants.
#include <sunder/number/interval.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/search/placed.h>

#include <vector>

namespace sunder::solid {

namespace {

// One, two or three vertices.
struct Part {
  std::uint8_t count;
  std::array<std::uint32_t, 3> vertex;
};

// Those of fewer vertices first: so of features that are as near, those that have no others in them come first.
std::vector<Part> parts_of(const ConvexPolyhedron& body) {
  std::vector<Part> parts;
  const auto n = static_cast<std::uint32_t>(body.vertices().size());
  for (std::uint32_t v = 0; v < n; ++v) parts.push_back({1, {v, 0, 0}});
  for (std::uint32_t v = 0; v < n; ++v) {
    for (const std::uint32_t w : body.neighbours(v)) {
      if (v < w) parts.push_back({2, {v, w, 0}});
    }
  }
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    for (std::size_t k = 2; k < facet.size(); ++k) parts.push_back({3, {facet[0], facet[k - 1], facet[k]}});
  }
  return parts;
}

template <class T>
struct Square {
  Guess faces;  // are the nearest points of the flats in both parts? At an end will do
  T numerator, denominator;
};

template <class T>
Guess all_of(std::initializer_list<T> numbers) {
  Guess all = Guess::positive;
  for (const T& x : numbers) {
    const Guess guess = sign(x);
    if (guess == Guess::negative) return guess;
    if (guess == Guess::unsure) all = guess;
  }
  return all;
}

template <class T>
Square<T> square_between(const std::vector<Vector3<T>>& a, const Part& p, const std::vector<Vector3<T>>& b,
                         const Part& q) {
  const Vector3<T> r = b[q.vertex[0]] - a[p.vertex[0]];
  std::array<Vector3<T>, 2> e;
  std::size_t n = 0;
  for (std::size_t k = 1; k < p.count; ++k) e[n++] = a[p.vertex[k]] - a[p.vertex[0]];
  for (std::size_t k = 1; k < q.count; ++k) e[n++] = b[q.vertex[0]] - b[q.vertex[k]];
  if (n == 0) return {Guess::positive, dot(r, r), T(1.0)};
  const T ee = dot(e[0], e[0]), re = dot(r, e[0]);
  if (n == 1) return {all_of({re, ee - re}), dot(r, r) * ee - re * re, ee};
  const T ff = dot(e[1], e[1]), ef = dot(e[0], e[1]), rf = dot(r, e[1]);
  const T whole = ee * ff - ef * ef, s = re * ff - rf * ef, t = rf * ee - re * ef;
  const T numerator = dot(r, r) * whole - re * s - rf * t;
  // Edges that are parallel are nearest at an end, too.
  const Guess spans = sign(whole) == Guess::zero ? Guess::negative : sign(whole);
  if (spans != Guess::positive) return {spans, numerator, whole};
  if (p.count == 2) return {all_of({s, t, whole - s, whole - t}), numerator, whole};
  return {all_of({s, t, whole - s - t}), numerator, whole};
}

template <class Number>
std::vector<Vector3<Number>> images(const Placed& body) {
  std::vector<Vector3<Number>> all;
  for (std::uint32_t v = 0; v < body.graph.vertices.size(); ++v) all.push_back(coordinates<Number>(body[v]));
  return all;
}

}  // namespace

PolyhedronDistance polyhedron_polyhedron_distance_by_scan(const ConvexPolyhedron& body_a, const Pose& pose_a,
                                                          const ConvexPolyhedron& body_b, const Pose& pose_b) {
  PairAnswer answer = polyhedron_polyhedron_by_scan(body_a, pose_a, body_b, pose_b);
  if (const auto* common = std::get_if<CommonVertices>(&answer.evidence)) {
    return {*common, answer.decided_by, answer.cost};
  }
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  const auto enclosed_a = images<Interval>(a), enclosed_b = images<Interval>(b);
  const auto exact_a = images<Dyadic>(a), exact_b = images<Dyadic>(b);
  const std::vector<Part> parts_a = parts_of(body_a), parts_b = parts_of(body_b);
  Square<Dyadic> least{Guess::unsure, {}, {}};
  Interval least_enclosed;
  Part best_a{}, best_b{};
  for (const Part& p : parts_a) {
    for (const Part& q : parts_b) {
      if (p.count + q.count > 4) continue;
      const Square<Interval> enclosed = square_between(enclosed_a, p, enclosed_b, q);
      if (enclosed.faces == Guess::negative) continue;
      const bool is_first = least.faces != Guess::positive;
      if (!is_first && (enclosed.numerator / enclosed.denominator).low > least_enclosed.high) continue;
      Square<Dyadic> exact = square_between(exact_a, p, exact_b, q);
      ++answer.cost.exact;
      if (exact.faces == Guess::negative) continue;
      if (!is_first &&
          (exact.numerator * least.denominator - least.numerator * exact.denominator).sign() != Sign::negative) {
        continue;
      }
      least = std::move(exact);
      best_a = p;
      best_b = q;
      const std::int64_t top = least.denominator.top();
      least_enclosed = least.numerator.scaled(-top).enclosure() / least.denominator.scaled(-top).enclosure();
    }
  }
  FeatureVertices found{best_a.count, best_b.count, {}};
  for (std::size_t k = 0; k < best_a.count; ++k) found.vertices[k] = best_a.vertex[k];
  for (std::size_t k = 0; k < best_b.count; ++k) found.vertices[best_a.count + k] = best_b.vertex[k];
  return {ClosestFeatures(body_a.vertices(), pose_a, body_b.vertices(), pose_b, found), answer.decided_by, answer.cost};
}

}  // namespace sunder::solid
