#include <sunder/number/integer_internal.h>
#include <sunder/predicate/stages.h>
#include <sunder/solid/pair/extreme_vertex.h>
#include <sunder/solid/pair/integer_basis_internal.h>
#include <sunder/solid/pair/placed.h>
#include <sunder/solid/pair/sweep_simplex.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sunder::solid {

namespace {

constexpr std::size_t most_rows = 6;
using Basis = IntegerBasis<most_rows>;
using Column = Basis::Column;

// A variable: the weight of a vertex or of an end of time, or an artificial one.
struct Variable {
  enum class Kind : std::uint8_t { artificial, of_a, of_b, of_time };
  Kind kind = Kind::artificial;
  std::uint32_t entry = 0;  // a vertex; or 0 or 1, the end
};
using Kind = Variable::Kind;

// An exponent that divides all of these numbers, and one that none reaches: less than 2^top in size.
struct Exponents {
  std::int64_t least = 0, top = 0;
};
Exponents exponents_of(const SizeRange& range) {
  if (range.greatest == 0) return {};
  // A double of size at least s is a multiple of 2^(exponent of s - 52), and of 2^-1074.
  return {std::max<std::int64_t>(std::ilogb(range.least) - 52, -1074), std::int64_t{std::ilogb(range.greatest)} + 1};
}

// A body without its translation.
struct Turned {
  const Placed placed;
  Affine3 linear;  // the linear part alone

  Turned(const ConvexPolyhedron& body, const Pose& pose) : placed(body, pose) { linear.linear = pose.affine().linear; }

  Vector3<Dyadic> operator[](std::uint32_t v) const {
    return lift<ExactStage>(Posed3{placed.graph.vertices[v], &linear, false});
  }
  Exponents exponents() const {
    const Exponents m = exponents_of(size_range(std::span<const double>(linear.linear))),
                    x = exponents_of(placed.graph.sizes);
    return {m.least + x.least, m.top + x.top + 2};  // a sum of three products
  }
};

Vector3<Dyadic> translation(const Pose& pose) {
  const auto& t = pose.affine().translation;
  return {Dyadic(t[0]), Dyadic(t[1]), Dyadic(t[2])};
}

std::int64_t bits_of(const Integer& n) {
  return n.is_zero() ? 0 : static_cast<std::int64_t>(msb(boost::multiprecision::abs(n))) + 1;
}

class SweepSimplex {
 public:
  SweepSimplex(const ConvexPolyhedron& a, const Translation& of_a, const ConvexPolyhedron& b, const Translation& of_b,
               SweepTime wanted, Cost& cost, StageTally& tally)
      : a_(a, of_a.begin()), b_(b, of_b.begin()), is_first_(wanted == SweepTime::first), cost_(cost), tally_(tally) {
    const Exponents of_x = a_.exponents(), of_y = b_.exponents();
    exponent_ = std::min(of_x.least, of_y.least);
    for (const Pose* pose : {&of_a.begin(), &of_a.end(), &of_b.begin(), &of_b.end()}) {
      exponent_ = std::min(exponent_, exponents_of(pose->translation_range()).least);
    }
    at_ = {translation(of_a.begin()), translation(of_a.end())};
    const std::array<Vector3<Dyadic>, 2> of_other{translation(of_b.begin()), translation(of_b.end())};
    column_bits_ = std::max<std::int64_t>({of_x.top - exponent_, of_y.top - exponent_, 1});
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3<Dyadic> v = at_[k] - of_other[k];
      ends_[k] = {scaled(v.x), scaled(v.y), scaled(v.z), 0, 0, 1};
      for (const Integer& n : ends_[k]) column_bits_ = std::max(column_bits_, bits_of(n));
    }
  }

  SweepOutcome decide(std::uint32_t near_a, std::uint32_t near_b) {
    basis_.rows = most_rows;
    basis_.start({0, 0, 0, 1, 1, 1});
    at_a_ = near_a, at_b_ = near_b;
    bool goes_on = true;
    while (goes_on) {
      look_along(direction());
      goes_on = false;
      for (const Variable& v : {Variable{Kind::of_a, at_a_}, Variable{Kind::of_b, at_b_}, Variable{Kind::of_time, 0},
                                Variable{Kind::of_time, 1}}) {
        goes_on = enter_if_it_pays(v) || goes_on;
      }
    }
    return outcome();
  }

 private:
  // The multipliers times the determinant: of costs of one on the artificial variables in the basis; of a cost of one
  // on the weight of the end.
  struct Multipliers {
    Column artificial{}, late{};
  };
  Multipliers multipliers() const {
    Multipliers y;
    for (std::size_t i = 0; i < most_rows; ++i) {
      const Variable& v = variables_[i];
      if (v.kind == Kind::artificial) add(y.artificial, basis_.inverse[i]);
      if (is_first_ && v.kind == Kind::of_time && v.entry == 1) add(y.late, basis_.inverse[i]);
    }
    return y;
  }
  static void add(Column& sum, const Column& row) {
    for (std::size_t k = 0; k < most_rows; ++k) sum[k] += row[k];
  }
  static Integer product(const Column& y, const Column& c) {
    Integer sum = 0;
    for (std::size_t k = 0; k < most_rows; ++k) sum += y[k] * c[k];
    return sum;
  }

