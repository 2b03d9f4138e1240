// The vertices of half-spaces of any dimension, of nasty sets of them: against all that some d of them have alone, and
// certificates checked without the library; and each vertex left out in turn, which is refused.
#include <tests/support/half_space_sets.h>
#include <tests/support/scale.h>

#include <sunder/base/error.h>
#include <sunder/base/random.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/region/region_claims.h>
#include <sunder/polytope/region/region_vertices.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder::tests {
namespace {

using nlohmann::json;
using polytope::Polytope;
using polytope::RegionKind;
using polytope::RegionVertices;
using Rational = boost::multiprecision::cpp_rational;
using Row = std::vector<Rational>;  // a1, .., ad, b

// The points in all half-spaces that d of them have alone.
class AllCombinations {
 public:
  explicit AllCombinations(const Polytope& body) : d_(body.dimension()) {
    for (std::uint32_t k = 0; k < body.size(); ++k) rows_.emplace_back(body.row(k).begin(), body.row(k).end());
    extend(0, {});
  }

  const std::set<Row>& points() const { return points_; }

 private:
  // known: reduced rows, each with the column that no other has.
  void extend(std::size_t from, const std::vector<std::pair<std::size_t, Row>>& known) {
    if (known.size() == d_) return take(known);
    for (std::size_t k = from; k < rows_.size(); ++k) {
      Row row = rows_[k];
      for (const auto& [column, other] : known) subtract(row, column, other);
      std::size_t pivot = 0;
      while (pivot < d_ && row[pivot] == 0) ++pivot;
      if (pivot == d_) continue;
      const Rational by = row[pivot];
      for (Rational& x : row) x /= by;
      auto more = known;
      for (auto& [column, other] : more) subtract(other, pivot, row);
      more.emplace_back(pivot, std::move(row));
      extend(k + 1, more);
    }
  }

  static void subtract(Row& row, std::size_t column, const Row& other) {
    const Rational by = row[column];
    if (by == 0) return;
    for (std::size_t c = 0; c < row.size(); ++c) row[c] -= by * other[c];
  }

  void take(const std::vector<std::pair<std::size_t, Row>>& known) {
    Row point(d_);
    for (const auto& [column, row] : known) point[column] = row[d_];
    for (const Row& row : rows_) {
      Rational sum = -row[d_];
      for (std::size_t c = 0; c < d_; ++c) sum += row[c] * point[c];
      if (sum > 0) return;
    }
    points_.insert(std::move(point));
  }

  std::size_t d_;
  std::vector<Row> rows_;
  std::set<Row> points_;
};

std::string written(const Polytope& body, const RegionVertices& answer) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  add_claims(file, "given", body, answer);
  file.end();
  return text;
}

std::string rule_of(const std::string& text) {
  const sunder_verifier::FileResult report = sunder_verifier::verify_text(text, "vertices");
  if (!report.readable) return "unreadable";
  if (report.statements.empty()) return "F";
  return report.accepted() ? "accepted" : report.statements[0].failed_check;
}

// Without vertex k; its cones, if they are kept, at the next one.
std::string without(const std::string& text, std::size_t k, bool keeps_cones) {
  json file = json::parse(text);
  json& statement = file["statements"][0];
  json& fans = statement["claims"][0]["fans"];
  const json cones = fans[k];
  statement["vertices"].erase(k);
  fans.erase(k);
  if (keeps_cones && !fans.empty()) {
    for (const json& cone : cones) fans[k % fans.size()].push_back(cone);
  }
  return file.dump();
}

