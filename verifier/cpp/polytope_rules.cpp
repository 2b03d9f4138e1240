// The rules about polytopes of R^d, of points or of half-spaces: docs/claims.md, "Rules" and "Half-spaces".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

std::size_t columns_of(const RowBody& body) { return body.dimension + (body.is_of_points ? 0 : 1); }

// Rows of the body, as they are, times weights.
Combination combined_rows(const WeightsMust& must, const WeightList& list, const RowBody& body) {
  return combined(must, list, columns_of(body),
                  [&](std::size_t k) { return std::pair(body.given->rows[k], body.given->e); });
}

// Requires that the point x, .., w is in each half-space; `words` tell which, and that they do not hold it. Is it on
// their boundaries?
template <class Words>
std::vector<bool> require_in_each(const char* rule, const RowBody& given, const Integers& place, const Words& words) {
  std::vector<bool> is_on;
  for (const Integers& row : given.given->rows) {
    Integer excess = -row.back() * place.back();
    for (std::size_t c = 0; c < given.dimension; ++c) excess += row[c] * place[c];
    if (excess > 0) require(false, rule, words(std::to_string(is_on.size())));
    is_on.push_back(excess == 0);
  }
  return is_on;
}

Integer greatest_product(const Integers& direction, const std::vector<Integers>& points) {
  Integer greatest = dot(direction, points[0]);
  for (const Integers& point : points) greatest = std::max<Integer>(greatest, dot(direction, point));
  return greatest;
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
    const Integer furthest = greatest_product(normal, body.given->rows);
    require(compare(furthest, body.given->e, row.back(), 0) <= 0, "parted_by_hyperplanes",
            "hyperplane " + std::to_string(planes.size() - 1) + " of " + body.quoted + " does not hold all of it");
  }
  return planes;
}

// Rows of half-spaces, those of a body or planes around it, times multipliers that are not negative.
Combination multiplied(const char* rule, const WeightList& multipliers, const RowBody& body, const Planes* planes) {
  const WeightsMust must{rule, false, "a multiplier of " + body.quoted + " is negative"};
  if (!body.is_of_points) return combined_rows(must, multipliers, body);
  WeightList list = multipliers;
  for (std::size_t k = 0; k < list.named.size(); ++k) list.values[k].d *= (*planes)[list.named[k]].d;
  return combined(must, list, body.dimension + 1,
                  [&](std::size_t k) { return std::pair((*planes)[k].integers, (*planes)[k].e); });
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
    along = transposed_times(body.linear, along);
    e += body.linear.e;
  }
  if (body.is_of_points && planes == nullptr) {
    take_steps(body.given->rows.size(), bits(along), body.given->bits);
    result.push_back({greatest_product(along, body.given->rows), given.d, e + body.given->e});
    return result;
  }
  const Combination all = multiplied(rule, multipliers, body, planes);
  for (std::size_t c = 0; c < d; ++c) {
    require(are_equal({all.row[c], all.d, all.e}, {along[c], given.d, e}), rule,
            "the multipliers of " + body.quoted + " do not make the direction");
  }
  result.push_back({all.row[d], all.d, all.e});
  return result;
}

// Do the limits of both sum to less than zero?
bool is_apart(Numbers ends, const Numbers& of_b) {
  ends.insert(ends.end(), of_b.begin(), of_b.end());
  take_steps(16, length(ends), length(ends));
  return sum(ends).n < 0;
}

void check_parted_by(const Numbers& direction, const WeightList& of_a, const WeightList& of_b, const RowBody& a,
                     const RowBody& b) {
  Numbers end = limit(a, of_a, direction, 1);
  require(is_apart(std::move(end), limit(b, of_b, direction, -1)), "parted_by",
          a.quoted + " is not strictly less far along the direction than " + b.quoted);
}

