// Which cells a segment is in, and which cell looks at a pair.
#include <sunder/base/random.h>
#include <sunder/near/near_pairs.h>
#include <sunder/planar/segments/segment_boxes.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace sunder::planar {
namespace {

using tests::largest, tests::least;

struct Box {
  double left, right, bottom, top;
  explicit Box(const Segment& s)
      : left(s.a.x < s.b.x ? s.a.x : s.b.x),
        right(s.a.x < s.b.x ? s.b.x : s.a.x),
        bottom(s.a.y < s.b.y ? s.a.y : s.b.y),
        top(s.a.y < s.b.y ? s.b.y : s.a.y) {}
  bool meets(const Box& b) const { return !(right < b.left || b.right < left || top < b.bottom || b.top < bottom); }
};

using Pairs = std::set<std::pair<std::uint32_t, std::uint32_t>>;

// All that the headers say about a grid and its pairs. Returns how many pairs of boxes meet.
template <std::size_t crowd = crowd_for_any>
std::size_t check_grid(const Segments& segments, const BoxGrid& grid, double most_covered) {
  const std::uint32_t n = segments.size();
  EXPECT_LE(grid.cell_count(), n);
  std::vector<std::vector<std::uint32_t>> cells_of(n);
  std::size_t covered = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    const auto cell = grid.cell(c);
    covered += cell.size();
    for (std::size_t k = 0; k < cell.size(); ++k) {
      const std::uint32_t number = cell[k].number();
      EXPECT_TRUE(k == 0 || cell[k - 1].number() < number);
      cells_of[number].push_back(c);
      const Segment& s = segments[number];
      EXPECT_EQ(cell[k].begins() & 1, std::uint32_t{grid.column(s.a.x) == c % grid.column_count()});
      EXPECT_EQ(cell[k].begins() >> 1, std::uint32_t{grid.row(std::min(s.a.y, s.b.y)) == c / grid.column_count()});
    }
  }
  EXPECT_LE(static_cast<double>(covered), most_covered * n);
  Pairs meeting;
  for (std::uint32_t i = 0; i < n; ++i) {
    const Box b(segments[i]);
    // The corners' cells are among those of the segment: none is beyond the last row or column.
    for (const Point2 corner :
         {Point2{b.left, b.bottom}, Point2{b.right, b.bottom}, Point2{b.left, b.top}, Point2{b.right, b.top}}) {
      EXPECT_EQ(std::count_if(cells_of[i].begin(), cells_of[i].end(),
                              [&](std::uint32_t c) { return grid.looking_cell(corner) == c; }),
                1);
    }
    for (std::uint32_t j = i + 1; j < n; ++j) {
      const Box d(segments[j]);
      if (!b.meets(d)) continue;
      meeting.insert({i, j});
      const Point2 corner{std::max(b.left, d.left), std::max(b.bottom, d.bottom)};
      EXPECT_EQ(low_corner(segments[i], segments[j]), corner);
      std::vector<std::uint32_t> both;
      std::set_intersection(cells_of[i].begin(), cells_of[i].end(), cells_of[j].begin(), cells_of[j].end(),
                            std::back_inserter(both));
      EXPECT_EQ(
          std::count_if(both.begin(), both.end(), [&](std::uint32_t c) { return grid.looking_cell(corner) == c; }), 1);
    }
  }
  // The pairs that are given, each once; for crowded cells, those that they are to look at.
  Pairs near;
  const auto add = [&](std::uint32_t i, std::uint32_t j) {
    EXPECT_LT(i, j);
    EXPECT_TRUE(near.insert({i, j}).second) << i << " " << j;
    return true;
  };
  EXPECT_TRUE(for_each_near_pair<crowd>(segments.all(), grid, add));
  const std::vector<std::uint32_t> members = members_of_crowds(grid, crowd, segments.size());
  EXPECT_TRUE(std::is_sorted(members.begin(), members.end()));
  std::size_t in_crowds = 0;
  for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
    const auto cell = grid.cell(c);
    if (cell.size() <= crowd) continue;
    in_crowds += cell.size();
    for (const Covering& s : cell) EXPECT_TRUE(std::binary_search(members.begin(), members.end(), s.number()));
  }
  EXPECT_EQ(crowded(grid, crowd), in_crowds);
  EXPECT_LE(members.size(), in_crowds);
  for (const auto& [i, j] : meeting) {
    const std::uint32_t c = grid.looking_cell(low_corner(segments[i], segments[j]));
    if (grid.cell(c).size() <= crowd) continue;
    EXPECT_TRUE(std::binary_search(members.begin(), members.end(), i));
    EXPECT_TRUE(std::binary_search(members.begin(), members.end(), j));
    add(i, j);
  }
  EXPECT_EQ(near, meeting);
  return meeting.size();
}

