#include <sunder/base/random.h>
#include <sunder/planar/sweep/keyed_order.h>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace sunder::planar {
namespace {

TEST(KeyedOrderTest, KeysAreInTheOrderOfDoubles) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const std::vector<double> rising{-infinity, -1.7e308, -1, -5e-324, 0, 5e-324, 1e-300, 1, std::nextafter(1, 2),
                                   infinity};
  for (std::size_t k = 0; k + 1 < rising.size(); ++k) EXPECT_LT(key_of(rising[k]), key_of(rising[k + 1])) << k;
  EXPECT_EQ(key_of(0.0), key_of(-0.0));
}

// Against the standard sort: few and many, spread, repeated, differing in the last bit only, of any scale.
TEST(KeyedOrderTest, SortsLikeTheStandardSort) {
  Random random(5);
  for (const std::size_t count : {0u, 1u, 2u, 100u, 1999u, 2000u, 30000u}) {
    for (int family = 0; family < 4; ++family) {
      std::vector<KeyedItem> items;
      for (std::uint32_t i = 0; i < count; ++i) {
        double x = random.uniform(-1, 1);
        if (family == 1) x = static_cast<double>(random.between(-9, 9));
        if (family == 2) x = 1 + 0x1p-52 * static_cast<double>(random.below(7));
        if (family == 3) x = std::ldexp(x, static_cast<int>(random.between(-1070, 1020)));
        items.push_back({key_of(x), i});
      }
      std::vector<KeyedItem> truth = items;
      const auto before = [](std::uint32_t i, std::uint32_t j) { return i % 7 != j % 7 ? i % 7 < j % 7 : i < j; };
      std::sort(truth.begin(), truth.end(), [&](const KeyedItem& a, const KeyedItem& b) {
        return a.key != b.key ? a.key < b.key : before(a.item, b.item);
      });
      sort_by_key(items, before);
      for (std::size_t k = 0; k < count; ++k) ASSERT_EQ(items[k].item, truth[k].item) << family << " " << k;
    }
  }
}

}  // namespace
}  // namespace sunder::planar
