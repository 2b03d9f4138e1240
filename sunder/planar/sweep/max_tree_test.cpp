#include <sunder/base/random.h>
#include <sunder/planar/sweep/max_tree.h>

#include <gtest/gtest.h>

#include <vector>

namespace sunder::planar {
namespace {

// Against a walk along the values.
TEST(MaxTreeTest, TheNextValueThatIsNotBelow) {
  Random random(4);
  EXPECT_EQ(MaxTree(0).next(0, 0), MaxTree::none);
  for (const std::uint32_t count : {1u, 7u, 8u, 9u, 64u, 65u, 511u, 513u, 5000u}) {
    MaxTree tree(count);
    std::vector<double> truth(count, MaxTree::nothing);
    int found = 0;
    for (int turn = 0; turn < 3000; ++turn) {
      const std::uint32_t k = static_cast<std::uint32_t>(random.below(count));
      const bool takes_away = random.below(3) == 0 || turn / 1000 == 1;
      truth[k] = takes_away ? MaxTree::nothing : static_cast<double>(random.between(-50, 50));
      tree.set(k, truth[k]);
      const double bound = static_cast<double>(random.between(-60, 60));
      const std::uint32_t from = static_cast<std::uint32_t>(random.below(count + 2));
      std::uint32_t next = from;
      while (next < count && truth[next] < bound) ++next;
      ASSERT_EQ(tree.next(from, bound), next < count ? next : MaxTree::none) << count << " " << from << " " << bound;
      found += next < count;
    }
    EXPECT_GT(found, 100) << count;
  }
}

#ifdef SUNDER_CONTRACTS
TEST(MaxTreeTest, NothingIsNoBound) {
  EXPECT_DEATH(MaxTree(8).next(0, MaxTree::nothing), "max_tree.h:[0-9]+: requires bound > nothing");
}
#endif

}  // namespace
}  // namespace sunder::planar
