#include <sunder/predicate/stages.h>
#include <sunder/solid/pair/exact_simplex.h>

#include <optional>

namespace sunder::solid {

namespace {

constexpr std::size_t rows = 5;
using Column = std::array<Integer, rows>;

// A variable: the weight of a vertex, or an artificial one.
struct Variable {
  enum class Kind : std::uint8_t { artificial, of_a, of_b };
  Kind kind = Kind::artificial;
  std::uint32_t vertex = 0;
};

class ExactSimplex {
 public:
  ExactSimplex(const Placed& a, const Placed& b, StageTally& tally) : a_(a), b_(b), tally_(tally) {
    exponent_ = std::min(least_exponent(a), least_exponent(b));
    for (std::size_t i = 0; i < rows; ++i) inverse_[i][i] = 1;
    solution_ = {0, 0, 0, 1, 1};
  }

  PairCertificate run(const DifferenceSimplex& hint) {
    for (std::size_t i = 0; i < static_cast<std::size_t>(hint.count); ++i) {
      enter_if_it_pays({Variable::Kind::of_a, hint.vertex[i].a});
      enter_if_it_pays({Variable::Kind::of_b, hint.vertex[i].b});
    }
    std::uint32_t at_a = hint.count > 0 ? hint.vertex[0].a : 0;
    std::uint32_t at_b = hint.count > 0 ? hint.vertex[0].b : 0;
    while (true) {
      const Column y = multipliers();
      const WorldDirection direction(
          Vector3<Dyadic>{Dyadic(y[0], 0), Dyadic(y[1], 0), Dyadic(y[2], 0)});
      if (y[0] != 0 || y[1] != 0 || y[2] != 0) {
        Along along_a(direction, a_.pose, a_.tame), along_b(direction, b_.pose, b_.tame);
        at_a = extreme_vertex_from(a_, along_a, End::greatest, at_a, tally_);
        at_b = extreme_vertex_from(b_, along_b, End::least, at_b, tally_);
      }
      const bool entered_a = enter_if_it_pays({Variable::Kind::of_a, at_a});
      if (entered_a) continue;
      if (!enter_if_it_pays({Variable::Kind::of_b, at_b})) return certificate(y, at_a, at_b);
    }
  }

 private:
  // An exponent that divides all coordinates of all images of the body.
  static std::int64_t least_exponent(const Placed& body) {
    const auto lowest_bit = [](const SizeRange& range) {
      // A double of size at least s is a multiple of 2^(exponent of s - 52), and of 2^-1074.
      return range.greatest == 0 ? std::int64_t{0}
                                 : std::max<std::int64_t>(std::ilogb(range.least) - 52, -1074);
    };
    const SizeRange linear = size_range(std::span<const double>(body.pose.linear));
    const SizeRange translation = size_range(std::span<const double>(body.pose.translation));
    return std::min(lowest_bit(linear) + lowest_bit(body.graph.sizes), lowest_bit(translation));
  }

  Integer scaled(const Dyadic& x) const {
    if (x.mantissa().is_zero()) return 0;
    return x.mantissa() << static_cast<unsigned long>(x.exponent() - exponent_);
  }

  Column column(const Variable& v) const {
    const bool of_a = v.kind == Variable::Kind::of_a;
    const Vector3<Dyadic> p = lift<ExactStage>(of_a ? a_[v.vertex] : b_[v.vertex]);
    Column c{scaled(p.x), scaled(p.y), scaled(p.z), of_a ? 1 : 0, of_a ? 0 : 1};
    if (!of_a) {
      for (std::size_t i = 0; i < 3; ++i) c[i] = -c[i];
    }
    return c;
  }

  // determinant_ times the multipliers: costs of one on the artificial variables in the basis.
  Column multipliers() const {
    Column y{};
    for (std::size_t i = 0; i < rows; ++i) {
      if (basis_[i].kind != Variable::Kind::artificial) continue;
      for (std::size_t k = 0; k < rows; ++k) y[k] += inverse_[i][k];
    }
    return y;
  }

  bool enter_if_it_pays(const Variable& v) {
    const Column c = column(v);
    const Column y = multipliers();
    Integer price = 0;
    for (std::size_t k = 0; k < rows; ++k) price += y[k] * c[k];
    if (price <= 0) return false;
    Column t{};  // determinant_ times the column in terms of the basis
    for (std::size_t i = 0; i < rows; ++i) {
      for (std::size_t k = 0; k < rows; ++k) t[i] += inverse_[i][k] * c[k];
    }
    pivot(leaving_row(t), t, v);
    return true;
  }

  // Among rows with t > 0 (there is one: the price is the sum of t over artificial rows), the lexicographically least
  // (solution, inverse) / t.
  std::size_t leaving_row(const Column& t) const {
    std::optional<std::size_t> best;
    for (std::size_t i = 0; i < rows; ++i) {
      if (t[i] <= 0) continue;
      if (!best || lexicographically_less(i, *best, t)) best = i;
    }
    return *best;
  }

  bool lexicographically_less(std::size_t i, std::size_t j, const Column& t) const {
    const auto less = [&](const Integer& at_i, const Integer& at_j) { return (at_i * t[j]).compare(at_j * t[i]); };
    int order = less(solution_[i], solution_[j]);
    for (std::size_t k = 0; order == 0 && k < rows; ++k) order = less(inverse_[i][k], inverse_[j][k]);
    return order < 0;
  }

  void pivot(std::size_t r, const Column& t, const Variable& entering) {
    for (std::size_t i = 0; i < rows; ++i) {
      if (i == r) continue;
      for (std::size_t k = 0; k < rows; ++k) {
        inverse_[i][k] = (inverse_[i][k] * t[r] - inverse_[r][k] * t[i]) / determinant_;  // exact
      }
      solution_[i] = (solution_[i] * t[r] - solution_[r] * t[i]) / determinant_;
    }
    determinant_ = t[r];
    basis_[r] = entering;
  }

  PairCertificate certificate(const Column& y, std::uint32_t at_a, std::uint32_t at_b) const {
    PairCertificate c;
    if (Integer(y[3] + y[4]) > 0) {  // the sum of the artificial variables
      c.verdict = Verdict::apart;
      c.direction.kind = Direction::Kind::exact;
      c.direction.numbers = std::make_shared<const std::array<Dyadic, 3>>(
          std::array<Dyadic, 3>{Dyadic(y[0], 0), Dyadic(y[1], 0), Dyadic(y[2], 0)});
      c.extreme_a = at_a;
      c.extreme_b = at_b;
      return c;
    }
    c.verdict = Verdict::meet;
    std::size_t n = 0;
    for (const Variable::Kind kind : {Variable::Kind::of_a, Variable::Kind::of_b}) {
      for (std::size_t i = 0; i < rows; ++i) {
        if (basis_[i].kind != kind || solution_[i].is_zero()) continue;
        c.vertices[n++] = basis_[i].vertex;
        ++(kind == Variable::Kind::of_a ? c.count_a : c.count_b);
      }
    }
    return c;
  }

  const Placed& a_;
  const Placed& b_;
  StageTally& tally_;
  std::int64_t exponent_;
  std::array<Variable, rows> basis_{};
  Integer determinant_ = 1;               // of the basis, positive
  std::array<Column, rows> inverse_{};    // of the basis, times its determinant
  Column solution_{};                     // the values of the basic variables, times the determinant
};

}  // namespace

PairCertificate decide_by_exact_simplex(const Placed& a, const Placed& b, const DifferenceSimplex& hint,
                                        StageTally& tally) {
  return ExactSimplex(a, b, tally).run(hint);
}

}  // namespace sunder::solid
