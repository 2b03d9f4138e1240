#include <sunder/number/exact/basis_internal.h>
#include <sunder/number/exact/scaled_integers_internal.h>
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/exact_simplex.h>
#include <sunder/solid/exact/spanning_vertices.h>
#include <sunder/solid/represent/bounded_hierarchy.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/of.h>

#include <algorithm>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

constexpr int most_steps_at_once = 24;  // before levels are gone down

constexpr std::size_t whole_weight = 12;  // a multiple of 1, 2, 3 and 4

class ExactSimplex {
 public:
  ExactSimplex(const Placed& a, const Placed& b, Cost& cost, StageTally& tally)
      : a_(a), b_(b), cost_(cost), tally_(tally) {
    exponent_ = std::min(least_exponent_of(a), least_exponent_of(b));
  }

  PairCertificate common_point(const DifferenceSimplex& hint) {
    basis_ = IntegerBasis(Column{0, 0, 0, 1, 1});
    minimize(hint);
    tally_.exact += basis_.comparisons();
    return certificate();
  }

  bool interiors_meet(const std::vector<std::uint32_t>& span_a, const std::vector<std::uint32_t>& span_b) {
    // whole_weight (mean of A's - mean of B's).
    Column c{};
    for (const std::uint32_t v : span_a) add_multiple(c, {of_a, v}, whole_weight / span_a.size());
    for (const std::uint32_t v : span_b) add_multiple(c, {of_b, v}, whole_weight / span_b.size());
    basis_ = IntegerBasis(std::array<Integer, 4>{-c[0], -c[1], -c[2], 0});
    minimize({});
    tally_.exact += basis_.comparisons();
    return basis_.is_solved();
  }

  // After interiors_meet said so: the point sum l_i a_i + whole_weight (mean of A's), over the sum of these weights.
  CommonPoint inner_point(const std::vector<std::uint32_t>& span_a, const std::vector<std::uint32_t>& span_b) const {
    CommonPoint point;
    point.of_a = inner_weights(of_a, span_a);
    point.of_b = inner_weights(of_b, span_b);
    const auto vertex = [&](std::uint32_t v) { return coordinates<Dyadic>(a_[v]); };
    point.at = exact_point(numerators_of(point.of_a, vertex), point.of_a.denominator);
    return point;
  }

  // After interiors_meet denied it: along it no vertex of A is further than any of B, and A's mean is less far.
  std::array<Dyadic, 3> parting() const { return direction(); }

 private:
  enum Kind : std::uint32_t { of_a, of_b };  // of variables: weights of vertices
  using Column = std::array<Integer, 5>;

  // The weights of the vertices of one body, all times basis_.denominator(): of the basis, and of those that span it.
  Combination inner_weights(Kind kind, const std::vector<std::uint32_t>& span) const {
    std::vector<std::pair<std::uint32_t, Integer>> weights;
    for (const std::uint32_t v : span) weights.push_back({v, basis_.denominator() * (whole_weight / span.size())});
    for (std::size_t i = 0; i < basis_.rows(); ++i) {
      const std::uint32_t v = basis_.variable(i).index;
      if (basis_.variable(i).kind != kind || basis_.value(i).is_zero()) continue;
      auto of_vertex = std::find_if(weights.begin(), weights.end(), [&](const auto& w) { return w.first == v; });
      if (of_vertex == weights.end()) of_vertex = weights.insert(of_vertex, {v, 0});
      of_vertex->second += basis_.value(i);
    }
    Combination combination;
    Integer sum = 0;
    for (const auto& [v, weight] : weights) {
      sum += weight;
      combination.parts.push_back({v, dyadic_of(weight, 0)});
    }
    combination.denominator = dyadic_of(sum, 0);
    return combination;
  }

  // Of the multipliers, the first three.
  std::array<Dyadic, 3> direction() const {
    const std::vector<Integer>& y = basis_.multipliers();
    return {dyadic_of(y[0], 0), dyadic_of(y[1], 0), dyadic_of(y[2], 0)};
  }