void check_parted_by_hyperplanes(const Numbers& direction, const Points& given_a, const WeightList& by_a,
                                 const Points& given_b, const WeightList& by_b, const RowBody& a, const RowBody& b) {
  const Planes planes_a = planes_around(a, given_a), planes_b = planes_around(b, given_b);
  Numbers of_a = limit(a, by_a, direction, 1, &planes_a);
  require(is_apart(std::move(of_a), limit(b, by_b, direction, -1, &planes_b)), "parted_by_hyperplanes",
          "the half-spaces around " + a.quoted + " and " + b.quoted + " do not contradict");
}

void check_keeps(const WeightList& weights, const Numbers& at, const RowBody& body, const Numbers& point) {
  const std::size_t d = body.dimension;
  Integers place;  // in the frame of the body: x, .., w
  if (body.is_of_points) {
    const Combination mean =
        combined_rows({"keeps", false, "a weight of " + body.quoted + " is negative"}, weights, body);
    require(are_equal(mean.total, {1, 1, 0}), "keeps", "the weights of " + body.quoted + " do not sum to 1");
    Numbers row;
    for (const Integer& n : mean.row) row.push_back({n, mean.d, mean.e});
    place = projective(row);
  } else {
    place = projective(at);
    take_steps(body.given->rows.size(), length(at), body.given->bits);
    require_in_each("keeps", body, place, [&](const std::string& k) {
      return "half-space " + k + " of " + body.quoted + " does not hold its point";
    });
  }
  if (body.is_image()) take_steps(d * d, length(point), body.linear.bits);
  const std::size_t axis = differs(body, place, point);
  require(
      axis == no_index, "keeps",
      "the weighted point of " + body.quoted + " differs from the stated point in coordinate " + std::to_string(axis));
}

std::size_t rank(const std::vector<Integers>& rows) {
  std::size_t wide = 0;
  for (const Integers& row : rows) wide = std::max(wide, rows[0].size() * bits(row));
  take_steps(rows.size(), wide, wide);
  Elimination span(rows.empty() ? 0 : rows[0].size());
  for (const Integers& row : rows) span.take(row);
  return span.rank();
}

Integers normal_of(Integers row) {
  row.pop_back();
  return row;
}

// The sum of the rows of half-spaces by multipliers. Its normal: the numbers but the last one.
Combination combined_half_spaces(const char* rule, const WeightList& multipliers, const RowBody& given) {
  return combined_rows({rule, true, "a multiplier is not positive"}, multipliers, given);
}

std::size_t rank_of_normals(const WeightList& multipliers, const RowBody& given) {
  std::vector<Integers> normals;
  for (const std::size_t k : multipliers.named) normals.push_back(normal_of(given.given->rows[k]));
  return rank(normals);
}

void require_receding(const char* rule, const Numbers& direction, const RowBody& given) {
  const Integers way = common(direction).integers;
  require(!all_zero(way), rule, "there is no direction");
  take_steps(given.given->rows.size(), bits(way), given.given->bits);
  for (std::size_t k = 0; k < given.given->rows.size(); ++k) {
    require(dot(way, given.given->rows[k]) <= 0, rule, "the direction leaves half-space " + std::to_string(k));
  }
}

void require_top(const char* rule, const WeightList& multipliers, const RowBody& given, const Numbers& objective,
                 const Numbers& point) {
  const Combination all = combined_half_spaces(rule, multipliers, given);
  const Common up = common(objective);
  require(!all_zero(up.integers), rule, "there is no objective");
  const Integers place = projective(point);
  const auto require_equal = [&](const Integer& m, const Integer& wanted) {
    require(compare(m, all.e, wanted * all.d, up.e) == 0, rule,
            "the combined rows do not bound the objective at the point");
  };
  for (std::size_t c = 0; c < given.dimension; ++c) require_equal(all.row[c], up.integers[c]);
  require_equal(all.row.back() * place.back(), dot(up.integers, place));
}

void check_contradicted(const WeightList& multipliers, const RowBody& given) {
  const Integers all = combined_half_spaces("contradicted", multipliers, given).row;
  require(all_zero(normal_of(all)) && all.back() < 0, "contradicted", "the combined rows have a common point");
}

