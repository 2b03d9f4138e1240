#include <sunder/base/contract.h>
#include <sunder/polytope/pair/common_weights.h>
#include <sunder/polytope/pair/null_vector_internal.h>
#include <sunder/polytope/pair/placed.h>
#include <sunder/polytope/pair/rounded_simplex.h>
#include <sunder/polytope/pair/support.h>

#include <array>
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

ExactVector difference(const ExactVector& u, const ExactVector& v) {
  ExactVector result(u.size());
  for (std::size_t c = 0; c < u.size(); ++c) result[c] = u[c] - v[c];
  return result;
}

std::optional<ExactEvidence> common_point(Placed a, Placed b, const FewNamed& named) {
  const std::size_t d = a.dimension(), first_b = named.count_a;
  if (first_b == 0 || first_b == named.count || named.count > d + 2) return std::nullopt;
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
  auto v = null_vector(std::span(vectors).first(count));
  if (!v || (*v)[count - 1].is_zero()) return std::nullopt;
  const Integer& denominator = (*v)[count - 1];
  std::array<Integer, most_points> weights;
  weights[0] = weights[first_b] = denominator;
  for (std::size_t k = 1, j = 0; k < named.count; ++k) {
    if (k == first_b) continue;
    if ((*v)[j] < 0) return std::nullopt;
    weights[k < first_b ? 0 : first_b] -= (*v)[j];
    weights[k] = std::move((*v)[j++]);
  }
  if (weights[0] < 0 || weights[first_b] < 0) return std::nullopt;
  ExactEvidence result;
  result.numbers.resize(d);
  result.denominator = result.of_a.denominator = result.of_b.denominator = dyadic_of(denominator, 0);
  for (std::size_t k = 0; k < named.count; ++k) {
    if (weights[k].is_zero()) continue;
    const Dyadic weight = dyadic_of(std::move(weights[k]), 0);
    const auto [is_of_a, row] = named.item[k];
    for (std::size_t c = 0; c < d && is_of_a; ++c) result.numbers[c] = result.numbers[c] + weight * images[k][c];
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
