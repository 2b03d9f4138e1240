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
    require(weights.integers[k] >= 0, rule, std::string("a ") + noun + " of " + body.quoted + " is negative");
    total += weights.integers[k];
    const Integers& row = body.given->rows[list.named[k]];
    for (std::size_t c = 0; c < columns; ++c) sum[c] += weights.integers[k] * row[c];
  }
  for (std::size_t c = 0; c < columns; ++c) result.row[c] = {sum[c], weights.d, weights.e + body.given->e};
  result.total = {total, weights.d, weights.e};
  return result;
}

using Planes = std::vector<Common>;  // half-spaces a1, .., ad, b

// Half-spaces that hold all of a polytope of points, where it is no image.
Planes planes_around(const RowBody& body, const std::vector<Numbers>& given) {
  Planes planes;
  for (const Numbers& plane : given) {
    take_steps(plane.size(), length(plane), length(plane));
    planes.push_back(common(plane));
    const Integers& row = planes.back().integers;
    take_steps(body.given->rows.size(), bits(row), body.given->bits);
    const Integers normal(row.begin(), row.end() - 1);
    Integer furthest = dot(normal, body.given->rows[0]);
    for (const Integers& point : body.given->rows) furthest = std::max<Integer>(furthest, dot(normal, point));
    require(sum_of({{furthest, 1, body.given->e}, {-row.back(), 1, 0}}) <= 0, "parted_by_hyperplanes",
            "hyperplane " + std::to_string(planes.size() - 1) + " of " + body.quoted + " does not hold all of it");
  }
  return planes;
}

// Of planes times multipliers, the sum.
Numbers combined(const WeightList& multipliers, const Planes& planes, const RowBody& body) {
  Numbers result(body.dimension + 1);
  if (multipliers.named.empty()) return result;
  Numbers values = multipliers.values;
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k].d *= planes[multipliers.named[k]].d;
  }
  const std::size_t whole = length(values);
  take_steps(values.size() / 4 + 1, whole, whole);
  for (std::size_t k = 0; k < values.size(); ++k) {
    require(values[k].n >= 0, "parted_by_hyperplanes", "a multiplier of " + body.quoted + " is negative");
    values[k].e += planes[multipliers.named[k]].e;
  }
  const Common weights = common(values);
  for (std::size_t c = 0; c < result.size(); ++c) {
    result[c] = {0, weights.d, weights.e};
    for (std::size_t k = 0; k < values.size(); ++k) {
      result[c].n += weights.integers[k] * planes[multipliers.named[k]].integers[c];
    }
  }
  return result;
}

// Numbers whose sum the body does not exceed along the direction, or (side -1) along its opposite. Of planes around a
// body of points: as of half-spaces.
Numbers limit(const RowBody& body, const WeightList& multipliers, const Numbers& direction, int side,
              const Planes* planes = nullptr) {
  const char* const rule = planes == nullptr ? "parted_by" : "parted_by_hyperplanes";
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
  if (body.is_of_points && planes == nullptr) {
    take_steps(body.given->rows.size(), bits(along), body.given->bits);
    Integer greatest = dot(along, body.given->rows[0]);
    for (const Integers& row : body.given->rows) greatest = std::max<Integer>(greatest, dot(along, row));
    result.push_back({greatest, given.d, e + body.given->e});
    return result;
  }
  const Numbers sum = body.is_of_points ? combined(multipliers, *planes, body)
                                        : weighted_rows(rule, "multiplier", multipliers, body).row;
  for (std::size_t c = 0; c < d; ++c) {
    require(are_equal(sum[c], {along[c], given.d, e}), rule,
            "the multipliers of " + body.quoted + " do not make the direction");
  }
  result.push_back(sum[d]);
  return result;
}

}  // namespace

void check_parted_by(const Claim& claim, const RowBody& a, const RowBody& b) {
  Numbers ends = limit(a, claim.of_a, claim.direction, 1);
  for (const Number& end : limit(b, claim.of_b, claim.direction, -1)) ends.push_back(end);
  take_steps(16, length(ends), length(ends));
  require(sum_of(ends) < 0, "parted_by", a.quoted + " is not strictly less far along the direction than " + b.quoted);
}

void check_parted_by_hyperplanes(const Claim& claim, const RowBody& a, const RowBody& b) {
  const Planes planes_a = planes_around(a, claim.planes_a), planes_b = planes_around(b, claim.planes_b);
  Numbers ends = limit(a, claim.of_a, claim.direction, 1, &planes_a);
  for (const Number& end : limit(b, claim.of_b, claim.direction, -1, &planes_b)) ends.push_back(end);
  take_steps(16, length(ends), length(ends));
  require(sum_of(ends) < 0, "parted_by_hyperplanes",
          "the half-spaces around " + a.quoted + " and " + b.quoted + " do not contradict");
}

void check_keeps(const Claim& claim, const RowBody& body, const Numbers& point) {
  const std::size_t d = body.dimension;
  Integers place;  // in the frame of the body: x, .., w
  if (body.is_of_points) {
    const WeightedRows mean = weighted_rows("keeps", "weight", claim.weights, body);
    require(are_equal(mean.total, {1, 1, 0}), "keeps", "the weights of " + body.quoted + " do not sum to 1");
    place = projective(mean.row);
  } else {
    place = projective(claim.at);
    take_steps(body.given->rows.size(), length(claim.at), body.given->bits);
    for (std::size_t k = 0; k < body.given->rows.size(); ++k) {
      const Integers& row = body.given->rows[k];
      Integer excess = -row[d] * place[d];
      for (std::size_t c = 0; c < d; ++c) excess += row[c] * place[c];
      require(excess <= 0, "keeps",
              "half-space " + std::to_string(k) + " of " + body.quoted + " does not hold its point");
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
    require(
        sum_of(terms) == 0, "keeps",
        "the weighted point of " + body.quoted + " differs from the stated point in coordinate " + std::to_string(r));
  }
}

}  // namespace sunder_verifier