void check_spans(const WeightList& multipliers, const RowBody& given, std::size_t dimension, const Points& points) {
  require(points.size() == dimension + 1, "spans", "the number of points is not the dimension plus one");
  std::vector<Integers> places;
  for (const Numbers& point : points) places.push_back(projective(point));
  for (std::size_t i = 0; i < points.size(); ++i) {
    take_steps(given.given->rows.size(), length(points[i]), given.given->bits);
    require_in_each("spans", given, places[i],
                    [](const std::string& k) { return "half-space " + k + " does not hold a point"; });
  }
  require(rank(places) == places.size(), "spans", "the points are in a flat of less dimensions");
  require(all_zero(combined_half_spaces("spans", multipliers, given).row), "spans", "the combined rows are not zero");
  require(rank_of_normals(multipliers, given) + dimension == given.dimension, "spans",
          "the rows leave more dimensions");
}

void check_enclosed(const WeightList& multipliers, const RowBody& given) {
  require(all_zero(normal_of(combined_half_spaces("enclosed", multipliers, given).row)), "enclosed",
          "the combined normals are not zero");
  require(rank_of_normals(multipliers, given) == given.dimension, "enclosed", "the normals do not span all");
}

void check_recedes(const Numbers& direction, const RowBody& given) { require_receding("recedes", direction, given); }

void check_rises(const Numbers& direction, const RowBody& given, const Numbers& objective) {
  require_receding("rises", direction, given);
  require(dot(common(objective).integers, common(direction).integers) > 0, "rises",
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
  const Integers way = way_between(projective(point), projective(as_good));
  require(!all_zero(way), "another", "it is the same point");
  require(dot(common(objective).integers, way) == 0, "another", "it is not as far along the objective");
}

void check_normal_fan(const std::vector<IndexLists>& fans, const RowBody& given, const Points& vertices) {
  const std::size_t d = given.dimension, size = d * given.given->bits / 2;
  for (const IndexLists& fan : fans) take_steps(fan.size() * d * d * d, size, size);
  std::map<Integers, std::size_t> known;
  std::set<Ridge> ridges;
  for (std::size_t v = 0; v < vertices.size(); ++v) {
    const std::string vertex = "vertex " + std::to_string(v);
    take_steps(given.given->rows.size(), length(vertices[v]), given.given->bits);
    const Integers place = projective(vertices[v]);
    const std::vector<bool> is_on = require_in_each("normal_fan", given, place, [&](const std::string& k) {
      return "half-space " + k + " does not hold " + vertex;
    });
    take_steps(16, length(vertices[v]), length(vertices[v]));
    const auto [before, is_new] = known.try_emplace(reduced(place), v);
    if (!is_new) require(false, "normal_fan", vertex + " is vertex " + std::to_string(before->second) + " once more");
    for (Indices cone : fans[v]) {
      for (const std::size_t k : cone) {
        require(is_on[k], "normal_fan", vertex + " is not where half-space " + std::to_string(k) + " ends");
      }
      std::sort(cone.begin(), cone.end());
      Elimination span(d);
      for (const std::size_t k : cone) span.take(normal_of(given.given->rows[k]));
      const int sign = span.sign_of_determinant();
      require(sign != 0, "normal_fan", "the normals of a cone of " + vertex + " are in a hyperplane");
      for (std::size_t i = 0; i < d; ++i) ridges.insert(ridge_of(cone, i, sign < 0));
    }
  }
  for (std::size_t v = 0; v < fans.size(); ++v) {  // each ridge has a cone on either side
    for (Indices cone : fans[v]) {
      std::sort(cone.begin(), cone.end());
      for (std::size_t i = 0; i < d; ++i) {
        require(ridges.contains(ridge_of(cone, i)) && ridges.contains(ridge_of(cone, i, true)), "normal_fan",
                "there is no cone beyond a ridge of one of vertex " + std::to_string(v));
      }
    }
  }
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
