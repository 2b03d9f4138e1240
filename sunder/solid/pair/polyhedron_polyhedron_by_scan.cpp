// The oracle: one exact linear program over all vertices. It shares nothing with the searches but the answer's type:
// it has its own reading of doubles, the oracles' simplex method (oracle/dictionary_internal.h), and looks at no edge of
// a body.
//
// Weights l_i >= 0 of A's vertices, m_j >= 0 of B's, with sum l_i a_i = sum m_j b_j, sum l_i = 1, sum m_j = 1: five
// equations. Phase one of the simplex method from five artificial variables, whose columns of the dictionary tell any
// other column, so that none but theirs is kept. All prices are looked at in every step:
// in floating point with a generous error bound first, exactly where that does not tell. The largest enters; after
// `patience` steps the first positive one does (Bland 1977), which cannot cycle if ties leave by least number.
#include <sunder/oracle/dictionary_internal.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

namespace sunder::solid {

namespace {

// x = mantissa 2^exponent; zero has the largest exponent, so that it never is the least.
struct Parts {
  std::int64_t mantissa = 0;
  int exponent = std::numeric_limits<int>::max();
};

Parts parts_of(double x) {
  if (x == 0) return {};
  const std::uint64_t bits = std::bit_cast<std::uint64_t>(x);
  const std::int64_t fraction = static_cast<std::int64_t>(bits & 0xfffffffffffffu);
  const int biased = static_cast<int>(bits >> 52 & 0x7ffu);
  const std::int64_t mantissa = biased == 0 ? fraction : fraction | std::int64_t{1} << 52;
  return {x < 0 ? -mantissa : mantissa, std::max(biased, 1) - 1075};
}

// Adds a b 2^(exponents) / 2^unit to the sum.
void add_product(Integer& sum, double a, double b, int unit) {
  const Parts p = parts_of(a), q = parts_of(b);
  if (p.mantissa == 0 || q.mantissa == 0) return;
  Integer product = p.mantissa;
  product *= q.mantissa;
  product <<= static_cast<unsigned>(p.exponent + q.exponent - unit);
  sum += product;
}

using FiveIntegers = std::array<Integer, 5>;

// An approximate column: |approx - exact| <= 2^-50 size for the first three entries, if all is of ordinary size.
struct Sketch {
  std::array<double, 3> approx;
  std::array<double, 3> size;
};

class Scan {
 public:
  Scan(const ConvexPolyhedron& a, const Affine3& pose_a, const ConvexPolyhedron& b, const Affine3& pose_b)
      : vertices_{a.vertices(), b.vertices()}, poses_{&pose_a, &pose_b} {
    for (std::size_t body = 0; body < 2; ++body) {
      int linear = std::numeric_limits<int>::max(), point = linear, shift = linear;
      for (const double x : poses_[body]->linear) linear = std::min(linear, parts_of(x).exponent);
      for (const double x : poses_[body]->translation) shift = std::min(shift, parts_of(x).exponent);
      for (const Point3& p : vertices_[body]) {
        for (const double x : {p.x, p.y, p.z}) point = std::min(point, parts_of(x).exponent);
      }
      constexpr int none = std::numeric_limits<int>::max();
      if (point != none && linear != none) unit_ = std::min(unit_, linear + point);
      if (shift != none) unit_ = std::min(unit_, shift + parts_of(1).exponent);
    }
    if (unit_ == std::numeric_limits<int>::max()) unit_ = 0;  // two points at the origin
    for (std::size_t body = 0; body < 2; ++body) {
      for (const Point3& p : vertices_[body]) sketches_.push_back(sketch(body, p));
    }
    columns_.resize(sketches_.size());
    for (std::int64_t i = 0; i < 5; ++i) {
      dictionary_.basic.push_back(first_artificial + i);
      dictionary_.rows.push_back({i < 3 ? 0 : 1});
    }
  }

