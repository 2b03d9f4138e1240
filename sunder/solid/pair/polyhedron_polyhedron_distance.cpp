// The search proposes features, which are checked exactly; where none hold, the descent decides.
//
// Why what is checked is enough: let p and q be the ends of the shortest way d between the features, in their hulls.
// As no vertex of A is further along d than those of the feature, all of which are as far as p, and no vertex of B less
// far than q, for all x of A and y of B d (y - x) >= d (q - p) = |d|^2: so none are nearer to each other.
#include <sunder/base/contract.h>
#include <sunder/number/estimate_ratio.h>
#include <sunder/number/root.h>
#include <sunder/solid/exact/exact_gjk.h>
#include <sunder/solid/object/search_graph_walk.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/search/closest_features.h>
#include <sunder/solid/search/extreme_vertex.h>
#include <sunder/solid/search/graph_support.h>

#include <cmath>

namespace sunder::solid {

namespace {

// The images of the vertices, as the predicates of shortest_way.h take them.
class PosedFeatures {
 public:
  PosedFeatures(const Placed& a, const Placed& b, const FeatureVertices& f) : count_a_(f.count_a), count_b_(f.count_b) {
    for (std::size_t k = 0; k < count_a_; ++k) points_[k] = a[f.of_a(k)];
    for (std::size_t k = 0; k < count_b_; ++k) points_[count_a_ + k] = b[f.of_b(k)];
  }
  std::span<const Posed3> a() const { return {points_.data(), count_a_}; }
  std::span<const Posed3> b() const { return {points_.data() + count_a_, count_b_}; }

 private:
  std::size_t count_a_, count_b_;
  std::array<Posed3, 4> points_;
};

// The closest features of bodies that are apart.
class Closest {
 public:
  Closest(const Placed& a, const Placed& b, Cost& cost, StageTally& tally) : a_(a), b_(b), cost_(cost), tally_(tally) {}

  FeatureVertices features;

  // Are these the closest features? Vertices of weight zero are left out.
  bool dispose(const FeatureVertices& proposal) {
    ++cost_.proposals;
    features = proposal;
    const PosedFeatures posed(a_, b_, proposal);
    const EnclosedWay enclosed = enclosed_way(posed.a(), posed.b());
    if (enclosed.weights == Guess::negative) return false;
    if (enclosed.weights == Guess::positive) {
      const std::span<const std::uint32_t> all(proposal.vertices),
          of_a = all.first(proposal.count_a), of_b = all.subspan(proposal.count_a, proposal.count_b);
      if (surely_all(a_, of_a, EnclosedAlong(enclosed.way, a_.pose), &EnclosedAlong::surely_less_far) &&
          surely_all(b_, of_b, EnclosedAlong(enclosed.way, b_.pose), &EnclosedAlong::surely_further)) {
        return true;
      }
    }
    ++tally_.exact;
    const std::optional<ExactWay> found = exact_way(posed.a(), posed.b());
    if (!found) return false;
    const auto [of_a, of_b] = extreme_vertices(found->way);
    if (of_a != proposal.of_a(0) || of_b != proposal.of_b(0)) return false;
    leave_out_zeros(found->weight);
    return true;
  }

  // From the features, which need not be the closest ones of their own hulls.
  void descend() {
    ExactNearest nearest;
    for (std::size_t k = 0; k < features.count_a; ++k) add(nearest.a, a_, features.of_a(k));
    for (std::size_t k = 0; k < features.count_b; ++k) add(nearest.b, b_, features.of_b(k));
    [[maybe_unused]] const bool are_apart = exact_gjk(*this, nearest, tally_.exact);
    SUNDER_REQUIRE(are_apart);
    features = nearest.closest.features;
  }

  // As the support of that search.
  std::array<std::uint32_t, 2> extreme(const ExactNearest& nearest) {
    ++cost_.iterations;
    ++tally_.exact;
    features = nearest.closest.features;
    return extreme_vertices(nearest.closest.way);
  }
  void join(ExactNearest& nearest, const std::array<std::uint32_t, 2>& next) const {
    add(nearest.a, a_, next[0]);
    add(nearest.b, b_, next[1]);
  }

