#include <sunder/polytope/region/half_space_region.h>

#include <tests/support/half_space_sets.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <vector>

namespace sunder::polytope {
namespace {

TEST(HalfSpaceRegion, OfNone) {
  const Polytope all = Polytope::from_half_spaces(3, {});
  const HalfSpaceRegion region = half_space_region(all);
  EXPECT_EQ(region.kind, RegionKind::unbounded);
  EXPECT_EQ(region.dimension, 3u);
  EXPECT_TRUE(check(all, region));
  EXPECT_FALSE(region.extents[0].least || region.extents[2].greatest);
}

TEST(HalfSpaceRegion, ATriangleInSpace) {
  const Polytope body = Polytope::from_half_spaces(
      3, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 2, -1, -1, -1, -2});  // x + y + z = 2, each at most 1
  HalfSpaceRegion region = half_space_region(body);
  EXPECT_EQ(region.kind, RegionKind::bounded);
  EXPECT_EQ(region.dimension, 2u);
  EXPECT_TRUE(check(body, region));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(region.extents[c].least, 0.0);
    EXPECT_EQ(region.extents[c].greatest, 1.0);
  }
  region.dimension = 3;
  EXPECT_FALSE(check(body, region));
  region.dimension = 2;
  region.points[2] = region.points[1];
  EXPECT_FALSE(check(body, region));
}

TEST(HalfSpaceRegion, APoint) {
  const Polytope body = Polytope::from_half_spaces(2, {1, 0, 0.1, 0, 1, 0.1, -1, -1, -0.2});
  const HalfSpaceRegion region = half_space_region(body);
  EXPECT_EQ(region.dimension, 0u);
  EXPECT_EQ(region.kind, RegionKind::bounded);
  EXPECT_TRUE(check(body, region));
}

// R1, on all families; each of them, spoilt, is refused.
TEST(HalfSpaceRegion, EachAnswerIsProved) {
  tests::HalfSpaceSets sets(tests::chosen_seed(21004));
  std::array<int, 3> kinds{};
  int flat = 0;
  const int count = tests::scaled_count(1000, 200);
  for (int k = 0; k < count; ++k) {
    const tests::HalfSpaceSet set = sets.next();
    HalfSpaceRegion region = half_space_region(set.half_spaces);
    ASSERT_TRUE(check(set.half_spaces, region)) << tests::name_of(set.family) << ", " << k;
    ++kinds[static_cast<std::size_t>(region.kind)];
    flat += !region.empty() && region.dimension < set.half_spaces.dimension() ? 1 : 0;
    for (Weights* const weights : {&region.flat, &region.enclosing, &region.contradiction}) {
      if (weights->parts.empty()) continue;
      const Weights::Part last = weights->parts.back();
      weights->parts.pop_back();
      EXPECT_FALSE(check(set.half_spaces, region));
      weights->parts.push_back(last);
    }
    ASSERT_TRUE(check(set.half_spaces, region));
    if (region.empty()) continue;
    region.points.pop_back();
    EXPECT_FALSE(check(set.half_spaces, region));
  }
  for (const int n : kinds) EXPECT_GT(n, count / 50);
  EXPECT_GT(flat, count / 50);
}

}  // namespace
}  // namespace sunder::polytope