  PairAnswer run() {
    constexpr int patience = 60;
    PairAnswer answer;
    answer.decided_by = DecidedBy::scan;
    for (int step = 0;; ++step) {
      ++answer.cost.iterations;
      answer.cost.probes += static_cast<std::uint32_t>(columns_.size());
      const std::optional<std::size_t> entering = price_all(step >= patience);
      if (!entering) break;
      enter(*entering);
    }
    answer.cost.exact = exact_prices_;
    const FiveIntegers y = multipliers();
    if (y[3] + y[4] > 0) {
      answer.evidence = Separation{exact_direction({dyadic_of(y[0], 0), dyadic_of(y[1], 0), dyadic_of(y[2], 0)}),
                                   furthest(0, y), furthest(1, y)};
      return answer;
    }
    CommonVertices& common = answer.evidence.emplace<CommonVertices>();
    std::size_t n = 0;
    for (std::size_t body = 0; body < 2; ++body) {
      for (std::size_t i = 0; i < 5; ++i) {
        const auto number = static_cast<std::size_t>(dictionary_.basic[i]);
        if (dictionary_.basic[i] < 0 || dictionary_.rows[i].back().is_zero() || body_of(number) != body) continue;
        common.vertices[n++] = vertex_of(number);
        ++(body == 0 ? common.count_a : common.count_b);
      }
    }
    return answer;
  }

 private:
  std::size_t body_of(std::size_t column) const { return column < vertices_[0].size() ? 0 : 1; }
  std::uint32_t vertex_of(std::size_t column) const {
    return static_cast<std::uint32_t>(body_of(column) == 0 ? column : column - vertices_[0].size());
  }

  Sketch sketch(std::size_t body, const Point3& p) const {
    const Affine3& pose = *poses_[body];
    Sketch s{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double* row = &pose.linear[3 * i];
      const double value = row[0] * p.x + row[1] * p.y + row[2] * p.z + pose.translation[i];
      s.approx[i] = body == 0 ? value : -value;
      s.size[i] =
          std::fabs(row[0] * p.x) + std::fabs(row[1] * p.y) + std::fabs(row[2] * p.z) + std::fabs(pose.translation[i]);
    }
    return s;
  }

  const FiveIntegers& column(std::size_t number) {
    std::optional<FiveIntegers>& c = columns_[number];
    if (c) return *c;
    c.emplace();
    const std::size_t body = body_of(number);
    const Affine3& pose = *poses_[body];
    const Point3& p = vertices_[body][vertex_of(number)];
    for (std::size_t i = 0; i < 3; ++i) {
      const double* row = &pose.linear[3 * i];
      Integer& sum = (*c)[i];
      add_product(sum, row[0], p.x, unit_);
      add_product(sum, row[1], p.y, unit_);
      add_product(sum, row[2], p.z, unit_);
      add_product(sum, pose.translation[i], 1, unit_);
      if (body == 1) sum = -sum;
    }
    (*c)[3] = body == 0 ? 1 : 0;
    (*c)[4] = body == 0 ? 0 : 1;
    return *c;
  }

  // The sum of the rows of the inverse with artificial variables.
  FiveIntegers multipliers() const {
    FiveIntegers y;
    for (std::size_t i = 0; i < 5; ++i) {
      if (dictionary_.basic[i] >= 0) continue;
      for (std::size_t k = 0; k < 5; ++k) {
        y[k] += dictionary_.inverse(i, first_artificial + static_cast<std::int64_t>(k));
      }
    }
    return y;
  }

  Integer exact_price(const FiveIntegers& y, std::size_t number) {
    ++exact_prices_;
    const FiveIntegers& c = column(number);
    Integer price;
    for (std::size_t k = 0; k < 5; ++k) price += y[k] * c[k];
    return price;
  }

  // A price, and how far off it may be.
  struct PriceOfSketch {
    double price = 0, error = std::numeric_limits<double>::infinity();
  };
  PriceOfSketch price_of_sketch(const std::array<double, 5>& q, std::size_t j) const {
    const Sketch& s = sketches_[j];
    const double own = q[body_of(j) == 0 ? 3 : 4];
    const double price = q[0] * s.approx[0] + q[1] * s.approx[1] + q[2] * s.approx[2] + own;
    const double size =
        std::fabs(q[0]) * s.size[0] + std::fabs(q[1]) * s.size[1] + std::fabs(q[2]) * s.size[2] + std::fabs(own);
    if (!(size > 0x1p-500 && size < 0x1p500)) return {};
    return {price, size * 0x1p-45};
  }

