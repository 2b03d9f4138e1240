// Hulls of nasty sets of points of two to six dimensions against all hyperplanes through as many of the points, in
// exact numbers; the facets as half-spaces; and their certificates by the verifier.
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/number/integer_internal.h>
#include <sunder/planar/object/convex_polygon.h>
#include <sunder/polytope/hull/convex_hull.h>
#include <sunder/polytope/hull/hull_claims.h>
#include <sunder/polytope/represent/affine_columns.h>
#include <sunder/solid/hull/convex_hull.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::polytope {
namespace {

constexpr std::array families{"few places", "ball", "sphere", "grid",      "cross",
                              "cyclic",     "flat", "line",   "last bits", "scales"};

struct Points {
  std::size_t d = 0;
  std::vector<double> numbers{};
  void add(const std::vector<double>& p) { numbers.insert(numbers.end(), p.begin(), p.end()); }
};

Points some_points(std::size_t family, std::size_t d, Random& random) {
  Points points{d};
  constexpr std::array<int, 7> most{0, 0, 16, 13, 11, 10, 9};
  const auto count = static_cast<int>(random.between(family < 2 ? 1 : static_cast<int>(d), most[d]));
  const auto whole = [&](int size) { return static_cast<double>(random.between(-size, size)); };
  const int scale = static_cast<int>(random.between(-1000, 1000));
  std::vector<double> map(d * d);
  for (double& x : map) x = whole(2);
  const std::size_t rank = 1 + static_cast<std::size_t>(random.between(0, static_cast<int>(d) - 1));
  for (int k = 0; k < count; ++k) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = random.uniform(-1, 1);
      square += x * x;
    }
    for (std::size_t c = 0; c < d; ++c) {
      switch (family) {
        case 0: p[c] = whole(1); break;
        case 2: p[c] /= std::sqrt(square); break;
        case 3: p[c] = 0.1 * whole(2); break;
        case 4: p[c] = static_cast<std::size_t>(k) % d == c ? (k % 2 == 0 ? 0.3 : -0.7) : 0.0; break;
        case 5: p[c] = std::pow(static_cast<double>(k - count / 2), static_cast<double>(c + 1)); break;
        case 7: p[c] = c == 0 ? whole(9) : map[c] * p[0] + 1; break;
        case 8: p[c] = std::nextafter(whole(1), whole(3)); break;
        case 9: p[c] = std::ldexp(c % 2 == 0 ? p[c] : whole(2), c == 1 ? -scale : scale); break;
        default: break;
      }
    }
    if (family == 6) {
      std::vector<double> some(rank), image(d);
      for (double& x : some) x = whole(3);
      for (std::size_t r = 0; r < d; ++r) {
        for (std::size_t c = 0; c < rank; ++c) image[r] += map[r * d + c] * some[c];
      }
      p = image;
    }
    points.add(p);
  }
  return points;
}

using Row = std::vector<Integer>;

Integer determinant(const std::vector<Row>& m) {
  if (m.size() == 1) return m[0][0];
  Integer sum = 0;
  for (std::size_t c = 0; c < m.size(); ++c) {
    if (m[0][c] == 0) continue;
    std::vector<Row> rest(m.begin() + 1, m.end());
    for (Row& row : rest) row.erase(row.begin() + static_cast<std::ptrdiff_t>(c));
    const Integer term = m[0][c] * determinant(rest);
    c % 2 == 0 ? sum += term : sum -= term;
  }
  return sum;
}

// Of points that span their space, as integers.
class Oracle {
 public:
  explicit Oracle(std::vector<Row> points) : points_(std::move(points)), k_(points_[0].size()) {
    std::vector<std::uint32_t> some;
    choose(some, 0);
  }

  std::set<std::vector<std::uint32_t>> planes;  // of each the points on it

  // Those that are alone in what the planes with them have in common; of equal ones the first.
  std::vector<std::uint32_t> vertices() const {
    std::vector<std::uint32_t> result;
    for (std::uint32_t v = 0; v < points_.size(); ++v) {
      std::vector<std::uint32_t> common(points_.size());
      for (std::uint32_t w = 0; w < points_.size(); ++w) common[w] = w;
      for (const auto& plane : planes) {
        if (!std::binary_search(plane.begin(), plane.end(), v)) continue;
        std::erase_if(common, [&](std::uint32_t w) { return !std::binary_search(plane.begin(), plane.end(), w); });
      }
      if (std::all_of(common.begin(), common.end(), [&](std::uint32_t w) { return points_[w] == points_[v]; }) &&
          common.front() == v) {
        result.push_back(v);
      }
    }
    return result;
  }

