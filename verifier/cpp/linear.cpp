#include <verifier/cpp/linear.h>

#include <algorithm>

namespace sunder_verifier {
namespace {

// The square of what has these coefficients.
Integers squared(std::span<const Integer> c, std::span<const Integer> roots) {
  Integers result(c.size());
  for (std::size_t i = 0; i < c.size(); ++i) {
    for (std::size_t j = 0; j <= i; ++j) {
      if (c[i] == 0 || c[j] == 0) continue;
      Integer term = i == j ? Integer(c[i] * c[j]) : 2 * c[i] * c[j];
      for (std::size_t k = 0; k < roots.size(); ++k) {
        if ((i >> k & j >> k & 1u) != 0) term *= roots[k];
      }
      result[i ^ j] += term;
    }
  }
  return result;
}

}  // namespace

int compare(const Integer& m, std::int64_t e, const Integer& n, std::int64_t f) {
  return shifted(m, std::max<std::int64_t>(e - f, 0)).compare(shifted(n, std::max<std::int64_t>(f - e, 0)));
}

Number sum(const Numbers& numbers) {
  const Common all = common(numbers);
  Number result{0, all.d, all.e};
  for (const Integer& n : all.integers) result.n += n;
  return result;
}

bool are_equal(const Number& x, const Number& y) { return sum({x, {-y.n, y.d, y.e}}).n == 0; }

bool all_zero(const Integers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Integer& n) { return n == 0; });
}

Integers opposite(Integers vector) {
  for (Integer& n : vector) n = -n;
  return vector;
}

Integers reduced(Integers vector) {
  Integer shared = 0;
  for (const Integer& n : vector) shared = gcd(shared, n);
  for (Integer& n : vector) n /= shared;
  return vector;
}

Integers minus(Integers u, const Integers& v) {
  for (std::size_t c = 0; c < u.size(); ++c) u[c] -= v[c];
  return u;
}

Indices joined(const IndexLists& lists) {
  Indices result;
  for (const Indices& list : lists) result.insert(result.end(), list.begin(), list.end());
  return result;
}

Integers sum_of(const std::vector<Integers>& rows, const Indices& named) {
  Integers sum(rows[named[0]].size());
  for (const std::size_t k : named) {
    for (std::size_t c = 0; c < sum.size(); ++c) sum[c] += rows[k][c];
  }
  return sum;
}

std::vector<Integers> from_mean(const std::vector<Integers>& rows, const Indices& named) {
  const Integers sum = sum_of(rows, named);
  std::vector<Integers> result;
  for (Integers row : rows) {
    for (Integer& n : row) n *= named.size();
    result.push_back(minus(std::move(row), sum));
  }
  return result;
}

Integers way_between(const Integers& p, const Integers& q) {
  Integers way;
  for (std::size_t axis = 0; axis + 1 < p.size(); ++axis) way.push_back(q[axis] * p.back() - p[axis] * q.back());
  return way;
}

std::size_t differs(const Placed& body, const Integers& place, const Numbers& point) {
  const Integers image = turned(body, place);
  for (std::size_t r = 0; r < point.size(); ++r) {
    Numbers terms{{-point[r].n * place.back(), point[r].d, point[r].e}, {image[r], 1, body.linear.e}};
    if (body.is_image()) terms.push_back({body.translation.rows[0][r] * place.back(), 1, body.translation.e});
    if (sum(terms).n != 0) return r;
  }
  return no_index;
}

Integers Elimination::rest(const Integers& row) const {
  Integers result;
  for (const Integer& n : row) result.push_back(n * unit_);
  for (std::size_t k = 0; k < rows_.size(); ++k) {
    const Integer& by = row[own_[k]];
    if (by == 0) continue;
    for (std::size_t c = 0; c < result.size(); ++c) result[c] -= by * rows_[k][c];
  }
  return result;
}

bool Elimination::take(const Integers& row) {
  Integers left = rest(row);
  std::size_t column = 0;
  while (column < columns_ && left[column] == 0) ++column;
  if (column == columns_) return false;
  const Integer unit = left[column];
  for (Integers& other : rows_) {
    const Integer by = other[column];
    for (std::size_t c = 0; c < other.size(); ++c) other[c] = Integer(unit * other[c] - by * left[c]) / unit_;  // exact
  }
  rows_.push_back(std::move(left));
  own_.push_back(column);
  unit_ = unit;
  return true;
}

int Elimination::sign_of_determinant() const {
  if (rank() < columns_) return 0;
  return is_odd(own_) ? -unit_.sign() : unit_.sign();
}

bool is_odd(const Indices& order) {
  bool result = false;
  for (std::size_t j = 1; j < order.size(); ++j) {
    for (std::size_t i = 0; i < j; ++i) result ^= order[i] > order[j];
  }
  return result;
}

int sign_of_root(const Integer& p, const Integer& q, const Integer& r) {
  const int a = p.sign(), b = r == 0 ? 0 : q.sign();
  return a * b >= 0 ? (a != 0 ? a : b) : a * Integer(p * p).compare(q * q * r);
}

// What has the last root as a factor, and what has not: of two signs the squares of both tell which is greater.
int sign_of_roots(std::span<const Integer> coefficients, std::span<const Integer> roots) {
  if (roots.size() == 1) return sign_of_root(coefficients[0], coefficients[1], roots[0]);
  const std::size_t half = coefficients.size() / 2;
  const std::span<const Integer> without = coefficients.first(half), with = coefficients.last(half);
  const std::span<const Integer> others = roots.first(roots.size() - 1);
  const int a = sign_of_roots(without, others), b = roots.back() == 0 ? 0 : sign_of_roots(with, others);
  if (a * b >= 0) return a != 0 ? a : b;
  Integers difference = squared(without, others);
  const Integers subtracted = squared(with, others);
  for (std::size_t k = 0; k < half; ++k) difference[k] -= roots.back() * subtracted[k];
  return a * sign_of_roots(difference, others);
}

int sign_with_roots(const Integer& n, std::int64_t e, const std::vector<SignedRoot>& roots) {
  Numbers squares;
  Integers coefficients{n};
  for (const auto& [sign, square] : roots) {
    if (square.n == 0) continue;
    squares.push_back(square);
    coefficients.resize(2 * coefficients.size());
    coefficients[coefficients.size() / 2] = sign;
  }
  if (squares.empty()) return n.sign();
  // All times d, in units of 2^unit: squares times d^2, in units of 2^(2 unit).
  Common all = common(squares);
  const std::int64_t unit = std::min(e, (all.e - (all.e % 2 != 0 ? 1 : 0)) / 2);
  coefficients[0] = shifted(n * all.d, e - unit);
  for (Integer& square : all.integers) square = shifted(square * all.d, all.e - 2 * unit);
  return sign_of_roots(coefficients, all.integers);
}

Ridge ridge_of(Indices simplex, std::size_t i, bool turned) {
  simplex.erase(simplex.begin() + static_cast<std::ptrdiff_t>(i));
  const bool side = is_odd(simplex) != (i % 2 != 0);
  std::sort(simplex.begin(), simplex.end());
  return {std::move(simplex), side != turned};
}

Ridge edge_of(std::size_t i, std::size_t j) { return {{std::min(i, j), std::max(i, j)}, i > j}; }

}  // namespace sunder_verifier