TEST(RegionVertices, AreThoseOfAllCombinations) {
  HalfSpaceSets sets(chosen_seed(20261201));
  std::map<RegionKind, int> kinds;
  std::map<std::pair<std::size_t, std::size_t>, int> flats;  // by dimensions of space and region
  int degenerate = 0, left_out = 0;
  for (int turn = 0; turn < scaled_count(1200, 60); ++turn) {
    const HalfSpaceSet set = turn % 2 == 0 ? sets.next(8) : sets.next(12);
    const std::size_t d = set.half_spaces.dimension();
    SCOPED_TRACE(std::string(name_of(set.family)) + ", turn " + std::to_string(turn));
    const RegionVertices answer = region_vertices(set.half_spaces);
    ++kinds[answer.region.verdict()];
    if (set.half_spaces.size() == 0) {  // all of space: nothing that a statement could speak of
      EXPECT_EQ(answer.region.verdict(), RegionKind::unbounded);
      EXPECT_THROW(written(set.half_spaces, answer), Error);
      continue;
    }
    const std::string text = written(set.half_spaces, answer);
    ASSERT_EQ(rule_of(text), "accepted") << text;
    if (answer.region.verdict() != RegionKind::bounded) {
      EXPECT_TRUE(answer.found.vertices.empty());
      continue;
    }
    ++flats[{d, extent_of(answer.region)->dimension}];
    const std::size_t count = answer.found.vertices.size();
    ASSERT_GE(count, extent_of(answer.region)->dimension + 1);
    ASSERT_EQ(answer.found.at.size(), count);
    for (const auto& fan : answer.found.fans) degenerate += fan.size() > d;
    if (set.half_spaces.size() <= 14) {
      std::set<Row> points;
      for (const std::vector<Dyadic>& vertex : answer.found.vertices) {
        Row point;
        for (std::size_t c = 0; c < d; ++c) point.emplace_back(fraction_text(vertex[c], vertex[d]));
        points.insert(std::move(point));
      }
      EXPECT_EQ(points.size(), count);
      EXPECT_EQ(points, AllCombinations(set.half_spaces).points());
    }
    for (std::size_t k = 0; k < std::min<std::size_t>(count, 3); ++k) {
      EXPECT_EQ(rule_of(without(text, k, false)), count == 1 ? "F" : "normal_fan");
      EXPECT_EQ(rule_of(without(text, k, true)), count == 1 ? "F" : "normal_fan");
      ++left_out;
    }
  }
  if (scaled_count(100, 1) < 50) return;
  for (const RegionKind kind : {RegionKind::empty, RegionKind::bounded, RegionKind::unbounded}) {
    EXPECT_GT(kinds[kind], scaled_count(60)) << name_of(kind);
  }
  for (std::size_t d = 2; d <= 6; ++d) {
    EXPECT_GT((flats[{d, d}]), scaled_count(5)) << d;
    int less = 0;
    for (std::size_t k = 0; k < d; ++k) less += flats[{d, k}];
    EXPECT_GT(less, 0) << d;
  }
  EXPECT_GT(degenerate, scaled_count(100));
  EXPECT_GT(left_out, scaled_count(400));
}

