#include <sunder/base/contract.h>
#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/rounded_simplex.h>
#include <sunder/polytope/pair/support.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace sunder::polytope {

namespace {

constexpr std::size_t most_points = most_dimension + 2;

// A point of A or of B.
struct Named {
  bool is_of_a = false;
  std::uint32_t row = 0;
};

// Up to so many of them, those of A first.
template <std::size_t Most>
struct NamedList {
  std::array<Named, Most> item{};
  std::size_t count = 0, count_a = 0;

  void add(const Named& named) {
    item[count++] = named;
    count_a += named.is_of_a ? 1 : 0;
  }
};
using AllNamed = NamedList<RoundedProgram::most_columns>;
using FewNamed = NamedList<most_points>;

// Those that floating point has in a basis, for weights of a common point. Columns are images less that of the first,
// and a 1 for the body that they are of.
FewNamed likely(const Polytope& a, const Pose& pose_a, const Polytope& b, const Pose& pose_b, const AllNamed& named) {
  const std::size_t d = a.dimension();
  RoundedProgram program;
  program.rows = d + 2;
  program.columns = named.count;
  program.ones = 2;
  const Vector origin = rounded_image(a, pose_a, named.item[0].row);
  for (std::size_t k = 0; k < named.count; ++k) {
    const auto [is_of_a, row] = named.item[k];
    const Vector image = is_of_a ? rounded_image(a, pose_a, row) : rounded_image(b, pose_b, row);
    for (std::size_t i = 0; i < d; ++i) program.table[i][k] = is_of_a ? image[i] - origin[i] : origin[i] - image[i];
    program.table[is_of_a ? d : d + 1][k] = 1;
  }
  const auto basis = program.basis();
  FewNamed result;
  for (std::size_t k = 0; k < named.count; ++k) {
    if (basis[k]) result.add(named.item[k]);
  }
  return result;
}

// ---- Weights, from the relation v of the edges from the first point of each body, and of the difference of those two,
// the last. The edges of B are taken the other way round.

bool is_negative(const Integer& x) { return x < 0; }
bool is_negative(const FewWords::Number& x) { return FewWords::is_negative(x); }
bool is_zero(const Integer& x) { return x.is_zero(); }
bool is_zero(const FewWords::Number& x) { return FewWords::is_zero(x); }
void subtract(Integer& sum, const Integer& x) { sum -= x; }
void subtract(FewWords::Number& sum, const FewWords::Number& x) { FewWords::add_product(sum, {1, false}, x, true); }

// Those of each body sum to the last number of v. Nothing where one is negative.
template <class Number>
std::optional<std::array<Number, most_points>> weights_of(const std::array<Number, most_vectors>& v,
                                                          const FewNamed& named) {
  const std::size_t first_b = named.count_a, last = named.count - 2;
  if (is_zero(v[last])) return std::nullopt;
  std::array<Number, most_points> weights{};
  weights[0] = weights[first_b] = v[last];
  for (std::size_t k = 1, j = 0; k < named.count; ++k) {
    if (k == first_b) continue;
    if (is_negative(v[j])) return std::nullopt;
    subtract(weights[k < first_b ? 0 : first_b], v[j]);
    weights[k] = v[j++];
  }
  if (is_negative(weights[0]) || is_negative(weights[first_b])) return std::nullopt;
  return weights;
}

// ---- Bodies that are not moved, in integers of few words.

__extension__ using SignedWord2 = __int128;

FewWords::Entry entry_of(SignedWord2 x) {
  return x < 0 ? FewWords::Entry{-static_cast<FewWords::Word2>(x), true}
               : FewWords::Entry{static_cast<FewWords::Word2>(x), false};
}

// Coordinates of the points, as multiples of a power of two for each.
struct WordPoints {
  std::array<std::array<SignedWord2, most_points>, most_dimension> at;
  std::array<std::int64_t, most_dimension> unit, bits;

  // False where they are of sizes that are too different.
  bool read(const Polytope& a, const Polytope& b, const FewNamed& named) {
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    for (std::size_t c = 0; c < a.dimension(); ++c) {
      std::array<OddMantissa, most_points> numbers;
      std::int64_t low = most, top = -most;
      for (std::size_t k = 0; k < named.count; ++k) {
        const auto [is_of_a, row] = named.item[k];
        numbers[k] = OddMantissa((is_of_a ? a : b).row(row)[c]);
        if (numbers[k].size == 0) continue;
        low = std::min(low, numbers[k].exponent);
        top = std::max(top, numbers[k].top());
      }
      unit[c] = low == most ? 0 : low;
      bits[c] = low == most ? 0 : top - low;
      if (bits[c] + 1 > static_cast<std::int64_t>(FewWords::most_bits)) return false;
      for (std::size_t k = 0; k < named.count; ++k) {
        const auto& [size, exponent, is_negative] = numbers[k];
        const SignedWord2 shifted = size == 0 ? 0 : SignedWord2{size} << (exponent - unit[c]);
        at[c][k] = is_negative ? -shifted : shifted;
      }
    }
    return true;
  }

