#include <sunder/number/integer_internal.h>
#include <sunder/predicate/stages.h>
#include <sunder/solid/pair/contact_evidence.h>
#include <sunder/solid/pair/exact_simplex.h>
#include <sunder/solid/pair/spanning_vertices.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

constexpr std::size_t most_rows = 5;
using Column = std::array<Integer, most_rows>;

// A variable: the weight of a vertex, or an artificial one.
struct Variable {
  enum class Kind : std::uint8_t { artificial, of_a, of_b };
  Kind kind = Kind::artificial;
  std::uint32_t vertex = 0;
};

constexpr std::size_t whole_weight = 12;  // a multiple of 1, 2, 3 and 4

class ExactSimplex {
 public:
  ExactSimplex(const Placed& a, const Placed& b, Cost& cost, StageTally& tally)
      : a_(a), b_(b), cost_(cost), tally_(tally) {
    exponent_ = std::min(least_exponent(a), least_exponent(b));
  }

  PairCertificate common_point(const DifferenceSimplex& hint) {
    rows_ = 5;
    start({0, 0, 0, 1, 1});
    minimize(hint);
    return certificate();
  }

  bool interiors_meet(const std::vector<std::uint32_t>& span_a, const std::vector<std::uint32_t>& span_b) {
    rows_ = 4;
    // whole_weight (mean of A's - mean of B's).
    Column c{};
    for (const std::uint32_t v : span_a) add_multiple(c, {Variable::Kind::of_a, v}, whole_weight / span_a.size());
    for (const std::uint32_t v : span_b) add_multiple(c, {Variable::Kind::of_b, v}, whole_weight / span_b.size());
    start({-c[0], -c[1], -c[2], 0, 0});
    minimize({});
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basis_[i].kind == Variable::Kind::artificial && !solution_[i].is_zero()) return false;
    }
    return true;
  }

  // After interiors_meet said so: the point sum l_i a_i + whole_weight (mean of A's), over the sum of these weights.
  CommonPoint inner_point(const std::vector<std::uint32_t>& span_a, const std::vector<std::uint32_t>& span_b) const {
    CommonPoint point;
    point.of_a = inner_weights(Variable::Kind::of_a, span_a);
    point.of_b = inner_weights(Variable::Kind::of_b, span_b);
    point.denominator = point.of_a.denominator;
    Vector3<Dyadic> sum{};
    for (const auto& [v, weight] : point.of_a.parts) {
      const Vector3<Dyadic> p = lift<ExactStage>(a_[v]);
      sum = {sum.x + p.x * weight, sum.y + p.y * weight, sum.z + p.z * weight};
    }
    point.coordinates = {sum.x, sum.y, sum.z};
    return point;
  }

  // After interiors_meet denied it: along it no vertex of A is further than any of B, and A's mean is less far.
  std::array<Dyadic, 3> parting() const { return dyadics(multipliers()); }

 private:
  // The basis of artificial variables, with the signs that make the solution not negative.
  void start(const Column& right_hand_side) {
    for (std::size_t i = 0; i < rows_; ++i) {
      inverse_[i] = {};
      inverse_[i][i] = right_hand_side[i] < 0 ? -1 : 1;
      solution_[i] = boost::multiprecision::abs(right_hand_side[i]);
    }
  }

  // The weights of the vertices of one body, all times determinant_: of the basis, and of those that span it.
  Combination inner_weights(Variable::Kind kind, const std::vector<std::uint32_t>& span) const {
    std::vector<std::pair<std::uint32_t, Integer>> weights;
    for (const std::uint32_t v : span) weights.push_back({v, determinant_ * (whole_weight / span.size())});
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basis_[i].kind != kind || solution_[i].is_zero()) continue;
      auto of_vertex =
          std::find_if(weights.begin(), weights.end(), [&](const auto& w) { return w.first == basis_[i].vertex; });
      if (of_vertex == weights.end()) of_vertex = weights.insert(of_vertex, {basis_[i].vertex, 0});
      of_vertex->second += solution_[i];
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

  static std::array<Dyadic, 3> dyadics(const Column& c) {
    return {dyadic_of(c[0], 0), dyadic_of(c[1], 0), dyadic_of(c[2], 0)};
  }

  void add_multiple(Column& sum, const Variable& v, std::size_t factor) const {
    const Column c = column(v);
    for (std::size_t k = 0; k < 3; ++k) sum[k] += c[k] * factor;
  }

  void minimize(const DifferenceSimplex& hint) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(hint.count); ++i) {
      enter_if_it_pays({Variable::Kind::of_a, hint.vertex[i].a});
      enter_if_it_pays({Variable::Kind::of_b, hint.vertex[i].b});
    }
    if (hint.count > 0) {
      at_a_ = hint.vertex[0].a;
      at_b_ = hint.vertex[0].b;
    }
    do {
      const Column y = multipliers();
      if (y[0] == 0 && y[1] == 0 && y[2] == 0) continue;  // all of one body have one price
      const WorldDirection direction(Vector3<Dyadic>{dyadic_of(y[0], 0), dyadic_of(y[1], 0), dyadic_of(y[2], 0)});
      Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
      at_a_ = extreme_vertex_from(a_, along_a, End::greatest, at_a_, cost_, tally_);
      at_b_ = extreme_vertex_from(b_, along_b, End::least, at_b_, cost_, tally_);
    } while (enter_if_it_pays({Variable::Kind::of_a, at_a_}) || enter_if_it_pays({Variable::Kind::of_b, at_b_}));
  }

  // An exponent that divides all coordinates of all images of the body.
  static std::int64_t least_exponent(const Placed& body) {
    const auto lowest_bit = [](const SizeRange& range) {
      // A double of size at least s is a multiple of 2^(exponent of s - 52), and of 2^-1074.
      return range.greatest == 0 ? std::int64_t{0} : std::max<std::int64_t>(std::ilogb(range.least) - 52, -1074);
    };
    const SizeRange linear = size_range(std::span<const double>(body.pose.linear));
    const SizeRange translation = size_range(std::span<const double>(body.pose.translation));
    return std::min(lowest_bit(linear) + lowest_bit(body.graph.sizes), lowest_bit(translation));
  }

  Integer scaled(const Dyadic& x) const {
    if (mantissa_of(x).is_zero()) return 0;
    return mantissa_of(x) << static_cast<unsigned long>(x.exponent() - exponent_);
  }

  Column column(const Variable& v) const {
    const bool of_a = v.kind == Variable::Kind::of_a;
    const Vector3<Dyadic> p = lift<ExactStage>(of_a ? a_[v.vertex] : b_[v.vertex]);
    const Vector3<Integer> q{scaled(p.x), scaled(p.y), scaled(p.z)};
    if (of_a) return {q.x, q.y, q.z, 1, 0};
    return {-q.x, -q.y, -q.z, rows_ == 4 ? -1 : 0, 1};
  }

  // The multipliers times determinant_: costs of one on the artificial variables in the basis.
  Column multipliers() const {
    Column y{};
    for (std::size_t i = 0; i < rows_; ++i) {
      if (basis_[i].kind != Variable::Kind::artificial) continue;
      for (std::size_t k = 0; k < rows_; ++k) y[k] += inverse_[i][k];
    }
    return y;
  }

  bool enter_if_it_pays(const Variable& v) {
    const Column c = column(v);
    const Column y = multipliers();
    Integer price = 0;
    for (std::size_t k = 0; k < rows_; ++k) price += y[k] * c[k];
    ++tally_.exact;
    if (price <= 0) return false;
    Column t{};  // the column in terms of the basis, times determinant_
    for (std::size_t i = 0; i < rows_; ++i) {
      for (std::size_t k = 0; k < rows_; ++k) t[i] += inverse_[i][k] * c[k];
    }
    pivot(leaving_row(t), t, v);
    return true;
  }

  // Among rows with t > 0 (there is one: the price is the sum of t over artificial rows), the lexicographically least
  // (solution, inverse) / t.
  std::size_t leaving_row(const Column& t) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rows_; ++i) {
      if (t[i] <= 0) continue;
      if (!best || lexicographically_less(i, *best, t)) best = i;
    }
    return *best;
  }

  bool lexicographically_less(std::size_t i, std::size_t j, const Column& t) const {
    const auto less = [&](const Integer& at_i, const Integer& at_j) {
      ++tally_.exact;
      return (at_i * t[j]).compare(at_j * t[i]);
    };
    int order = less(solution_[i], solution_[j]);
    for (std::size_t k = 0; order == 0 && k < rows_; ++k) order = less(inverse_[i][k], inverse_[j][k]);
    return order < 0;
  }

  void pivot(std::size_t r, const Column& t, const Variable& entering) {
    for (std::size_t i = 0; i < rows_; ++i) {
      if (i == r) continue;
      for (std::size_t k = 0; k < rows_; ++k) {
        inverse_[i][k] = (inverse_[i][k] * t[r] - inverse_[r][k] * t[i]) / determinant_;  // exact
      }
      solution_[i] = (solution_[i] * t[r] - solution_[r] * t[i]) / determinant_;
    }
    determinant_ = t[r];
    basis_[r] = entering;
  }

  PairCertificate certificate() const {
    PairCertificate c;
    const Column y = multipliers();
    if (y[3] + y[4] > 0) {  // the sum of the artificial variables
      c.verdict = Verdict::apart;
      c.direction.kind = Direction::Kind::exact;
      c.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(dyadics(y));
      c.extreme_a = at_a_;
      c.extreme_b = at_b_;
      return c;
    }
    c.verdict = Verdict::meet;
    std::size_t n = 0;
    for (const Variable::Kind kind : {Variable::Kind::of_a, Variable::Kind::of_b}) {
      for (std::size_t i = 0; i < rows_; ++i) {
        if (basis_[i].kind != kind || solution_[i].is_zero()) continue;
        c.vertices[n++] = basis_[i].vertex;
        ++(kind == Variable::Kind::of_a ? c.count_a : c.count_b);
      }
    }
    return c;
  }

  const Placed& a_;
  const Placed& b_;
  Cost& cost_;
  StageTally& tally_;
  std::int64_t exponent_;  // images are multiples of 2^exponent_, and counted in it
  std::size_t rows_ = 0;
  std::uint32_t at_a_ = 0, at_b_ = 0;  // the extreme vertices along the last direction
  std::array<Variable, most_rows> basis_{};
  Integer determinant_ = 1;                  // of the basis, as its absolute value
  std::array<Column, most_rows> inverse_{};  // of the basis, times determinant_
  Column solution_{};                        // the values of the basic variables, times determinant_
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

void add_claims(PairClaims& pairs, const ClaimedPair& pair, const PairCertificate& certificate, Contact contact) {
  if (contact == Contact::none) return pairs.add_pair(pair.index_a, pair.index_b, certificate);
  const Interiors found = interiors(pair.a, pair.pose_a, pair.b, pair.pose_b);
  if (found.meet) return pairs.add_overlapping(pair.index_a, pair.index_b, found.point);
  pairs.add_touching(pair.index_a, pair.index_b, pairs.common_point(pair.index_a, pair.index_b, certificate),
                     found.direction);
}

}  // namespace sunder::solid