// Many half-spaces in each vertex: a cube or a cross-polytope somewhere, or the facets of few lattice points; with
// copies that have another scale, and sums of two, which touch; in any order; of some a third is left out, or opposites
// are added.
std::vector<double> degenerate_rows(std::size_t d, Random& random) {
  const auto whole = [&](std::int64_t most) { return static_cast<double>(random.between(-most, most)); };
  std::vector<std::vector<double>> rows;
  const std::uint64_t family = random.below(4);
  if (family < 2) {
    std::vector<double> center;
    for (std::size_t c = 0; c < d; ++c) center.push_back(whole(3));
    const bool is_cube = family == 0 || d > 4;
    for (std::size_t k = 0; k < (is_cube ? 2 * d : std::size_t{1} << d); ++k) {
      std::vector<double> row(d);
      for (std::size_t c = 0; c < d; ++c) row[c] = is_cube ? (k / 2 == c ? 1 : 0) : (k >> c & 1) == 0 ? 1 : -1;
      if (is_cube && k % 2 == 1) row[k / 2] = -1;
      row.push_back(1);
      for (std::size_t c = 0; c < d; ++c) row[d] += row[c] * center[c];
      rows.push_back(row);
    }
  } else {  // sizes that do, and do not, fit in integers of one word
    constexpr std::array<std::int64_t, 7> most_of{0, 0, 30'000, 30'000, 1'000, 100, 30};
    const bool is_long = family == 3;
    std::vector<double> numbers;
    for (std::size_t k = 0; k < d * (is_long && (d == 4 || d == 5) ? 18 : d + 3); ++k) {
      numbers.push_back(whole(is_long ? most_of[d] : 2));
    }
    const Polytope points = Polytope::from_points(d, numbers);
    const polytope::ConvexHull hull = convex_hull(points);
    for (std::size_t f = 0; f < hull.facet_count() && hull.dimension == d; ++f) {
      std::vector<double> row;
      bool is_exact = true;
      for (const Dyadic& x : facet_half_space(hull, points, f)) {
        row.push_back(x.nearest());
        is_exact = is_exact && x == Dyadic(row.back());
      }
      if (is_exact) rows.push_back(row);
    }
  }
  const std::size_t count = rows.size();
  for (std::size_t turn = 0; turn < 3 && count > 0; ++turn) {
    std::vector<double> copy = rows[random.below(count)], sum = rows[random.below(count)];
    const std::vector<double>& other = rows[random.below(count)];
    for (std::size_t c = 0; c <= d; ++c) {
      copy[c] *= turn == 0 ? 1 : 2.5;
      sum[c] += other[c];
    }
    rows.push_back(copy);
    rows.push_back(sum);
  }
  const std::uint64_t change = random.below(6);
  if (change == 0 && count > 0) {
    for (std::size_t turn = 0; turn < 2; ++turn) {
      std::vector<double> opposite = rows[random.below(count)];
      for (double& x : opposite) x = -x;
      if (random.below(4) == 0) opposite[d] -= 1;
      rows.push_back(opposite);
    }
  }
  for (std::size_t k = rows.size(); k > 1; --k) std::swap(rows[k - 1], rows[random.below(k)]);
  if (change == 1) rows.resize(rows.size() - rows.size() / 3);
  std::vector<double> result;
  for (const auto& row : rows) result.insert(result.end(), row.begin(), row.end());
  return result;
}

TEST(RegionVertices, OfDegenerateHalfSpacesAreThoseOfAllCombinations) {
  Random random(chosen_seed(20261202));
  std::map<RegionKind, int> kinds;
  int flat = 0, in_words = 0, in_any = 0;
  for (int turn = 0; turn < scaled_count(120, 8); ++turn) {
    const std::size_t d = 2 + static_cast<std::size_t>(turn % 5);
    SCOPED_TRACE(turn);
    const std::vector<double> rows = degenerate_rows(d, random);
    if (rows.empty()) continue;
    const Polytope body = Polytope::from_half_spaces(d, rows);
    const RegionVertices answer = region_vertices(body);
    ++kinds[answer.region.verdict()];
    ASSERT_EQ(rule_of(written(body, answer)), "accepted");
    if (answer.region.verdict() != RegionKind::bounded) continue;
    flat += extent_of(answer.region)->dimension < d;
    const bool is_degenerate = std::any_of(answer.found.at.begin(), answer.found.at.end(), [&](const auto& at) {
      return at.size() > extent_of(answer.region)->dimension;
    });
    in_words += is_degenerate && answer.found.exact_tests == 0;
    in_any += is_degenerate && answer.found.exact_tests > 0;
    if (body.size() > (d < 4 ? 40u : d == 4 ? 22u : 16u)) continue;
    std::set<Row> points;
    for (const std::vector<Dyadic>& vertex : answer.found.vertices) {
      Row point;
      for (std::size_t c = 0; c < d; ++c) point.emplace_back(fraction_text(vertex[c], vertex[d]));
      points.insert(std::move(point));
    }
    EXPECT_EQ(points.size(), answer.found.vertices.size());
    EXPECT_EQ(points, AllCombinations(body).points());
  }
  if (scaled_count(100, 1) < 50) return;
  EXPECT_GT(kinds[RegionKind::empty], 0);
  EXPECT_GT(kinds[RegionKind::unbounded], scaled_count(3));
  EXPECT_GT(kinds[RegionKind::bounded], scaled_count(50));
  EXPECT_GT(flat, scaled_count(2));
  EXPECT_GT(in_words, scaled_count(20));
  EXPECT_GT(in_any, scaled_count(2));
}

// Of each number of dimensions in space of each: a box in the flat x_c = x_1 + .. + x_k + c, k < c, from both sides.
TEST(RegionVertices, OfBoxesInFlats) {
  for (std::size_t d = 2; d <= 6; ++d) {
    for (std::size_t k = 0; k <= d; ++k) {
      SCOPED_TRACE(std::to_string(k) + " dimensions of " + std::to_string(d));
      std::vector<double> rows;
      for (std::size_t c = 0; c < d; ++c) {
        for (const double side : {1.0, -1.0}) {
          for (std::size_t e = 0; e < d; ++e) rows.push_back(e == c ? side : c >= k && e < k ? -side : 0);
          rows.push_back(c < k ? 1 : side * static_cast<double>(c));
        }
      }
      for (std::size_t c = 0; c < k; ++c) {  // and such that hold all of it with room
        for (const double side : {2.0, -3.0}) {
          for (std::size_t e = 0; e < d; ++e) rows.push_back(e == c ? side : 0);
          rows.push_back(5);
        }
      }
      const Polytope body = Polytope::from_half_spaces(d, rows);
      const RegionVertices answer = region_vertices(body);
      EXPECT_EQ(extent_of(answer.region)->dimension, k);
      EXPECT_EQ(answer.found.vertices.size(), std::size_t{1} << k);
      EXPECT_EQ(answer.found.bounding.size(), 2 * k);
      for (const auto& at : answer.found.at) EXPECT_EQ(at.size(), k);
      for (std::uint32_t row = 0; row < body.size(); ++row) {
        Dyadic left = Dyadic(body.row(row)[d]) * answer.found.inside[d];
        for (std::size_t c = 0; c < d; ++c) left = left - answer.found.inside[c] * body.row(row)[c];
        EXPECT_EQ(left.sign(), row < 2 * k || row >= 2 * d ? Sign::positive : Sign::zero);
      }
      const std::string text = written(body, answer);
      EXPECT_EQ(rule_of(text), "accepted");
      EXPECT_EQ(rule_of(without(text, 0, true)), k == 0 ? "F" : "normal_fan");
    }
  }
}

}  // namespace
}  // namespace sunder::tests
