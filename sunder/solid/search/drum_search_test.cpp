#include <sunder/solid/search/drum_search.h>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace sunder::solid {
namespace {

// Of the 16 directions with small whole numbers, all normals that go round once, against the definition: ties, and
// directions exactly opposite to the first normal.
TEST(DrumSearch, FirstPastIsItsDefinition) {
  std::vector<Point3> directions;
  for (const Point3& d : {Point3{1, 0, 5}, Point3{2, 1, -1}, Point3{1, 1, 0}, Point3{1, 2, 3}}) {
    directions.push_back(d);
  }
  for (std::size_t k = 0; k < 12; ++k) directions.push_back({-directions[k].y, directions[k].x, directions[k].z});
  const auto count = static_cast<std::uint32_t>(directions.size());
  int cases = 0;
  for (std::uint32_t chosen = 3; chosen < 1u << count; chosen += 5) {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < count; ++k) {
      if ((chosen >> k & 1) != 0) numbers.push_back(k);
    }
    const auto n = static_cast<std::uint32_t>(numbers.size());
    const auto from_first = [&](std::uint32_t k) { return (k + count - numbers[0]) % count; };
    bool is_all_round = n >= 2;
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t gap = (numbers[(k + 1) % n] + count - numbers[k]) % count;
      is_all_round = is_all_round && gap <= count / 2;
    }
    if (!is_all_round) continue;
    for (std::uint32_t d = 0; d < count; ++d) {
      std::uint32_t expected = 1;
      while (expected < n && from_first(numbers[expected]) < from_first(d)) ++expected;
      int looks = 0;
      const std::uint32_t found = first_past(n, {0, 0, 2}, directions[d], [&](std::uint32_t k) {
        ++looks;
        return directions[numbers[k]];
      });
      ASSERT_EQ(found, expected % n) << chosen << " " << d;
      ASSERT_LE(looks, std::log2(n) + 2);
      ++cases;
    }
  }
  EXPECT_GT(cases, 10000);
}

}  // namespace
}  // namespace sunder::solid
