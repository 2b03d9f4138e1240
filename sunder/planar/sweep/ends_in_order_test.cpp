// The order against a stable sort of all that it depends on.
#include <sunder/base/random.h>
#include <sunder/planar/sweep/ends_in_order.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

namespace sunder::planar {
namespace {

std::vector<std::uint32_t> sorted_ends(const Segments& segments) {
  std::vector<std::uint32_t> ends(2 * std::size_t{segments.size()});
  std::iota(ends.begin(), ends.end(), 0u);
  const auto place = [&](std::uint32_t end) {
    const Segment& s = segments[end / 2];
    const bool is_point = s.a.x == s.b.x && s.a.y == s.b.y, is_last = end % 2 == 1;
    return std::tuple{is_last ? s.b.x : s.a.x, is_last ? s.b.y : s.a.y, is_point ? 1 : is_last ? 0 : 2, end};
  };
  std::sort(ends.begin(), ends.end(), [&](std::uint32_t e, std::uint32_t f) { return place(e) < place(f); });
  return ends;
}

// Around 1000 segments the method changes.
TEST(EndsInOrderTest, AsAStableSort) {
  Random random(141);
  const auto number = [&](int kind) {
    switch (kind) {
      case 0: return random.uniform(-1, 1);
      case 1: return static_cast<double>(random.between(-3, 3));  // long runs of one x, and of one point
      case 2: return random.below(2) ? 0.0 : -0.0;
      case 3: return std::ldexp(random.uniform(-1, 1), static_cast<int>(random.between(-1074, 1024)));
      case 4:
        return 1 + static_cast<double>(random.between(0, 300)) * 0x1p-52;  // they differ in the last bits
      // Far apart, so that only leading bits are sorted by, and many that are equal in these.
      case 5: return random.below(8) == 0 ? random.uniform(-1e9, 1e9) : 1 + random.unit() * 0x1p-40;
      case 6: return static_cast<double>(random.between(-2, 2)) * 5e-324;
      default: return random.uniform(-1, 1) * (random.below(2) ? 1e300 : 1e-300);
    }
  };
  for (int kind = 0; kind < 8; ++kind) {
    for (const int size : {0, 1, 2, 7, 60, 999, 1000, 1001, 3000}) {
      std::vector<Segment> given;
      for (int i = 0; i < size; ++i) {
        Segment s{{number(kind), number(kind)}, {number(kind), number(kind)}};
        if (random.below(8) == 0) s.b = s.a;
        if (random.below(8) == 0) s.b.x = s.a.x;
        if (i > 0 && random.below(8) == 0) s.a = given[random.below(given.size())].b;
        if (i > 0 && random.below(16) == 0) s = given[random.below(given.size())];
        given.push_back(s);
      }
      const Segments segments(given);
      ASSERT_EQ(ends_in_order(segments.all()), sorted_ends(segments)) << kind << " " << size;
    }
  }
}

// At one point: what ends, then points, each for itself, then what begins; the lower number first.
TEST(EndsInOrderTest, AtOnePoint) {
  const Segments segments(std::vector<Segment>{{{1, -0.0}, {2, 2}},
                                               {{1, 0}, {1, -0.0}},
                                               {{0, 5}, {1, 0}},
                                               {{1, 0}, {1, 0}},
                                               {{1, -1}, {1, 0}},
                                               {{1, 0}, {1, 7}}});
  EXPECT_EQ(ends_in_order(segments.all()), (std::vector<std::uint32_t>{4, 8, 5, 9, 2, 3, 6, 7, 0, 10, 11, 1}));
  std::vector<Segment> many;
  for (int k = 0; k < 3000; ++k) {
    const Point2 hub{k % 5 == 0 ? -0.0 : 0.0, 0}, other{k % 3 == 0 ? 1.0 + k : -1.0 - k, 7.0 * k};
    many.push_back(k % 7 == 0 ? Segment{hub, hub} : Segment{hub, other});
  }
  EXPECT_EQ(ends_in_order(Segments(many).all()), sorted_ends(Segments(many)));
  many.push_back({{0, 1}, {5, 5}});  // one at another point of the same abscissa
  EXPECT_EQ(ends_in_order(Segments(many).all()), sorted_ends(Segments(many)));
}

}  // namespace
}  // namespace sunder::planar