  // A column with a positive price: the largest as far as can be seen, or just the first; none if there is none.
  std::optional<std::size_t> price_all(bool first) {
    const FiveIntegers y = multipliers();
    // The multipliers in units that make images ordinary: entries of columns count in units of 2^unit_.
    std::array<double, 5> q{};
    const bool sketchy = to_doubles(y, q);
    std::optional<std::size_t> best;
    double best_price = 0;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      const auto [price, error] = sketchy ? price_of_sketch(q, j) : PriceOfSketch{};
      if (price < -error) continue;
      if (!(price > error) && exact_price(y, j) <= 0) continue;
      if (first) return j;
      if (!best || price > best_price) {
        best = j;
        best_price = price;
      }
    }
    return best;
  }

  // y_k 2^(3 units of length) as doubles up to one common power of two, each with relative error at most 2^-52; the
  // last two in units of length. False where the range of doubles is too small for that.
  bool to_doubles(const FiveIntegers& y, std::array<double, 5>& q) const {
    std::array<int, 5> exponent{};
    int top = std::numeric_limits<int>::min();
    for (std::size_t k = 0; k < 5; ++k) {
      if (y[k] == 0) continue;
      const Integer size = abs(y[k]);
      const int bits = static_cast<int>(msb(size)) + 1;
      const int drop = std::max(bits - 53, 0);
      const double mantissa = static_cast<double>(static_cast<std::int64_t>(size >> static_cast<unsigned>(drop)));
      q[k] = y[k] < 0 ? -mantissa : mantissa;
      exponent[k] = drop + (k >= 3 ? unit_ : 0);
      top = std::max(top, exponent[k] + 53);
    }
    for (std::size_t k = 0; k < 5; ++k) {
      if (q[k] == 0) continue;
      const int shift = exponent[k] - top;
      if (shift < -400) return false;
      q[k] = std::ldexp(q[k], shift);
    }
    return true;
  }

  // The column comes into the dictionary in terms of the basis, and that of what leaves stays if it is artificial.
  void enter(std::size_t number) {
    const FiveIntegers& c = column(number);
    dictionary_.add_column(static_cast<std::int64_t>(number), c, first_artificial);
    const std::size_t last = dictionary_.others.size() - 1;
    dictionary_.pivot(*dictionary_.leaving(last), last);
    if (dictionary_.others.back() >= 0) dictionary_.drop_last_column();
  }

  // The vertex of the body with the greatest price, exactly. Most are surely not it.
  std::uint32_t furthest(std::size_t body, const FiveIntegers& y) {
    const std::size_t first = body == 0 ? 0 : vertices_[0].size();
    const std::size_t end = first + vertices_[body].size();
    std::array<double, 5> q{};
    const bool sketchy = to_doubles(y, q);
    const auto sketch_of = [&](std::size_t j) { return sketchy ? price_of_sketch(q, j) : PriceOfSketch{}; };
    double surely = -std::numeric_limits<double>::infinity();
    for (std::size_t j = first; j < end; ++j) surely = std::max(surely, sketch_of(j).price - sketch_of(j).error);
    std::optional<std::size_t> best;
    Integer best_price;
    for (std::size_t j = first; j < end; ++j) {
      if (sketch_of(j).price + sketch_of(j).error < surely) continue;
      const Integer price = exact_price(y, j);
      if (best && price <= best_price) continue;
      best_price = price;
      best = j;
    }
    return vertex_of(*best);
  }

  std::array<std::span<const Point3>, 2> vertices_;
  std::array<const Affine3*, 2> poses_;
  int unit_ = std::numeric_limits<int>::max();  // all coordinates of images are multiples of 2^unit_
  std::vector<Sketch> sketches_;
  std::vector<std::optional<FiveIntegers>> columns_;
  std::uint32_t exact_prices_ = 0;

  // Variables: vertices of both bodies, by their number; artificial ones, which leave first.
  static constexpr std::int64_t first_artificial = -5;
  oracle::Dictionary dictionary_;
};

}  // namespace

PairAnswer polyhedron_polyhedron_by_scan(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                         const ConvexPolyhedron& b, const Pose& pose_b) {
  return Scan(a, pose_a.affine(), b, pose_b.affine()).run();
}

}  // namespace sunder::solid
