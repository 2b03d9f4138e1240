#include <sunder/polytope/represent/affine_columns.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

namespace {

bool is_zero(const Dyadic& x) { return x.sign() == Sign::zero; }

// v less its part along w, times a positive number: then it has 0 in the column, where w has a positive one.
void take_out(std::vector<Dyadic>& v, const std::vector<Dyadic>& w, std::size_t column) {
  if (is_zero(v[column])) return;
  const Dyadic by = v[column];
  for (std::size_t c = 0; c < v.size(); ++c) v[c] = v[c] * w[column] - w[c] * by;
}

}  // namespace

std::vector<Dyadic> AffineColumns::reduced(std::span<const Dyadic> direction) const {
  std::vector<Dyadic> result;
  for (const Column& of : columns) {
    Dyadic sum;
    for (std::size_t c = 0; c < direction.size(); ++c) {
      if (!is_zero(of.vector[c])) sum = sum + direction[c] * of.vector[c];
    }
    for (const Column& other : columns) {
      if (other.column != of.column) sum = sum * other.vector[other.column];
    }
    result.push_back(std::move(sum));
  }
  return result;
}

AffineColumns affine_columns(std::size_t d, std::size_t count,
                             const std::function<std::span<const double>(std::size_t)>& row) {
  AffineColumns result;
  for (std::size_t k = 1; k < count && result.columns.size() < d; ++k) {
    std::vector<Dyadic> v;
    for (std::size_t c = 0; c < d; ++c) v.push_back(Dyadic(row(k)[c]) - Dyadic(row(0)[c]));
    for (const AffineColumns::Column& known : result.columns) take_out(v, known.vector, known.column);
    const auto found = std::find_if(v.begin(), v.end(), [](const Dyadic& x) { return !is_zero(x); });
    if (found == v.end()) continue;
    const auto column = static_cast<std::size_t>(found - v.begin());
    if (found->sign() == Sign::negative) {
      for (Dyadic& x : v) x = -x;
    }
    for (AffineColumns::Column& known : result.columns) take_out(known.vector, v, column);
    result.columns.push_back({column, std::move(v)});
  }
  std::sort(result.columns.begin(), result.columns.end(),
            [](const AffineColumns::Column& a, const AffineColumns::Column& b) { return a.column < b.column; });
  return result;
}

}  // namespace sunder::polytope
