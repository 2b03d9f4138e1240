#include <sunder/base/random.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

namespace sunder::polytope {
namespace {

using ExactDirection = std::vector<Dyadic>;

std::vector<double> numbers_on_sphere(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> rows;
  while (rows.size() < d * count) {
    std::vector<double> p(d);
    double square = 0;
    for (double& x : p) {
      x = random.uniform(-1, 1);
      square += x * x;
    }
    if (square > 1 || square < 0.01) continue;
    for (const double x : p) rows.push_back(x / std::sqrt(square));
  }
  return rows;
}

// Small integers in a cube: many rows on its facets, many repeated.
std::vector<double> numbers_of_grid(Random& random, std::size_t d, std::size_t count) {
  std::vector<double> rows;
  for (std::size_t k = 0; k < d * count; ++k) rows.push_back(static_cast<double>(random.between(-2, 2)));
  return rows;
}

Dyadic product(const Polytope& body, std::uint32_t k, const ExactDirection& direction) {
  Dyadic sum;
  for (std::size_t c = 0; c < direction.size(); ++c) sum = sum + Dyadic(body.row(k)[c]) * direction[c];
  return sum;
}

// Down to the leaves, each walk ends where a scan does; before that, at a row that is no further.
void expect_right(const HierarchicalTree& tree, Random& random, int count, bool small_integers) {
  TreeWalk walk(tree);
  const Polytope& body = tree.body();
  const std::size_t d = body.columns().dimension;
  for (int i = 0; i < count; ++i) {
    ExactDirection direction;
    for (std::size_t c = 0; c < d; ++c) {
      direction.emplace_back(small_integers ? static_cast<double>(random.between(-2, 2)) : random.uniform(-1, 1));
    }
    std::uint32_t looks = 0;
    Cost cost;
    const Dyadic expected = exactly_furthest_along(body.columns(), direction, looks).product;
    ExactFurthest found = walk.furthest(direction, cost);
    ASSERT_NE((found.product - expected).sign(), Sign::positive);
    if (i == 0) {
      while (walk.deepen()) continue;
    }
    found = walk.furthest(direction, cost);
    ASSERT_EQ((found.product - expected).sign(), Sign::zero) << i;
    ASSERT_EQ((product(body, found.index, direction) - expected).sign(), Sign::zero) << i;
    ASSERT_LE(walk.path().size(), tree.depth());
  }
}

// Walks in floating point: where they say that they found the end, no product is greater by more than its error. Of a
// body each of whose points has others beside it, along directions near walls between cones, where single precision
// takes the wrong one.
TEST(HierarchicalTree, WalksInFloatingPointKnowWhereTheyMayBeWrong) {
  Random random(6203);
  int sure = 0, asked = 0, wrong = 0;
  for (const std::size_t d : {2u, 3u, 4u}) {
    std::vector<double> rows;
    for (const double x : numbers_on_sphere(random, d, 150)) rows.push_back(x);
    const std::size_t size = rows.size();
    for (int k = 0; k < 3; ++k) {
      for (std::size_t i = 0; i < size; ++i) rows.push_back(rows[i] + random.uniform(-1e-5, 1e-5));
    }
    const HierarchicalTree tree(Polytope::from_points(d, std::move(rows)), {.leaf = d < 4 ? 8u : 48u});
    TreeWalk walk(tree);
    for (std::uint32_t cone = 0; cone < tree.cone_count();
         cone += 1 + static_cast<std::uint32_t>(tree.cone_count() / 4000)) {
      for (const double near : {1e-3, 1e-7, 1e-9}) {
        ColumnNumbers direction{};
        for (std::size_t c = 0; c < d; ++c) {
          for (std::size_t k = 1; k < d; ++k) direction[c] += tree.ray(cone, k)[c];  // on a wall
        }
        for (std::size_t c = 0; c < d; ++c) direction[c] += near * std::fabs(direction[c]) * random.uniform(-1, 1);
        Cost cost;
        std::uint32_t looks = 0;
        const ExactDirection exact(direction.begin(), direction.begin() + static_cast<std::ptrdiff_t>(d));
        const FurthestPoint found = walk.likely_furthest(direction, TreeWalk::Reach::leaf, cost);
        const Dyadic expected = exactly_furthest_along(tree.body().columns(), exact, looks).product;
        const bool is_end = (expected - product(tree.body(), found.index, exact)).sign() == Sign::zero;
        ++asked;
        if (walk.was_to_the_end(direction, cost)) {
          ++sure;
          ColumnNumbers sizes{};
          for (std::size_t c = 0; c < d; ++c) sizes[c] = std::fabs(direction[c]);
          const double error = product_error(tree.body().columns(), sizes, 1);
          ASSERT_LE((expected - Dyadic(found.product)).nearest(), error) << d << " " << cone;
        }
        wrong += !is_end;
      }
    }
  }
  std::printf("%d directions near walls: %d sure, %d ended elsewhere\n", asked, sure, wrong);
  EXPECT_GT(sure, asked / 4);
  EXPECT_GT(wrong, 10);
}

TEST(HierarchicalTree, WalksEndWhereScansDo) {
  Random random(1);
  for (std::size_t d = 2; d <= 6; ++d) {
    const std::size_t count = d < 4 ? 1000 : d == 4 ? 300 : 60;
    const HierarchicalTree tree(Polytope::from_points(d, numbers_on_sphere(random, d, count)));
    SCOPED_TRACE(d);
    EXPECT_GE(tree.depth(), d < 4 ? 2u : d < 6 ? 1u : 0u);
    const auto count_of_directions = tests::scaled_count(200, 40);
    expect_right(tree, random, count_of_directions, false);
    expect_right(tree, random, count_of_directions, true);
    std::printf(
        "d %zu: %zu rows, depth %u, %zu nodes, %zu cones, %zu rows of nodes, largest leaf %u, %zu unverified, %zu "
        "samples, %zu KiB, estimated %zu KiB\n",
        d, count, tree.depth(), tree.node_count(), tree.cone_count(), tree.row_count(), tree.largest_leaf(),
        tree.unverified(), tree.samples(), tree.memory() >> 10, tree.estimate() >> 10);
  }
}

TEST(HierarchicalTree, GridsAndRepeatedRows) {
  Random random(2);
  for (std::size_t d = 2; d <= 5; ++d) {
    const std::uint32_t net = static_cast<std::uint32_t>(d) + 4;
    const HierarchicalTree tree(Polytope::from_points(d, numbers_of_grid(random, d, d < 4 ? 200 : 60)),
                                {.net = net, .leaf = 12, .levels = d < 4 ? 2u : 1u});
    EXPECT_GE(tree.depth(), 1u);
    SCOPED_TRACE(d);
    expect_right(tree, random, 200, true);
    expect_right(tree, random, 100, false);
  }
}

// Half-spaces with b = 1, and bodies in tilted flats: a tree of the flat.
TEST(HierarchicalTree, FlatSetsAreOfTheirOwnDimension) {
  Random random(3);
  std::vector<double> half_spaces, tilted, on_line;
  const std::vector<double> circle = numbers_on_sphere(random, 2, 500);
  for (std::size_t k = 0; k < circle.size(); k += 2) {
    const double x = circle[k], y = circle[k + 1];
    half_spaces.insert(half_spaces.end(), {x, y, 1});
    const double u = std::ldexp(std::nearbyint(std::ldexp(x, 30)), -30),
                 v = std::ldexp(std::nearbyint(std::ldexp(y, 30)), -30);
    tilted.insert(tilted.end(), {u, u + 2 * v + 1, v, -u - v});  // exact
    on_line.insert(on_line.end(), {u, 2 * u, 1 - u});
  }
  const HierarchicalTree of_half_spaces(Polytope::from_half_spaces(2, half_spaces));
  const HierarchicalTree of_tilted(Polytope::from_points(4, tilted));
  const HierarchicalTree of_line(Polytope::from_points(3, on_line)), of_point(Polytope::from_points(2, {1, 2, 1, 2}));
  EXPECT_EQ(of_half_spaces.dimension(), 2u);
  EXPECT_EQ(of_tilted.dimension(), 2u);
  EXPECT_EQ(of_line.dimension(), 1u);
  EXPECT_EQ(of_point.dimension(), 0u);
  for (const HierarchicalTree* tree : {&of_half_spaces, &of_tilted, &of_line, &of_point}) {
    expect_right(*tree, random, 100, true);
    expect_right(*tree, random, 100, false);
    EXPECT_EQ(tree->unverified(), 0u);
    EXPECT_LE(tree->largest_leaf(), 8u);
  }
  EXPECT_GE(of_half_spaces.depth(), 2u);
  EXPECT_GE(of_tilted.depth(), 2u);
}

TEST(HierarchicalTree, IsRefusedWhereItIsTooLarge) {
  Random random(4);
  const Polytope body = Polytope::from_points(4, numbers_on_sphere(random, 4, 400));
  const auto message = [&](std::size_t most_bytes) {
    try {
      const HierarchicalTree tree(body, {.most_bytes = most_bytes});
      EXPECT_LE(tree.memory(), most_bytes);
      return std::string();
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_shape);
      return std::string(error.what());
    }
  };
  EXPECT_EQ(message(std::size_t{1} << 30), "");
  EXPECT_EQ(message(1 << 16),
            "the tree of 400 rows of dimension 4 takes about 1 MiB, more than the 1 MiB that it may; "
            "give fewer rows, or use another method");
}

// Points of {-2, .., 2}^5: nets of few of them have fans of many cones, none of which is verified; so sample follows
// sample. An answer or a refusal: looks end it.
TEST(HierarchicalTree, LatticesAreRefusedAfterSoManyLooks) {
  Random random(1);
  std::vector<double> numbers;
  for (int k = 0; k < 250 * 5; ++k) numbers.push_back(static_cast<double>(random.between(-2, 2)));
  const Polytope body = Polytope::from_points(5, numbers);
  try {
    const HierarchicalTree tree(body, {.most_looks = 2'000'000});
    FAIL() << tree.looks();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::bad_shape);
    EXPECT_STREQ(error.what(),
                 "the tree of 250 rows of dimension 5 takes more than the 2000000 looks at its cones and rows that it "
                 "may; give fewer rows, or use another method");
  }
  // What is refused by default is far above what other bodies take.
  Random of_ball(2);
  const HierarchicalTree tree(Polytope::from_points(4, numbers_on_sphere(of_ball, 4, 400)));
  EXPECT_GT(tree.looks(), tree.node_count());
  EXPECT_LT(tree.looks(), TreeOptions().most_looks / 20);
}

}  // namespace
}  // namespace sunder::polytope
