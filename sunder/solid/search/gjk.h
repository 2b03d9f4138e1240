// The search of Gilbert, Johnson and Keerthi in space, in double or in double-double precision: one point of the
// difference A - B after another, each further towards the origin. Supports know the bodies. What the search leaves is
// for proposals; nothing here decides anything.
// Source: Gilbert, Johnson, Keerthi 1988.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/search/closest_simplex.h>

#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>

namespace sunder::solid {

// Why a search ended.
enum class GjkEnd : std::uint8_t {
  stopped,   // by its caller
  no_gain,   // no point is further along the direction than the simplex, by more than the noise of floating point
  inside,    // the simplex holds the origin, or comes as near as floating point can tell
  circling,  // several steps in a row came no nearer
  too_long,
};

struct GjkLimits {
  int steps = 100;
  int in_vain = 4;  // steps in a row that come no nearer
};

struct GjkNever {
  bool operator()(const auto&) const { return false; }
};

// Support: what a search knows of the difference.
//   scale                                   of its points: a power of two
//   first_direction()                       from A towards B, about; not zero
//   furthest(direction, simplex, cost)      a vertex of the difference that is furthest along the direction, about
//   are_same(v, w)                          two such vertices
//   noise(direction, w)                     what rounding may make of the way of w along the direction
//   noise2(v)                               the same of the distance of the vertex v from the origin, squared
//   is_coarse(), refine()                   is furthest() about a part of the bodies only? no longer, after refine()
template <class Real, class Support>
class Gjk {
 public:
  using Vector = VectorOf<Real>;
  using Vertex = DifferenceVertexOf<Real>;

  template <class A, class B, class... More>
  Gjk(const A& a, const B& b, More&... more) : support(a, b, more...) {
    simplex.scale = support.scale;
  }

  // Without a simplex; the support's first direction, where this one is zero.
  void begin(const Vector& first) {
    simplex.count = 0;
    direction = dot(first, first) > Real(0) ? first : support.first_direction();
  }

  Vertex probe(Cost& cost) { return support.furthest(direction, simplex, cost); }

  // How far the direction parts A from B, times its length, if w is furthest along it.
  Real gap_at(const Vertex& w) const { return -dot(direction, w.at); }

  // Is w further along the direction than the face, by more than the noise of floating point?
  bool gains_by(const Vertex& w) const {
    if (simplex.count == 0) return true;
    bool is_there = false;  // without branches: how many vertices there are is hard to predict
    for (int i = 0; i < 4; ++i) {
      is_there |= (i < simplex.count) & support.are_same(simplex.vertex[static_cast<std::size_t>(i)], w);
    }
    return !is_there && dot(direction, minus(w.at, simplex.vertex[0].at)) > support.noise(direction, w);
  }

  // One step: w joins the simplex, which becomes its face nearest to the origin. False where that is no use: the origin
  // is inside, or as near as floating point can tell.
  bool step_to(const Vertex& w) {
    simplex.vertex[static_cast<std::size_t>(simplex.count++)] = w;
    if (!reduce_to_closest_face(simplex, direction, distance2)) return false;
    return distance2 > (simplex.count == 1 ? support.noise2(simplex.vertex[0]) : Real(0));
  }

  // From the direction and the simplex that there are, until a caller's function is true:
  //   on_vertex(w)        w is furthest along the direction
  //   on_step(is_nearer)  after a step; is the simplex the nearest one so far?
  template <class OnVertex = GjkNever, class OnStep = GjkNever>
  GjkEnd run(const GjkLimits& limits, Cost& cost, const OnVertex& on_vertex = {}, const OnStep& on_step = {}) {
    Real nearest2 = std::numeric_limits<double>::infinity();
    int in_vain = 0;
    for (int i = 0; i < limits.steps; ++i) {
      ++cost.iterations;
      const Vertex w = probe(cost);
      const bool is_coarse = support.is_coarse();
      if (!is_coarse && on_vertex(w)) return GjkEnd::stopped;
      if ((is_coarse && gap_at(w) > Real(0)) || !gains_by(w)) {
        if (!is_coarse) return GjkEnd::no_gain;
        support.refine();
        continue;
      }
      if (!step_to(w)) return GjkEnd::inside;
      const bool is_nearer = distance2 < nearest2;
      if (on_step(is_nearer)) return GjkEnd::stopped;
      if (is_nearer) {
        nearest2 = distance2;
        in_vain = 0;
      } else if (++in_vain == limits.in_vain) {
        return GjkEnd::circling;
      }
    }
    return GjkEnd::too_long;
  }

  Support support;
  Vector direction{};                 // of the world, from A towards B
  DifferenceSimplexOf<Real> simplex;  // the face nearest to the origin, or the tetrahedron around it
  Real distance2 = 0;                 // of that face, squared, after a step
};

// For supports that keep what their vertices are differences of, by the number `a`: one below 5 that none has.
template <class Real>
std::uint32_t free_slot(const DifferenceSimplexOf<Real>& simplex) {
  std::uint32_t used = 0;
  for (std::size_t i = 0; i < static_cast<std::size_t>(simplex.count); ++i) used |= 1U << simplex.vertex[i].a;
  return static_cast<std::uint32_t>(std::countr_one(used));
}

// The point of a simplex that is nearest to the origin, as a mean of its vertices: `a` of those, and weights over
// their sum.
template <class Real>
struct MeanOf {
  struct Part {
    std::uint32_t a;
    Real weight;  // positive
  };
  std::array<Part, 4> parts;
  std::size_t count = 0;
  Real total = 0;  // of the weights, finite

  const Part* begin() const { return parts.data(); }
  const Part* end() const { return parts.data() + count; }
};

// Nothing where rounding leaves none. The simplex must be the least face that holds the point, or empty.
template <class Real>
std::optional<MeanOf<Real>> mean_nearest(const DifferenceSimplexOf<Real>& simplex) {
  if (simplex.count == 0) return std::nullopt;
  const std::array<Real, 4> weights = weights_of_nearest(simplex);
  MeanOf<Real> mean;
  for (std::size_t k = 0; k < static_cast<std::size_t>(simplex.count); ++k) {
    if (!(weights[k] > Real(0))) continue;
    mean.parts[mean.count++] = {simplex.vertex[k].a, weights[k]};
    mean.total = mean.total + weights[k];
  }
  if (!(mean.total > Real(0)) || !std::isfinite(nearest(mean.total))) return std::nullopt;
  return mean;
}

}  // namespace sunder::solid