 private:
  // Of A furthest, of B least far, from the features' first vertices on: these, where nothing is beyond them.
  std::array<std::uint32_t, 2> extreme_vertices(const ShortestWay<Dyadic>& way) {
    const WorldDirection direction(way.way);
    Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
    return {extreme_vertex_from(a_, along_a, End::greatest, features.of_a(0), cost_, tally_),
            extreme_vertex_from(b_, along_b, End::least, features.of_b(0), cost_, tally_)};
  }

  // Are all neighbours of the first of the vertices, but for the others, which are as far, surely behind it? Not told
  // of a vertex of many: exact walks down the hierarchy do that.
  using Behind = bool (EnclosedAlong::*)(const Point3& from, const Point3& to) const;
  bool surely_all(const Placed& body, std::span<const std::uint32_t> of, const EnclosedAlong& along, Behind behind) {
    const VertexBlock block = body.graph.block(body.graph.place[of[0]]);
    const std::uint32_t count = block.count();
    if (count > most_around) return false;
    const Point3 at = block.at();
    cost_.probes += count;
    for (std::uint32_t j = 0; j < count; ++j) {
      if ((along.*behind)(at, {block.x()[j], block.y()[j], block.z()[j]})) continue;
      if (std::find(of.begin(), of.end(), body.graph.block(block.place(j)).vertex()) == of.end()) return false;
    }
    tally_.interval += count;
    return true;
  }

  void leave_out_zeros(const std::array<Dyadic, 4>& weight) {
    const FeatureVertices all = features;
    features = {};
    std::size_t n = 0;
    for (std::size_t k = 0; k < std::size_t{all.count_a} + all.count_b; ++k) {
      if (weight[k].sign() == Sign::zero) continue;
      features.vertices[n++] = all.vertices[k];
      ++(k < all.count_a ? features.count_a : features.count_b);
    }
  }

  static void add(VertexSet<Dyadic>& set, const Placed& body, std::uint32_t v) {
    if (!set.has(v)) set.add(v, coordinates<Dyadic>(body[v]));
  }