  // The edges that weights_of speaks of.
  FewWordVectors edges(std::size_t d, const FewNamed& named) const {
    const std::size_t first_b = named.count_a;
    FewWordVectors result;
    result.equations = d;
    result.count = named.count - 1;
    for (std::size_t c = 0; c < d; ++c) {
      const auto& x = at[c];
      result.bits[c] = bits[c] + 1;
      for (std::size_t k = 1, j = 0; k < named.count; ++k) {
        if (k != first_b) result.numbers[c][j++] = entry_of(k < first_b ? x[k] - x[0] : x[first_b] - x[k]);
      }
      result.numbers[c][result.count - 1] = entry_of(x[0] - x[first_b]);
    }
    return result;
  }
};

// False where the integers have too many words; else the answer is that of `common_point`.
bool common_point_in_words(const Polytope& a, const Polytope& b, const FewNamed& named,
                           std::optional<ExactEvidence>& result) {
  const std::size_t d = a.dimension();
  WordPoints points;
  if (!points.read(a, b, named)) return false;
  const FewWordVectors vectors = points.edges(d, named);
  std::int64_t most_bits = 0;
  for (std::size_t c = 0; c < d; ++c) most_bits = std::max(most_bits, points.bits[c]);
  if (!vectors.fit(most_bits + 3)) return false;  // sums of eight weights, and of products with coordinates
  const auto v = null_vector(vectors);
  if (!v) return true;
  const auto weights = weights_of(*v, named);
  if (!weights) return true;
  ExactEvidence& evidence = result.emplace();
  evidence.numbers.reserve(d);
  for (std::size_t c = 0; c < d; ++c) {
    FewWords::Number sum{};
    for (std::size_t k = 0; k < named.count_a; ++k) {
      FewWords::add_product(sum, entry_of(points.at[c][k]), (*weights)[k], false);
    }
    evidence.numbers.push_back(dyadic_of(FewWords::integer(sum), points.unit[c]));
  }
  evidence.denominator = dyadic_of(FewWords::integer((*v)[named.count - 2]), 0);
  evidence.of_a.denominator = evidence.of_b.denominator = evidence.denominator;
  evidence.of_a.parts.reserve(named.count_a);
  evidence.of_b.parts.reserve(named.count - named.count_a);
  for (std::size_t k = 0; k < named.count; ++k) {
    if (is_zero((*weights)[k])) continue;
    const auto [is_of_a, row] = named.item[k];
    (is_of_a ? evidence.of_a : evidence.of_b).parts.push_back({row, dyadic_of(FewWords::integer((*weights)[k]), 0)});
  }
  return true;
}

// ---- In integers of any size.

ExactVector difference(const ExactVector& u, const ExactVector& v) {
  ExactVector result(u.size());
  for (std::size_t c = 0; c < u.size(); ++c) result[c] = u[c] - v[c];
  return result;
}

std::optional<ExactEvidence> common_point(Placed a, Placed b, const FewNamed& named) {
  const std::size_t d = a.dimension(), first_b = named.count_a;
  if (first_b == 0 || first_b == named.count || named.count > d + 2) return std::nullopt;
  if (a.pose().is_identity() && b.pose().is_identity()) {
    std::optional<ExactEvidence> result;
    if (common_point_in_words(a.body(), b.body(), named, result)) return result;
  }
  std::array<ExactVector, most_points> images;
  for (std::size_t k = 0; k < named.count; ++k) {
    images[k] = (named.item[k].is_of_a ? a : b).image(named.item[k].row);
  }
  std::array<ExactVector, most_vectors> vectors;
  std::size_t count = 0;
  for (std::size_t k = 1; k < named.count; ++k) {
    if (k < first_b) vectors[count++] = difference(images[k], images[0]);
    if (k > first_b) vectors[count++] = difference(images[first_b], images[k]);
  }
  vectors[count++] = difference(images[0], images[first_b]);
  const auto v = null_vector(std::span(vectors).first(count));
  if (!v) return std::nullopt;
  auto weights = weights_of(*v, named);
  if (!weights) return std::nullopt;
  ExactEvidence result{.numbers = ExactVector(d)};
  result.denominator = result.of_a.denominator = result.of_b.denominator = dyadic_of((*v)[count - 1], 0);
  for (std::size_t k = 0; k < named.count; ++k) {
    if (is_zero((*weights)[k])) continue;
    const Dyadic weight = dyadic_of(std::move((*weights)[k]), 0);
    const auto [is_of_a, row] = named.item[k];
    if (is_of_a) add_multiple(result.numbers, weight, images[k]);
    (is_of_a ? result.of_a : result.of_b).parts.push_back({row, weight});
  }
  return result;
}

}  // namespace

std::optional<ExactEvidence> common_point_by_determinants(const Polytope& a, const Pose& pose_a, const Polytope& b,
                                                          const Pose& pose_b, NamedPoints named) {
  SUNDER_REQUIRE(named.of_a.size() <= most_dimension + 1 && named.of_b.size() <= most_dimension + 1);
  if (named.of_a.empty() || named.of_b.empty()) return std::nullopt;
  AllNamed all;
  for (const std::uint32_t k : named.of_a) all.add({true, k});
  for (const std::uint32_t k : named.of_b) all.add({false, k});
  if (all.count <= a.dimension() + 2) {
    FewNamed few;
    for (std::size_t k = 0; k < all.count; ++k) few.add(all.item[k]);
    if (auto found = common_point({a, pose_a}, {b, pose_b}, few)) return found;
  }
  return common_point({a, pose_a}, {b, pose_b}, likely(a, pose_a, b, pose_b, all));
}

}  // namespace sunder::polytope
