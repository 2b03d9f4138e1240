#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/represent/affine_columns.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

std::vector<Dyadic> AffineColumns::reduced(std::span<const Dyadic> direction) const {
  std::vector<Dyadic> result;
  for (const Column& of : columns) {
    Dyadic sum;
    for (std::size_t c = 0; c < direction.size(); ++c) {
      if (of.vector[c].sign() != Sign::zero) sum = sum + direction[c] * of.vector[c];
    }
    result.push_back(std::move(sum));
  }
  return result;
}

AffineColumns affine_columns(std::size_t d, std::size_t count,
                             const std::function<std::span<const double>(std::size_t)>& row) {
  Elimination span(d);
  for (std::size_t k = 1; k < count && span.rank() < d; ++k) {
    std::vector<Dyadic> v;
    for (std::size_t c = 0; c < d; ++c) v.push_back(Dyadic(row(k)[c]) - Dyadic(row(0)[c]));
    span.add(v);
  }
  AffineColumns result{.columns = {}, .pivot = dyadic_of(span.pivot(), 0)};
  for (const Elimination::Row& of : span.rows()) {
    result.columns.push_back({of.column, {}});
    for (const Integer& x : of.numbers) result.columns.back().vector.push_back(dyadic_of(x, 0));
  }
  std::sort(result.columns.begin(), result.columns.end(),
            [](const AffineColumns::Column& a, const AffineColumns::Column& b) { return a.column < b.column; });
  return result;
}

}  // namespace sunder::polytope
