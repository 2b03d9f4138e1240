// The rules about polytopes of R^d, of points or of half-spaces: docs/claims.md, "Polytopes".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <string>
#include <utility>

namespace sunder_verifier {
namespace {

// The sum of numbers, times a positive one.
Integer sum_of(const Numbers& numbers) {
  Integer sum = 0;
  for (const Integer& n : common(numbers).integers) sum += n;
  return sum;
}

bool are_equal(const Number& x, const Number& y) { return sum_of({x, {-y.n, y.d, y.e}}) == 0; }

// Rows of the body, as they are, times weights that are not negative; and the sum of the weights.
struct WeightedRows {
  Numbers row;
  Number total;
};

WeightedRows weighted_rows(const char* rule, const char* noun, const WeightList& list, const RowBody& body) {
  const std::size_t columns = body.dimension + (body.is_of_points ? 0 : 1);
  WeightedRows result{Numbers(columns), {}};
  if (list.named.empty()) return result;
  const Common weights = common_weights(list.values);
  Integers sum(columns);
  Integer total = 0;
  for (std::size_t k = 0; k < list.named.size(); ++k) {
    require(weights.integers[k] >= 0, rule, std::string("a ") + noun + " of " + body.name + " is negative");
    total += weights.integers[k];
    const Integers& row = body.given->rows[list.named[k]];
    for (std::size_t c = 0; c < columns; ++c) sum[c] += weights.integers[k] * row[c];
  }
  for (std::size_t c = 0; c < columns; ++c) result.row[c] = {sum[c], weights.d, weights.e + body.given->e};
  result.total = {total, weights.d, weights.e};
  return result;
}

// Numbers whose sum the body does not exceed along the direction, or (side -1) along its opposite.
Numbers limit(const RowBody& body, const WeightList& multipliers, const Numbers& direction, int side) {
  const std::size_t d = body.dimension;
  const Common given = common(direction);
  Integers along = given.integers;
  for (Integer& n : along) n *= side;
  std::int64_t e = given.e;
  Numbers result;
  if (body.is_image()) {
    take_steps(d * d, bits(along), body.linear.bits);
    result.push_back({dot(along, body.translation.rows[0]), given.d, e + body.translation.e});
    const Integers before = std::exchange(along, Integers(d));
    for (std::size_t c = 0; c < d; ++c) {
      for (std::size_t r = 0; r < d; ++r) along[c] += before[r] * body.linear.rows[0][r * d + c];
    }
    e += body.linear.e;
  }
  if (body.is_of_points) {
    take_steps(body.given->rows.size(), bits(along), body.given->bits);
    Integer greatest = dot(along, body.given->rows[0]);
    for (const Integers& row : body.given->rows) greatest = std::max<Integer>(greatest, dot(along, row));
    result.push_back({greatest, given.d, e + body.given->e});
    return result;
  }
  const WeightedRows combined = weighted_rows("parted_by", "multiplier", multipliers, body);
  for (std::size_t c = 0; c < d; ++c) {
    require(are_equal(combined.row[c], {along[c], given.d, e}), "parted_by",
            "the multipliers of " + body.name + " do not make the direction");
  }
  result.push_back(combined.row[d]);
  return result;
}

}  // namespace

void check_parted_by(const Claim& claim, const RowBody& a, const RowBody& b) {
  Numbers ends = limit(a, claim.of_a, claim.direction, 1);
  for (const Number& end : limit(b, claim.of_b, claim.direction, -1)) ends.push_back(end);
  take_steps(16, length(ends), length(ends));
  require(sum_of(ends) < 0, "parted_by", a.name + " is not strictly less far along the direction than " + b.name);
}

void check_keeps(const Claim& claim, const RowBody& body, const Numbers& point) {
  const std::size_t d = body.dimension;
  Integers place;  // in the frame of the body: x, .., w
  if (body.is_of_points) {
    const WeightedRows mean = weighted_rows("keeps", "weight", claim.weights, body);
    require(are_equal(mean.total, {1, 1, 0}), "keeps", "the weights of " + body.name + " do not sum to 1");
    place = projective(mean.row);
  } else {
    place = projective(claim.at);
    take_steps(body.given->rows.size(), length(claim.at), body.given->bits);
    for (std::size_t k = 0; k < body.given->rows.size(); ++k) {
      const Integers& row = body.given->rows[k];
      Integer excess = -row[d] * place[d];
      for (std::size_t c = 0; c < d; ++c) excess += row[c] * place[c];
      require(excess <= 0, "keeps",
              "half-space " + std::to_string(k) + " of " + body.name + " does not hold its point");
    }
  }
  if (body.is_image()) take_steps(d * d, length(point), body.linear.bits);
  for (std::size_t r = 0; r < d; ++r) {
    Numbers terms{{-point[r].n * place[d], point[r].d, point[r].e}};
    if (body.is_image()) {
      Integer turned = 0;
      for (std::size_t c = 0; c < d; ++c) turned += body.linear.rows[0][r * d + c] * place[c];
      terms.push_back({turned, 1, body.linear.e});
      terms.push_back({body.translation.rows[0][r] * place[d], 1, body.translation.e});
    } else {
      terms.push_back({place[r], 1, 0});
    }
    require(sum_of(terms) == 0, "keeps",
            "the point of " + body.name + " is another one in coordinate " + std::to_string(r));
  }
}

}  // namespace sunder_verifier
