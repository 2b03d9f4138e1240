#include <sunder/solid/search/simplex_proposals.h>

#include <algorithm>
#include <type_traits>

namespace sunder::solid {

template <class Real>
bool propose_meet(const Placed& a, const Placed& b, const DifferenceSimplexOf<Real>& simplex, const Holds& holds) {
  if (simplex.count == 0) return false;
  const std::array<Real, 4> weights = weights_of_nearest(simplex);
  Proposal p;
  p.near_a = simplex.vertex[0].a, p.near_b = simplex.vertex[0].b;
  if constexpr (std::is_same_v<Real, double>) {
    if (simplex.count == 4 && *std::min_element(weights.begin(), weights.end()) > 0 &&
        name_five_of_tetrahedron(a, simplex, weights, p) && holds(p)) {
      return true;
    }
  }
  // A tetrahedron mostly holds the origin properly; in a smaller simplex something vanishes.
  for (const bool drop_negligible : {simplex.count < 4, simplex.count == 4}) {
    if (name_at_most_five(a, b, simplex, weights, drop_negligible, p) && holds(p)) return true;
  }
  return false;
}

template <class Real>
bool propose_apart_along_perpendicular(const DifferenceSimplexOf<Real>& simplex, std::uint32_t near_a,
                                       std::uint32_t near_b, const Holds& holds) {
  if (simplex.count < 1 || simplex.count > 3) return false;
  const std::size_t n = static_cast<std::size_t>(simplex.count);
  Proposal p{Proposal::Claim::apart_along_perpendicular,
             static_cast<std::uint8_t>(n),
             static_cast<std::uint8_t>(n),
             {},
             near_a,
             near_b,
             {},
             {}};
  for (std::size_t i = 0; i < n; ++i) p.vertices[i] = simplex.vertex[i].a, p.vertices[n + i] = simplex.vertex[i].b;
  return holds(p);
}

bool propose_apart_along_features(const DifferenceSimplex& given, const Point3& towards, const Holds& holds) {
  // A tetrahedron with the origin next to a face counts as that face.
  DifferenceSimplex simplex = given;
  if (given.count == 4) {
    const std::array<double, 4> weights = weights_of_origin(given);
    const double least = *std::max_element(weights.begin(), weights.end()) * negligible<double>;
    simplex.count = 0;
    for (std::size_t i = 0; i < 4; ++i) {
      if (weights[i] > least) simplex.vertex[static_cast<std::size_t>(simplex.count++)] = given.vertex[i];
    }
    if (simplex.count == 4) return false;
  }
  Support of_a, of_b;
  const DifferenceVertex* nearest = nullptr;
  double largest = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) {
    const DifferenceVertex& w = simplex.vertex[i];
    of_a.add(w.a);
    of_b.add(w.b);
    largest = std::max(largest, dot(w.at, w.at));
    if (nearest == nullptr || dot(w.at, w.at) < dot(nearest->at, nearest->at)) nearest = &w;
  }
  if (nearest == nullptr) return false;
  if (simplex.count == 1 || dot(nearest->at, nearest->at) < largest * (negligible<double> * negligible<double>)) {
    if (holds(apart_at_vertices(nearest->a, nearest->b))) return true;
  }
  const auto& p = of_a.vertex;
  const auto& q = of_b.vertex;
  using enum Proposal::Claim;
  const auto along = [&](Proposal::Claim claim, std::uint8_t count_a, std::uint8_t count_b,
                         const std::array<std::uint32_t, 6>& vertices) {
    return holds(Proposal{claim, count_a, count_b, vertices, p[0], q[0], towards, {}});
  };
  if (of_a.count == 3 && along(apart_along_normal_of_a, 3, 0, {p[0], p[1], p[2]})) return true;
  if (of_b.count == 3 && along(apart_along_normal_of_b, 0, 3, {q[0], q[1], q[2]})) return true;
  if (of_a.count == 2 && of_b.count == 2 && along(apart_along_edge_x_edge, 2, 2, {p[0], p[1], q[0], q[1]})) return true;
  return of_a.count == 1 && of_b.count == 1 && along(apart_along_difference, 1, 1, {p[0], q[0]});
}

template bool propose_meet(const Placed&, const Placed&, const DifferenceSimplexOf<double>&, const Holds&);
template bool propose_meet(const Placed&, const Placed&, const DifferenceSimplexOf<DoubleDouble>&, const Holds&);
template bool propose_apart_along_perpendicular(const DifferenceSimplexOf<DoubleDouble>&, std::uint32_t, std::uint32_t,
                                                const Holds&);

}  // namespace sunder::solid