TEST(SegmentBoxesTest, OneCellLooksAtEachPair) {
  Random random(151);
  int grids = 0, none = 0;
  std::size_t pairs = 0, cells = 0;
  for (int i = 0; i < 400; ++i) {
    const int kind = i % 8;
    const double length = random.log_uniform(0.003, 0.5);
    const auto number = [&]() -> double {
      switch (kind) {
        case 1: return static_cast<double>(random.below(20));
        case 2: return 1 + static_cast<double>(random.below(12)) * 0x1p-52;  // a few units wide
        case 3: return 1e300 * (1 + random.unit());
        case 4: return static_cast<double>(random.between(-9, 9)) * 0x1p-1020;
        case 5: return random.uniform(-largest / 4, largest / 4);
        default: return random.unit();
      }
    };
    std::vector<Segment> given;
    for (std::uint64_t n = 2 + random.below(80); n > 0; --n) {
      const Point2 p{kind == 6 ? 3 : number(), kind == 7 ? -3 : number()};
      Point2 q{kind == 6 ? 3 : number(), kind == 7 ? -3 : number()};
      if (kind == 0 || kind >= 6)
        q = {p.x + (kind == 6 ? 0 : length * random.unit()), p.y + (kind == 7 ? 0 : length * random.unit())};
      given.push_back({p, random.below(10) == 0 ? p : q});
    }
    const double most_covered = i % 3 == 0 ? 2 : 1000;
    const Segments segments(given);
    const auto grid = BoxGrid::over(segments.all(), segments.extents(), 1, most_covered);
    ++(grid ? grids : none);
    if (!grid) continue;
    cells += grid->cell_count();
    pairs += check_grid(segments, *grid, most_covered);
    if (HasFailure()) FAIL() << i;
  }
  EXPECT_GT(grids, 250);
  EXPECT_GT(none, 10);
  EXPECT_GT(pairs, 5000u);
  EXPECT_GT(cells, 1500u);
}

TEST(SegmentBoxesTest, Degenerate) {
  const auto over = [](const std::vector<Segment>& given, double most_covered = 8) {
    const Segments segments(given);
    const auto grid = BoxGrid::over(segments.all(), segments.extents(), 1, most_covered);
    if (grid) check_grid(segments, *grid, most_covered);
    return grid.has_value();
  };
  EXPECT_FALSE(over({}));
  EXPECT_FALSE(over({{{0, 0}, {1, 1}}}));
  EXPECT_TRUE(over({{{2, 3}, {2, 3}}, {{2, 3}, {2, 3}}}));  // one place
  EXPECT_TRUE(over({{{2, 0}, {2, 1}}, {{2, 3}, {2, 4}}, {{2, 4}, {2, 9}}}));
  EXPECT_TRUE(over({{{0, 5}, {1, 5}}, {{2, 5}, {7, 5}}, {{3, 5}, {4, 5}}}));
  EXPECT_TRUE(over({{{0, 0}, {0, 0}}, {{0, 1}, {0, 1}}, {{1, 0}, {1, 0}}, {{1, 1}, {1, 1}}}));  // points
  EXPECT_FALSE(over({{{0, 0}, {8, 8}}, {{0, 0}, {8, 8}}}, 0.5));                                // covered once each
  // Ranges that overflow, whole or by their reciprocal.
  EXPECT_FALSE(over({{{0, -largest}, {1, -largest}}, {{0, largest}, {1, largest}}}));
  EXPECT_FALSE(over({{{-largest, 0}, {-largest, 1}}, {{largest, 0}, {largest, 1}}}));
  EXPECT_FALSE(over({{{0, 0}, {least, 0}}, {{least, 0}, {3 * least, 1}}}));
  EXPECT_TRUE(over({{{0, 0}, {1, largest}}, {{1, 0}, {2, largest}}}));  // the sum of heights does
  EXPECT_TRUE(over({{{0, 0}, {largest, 1}}, {{0, 1}, {largest, 2}}, {{0, 0}, {1, 1}}}, 1000));
}