  const Placed& a_;
  const Placed& b_;
  Cost& cost_;
  StageTally& tally_;
};

// From the difference of these vertices on.
template <class Real>
bool propose(const Placed& a, const Placed& b, std::uint32_t from_a, std::uint32_t from_b, Closest& closest,
             Cost& cost) {
  GjkSearch<Real> search(a, b);
  if (search.step_to(search.support.of_vertices(from_a, from_b))) search.run({}, cost);
  VertexSet<Real> of_a, of_b;
  for (int i = 0; i < search.simplex.count; ++i) {
    const DifferenceVertexOf<Real>& v = search.simplex.vertex[static_cast<std::size_t>(i)];
    if (!of_a.has(v.a)) of_a.add(v.a, search.support.image_of_a(v.a));
    if (!of_b.has(v.b)) of_b.add(v.b, search.support.image_of_b(v.b));
  }
  return closest.dispose(closest_features(of_a, of_b));
}

}  // namespace

ClosestFeatures::ClosestFeatures(std::span<const Point3> a, const Pose& pose_a, std::span<const Point3> b,
                                 const Pose& pose_b, const FeatureVertices& features)
    : features_(features), pose_a_(pose_a.affine()), pose_b_(pose_b.affine()) {
  for (std::size_t k = 0; k < features.count_a; ++k) points_[k] = a[features.of_a(k)];
  for (std::size_t k = 0; k < features.count_b; ++k) points_[features.count_a + k] = b[features.of_b(k)];
}

std::array<Posed3, 4> ClosestFeatures::images() const {
  std::array<Posed3, 4> posed;
  for (std::size_t k = 0; k < posed.size(); ++k)
    posed[k] = {points_[k], k < features_.count_a ? &pose_a_ : &pose_b_, false};
  return posed;
}

ExactWay ClosestFeatures::way() const {
  const std::array<Posed3, 4> posed = images();
  const std::span<const Posed3> all(posed);
  return *exact_way(all.first(features_.count_a), all.subspan(features_.count_a, features_.count_b));
}

template <class Number>
auto ClosestFeatures::arrows_in() const {
  const std::array<Posed3, 4> posed = images();
  const std::span<const Posed3> all(posed);
  return flat_arrows<Number>(all.first(features_.count_a), all.subspan(features_.count_a, features_.count_b));
}

template <class Number>
auto ClosestFeatures::way_in() const {
  return shortest_way(arrows_in<Number>());
}

// The nearest points, of A and of B, over a denominator.
template <class Number>
auto ClosestFeatures::ends_in() const {
  const auto arrows = arrows_in<Number>();
  const ShortestWay<Number> way = shortest_way(arrows);
  const std::array<Number, 4> weights = weights_of(arrows, way);
  const std::array<Posed3, 4> posed = images();
  struct Ends {
    std::array<std::array<Number, 3>, 2> of;
    Number denominator;
  };
  const Number zero(0.0);
  Ends ends{{{{zero, zero, zero}, {zero, zero, zero}}}, way.denominator};
  for (std::size_t k = 0; k < std::size_t{features_.count_a} + features_.count_b; ++k) {
    auto& [x, y, z] = ends.of[k < features_.count_a ? 0 : 1];
    const auto at = coordinates<Number>(posed[k]);
    x = x + at.x * weights[k];
    y = y + at.y * weights[k];
    z = z + at.z * weights[k];
  }
  return ends;
}

std::array<Point3, 2> ClosestFeatures::nearest_points() const {
  const auto sure = ends_in<Estimate>();
  std::array<Point3, 2> points;
  bool is_sure = true;
  for (std::size_t k = 0; k < 6 && is_sure; ++k) {
    const Estimate quotient = ratio(sure.of[k / 3][k % 3], sure.denominator);
    const std::optional<double> nearest = surely_nearest(quotient.value, quotient.error);
    is_sure = nearest.has_value();
    points[k / 3][k % 3] = nearest.value_or(0) + 0.0;  // no zero below zero
  }
  if (is_sure) return points;
  const auto exact = ends_in<Dyadic>();
  for (std::size_t k = 0; k < 6; ++k) {
    points[k / 3][k % 3] = nearest_ratio(exact.of[k / 3][k % 3], exact.denominator);
  }
  return points;
}

ExactFraction ClosestFeatures::squared() const {
  const ShortestWay<Dyadic> found = way_in<Dyadic>();
  return {found.squared(), found.denominator};
}

Interval ClosestFeatures::distance() const {
  const ShortestWay<Estimate> estimate = way_in<Estimate>();
  if (const auto sure = sure_root(estimate.squared(), estimate.denominator)) return *sure;
  return root(squared());
}

PolyhedronDistance polyhedron_polyhedron_distance(const ConvexPolyhedron& body_a, const Pose& pose_a,
                                                  const ConvexPolyhedron& body_b, const Pose& pose_b) {
  PairAnswer answer = polyhedron_polyhedron(body_a, pose_a, body_b, pose_b);
  if (const auto* common = std::get_if<CommonVertices>(&answer.evidence)) {
    return {*common, answer.decided_by, answer.cost};
  }
  const Placed a(body_a, pose_a), b(body_b, pose_b);
  StageTally tally;
  Closest closest(a, b, answer.cost, tally);
  const Separation& apart = std::get<Separation>(answer.evidence);
  const bool held =
      propose<double>(a, b, apart.extreme_a, apart.extreme_b, closest, answer.cost) ||
      propose<DoubleDouble>(a, b, closest.features.of_a(0), closest.features.of_b(0), closest, answer.cost);
  if (!held) closest.descend();
  conclude(answer, answer.cost.exact + tally.exact, !held || answer.decided_by == DecidedBy::finishing);
  return {ClosestFeatures(body_a.vertices(), pose_a, body_b.vertices(), pose_b, closest.features), answer.decided_by,
          answer.cost};
}

Sign compare_distance(const PolyhedronDistance& distance, double radius) {
  SUNDER_REQUIRE(std::isfinite(radius) && radius >= 0);
  const ClosestFeatures* closest = closest_of(distance);
  if (closest == nullptr) return radius > 0 ? Sign::negative : Sign::zero;
  return compare_distance(*closest, radius);
}

Sign compare_distance(const ClosestFeatures& closest, double radius) {
  const auto [low, high] = closest.distance();
  if (radius < low) return Sign::positive;
  if (radius > high) return Sign::negative;
  return compare_root(closest.squared(), radius);
}

}  // namespace sunder::solid
