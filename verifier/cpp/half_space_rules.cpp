// The rules about half-spaces, a polytope of these that is not placed: docs/claims.md, "Half-spaces".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

bool all_zero(const Integers& numbers) {
  return std::all_of(numbers.begin(), numbers.end(), [](const Integer& n) { return n == 0; });
}

Integer product(const Integers& u, const Integers& v) {  // of as many numbers as the shorter one has
  Integer sum = 0;
  for (std::size_t k = 0; k < std::min(u.size(), v.size()); ++k) sum += u[k] * v[k];
  return sum;
}

std::size_t rank(const std::vector<Integers>& rows) {
  std::size_t wide = 0;
  for (const Integers& row : rows) wide = std::max(wide, rows[0].size() * bits(row));
  take_steps(rows.size(), wide, wide);
  std::vector<std::pair<std::size_t, Integers>> known;  // each with where it is not zero
  for (Integers row : rows) {
    for (const auto& [pivot, other] : known) {
      if (row[pivot] == 0) continue;
      const Integer own = row[pivot];
      for (std::size_t k = 0; k < row.size(); ++k) row[k] = row[k] * other[pivot] - other[k] * own;
    }
    const auto pivot = std::find_if(row.begin(), row.end(), [](const Integer& n) { return n != 0; });
    if (pivot == row.end()) continue;
    const auto at = static_cast<std::size_t>(pivot - row.begin());
    Integer shared = 0;
    for (const Integer& n : row) shared = gcd(shared, n);
    for (Integer& n : row) n /= shared;
    known.emplace_back(at, std::move(row));
  }
  return known.size();
}

// The sum of the rows by multipliers: its normal and its b are to be divided by n, times 2^e.
struct CombinedRows {
  Integers normal;
  Integer b = 0, n = 1;
  std::int64_t e = 0;
};

CombinedRows combined(const char* rule, const WeightList& multipliers, const RowBody& given) {
  CombinedRows result{Integers(given.dimension)};
  if (multipliers.named.empty()) return result;
  const Common weights = common_weights(multipliers.values);
  for (std::size_t k = 0; k < multipliers.named.size(); ++k) {
    require(weights.integers[k] > 0, rule, "a multiplier is not positive");
    const Integers& row = given.given->rows[multipliers.named[k]];
    for (std::size_t c = 0; c < given.dimension; ++c) result.normal[c] += weights.integers[k] * row[c];
    result.b += weights.integers[k] * row[given.dimension];
  }
  result.n = weights.d;
  result.e = weights.e + given.given->e;
  return result;
}

std::size_t rank_of_normals(const WeightList& multipliers, const RowBody& given) {
  std::vector<Integers> normals;
  for (const std::size_t k : multipliers.named) {
    normals.push_back(given.given->rows[k]);
    normals.back().pop_back();
  }
  return rank(normals);
}

void require_receding(const char* rule, const Claim& claim, const RowBody& given) {
  const Integers way = common(claim.direction).integers;
  require(!all_zero(way), rule, "there is no direction");
  take_steps(given.given->rows.size(), bits(way), given.given->bits);
  for (std::size_t k = 0; k < given.given->rows.size(); ++k) {
    require(product(way, given.given->rows[k]) <= 0, rule, "the direction leaves half-space " + std::to_string(k));
  }
}

void require_top(const char* rule, const Claim& claim, const RowBody& given, const Numbers& objective,
                 const Numbers& point) {
  const auto [normal, b, n, e] = combined(rule, claim.multipliers, given);
  const Common up = common(objective);
  require(!all_zero(up.integers), rule, "there is no objective");
  const Integers place = projective(point);
  const std::int64_t more = std::max<std::int64_t>(e - up.e, 0), less = std::max<std::int64_t>(up.e - e, 0);
  const auto require_equal = [&](const Integer& m, const Integer& wanted) {
    require(shifted(m, more) == shifted(wanted * n, less), rule,
            "the combined rows do not bound the objective at the point");
  };
  for (std::size_t c = 0; c < given.dimension; ++c) require_equal(normal[c], up.integers[c]);
  require_equal(b * place.back(), product(up.integers, place));
}

}  // namespace

void check_contradicted(const Claim& claim, const RowBody& given) {
  const CombinedRows sum = combined("contradicted", claim.multipliers, given);
  require(all_zero(sum.normal) && sum.b < 0, "contradicted", "the combined rows have a common point");
}

void check_spans(const Claim& claim, const RowBody& given, std::size_t dimension, const std::vector<Numbers>& points) {
  require(points.size() == dimension + 1, "spans", "the number of points is not the dimension plus one");
  std::vector<Integers> places;
  for (const Numbers& point : points) places.push_back(projective(point));
  for (std::size_t i = 0; i < points.size(); ++i) {
    take_steps(given.given->rows.size(), length(points[i]), given.given->bits);
    for (std::size_t k = 0; k < given.given->rows.size(); ++k) {
      const Integers& row = given.given->rows[k];
      Integer excess = -row[given.dimension] * places[i][given.dimension];
      for (std::size_t c = 0; c < given.dimension; ++c) excess += row[c] * places[i][c];
      require(excess <= 0, "spans", "half-space " + std::to_string(k) + " does not hold a point");
    }
  }
  require(rank(places) == places.size(), "spans", "the points are in a flat of less dimensions");
  const CombinedRows sum = combined("spans", claim.multipliers, given);
  require(all_zero(sum.normal) && sum.b == 0, "spans", "the combined rows are not zero");
  require(rank_of_normals(claim.multipliers, given) + dimension == given.dimension, "spans",
          "the rows leave more dimensions");
}

void check_enclosed(const Claim& claim, const RowBody& given) {
  require(all_zero(combined("enclosed", claim.multipliers, given).normal), "enclosed",
          "the combined normals are not zero");
  require(rank_of_normals(claim.multipliers, given) == given.dimension, "enclosed", "the normals do not span all");
}

void check_recedes(const Claim& claim, const RowBody& given) { require_receding("recedes", claim, given); }

void check_rises(const Claim& claim, const RowBody& given, const Numbers& objective) {
  require_receding("rises", claim, given);
  require(product(common(objective).integers, common(claim.direction).integers) > 0, "rises",
          "the direction does not lead further");
}

void check_tops(const Claim& claim, const RowBody& given, const Numbers& objective, const Numbers& point) {
  require_top("tops", claim, given, objective, point);
}

void check_tops_only(const Claim& claim, const RowBody& given, const Numbers& objective, const Numbers& point) {
  require_top("tops_only", claim, given, objective, point);
  require(rank_of_normals(claim.multipliers, given) == given.dimension, "tops_only", "the normals do not span all");
}

void check_another(const Numbers& objective, const Numbers& point, const Numbers& as_good) {
  const Integers up = common(objective).integers, p = projective(point), q = projective(as_good);
  bool is_same = true;
  for (std::size_t c = 0; c < up.size(); ++c) is_same = is_same && p[c] * q.back() == q[c] * p.back();
  require(!is_same, "another", "it is the same point");
  require(product(up, p) * q.back() == product(up, q) * p.back(), "another", "it is not as far along the objective");
}

}  // namespace sunder_verifier