 private:
  void choose(std::vector<std::uint32_t>& some, std::uint32_t from) {
    if (some.size() == k_) return look(some);
    for (std::uint32_t k = from; k < points_.size(); ++k) {
      some.push_back(k);
      choose(some, k + 1);
      some.pop_back();
    }
  }

  void look(const std::vector<std::uint32_t>& some) {
    Row normal(k_);
    bool is_zero = true;
    for (std::size_t c = 0; c < k_; ++c) {
      std::vector<Row> edges;
      for (std::size_t i = 1; i < k_; ++i) {
        edges.emplace_back();
        for (std::size_t r = 0; r < k_; ++r) {
          if (r != c) edges.back().push_back(points_[some[i]][r] - points_[some[0]][r]);
        }
      }
      normal[c] = edges.empty() ? Integer(1) : determinant(edges);
      if (c % 2 == 1) normal[c] = -normal[c];
      is_zero = is_zero && normal[c] == 0;
    }
    if (is_zero) return;
    std::vector<std::uint32_t> on;
    bool above = false, below = false;
    for (std::uint32_t q = 0; q < points_.size(); ++q) {
      Integer sum = 0;
      for (std::size_t c = 0; c < k_; ++c) sum += normal[c] * (points_[q][c] - points_[some[0]][c]);
      if (sum == 0) on.push_back(q);
      above = above || sum > 0;
      below = below || sum < 0;
    }
    if (!above || !below) planes.insert(on);
  }

  std::vector<Row> points_;
  std::size_t k_;
};

std::vector<Row> integers_of(const Polytope& points, const std::vector<std::size_t>& columns) {
  std::int64_t unit = 0;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    for (const double x : points.row(k)) unit = std::min(unit, Dyadic(x).exponent());
  }
  std::vector<Row> result;
  for (std::uint32_t k = 0; k < points.size(); ++k) {
    result.emplace_back();
    for (const std::size_t c : columns) {
      const Dyadic x = points.row(k)[c];
      result.back().push_back(mantissa_of(x) << static_cast<unsigned>(x.exponent() - unit));
    }
  }
  return result;
}

std::string proof_of(const Polytope& points, const ConvexHull& hull) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  write_hull(file, "points", points, hull);
  file.end();
  return text;
}

Sign side(const std::vector<Dyadic>& row, std::span<const double> p) {
  Dyadic sum = -row.back();
  for (std::size_t c = 0; c < p.size(); ++c) sum = sum + row[c] * p[c];
  return sum.sign();
}

void expect_same(const Polytope& points, const ConvexHull& hull) {
  const AffineColumns flat = affine_columns(points.dimension(), points.size(),
                                            [&](std::size_t k) { return points.row(static_cast<std::uint32_t>(k)); });
  ASSERT_EQ(hull.dimension, flat.columns.size());
  const auto equations = flat_equations(hull, points);
  ASSERT_EQ(equations.size(), hull.space - hull.dimension);
  for (const auto& row : equations) {
    for (std::uint32_t k = 0; k < points.size(); ++k) EXPECT_EQ(side(row, points.row(k)), Sign::zero);
  }
  if (hull.dimension == 0) {
    EXPECT_EQ(hull.vertices, std::vector<std::uint32_t>{0});
    return;
  }
  const Oracle oracle(integers_of(points, hull.columns));
  const std::vector<std::uint32_t> vertices = oracle.vertices();
  EXPECT_EQ(hull.vertices, vertices);
  ASSERT_EQ(hull.facet_count(), oracle.planes.size());
  std::vector<std::uint32_t> last;
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    const auto here = hull.facet_vertices(f);
    const std::vector<std::uint32_t> corners(here.begin(), here.end());
    EXPECT_LT(last, corners);
    last = corners;
    const std::vector<Dyadic> row = facet_half_space(hull, points, f);
    std::vector<std::uint32_t> on;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const Sign sign = side(row, points.row(k));
      EXPECT_NE(sign, Sign::positive);
      if (sign == Sign::zero) on.push_back(k);
    }
    EXPECT_TRUE(oracle.planes.contains(on));
    std::erase_if(on, [&](std::uint32_t k) { return !std::binary_search(vertices.begin(), vertices.end(), k); });
    EXPECT_EQ(on, corners);
  }
}

