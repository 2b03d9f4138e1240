#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/polytope/hull/vertices.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

namespace sunder::polytope {
namespace {

Sign side(std::span<const double> row, std::span<const Dyadic> x) {
  const std::size_t d = row.size() - 1;
  Dyadic sum = -(x[d] * row[d]);
  for (std::size_t c = 0; c < d; ++c) sum = sum + x[c] * row[c];
  return sum.sign();
}

std::string refusal(std::size_t d, const std::vector<double>& numbers) {
  try {
    (void)vertices_of(Polytope::from_half_spaces(d, numbers));
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_shape);
    return error.what();
  }
  return "none";
}

TEST(PolytopeVertices, ACubeAndACrossPolytope) {
  for (std::size_t d = 2; d <= 6; ++d) {
    std::vector<double> cube, cross;
    for (std::size_t k = 0; k < 2 * d; ++k) {
      for (std::size_t c = 0; c < d; ++c) cube.push_back(c == k / 2 ? (k % 2 == 0 ? 1 : -1) : 0);
      cube.push_back(0.1);
    }
    cube.insert(cube.end(), {1, 1});  // touches in less than a facet
    cube.insert(cube.end(), d - 2, 0);
    cube.push_back(0.2);
    for (std::size_t k = 0; k < std::size_t{1} << d; ++k) {
      for (std::size_t c = 0; c < d; ++c) cross.push_back((k >> c & 1) == 0 ? 1 : -1);
      cross.push_back(1);
    }
    const PolytopeVertices of_cube = vertices_of(Polytope::from_half_spaces(d, cube));
    EXPECT_EQ(of_cube.vertices.size(), std::size_t{1} << d);
    EXPECT_EQ(of_cube.bounding.size(), 2 * d);
    for (const auto& at : of_cube.at) EXPECT_EQ(at.size(), d);
    const PolytopeVertices of_cross = vertices_of(Polytope::from_half_spaces(d, cross));
    EXPECT_EQ(of_cross.vertices.size(), 2 * d);
    EXPECT_EQ(of_cross.bounding.size(), std::size_t{1} << d);
    for (const auto& at : of_cross.at) EXPECT_EQ(at.size(), std::size_t{1} << (d - 1));
    for (const auto& x : of_cross.vertices) {
      int zeros = 0;
      for (std::size_t c = 0; c < d; ++c) {
        if (x[c].sign() == Sign::zero) {
          ++zeros;
        } else {
          EXPECT_TRUE(x[c] == x[d] || x[c] == -x[d]);
        }
      }
      EXPECT_EQ(zeros, static_cast<int>(d) - 1);
    }
  }
}

// Many half-spaces in each vertex: rays of integers of one word, and fewer signs than a polar of simplices takes (5,804
// and 3,134 of them exact; some 40,000, all exact).
TEST(PolytopeVertices, OfDegenerateHalfSpacesTakeFewSigns) {
  constexpr std::size_t d = 6;
  std::vector<double> cross;
  for (std::size_t k = 0; k < 64; ++k) {
    for (std::size_t c = 0; c < d; ++c) cross.push_back((k >> c & 1) == 0 ? 1 : -1);
    cross.push_back(1);
  }
  const PolytopeVertices of_cross = vertices_of(Polytope::from_half_spaces(d, cross));
  EXPECT_EQ(of_cross.vertices.size(), 12u);
  EXPECT_LT(of_cross.side_tests, 1000u);
  EXPECT_EQ(of_cross.exact_tests, 0u);

  Random random(1);  // not chosen: the counts are of this one
  std::vector<double> numbers, rows;
  for (std::size_t k = 0; k < 14 * d; ++k) numbers.push_back(static_cast<double>(random.between(-3, 3)));
  const Polytope points = Polytope::from_points(d, numbers);
  const ConvexHull hull = convex_hull(points);
  for (std::size_t f = 0; f < hull.facet_count(); ++f) {
    for (const Dyadic& x : facet_half_space(hull, points, f)) rows.push_back(x.nearest());
  }
  const PolytopeVertices found = vertices_of(Polytope::from_half_spaces(d, rows));
  EXPECT_EQ(found.bounding.size(), 134u);
  EXPECT_EQ(found.vertices.size(), 14u);
  EXPECT_LT(found.side_tests, 10'000u);
  EXPECT_EQ(found.exact_tests, 0u);
}

TEST(PolytopeVertices, WhatHasNoVerticesOrNoInsideIsRefused) {
  const std::string unbounded = "the half-spaces are not bounded; give bounded ones";
  EXPECT_EQ(refusal(2, {}), unbounded);
  EXPECT_EQ(refusal(2, {1, 0, 1, 0, 1, 1}), unbounded);
  EXPECT_EQ(refusal(2, {1, 0, 1, -1, 0, 1}), unbounded);                    // a strip
  EXPECT_EQ(refusal(2, {1, 0, 1, -1, 0, 1, 0, 1, 5}), unbounded);           // that ends
  EXPECT_EQ(refusal(2, {1, 0, 1, 1, 0, 2, -1, 0, 1, 0, 1, 5}), unbounded);  // likewise
  EXPECT_EQ(refusal(2, {1, 0, 1, -1, 0, -2}), "the half-spaces have no common point");
  EXPECT_EQ(refusal(2, {0, 0, -1}), "the half-spaces have no common point");
  EXPECT_EQ(refusal(2, {1, 0, 1, -1, 0, -1, 0, 1, 1, 0, -1, 1}),
            "what the half-spaces have in common lies in a hyperplane");
  EXPECT_EQ(refusal(2, {1, 0, 1, -1, 0, 1, 0, 1, 1, 0, -1, 1, 0, 0, 3}), "none");
  EXPECT_EQ(refusal(2, {1, 0, 1, -1, 0, 1, 0, 1, 1, 0, -1, 1, 0, 0, 0}), "none");  // one that is all of space
  const std::vector<double> simplex{-1, 0, 0, 0, 0, -1, 0, 0, 0, 0, -1, 0, 1, 1, 1, 1};
  EXPECT_EQ(refusal(3, simplex), "none");
}

// Points to half-spaces, and back to the same points.
TEST(PolytopeVertices, HalfSpacesOfAHullHaveItsVertices) {
  Random random(sunder::tests::chosen_seed(20261128));
  int turns = 0;
  for (int turn = 0; turn < sunder::tests::scaled_count(60, 10); ++turn) {
    const std::size_t d = 2 + static_cast<std::size_t>(turn % 5);
    std::vector<double> numbers;
    const int count = static_cast<int>(d) + static_cast<int>(random.between(1, d == 6 ? 5 : 10));
    const int size = turn % 2 == 0 ? 1 : 4;
    for (std::size_t k = 0; k < static_cast<std::size_t>(count) * d; ++k) {
      numbers.push_back(static_cast<double>(random.between(-size, size)) * 0.125);
    }
    const Polytope points = Polytope::from_points(d, numbers);
    const ConvexHull hull = convex_hull(points);
    if (hull.dimension < d) continue;
    ++turns;
    std::vector<double> rows;
    for (std::size_t f = 0; f < hull.facet_count(); ++f) {
      for (const Dyadic& x : facet_half_space(hull, points, f)) {
        rows.push_back(x.nearest());
        ASSERT_TRUE(x == Dyadic(rows.back()));
      }
    }
    const Polytope half_spaces = Polytope::from_half_spaces(d, rows);
    const PolytopeVertices found = vertices_of(half_spaces);
    EXPECT_EQ(found.bounding.size(), hull.facet_count());
    ASSERT_EQ(found.vertices.size(), hull.vertices.size());
    for (std::size_t v = 0; v < found.vertices.size(); ++v) {
      const auto& x = found.vertices[v];
      ASSERT_EQ(x[d].sign(), Sign::positive);
      EXPECT_TRUE(std::any_of(hull.vertices.begin(), hull.vertices.end(), [&](std::uint32_t k) {
        for (std::size_t c = 0; c < d; ++c) {
          if (!(x[c] == x[d] * points.row(k)[c])) return false;
        }
        return true;
      }));
      for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
        const bool is_on = std::binary_search(found.at[v].begin(), found.at[v].end(), k);
        EXPECT_EQ(side(half_spaces.row(k), x), is_on ? Sign::zero : Sign::negative);
      }
    }
    for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
      EXPECT_EQ(side(half_spaces.row(k), found.inside), Sign::negative);
    }
  }
  EXPECT_GT(turns, sunder::tests::scaled_count(25));
}