  void add_multiple(Column& sum, const BasicVariable& v, std::size_t factor) const {
    const Column c = column(v);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k] * factor;
  }

  void minimize(const DifferenceSimplex& hint) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(hint.count); ++i) {
      enter_if_it_pays({of_a, hint.vertex[i].a});
      enter_if_it_pays({of_b, hint.vertex[i].b});
    }
    if (hint.count > 0) {
      at_a_ = hint.vertex[0].a;
      at_b_ = hint.vertex[0].b;
    }
    for (int step = 0; step < most_steps_at_once; ++step) {
      if (!improve()) return;
    }
    // Where vertices crowd together, each step may halve a distance and no more. Down the hierarchies each level takes
    // a few: below, at most one vertex of each body is beyond the planes that part the levels (BL15 Lemma 4.2).
    for (std::size_t level = 0; level < std::max(level_count(a_), level_count(b_)); ++level) {
      while (improve(level)) continue;
    }
    while (improve()) continue;
  }

  // A step: true if a vertex came in. Of the levels of this number from the top, or of the whole bodies.
  bool improve(std::optional<std::size_t> level = std::nullopt) {
    const auto [x, y, z] = direction();
    const Vector3<Dyadic> along{x, y, z};
    if (!is_zero(along)) {  // else all of one body have one price
      const WorldDirection world(along);
      at_a_ = extreme(a_, world, End::greatest, at_a_, level);
      at_b_ = extreme(b_, world, End::least, at_b_, level);
    }
    return enter_if_it_pays({of_a, at_a_}) || enter_if_it_pays({of_b, at_b_});
  }

  // A point and a segment have one level, which is the body.
  static std::size_t level_count(const Placed& body) {
    if (body.graph.vertices.size() < 3) return 1;
    return body.by_bounded ? represent::of<BoundedHierarchy>(body.body).levels.size()
                           : represent::of<Hierarchy>(body.body).level_end.size();
  }

  std::uint32_t extreme(const Placed& body, const WorldDirection& direction, End end, std::uint32_t start,
                        std::optional<std::size_t> level) {
    Along along(direction, body.pose, body.tame);
    if (!level || body.graph.vertices.size() < 3) return extreme_vertex_from(body, along, end, start, cost_, tally_);
    if (body.by_bounded) {
      const auto& levels = represent::of<BoundedHierarchy>(body.body).levels;
      const std::uint32_t ranks = levels[std::min(*level, levels.size() - 1)].end;
      return extreme_vertex_by_bounded(body, along, end, cost_, tally_, ranks);
    }
    const auto& level_end = represent::of<Hierarchy>(body.body).level_end;
    return extreme_vertex_of_ranks(body, along, end, level_end[std::min(*level, level_end.size() - 1)], cost_, tally_);
  }

  // An exponent that divides all coordinates of all images of the body.
  static std::int64_t least_exponent_of(const Placed& body) {
    const auto lowest_bit = [](const SizeRange& range) {
      return range.greatest == 0 ? std::int64_t{0} : least_exponent(range.least);
    };
    const SizeRange linear = size_range(std::span<const double>(body.pose.linear));
    const SizeRange translation = size_range(std::span<const double>(body.pose.translation));
    return std::min(lowest_bit(linear) + lowest_bit(body.graph.sizes), lowest_bit(translation));
  }

  Column column(const BasicVariable& v) const {
    const Vector3<Dyadic> p = coordinates<Dyadic>(v.kind == of_a ? a_[v.index] : b_[v.index]);
    const Vector3<Integer> q{in_unit(p.x, exponent_), in_unit(p.y, exponent_), in_unit(p.z, exponent_)};
    if (v.kind == of_a) return {q.x, q.y, q.z, 1, 0};
    return {-q.x, -q.y, -q.z, basis_.rows() == 4 ? -1 : 0, 1};
  }

  bool enter_if_it_pays(const BasicVariable& v) {
    ++tally_.exact;
    const Column c = column(v);
    return basis_.enter_if_it_pays(v, std::span(c).first(basis_.rows()));
  }

  PairCertificate certificate() const {
    if (!basis_.is_solved()) return Separation{exact_direction(direction()), at_a_, at_b_};
    CommonVertices c;
    std::size_t n = 0;
    for (const Kind kind : {of_a, of_b}) {
      for (std::size_t i = 0; i < basis_.rows(); ++i) {
        if (basis_.variable(i).kind != kind || basis_.value(i).is_zero()) continue;
        c.vertices[n++] = basis_.variable(i).index;
        ++(kind == of_a ? c.count_a : c.count_b);
      }
    }
    return c;
  }

  const Placed& a_;
  const Placed& b_;
  Cost& cost_;
  StageTally& tally_;
  std::int64_t exponent_;              // images are multiples of 2^exponent_, and counted in it
  std::uint32_t at_a_ = 0, at_b_ = 0;  // the extreme vertices along the last direction
  IntegerBasis basis_;
};

}  // namespace

PairCertificate decide_by_exact_simplex(const Placed& a, const Placed& b, const DifferenceSimplex& hint, Cost& cost,
                                        StageTally& tally) {
  return ExactSimplex(a, b, cost, tally).common_point(hint);
}

bool interiors_meet(const ConvexPolyhedron& body_a, const Placed& a, const ConvexPolyhedron& body_b, const Placed& b,
                    StageTally& tally) {
  Cost cost;
  return ExactSimplex(a, b, cost, tally).interiors_meet(spanning_vertices(body_a), spanning_vertices(body_b));
}

Interiors interiors(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b) {
  Cost cost;
  StageTally tally;
  const Placed placed_a(a, pose_a), placed_b(b, pose_b);
  const std::vector<std::uint32_t> span_a = spanning_vertices(a), span_b = spanning_vertices(b);
  ExactSimplex simplex(placed_a, placed_b, cost, tally);
  if (simplex.interiors_meet(span_a, span_b)) return {true, simplex.inner_point(span_a, span_b), {}};
  return {false, {}, simplex.parting()};
}

}  // namespace sunder::solid