// About as many cells as segments where they are short, and few to a cell.
TEST(SegmentBoxesTest, CellsAreFew) {
  Random random(152);
  for (std::uint32_t n = 64; n <= 1u << 16; n *= 4) {
    std::vector<Segment> given;
    const double length = 0.5 / std::sqrt(n);
    for (std::uint32_t k = 0; k < n; ++k) {
      const Point2 p{random.unit(), random.unit()};
      given.push_back({p, {p.x + length * random.unit(), p.y + length * random.unit()}});
    }
    const Segments segments(given);
    const auto grid = grid_over(segments);
    ASSERT_TRUE(grid);
    EXPECT_GE(grid->cell_count(), n / 4);
    EXPECT_LE(grid->cell_count(), n);
    std::size_t most = 0, covered = 0;
    for (std::uint32_t c = 0; c < grid->cell_count(); ++c) {
      most = std::max(most, grid->cell(c).size());
      covered += grid->cell(c).size();
    }
    EXPECT_LE(most, 20u);
    EXPECT_LE(covered, 3 * std::size_t{n});
    EXPECT_EQ(crowded(*grid, crowd_for_any), 0u);
  }
}

TEST(SegmentBoxesTest, Crowds) {
  Random random(153);
  std::vector<Segment> given;
  const auto short_one = [&](double x, double y, double size) {
    const Point2 p{x + size * random.unit(), y + size * random.unit()};
    given.push_back({p, {p.x + size * random.unit(), p.y + size * random.unit()}});
  };
  for (int k = 0; k < 500; ++k) short_one(0, 0, 30);
  for (int k = 0; k < 300; ++k) short_one(10.25, 10.25, 0.001);
  for (const std::size_t crowd : {crowd_for_any, crowd_for_all}) {
    for (const std::size_t in_corner : {crowd - 1, crowd, crowd + 1}) {  // in a cell of their own
      if (in_corner <= crowd && tests::is_scaled_down()) continue;
      std::vector<Segment> all = given;
      for (std::size_t k = 0; k < in_corner; ++k) {
        const Point2 p{90 + random.unit() * 0.001, 90 + random.unit() * 0.001};
        all.push_back({p, p});
      }
      const Segments segments(all);
      const auto grid = grid_over(segments);
      ASSERT_TRUE(grid);
      check_grid<crowd_for_any>(segments, *grid, 8);
      check_grid<crowd_for_all>(segments, *grid, 8);
      EXPECT_EQ(grid->cell(grid->looking_cell(segments[segments.size() - 1].a)).size(), in_corner);
    }
  }
}

// More columns than the 16 bits in which a range of them is noted: one segment covers them all.
TEST(SegmentBoxesTest, ALongOneAmongVeryMany) {
  constexpr int count = 200000;
  std::vector<Segment> all;
  for (int i = 0; i < count; ++i) all.push_back({{i + 0.0, 0}, {i + 0.5, 1}});
  all.push_back({{0, 2}, {count, 2}});
  all.push_back({{count - 0.25, 1.5}, {count - 0.25, 2.5}});
  const Segments segments(all);
  const auto grid = grid_over(segments);
  ASSERT_TRUE(grid);
  ASSERT_GT(grid->column_count(), 70000u);
  std::uint32_t holds_long_one = 0;
  for (std::uint32_t c = 0; c < grid->cell_count(); ++c) {
    for (const Covering& s : grid->cell(c)) holds_long_one += s.number() == count;
  }
  EXPECT_EQ(holds_long_one, grid->cell_count());
  Pairs near;
  for_each_near_pair<crowd_for_any>(segments.all(), *grid, [&](std::uint32_t i, std::uint32_t j) {
    near.insert({i, j});
    return true;
  });
  EXPECT_EQ(near, (Pairs{{count, count + 1}}));
}

}  // namespace
}  // namespace sunder::planar