TEST(PolytopeHullDifferential, EachHullIsThatOfAllPlanesAndIsProved) {
  const int count = sunder::tests::scaled_count(1200);
  const std::uint64_t seed = sunder::tests::chosen_seed(20261127);
  SCOPED_TRACE("seed " + std::to_string(seed));
  Random random(seed);
  std::map<std::pair<std::size_t, std::size_t>, int> total;  // by space and dimension
  int with_merged = 0, with_others = 0;
  for (int k = 0; k < count; ++k) {
    const std::size_t family = static_cast<std::size_t>(k) % families.size();
    const std::size_t d = least_dimension + static_cast<std::size_t>(k) / families.size() % 5;
    Points some = some_points(family, d, random);
    const Polytope points = Polytope::from_points(d, std::move(some.numbers));
    const ConvexHull hull = convex_hull(points);
    SCOPED_TRACE(std::string(families[family]) + ", case " + std::to_string(k));
    expect_same(points, hull);
    if (HasFatalFailure() || HasNonfatalFailure()) return;
    const std::string text = proof_of(points, hull);
    const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::by_size);
    ASSERT_EQ(result.statements.size(), 1u) << result.failed_form << result.error << text;
    ASSERT_TRUE(result.accepted()) << result.statements[0].reason << "\n" << text;
    ++total[{d, hull.dimension}];
    with_merged += hull.simplex_count() > hull.facet_count() ? 1 : 0;
    with_others += hull.vertices.size() < points.size() ? 1 : 0;
  }
  std::printf("%d with facets of several simplices, %d with points that are no vertices\n", with_merged, with_others);
  if (count < 1000) return;
  for (std::size_t d = least_dimension; d <= most_dimension; ++d) {
    for (std::size_t dimension = 0; dimension <= d; ++dimension) {
      EXPECT_GT((total[{d, dimension}]), 0) << d << " " << dimension;
    }
  }
  EXPECT_GT(with_merged, count / 50);
  EXPECT_GT(with_others, count / 10);
}

std::vector<double> many_points(std::size_t d, int family, int count, Random& random) {
  std::vector<double> numbers;
  for (int k = 0; k < count; ++k) {
    double square = 0;
    for (std::size_t c = 0; c < d; ++c) {
      const double x = random.uniform(-1, 1);
      square += x * x;
      numbers.push_back(family == 0   ? x
                        : family == 1 ? static_cast<double>(random.between(-4, 4)) * 0.3
                                      : x * 0x1p-40 + (c == 0));
    }
    if (family != 3) continue;
    for (std::size_t c = numbers.size() - d; c < numbers.size(); ++c)
      numbers[c] = numbers[c] / std::sqrt(square) - (c % d == 0);
  }
  return numbers;
}

// The hulls of the plane and of space are made by other code.
TEST(PolytopeHullDifferential, InThePlaneAndInSpaceHullsAreThoseOfTheOtherLayers) {
  Random random(sunder::tests::chosen_seed(20261130));
  for (int turn = 0; turn < sunder::tests::scaled_count(200); ++turn) {
    const int count = static_cast<int>(random.between(1, 400)), family = turn / 2 % 4;
    const std::size_t d = turn % 2 == 0 ? 2 : 3;
    SCOPED_TRACE(turn);
    const Polytope points = Polytope::from_points(d, many_points(d, family, count, random));
    const ConvexHull hull = convex_hull(points);
    if (d == 2) {
      std::vector<Point2> planar;
      for (std::uint32_t k = 0; k < points.size(); ++k) planar.push_back({points.row(k)[0], points.row(k)[1]});
      const auto polygon = planar::ConvexPolygon::hull_of(planar);
      std::set<std::pair<double, double>> ours, theirs;
      for (const std::uint32_t v : hull.vertices) ours.insert({planar[v].x, planar[v].y});
      for (std::uint32_t v = 0; v < polygon.size(); ++v)
        theirs.insert({polygon.vertices()[v].x, polygon.vertices()[v].y});
      EXPECT_EQ(ours, theirs);
      EXPECT_EQ(hull.vertices.size(), polygon.size());
      continue;
    }
    std::vector<Point3> solid;
    for (std::uint32_t k = 0; k < points.size(); ++k) {
      const auto p = points.row(k);
      solid.push_back({p[0], p[1], p[2]});
    }
    const solid::ConvexHull other = solid::convex_hull(solid);
    EXPECT_EQ(static_cast<int>(hull.dimension), other.dimension);
    EXPECT_EQ(hull.vertices, other.vertices);
    if (other.dimension < 3) continue;
    std::set<std::vector<std::uint32_t>> ours, theirs;
    for (std::size_t f = 0; f < hull.facet_count(); ++f) {
      const auto here = hull.facet_vertices(f);
      ours.insert({here.begin(), here.end()});
    }
    for (std::size_t f = 0; f + 1 < other.facet_begin.size(); ++f) {
      std::vector<std::uint32_t> face;
      for (std::uint32_t at = other.facet_begin[f]; at < other.facet_begin[f + 1]; ++at) {
        face.push_back(other.vertices[other.facet_vertices[at]]);
      }
      std::sort(face.begin(), face.end());
      theirs.insert(face);
    }
    EXPECT_EQ(ours, theirs);
  }
}

}  // namespace
}  // namespace sunder::polytope
