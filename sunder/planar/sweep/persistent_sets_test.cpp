#include <sunder/base/random.h>
#include <sunder/planar/sweep/persistent_sets.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <vector>

namespace sunder::planar {
namespace {

// As plain sets do, where many are alive at once and each came of another one.
TEST(PersistentSets, AsPlainSets) {
  Random random(20261127);
  for (const std::uint64_t range : {1ull, 2ull, 9ull, 100ull, 0x80000000ull}) {
    PersistentSets sets;
    std::vector<PersistentSets::Set> alive{PersistentSets::empty};
    std::vector<std::set<std::uint32_t>> plain(1);
    for (int step = 0; step < 3000; ++step) {
      const std::size_t from = random.below(alive.size());
      std::uint32_t member = static_cast<std::uint32_t>(random.below(range));
      if (random.below(2) == 0 && !plain[from].empty()) member = *plain[from].begin();
      EXPECT_EQ(sets.holds(alive[from], member), plain[from].contains(member));
      const PersistentSets::Set next =
          random.below(8) == 0 ? sets.again(alive[from]) : sets.toggled(alive[from], member);
      std::set<std::uint32_t> expected = plain[from];
      if (next != alive[from] && expected.erase(member) == 0) expected.insert(member);
      alive.push_back(next);
      plain.push_back(expected);
      std::vector<std::uint32_t> members;
      sets.for_each(next, [&](std::uint32_t m) { members.push_back(m); });
      ASSERT_TRUE(std::equal(members.begin(), members.end(), expected.begin(), expected.end()));
      const std::uint32_t first = static_cast<std::uint32_t>(random.below(range));
      const std::uint32_t last = first + static_cast<std::uint32_t>(random.below(range - first));
      std::erase_if(members, [&](std::uint32_t m) { return first <= m && m <= last; });
      std::vector<std::uint32_t> others;
      sets.for_each_without(next, first, last, [&](std::uint32_t m) { others.push_back(m); });
      ASSERT_EQ(others, members);
      if (alive.size() > 50) {
        const std::size_t out = 1 + random.below(alive.size() - 1);
        sets.release(alive[out]);
        alive.erase(alive.begin() + static_cast<std::ptrdiff_t>(out));
        plain.erase(plain.begin() + static_cast<std::ptrdiff_t>(out));
      }
    }
    EXPECT_GT(sets.size_in_nodes(), 0u);
    for (const PersistentSets::Set set : alive) sets.release(set);
    EXPECT_EQ(sets.size_in_nodes(), 0u);
  }
}

}  // namespace
}  // namespace sunder::planar