// Doubles as they come: each vertex is where d half-spaces end, inside of all others, and as many as Euler says.
TEST(PolytopeVertices, HalfSpacesThatTouchABall) {
  Random random(sunder::tests::chosen_seed(20261129));
  for (int turn = 0; turn < sunder::tests::scaled_count(25); ++turn) {
    const std::size_t d = 2 + static_cast<std::size_t>(turn % 5);
    const std::size_t count = d == 6 ? 14 : d == 5 ? 18 : 40;
    std::vector<double> rows;
    for (std::size_t k = 0; k < count; ++k) {
      double square = 0;
      for (std::size_t c = 0; c < d; ++c) {
        rows.push_back(random.uniform(-1, 1) + (k < 2 * d && c == k / 2 ? (k % 2 == 0 ? 4 : -4) : 0));
        square += rows.back() * rows.back();
      }
      rows.push_back(std::sqrt(square) + rows[rows.size() - d] * 1e6);  // about (1e6, 0, ..)
    }
    const Polytope half_spaces = Polytope::from_half_spaces(d, rows);
    const PolytopeVertices found = vertices_of(half_spaces);
    EXPECT_EQ(found.bounding.size(), count);
    std::size_t incidences = 0;
    for (std::size_t v = 0; v < found.vertices.size(); ++v) {
      incidences += found.at[v].size();
      for (std::uint32_t k = 0; k < half_spaces.size(); ++k) {
        const bool is_on = std::binary_search(found.at[v].begin(), found.at[v].end(), k);
        EXPECT_EQ(side(half_spaces.row(k), found.vertices[v]), is_on ? Sign::zero : Sign::negative);
      }
    }
    EXPECT_EQ(incidences, d * found.vertices.size());
    if (d == 2) {
      EXPECT_EQ(found.vertices.size(), count);
    }
    if (d == 3) {
      EXPECT_EQ(found.vertices.size(), 2 * count - 4);
    }
  }
}

}  // namespace
}  // namespace sunder::polytope
