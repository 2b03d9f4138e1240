// The rules about polytopes of R^d, of points or of half-spaces: docs/claims.md, "Rules" and "Half-spaces".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

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
Planes planes_around(const RowBody& body, const Points& given) {
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

void check_parted_by(const Numbers& direction, const WeightList& of_a, const WeightList& of_b, const RowBody& a,
                     const RowBody& b) {
  Numbers ends = limit(a, of_a, direction, 1);
  for (const Number& end : limit(b, of_b, direction, -1)) ends.push_back(end);
  take_steps(16, length(ends), length(ends));
  require(sum_of(ends) < 0, "parted_by", a.quoted + " is not strictly less far along the direction than " + b.quoted);
}

void check_parted_by_hyperplanes(const Numbers& direction, const Points& given_a, const WeightList& by_a,
                                 const Points& given_b, const WeightList& by_b, const RowBody& a, const RowBody& b) {
  const Planes planes_a = planes_around(a, given_a), planes_b = planes_around(b, given_b);
  Numbers ends = limit(a, by_a, direction, 1, &planes_a);
  for (const Number& end : limit(b, by_b, direction, -1, &planes_b)) ends.push_back(end);
  take_steps(16, length(ends), length(ends));
  require(sum_of(ends) < 0, "parted_by_hyperplanes",
          "the half-spaces around " + a.quoted + " and " + b.quoted + " do not contradict");
}

void check_keeps(const WeightList& weights, const Numbers& at, const RowBody& body, const Numbers& point) {
  const std::size_t d = body.dimension;
  Integers place;  // in the frame of the body: x, .., w
  if (body.is_of_points) {
    const WeightedRows mean = weighted_rows("keeps", "weight", weights, body);
    require(are_equal(mean.total, {1, 1, 0}), "keeps", "the weights of " + body.quoted + " do not sum to 1");
    place = projective(mean.row);
  } else {
    place = projective(at);
    take_steps(body.given->rows.size(), length(at), body.given->bits);
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

void require_receding(const char* rule, const Numbers& direction, const RowBody& given) {
  const Integers way = common(direction).integers;
  require(!all_zero(way), rule, "there is no direction");
  take_steps(given.given->rows.size(), bits(way), given.given->bits);
  for (std::size_t k = 0; k < given.given->rows.size(); ++k) {
    require(product(way, given.given->rows[k]) <= 0, rule, "the direction leaves half-space " + std::to_string(k));
  }
}

void require_top(const char* rule, const WeightList& multipliers, const RowBody& given, const Numbers& objective,
                 const Numbers& point) {
  const auto [normal, b, n, e] = combined(rule, multipliers, given);
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

void check_contradicted(const WeightList& multipliers, const RowBody& given) {
  const CombinedRows sum = combined("contradicted", multipliers, given);
  require(all_zero(sum.normal) && sum.b < 0, "contradicted", "the combined rows have a common point");
}

void check_spans(const WeightList& multipliers, const RowBody& given, std::size_t dimension, const Points& points) {
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
  const CombinedRows sum = combined("spans", multipliers, given);
  require(all_zero(sum.normal) && sum.b == 0, "spans", "the combined rows are not zero");
  require(rank_of_normals(multipliers, given) + dimension == given.dimension, "spans",
          "the rows leave more dimensions");
}

void check_enclosed(const WeightList& multipliers, const RowBody& given) {
  require(all_zero(combined("enclosed", multipliers, given).normal), "enclosed", "the combined normals are not zero");
  require(rank_of_normals(multipliers, given) == given.dimension, "enclosed", "the normals do not span all");
}

void check_recedes(const Numbers& direction, const RowBody& given) { require_receding("recedes", direction, given); }

void check_rises(const Numbers& direction, const RowBody& given, const Numbers& objective) {
  require_receding("rises", direction, given);
  require(product(common(objective).integers, common(direction).integers) > 0, "rises",
          "the direction does not lead further");
}

void check_tops(const WeightList& multipliers, const RowBody& given, const Numbers& objective, const Numbers& point) {
  require_top("tops", multipliers, given, objective, point);
}

void check_tops_only(const WeightList& multipliers, const RowBody& given, const Numbers& objective,
                     const Numbers& point) {
  require_top("tops_only", multipliers, given, objective, point);
  require(rank_of_normals(multipliers, given) == given.dimension, "tops_only", "the normals do not span all");
}

void check_another(const Numbers& objective, const Numbers& point, const Numbers& as_good) {
  const Integers up = common(objective).integers, p = projective(point), q = projective(as_good);
  bool is_same = true;
  for (std::size_t c = 0; c < up.size(); ++c) is_same = is_same && p[c] * q.back() == q[c] * p.back();
  require(!is_same, "another", "it is the same point");
  require(product(up, p) * q.back() == product(up, q) * p.back(), "another", "it is not as far along the objective");
}

// The sign of the determinant, by elimination without fractions.
int sign_of_determinant(std::vector<Integers> rows) {
  int sign = 1;
  Integer before = 1;
  for (std::size_t c = 0; c < rows.size(); ++c) {
    const auto pivot = std::find_if(rows.begin() + static_cast<std::ptrdiff_t>(c), rows.end(),
                                    [c](const Integers& row) { return row[c] != 0; });
    if (pivot == rows.end()) return 0;
    if (pivot != rows.begin() + static_cast<std::ptrdiff_t>(c)) {
      std::swap(*pivot, rows[c]);
      sign = -sign;
    }
    for (std::size_t r = c + 1; r < rows.size(); ++r) {
      for (std::size_t k = rows.size(); k-- > c;) {
        rows[r][k] = Integer(rows[c][c] * rows[r][k] - rows[r][c] * rows[c][k]) / before;  // exact
      }
    }
    before = rows[c][c];
  }
  return before > 0 ? sign : -sign;
}

// The same point has the same numbers.
Integers reduced(Integers place) {
  Integer shared = 0;
  for (const Integer& n : place) shared = gcd(shared, n);
  for (Integer& n : place) n /= shared;
  return place;
}

struct RidgeSides {
  bool is_right = false, is_left = false;
};

class NormalFan {
 public:
  NormalFan(const std::vector<IndexLists>& fans, const RowBody& given) : fans_(fans), given_(given) {
    std::size_t count = 0;
    for (const IndexLists& fan : fans) count += fan.size();
    const std::size_t d = given.dimension, size = d * given.given->bits / 2;
    take_steps(count * d * d * d, size, size);
  }

  // Is it in all half-spaces, at the end of those of its cones, and new?
  void take_vertex(std::size_t v, const Numbers& point) {
    take_steps(given_.given->rows.size(), length(point), given_.given->bits);
    const Integers place = projective(point);
    const std::size_t d = given_.dimension;
    std::vector<bool> is_on;
    for (const Integers& row : given_.given->rows) {
      Integer excess = -row[d] * place[d];
      for (std::size_t c = 0; c < d; ++c) excess += row[c] * place[c];
      require(excess <= 0, "normal_fan",
              "half-space " + std::to_string(is_on.size()) + " does not hold vertex " + std::to_string(v));
      is_on.push_back(excess == 0);
    }
    take_steps(16, length(point), length(point));
    const auto [known, is_new] = vertices_.try_emplace(reduced(place), v);
    require(is_new, "normal_fan",
            "vertex " + std::to_string(v) + " is vertex " + std::to_string(known->second) + " once more");
    for (const Indices& cone : fans_[v]) {
      for (const std::size_t k : cone) {
        require(is_on[k], "normal_fan",
                "vertex " + std::to_string(v) + " is not where half-space " + std::to_string(k) + " ends");
      }
      take_cone(v, cone);
    }
  }

  // Does each ridge have a cone on either side?
  void look_at_ridges() const {
    for (std::size_t v = 0; v < fans_.size(); ++v) {
      for (Indices cone : fans_[v]) {
        std::sort(cone.begin(), cone.end());
        for (std::size_t i = 0; i < cone.size(); ++i) {
          const RidgeSides& sides = ridges_.at(without(cone, i));
          require(sides.is_right && sides.is_left, "normal_fan",
                  "there is no cone beyond a ridge of one of vertex " + std::to_string(v));
        }
      }
    }
  }

 private:
  static Indices without(Indices cone, std::size_t i) {
    cone.erase(cone.begin() + static_cast<std::ptrdiff_t>(i));
    return cone;
  }

  void take_cone(std::size_t v, Indices cone) {
    std::sort(cone.begin(), cone.end());
    std::vector<Integers> normals;
    for (const std::size_t k : cone) {
      normals.push_back(given_.given->rows[k]);
      normals.back().pop_back();
    }
    const int sign = sign_of_determinant(std::move(normals));
    require(sign != 0, "normal_fan", "the normals of a cone of vertex " + std::to_string(v) + " are in a hyperplane");
    for (std::size_t i = 0; i < cone.size(); ++i) {
      RidgeSides& sides = ridges_[without(cone, i)];
      ((sign > 0) == (i % 2 == 0) ? sides.is_right : sides.is_left) = true;
    }
  }

  const std::vector<IndexLists>& fans_;
  const RowBody& given_;
  std::map<Integers, std::size_t> vertices_;
  std::map<Indices, RidgeSides> ridges_;  // by half-spaces, ascending
};

void check_normal_fan(const std::vector<IndexLists>& fans, const RowBody& given, const Points& vertices) {
  NormalFan fan(fans, given);
  for (std::size_t v = 0; v < vertices.size(); ++v) fan.take_vertex(v, vertices[v]);
  fan.look_at_ridges();
}

}  // namespace

const ClaimRows claims_of_polytopes{
    {"parted_by", "direction: point; of_a: row multipliers of a; of_b: row multipliers of b", rule<check_parted_by>},
    {"parted_by_hyperplanes",
     "direction: point; planes_a: surrounding planes of a; by_a: plane multipliers of a; "
     "planes_b: surrounding planes of b; by_b: plane multipliers of b",
     rule<check_parted_by_hyperplanes>},
    {"keeps", "weights: point weights of subject; at: place of subject", rule<check_keeps>},
    {"contradicted", "multipliers: multipliers of subject", rule<check_contradicted>},
    {"spans", "multipliers: multipliers of subject", rule<check_spans>},
    {"enclosed", "multipliers: multipliers of subject", rule<check_enclosed>},
    {"recedes", "direction: point", rule<check_recedes>},
    {"rises", "direction: point", rule<check_rises>},
    {"tops", "multipliers: multipliers of subject", rule<check_tops>},
    {"tops_only", "multipliers: multipliers of subject", rule<check_tops_only>},
    {"another", "", rule<check_another>},
    {"normal_fan", "fans: fans of subject", rule<check_normal_fan>},
};

}  // namespace sunder_verifier
