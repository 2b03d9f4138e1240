#include <sunder/polytope/region/half_space_region.h>

#include <tests/support/half_space_sets.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <array>
#include <cstddef>
#include <variant>
#include <vector>

namespace sunder::polytope {
namespace {

TEST(HalfSpaceRegion, OfNone) {
  const Polytope all = Polytope::from_half_spaces(3, {});
  const HalfSpaceRegion region = half_space_region(all);
  EXPECT_EQ(region.verdict(), RegionKind::unbounded);
  EXPECT_EQ(extent_of(region)->dimension, 3u);
  EXPECT_TRUE(check(all, region));
  EXPECT_FALSE(extent_of(region)->ranges[0].least || extent_of(region)->ranges[2].greatest);
}

TEST(HalfSpaceRegion, ATriangleInSpace) {
  const Polytope body = Polytope::from_half_spaces(
      3, {1, 0, 0, 1, 0, 1, 0, 1, 0, 0, 1, 1, 1, 1, 1, 2, -1, -1, -1, -2});  // x + y + z = 2, each at most 1
  HalfSpaceRegion region = half_space_region(body);
  ASSERT_EQ(region.verdict(), RegionKind::bounded);
  BoundedRegion& bounded = std::get<BoundedRegion>(region.evidence);
  EXPECT_EQ(bounded.dimension, 2u);
  EXPECT_TRUE(check(body, region));
  for (std::size_t c = 0; c < 3; ++c) {
    EXPECT_EQ(bounded.ranges[c].least, 0.0);
    EXPECT_EQ(bounded.ranges[c].greatest, 1.0);
  }
  bounded.dimension = 3;
  EXPECT_FALSE(check(body, region));
  bounded.dimension = 2;
  bounded.points[2] = bounded.points[1];
  EXPECT_FALSE(check(body, region));
}

TEST(HalfSpaceRegion, APoint) {
  const Polytope body = Polytope::from_half_spaces(2, {1, 0, 0.1, 0, 1, 0.1, -1, -1, -0.2});
  const HalfSpaceRegion region = half_space_region(body);
  EXPECT_EQ(extent_of(region)->dimension, 0u);
  EXPECT_EQ(region.verdict(), RegionKind::bounded);
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
    ++kinds[static_cast<std::size_t>(region.verdict())];
    auto* const empty = std::get_if<EmptyRegion>(&region.evidence);
    auto* const bounded = std::get_if<BoundedRegion>(&region.evidence);
    auto* const far = std::get_if<UnboundedRegion>(&region.evidence);
    RegionExtent* const extent = bounded != nullptr ? static_cast<RegionExtent*>(bounded) : far;
    flat += extent != nullptr && extent->dimension < set.half_spaces.dimension() ? 1 : 0;
    for (Weights* const weights : {extent != nullptr ? &extent->flat : &empty->contradiction,
                                   bounded != nullptr ? &bounded->enclosing : nullptr}) {
      if (weights == nullptr || weights->parts.empty()) continue;
      const Weights::Part last = weights->parts.back();
      weights->parts.pop_back();
      EXPECT_FALSE(check(set.half_spaces, region));
      weights->parts.push_back(last);
    }
    ASSERT_TRUE(check(set.half_spaces, region));
    if (extent == nullptr) continue;
    extent->points.pop_back();
    EXPECT_FALSE(check(set.half_spaces, region));
  }
  for (const int n : kinds) EXPECT_GT(n, count / 50);
  EXPECT_GT(flat, count / 50);
}

}  // namespace
}  // namespace sunder::polytope