  // Both in one, as prices are compared: the product of a column, or of the difference of two, with what stands first
  // is an integer, and that with the rest is less than 2^shift in size.
  Vector3<Dyadic> direction() const {
    const Multipliers y = multipliers();
    std::int64_t bits = 0;
    for (const Integer& n : y.late) bits = std::max(bits, bits_of(n));
    const std::int64_t shift = bits == 0 ? 0 : std::max(bits, bits_of(basis_.determinant)) + column_bits_ + 5;
    const auto sum = [&](std::size_t k) {
      return dyadic_of((y.artificial[k] << static_cast<unsigned long>(shift)) + y.late[k], 0);
    };
    return {sum(0), sum(1), sum(2)};
  }

  void look_along(const Vector3<Dyadic>& d) {
    if (d.x.sign() == Sign::zero && d.y.sign() == Sign::zero && d.z.sign() == Sign::zero) return;
    const WorldDirection world(d);
    Along along_a(world, a_.placed.pose, a_.placed.tame), along_b(world, b_.placed.pose, b_.placed.tame);
    at_a_ = extreme_vertex_from(a_.placed, along_a, End::greatest, at_a_, cost_, tally_);
    at_b_ = extreme_vertex_from(b_.placed, along_b, End::least, at_b_, cost_, tally_);
  }

  bool enter_if_it_pays(const Variable& v) {
    const Column c = column(v);
    const Multipliers y = multipliers();
    ++tally_.exact;
    const Integer price = product(y.artificial, c);
    if (price < 0) return false;
    if (price == 0) {
      if (!is_first_) return false;
      const bool is_late = v.kind == Kind::of_time && v.entry == 1;
      if (product(y.late, c) <= (is_late ? basis_.determinant : Integer(0))) return false;
    }
    const Column t = basis_.in_terms(c);
    const std::size_t row = basis_.leaving_row(t, tally_);  // there is one: all variables are bounded
    basis_.pivot(row, t);
    variables_[row] = v;
    return true;
  }

  Integer scaled(const Dyadic& x) const {
    if (mantissa_of(x).is_zero()) return 0;
    return mantissa_of(x) << static_cast<unsigned long>(x.exponent() - exponent_);
  }
  Column column(const Variable& v) const {
    if (v.kind == Kind::of_time) return ends_[v.entry];
    const bool of_a = v.kind == Kind::of_a;
    const Vector3<Dyadic> p = of_a ? a_[v.entry] : b_[v.entry];
    if (of_a) return {scaled(p.x), scaled(p.y), scaled(p.z), 1, 0, 0};
    return {-scaled(p.x), -scaled(p.y), -scaled(p.z), 0, 1, 0};
  }

  SweepOutcome outcome() const {
    SweepOutcome result;
    const Vector3<Dyadic> d = direction();
    const Column y = multipliers().artificial;
    if (y[3] + y[4] + y[5] > 0) {  // the sum of the artificial variables
      // What parts them is the first part alone.
      result.direction = {dyadic_of(y[0], 0), dyadic_of(y[1], 0), dyadic_of(y[2], 0)};
      result.extreme_a = at_a_, result.extreme_b = at_b_;
      return result;
    }
    SweepContact contact;
    Vector3<Dyadic> sum{};
    const auto include = [&](const Vector3<Dyadic>& p, const Dyadic& weight) {
      sum = {sum.x + p.x * weight, sum.y + p.y * weight, sum.z + p.z * weight};
    };
    for (std::size_t i = 0; i < most_rows; ++i) {
      const auto& [kind, entry] = variables_[i];
      if (kind == Kind::artificial || basis_.solution[i].is_zero()) continue;
      const Dyadic weight = dyadic_of(basis_.solution[i], 0);
      if (kind == Kind::of_b) {
        contact.point.of_b.parts.push_back({entry, weight});
        continue;
      }
      include(kind == Kind::of_a ? a_[entry] : at_[entry], weight);
      if (kind == Kind::of_a) contact.point.of_a.parts.push_back({entry, weight});
      if (kind == Kind::of_time && entry == 1) contact.time = weight;
    }
    const Dyadic whole = dyadic_of(basis_.determinant, 0);
    contact.denominator = contact.point.of_a.denominator = contact.point.of_b.denominator = whole;
    contact.point.at = exact_point(sum, whole);
    if (is_first_ && contact.time.sign() != Sign::zero) contact.direction = {d.x, d.y, d.z};
    result.contact = std::move(contact);
    return result;
  }

  Turned a_, b_;
  bool is_first_;
  Cost& cost_;
  StageTally& tally_;
  std::int64_t exponent_ = 0;          // images and translations are multiples of 2^exponent_, and counted in it
  std::int64_t column_bits_ = 0;       // of the longest number of a column
  std::array<Vector3<Dyadic>, 2> at_;  // the translation of A at both ends
  std::array<Column, 2> ends_;
  std::uint32_t at_a_ = 0, at_b_ = 0;  // the extreme vertices along the last direction
  Basis basis_;
  std::array<Variable, most_rows> variables_{};  // of each row of the basis
};

}  // namespace

SweepOutcome decide_by_sweep_simplex(const ConvexPolyhedron& a, const Translation& of_a,  //
                                     const ConvexPolyhedron& b, const Translation& of_b, SweepTime wanted,
                                     std::uint32_t near_a, std::uint32_t near_b, Cost& cost, StageTally& tally) {
  return SweepSimplex(a, of_a, b, of_b, wanted, cost, tally).decide(near_a, near_b);
}

}  // namespace sunder::solid
