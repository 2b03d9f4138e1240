#include <sunder/number/exact/basis_internal.h>
#include <sunder/number/exact/scaled_integers_internal.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/exact/sweep_simplex.h>
#include <sunder/solid/search/extreme_vertex.h>
#include <sunder/solid/search/placed.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

// An exponent that divides all of these numbers, and one that none reaches: less than 2^top in size.
struct Exponents {
  std::int64_t least = 0, top = 0;
};
Exponents exponents_of(const SizeRange& range) {
  if (range.greatest == 0) return {};
  return {least_exponent(range.least), std::int64_t{std::ilogb(range.greatest)} + 1};
}

// A body without its translation.
struct Turned {
  const Placed placed;
  Affine3 linear;  // the linear part alone

  Turned(const ConvexPolyhedron& body, const Pose& pose) : placed(body, pose) { linear.linear = pose.affine().linear; }

  Vector3<Dyadic> operator[](std::uint32_t v) const {
    return coordinates<Dyadic>(Posed3{placed.graph.vertices[v], &linear, false});
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
  SweepSimplex(const ConvexPolyhedron& a, const Translation& path_a, const ConvexPolyhedron& b,
               const Translation& path_b, SweepTime wanted, Cost& cost, StageTally& tally)
      : a_(a, path_a.begin()),
        b_(b, path_b.begin()),
        is_first_(wanted == SweepTime::first),
        cost_(cost),
        tally_(tally) {
    const Exponents of_x = a_.exponents(), of_y = b_.exponents();
    exponent_ = std::min(of_x.least, of_y.least);
    for (const Pose* pose : {&path_a.begin(), &path_a.end(), &path_b.begin(), &path_b.end()}) {
      exponent_ = std::min(exponent_, exponents_of(pose->translation_range()).least);
    }
    at_ = {translation(path_a.begin()), translation(path_a.end())};
    const std::array<Vector3<Dyadic>, 2> of_other{translation(path_b.begin()), translation(path_b.end())};
    column_bits_ = std::max<std::int64_t>({of_x.top - exponent_, of_y.top - exponent_, 1});
    for (std::size_t k = 0; k < 2; ++k) {
      const Vector3<Dyadic> v = at_[k] - of_other[k];
      ends_[k] = {scaled(v.x), scaled(v.y), scaled(v.z), 0, 0, 1};
      for (const Integer& n : ends_[k]) column_bits_ = std::max(column_bits_, bits_of(n));
    }
  }

  SweepOutcome decide(std::uint32_t near_a, std::uint32_t near_b) {
    basis_ = IntegerBasis(Column{0, 0, 0, 1, 1, 1});
    at_a_ = near_a, at_b_ = near_b;
    bool goes_on = true;
    while (goes_on) {
      look_along(direction());
      goes_on = false;
      for (const BasicVariable& v : {BasicVariable{of_a, at_a_}, {of_b, at_b_}, {of_time, 0}, {of_time, 1}}) {
        goes_on = enter_if_it_pays(v) || goes_on;
      }
    }
    tally_.exact += basis_.comparisons();
    return outcome();
  }

 private:
  enum Kind : std::uint32_t { of_a, of_b, of_time };  // of variables: weights of vertices, and of the ends 0 and 1
  static constexpr std::size_t rows = 6;
  using Column = std::array<Integer, rows>;

  static bool is_late(const BasicVariable& v) { return v.kind == of_time && v.index == 1; }

  // The multipliers of a cost of one on the weight of the end, times the denominator.
  Column late_multipliers() const {
    Column y{};
    for (std::size_t i = 0; i < rows; ++i) {
      if (is_first_ && is_late(basis_.variable(i))) std::copy_n(basis_.inverse(i).begin(), rows, y.begin());
    }
    return y;
  }

  // Both in one, as prices are compared: the product of a column, or of the difference of two, with what stands first
  // is an integer, and that with the rest is less than 2^shift in size.
  Vector3<Dyadic> direction() const {
    const std::vector<Integer>& y = basis_.multipliers();
    const Column late = late_multipliers();
    std::int64_t bits = 0;
    for (const Integer& n : late) bits = std::max(bits, bits_of(n));
    const std::int64_t shift = bits == 0 ? 0 : std::max(bits, bits_of(basis_.denominator())) + column_bits_ + 5;
    const auto sum = [&](std::size_t k) { return dyadic_of((y[k] << static_cast<unsigned long>(shift)) + late[k], 0); };
    return {sum(0), sum(1), sum(2)};
  }

  void look_along(const Vector3<Dyadic>& d) {
    if (d.x.sign() == Sign::zero && d.y.sign() == Sign::zero && d.z.sign() == Sign::zero) return;
    const WorldDirection world(d);
    Along along_a(world, a_.placed.pose, a_.placed.tame), along_b(world, b_.placed.pose, b_.placed.tame);
    at_a_ = extreme_vertex_from(a_.placed, along_a, End::greatest, at_a_, cost_, tally_);
    at_b_ = extreme_vertex_from(b_.placed, along_b, End::least, at_b_, cost_, tally_);
  }

  bool enter_if_it_pays(const BasicVariable& v) {
    ++tally_.exact;
    const Column c = column(v);
    const Integer price = basis_.price(c);
    if (price < 0 || (price == 0 && !(is_first_ && is_earlier(v, c)))) return false;
    const std::vector<Integer>& t = basis_.in_terms(c);
    basis_.pivot(basis_.leaving_row(t), v, t);  // there is a row: all variables are bounded
    return true;
  }
  // Does the column pay by the weight of the end?
  bool is_earlier(const BasicVariable& v, const Column& c) const {
    const Column y = late_multipliers();
    return std::inner_product(y.begin(), y.end(), c.begin(), Integer(0)) > (is_late(v) ? basis_.denominator() : 0);
  }

  Integer scaled(const Dyadic& x) const { return in_unit(x, exponent_); }
  Column column(const BasicVariable& v) const {
    if (v.kind == of_time) return ends_[v.index];
    const Vector3<Dyadic> p = v.kind == of_a ? a_[v.index] : b_[v.index];
    if (v.kind == of_a) return {scaled(p.x), scaled(p.y), scaled(p.z), 1, 0, 0};
    return {-scaled(p.x), -scaled(p.y), -scaled(p.z), 0, 1, 0};
  }

  SweepOutcome outcome() const {
    SweepOutcome result;
    const Vector3<Dyadic> d = direction();
    if (!basis_.is_solved()) {
      const std::vector<Integer>& y = basis_.multipliers();
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
    for (std::size_t i = 0; i < rows; ++i) {
      const BasicVariable& v = basis_.variable(i);
      if (basis_.is_artificial(i) || basis_.value(i).is_zero()) continue;
      const Dyadic weight = dyadic_of(basis_.value(i), 0);
      if (v.kind == of_b) {
        contact.point.of_b.parts.push_back({v.index, weight});
        continue;
      }
      include(v.kind == of_a ? a_[v.index] : at_[v.index], weight);
      if (v.kind == of_a) contact.point.of_a.parts.push_back({v.index, weight});
      if (is_late(v)) contact.time.numerator = weight;
    }
    const Dyadic whole = dyadic_of(basis_.denominator(), 0);
    contact.time.denominator = contact.point.of_a.denominator = contact.point.of_b.denominator = whole;
    contact.point.at = exact_point(sum, whole);
    if (is_first_ && contact.time.numerator.sign() != Sign::zero) contact.direction = {d.x, d.y, d.z};
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
  IntegerBasis basis_;
};

}  // namespace

SweepOutcome decide_by_sweep_simplex(const ConvexPolyhedron& a, const Translation& of_a,  //
                                     const ConvexPolyhedron& b, const Translation& of_b, SweepTime wanted,
                                     std::uint32_t near_a, std::uint32_t near_b, Cost& cost, StageTally& tally) {
  return SweepSimplex(a, of_a, b, of_b, wanted, cost, tally).decide(near_a, near_b);
}

}  // namespace sunder::solid
