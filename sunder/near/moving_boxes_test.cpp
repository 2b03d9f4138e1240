#include <sunder/base/random.h>
#include <sunder/near/moving_boxes.h>

#include <tests/support/doubles.h>
#include <tests/support/scale.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <set>
#include <utility>
#include <vector>

namespace sunder {
namespace {

using tests::infinity;

using Pairs = std::vector<std::array<std::uint32_t, 2>>;

bool wanted(std::uint32_t i, std::uint32_t j) { return i / 2 != j / 2 && (i + j) % 7 != 3; }

Pairs meeting_by_all_pairs(const std::vector<Box3>& boxes) {
  Pairs pairs;
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (wanted(i, j) && meet(boxes[i], boxes[j])) pairs.push_back({i, j});
    }
  }
  return pairs;
}

// Keeps the pairs by their slots, and expects that no slot changes hands without being told as fresh.
class Slots {
 public:
  void follow(const MovingBoxes& moving) {
    std::map<std::uint32_t, std::array<std::uint32_t, 2>> now;
    for (const auto& [i, j, slot] : moving.pairs()) {
      ASSERT_LT(i, j);
      ASSERT_TRUE(wanted(i, j));
      ASSERT_LT(slot, moving.slot_count());
      ASSERT_TRUE(now.emplace(slot, std::array{i, j}).second);
    }
    const std::set<std::uint32_t> fresh(moving.fresh().begin(), moving.fresh().end());
    ASSERT_EQ(fresh.size(), moving.fresh().size());
    std::set<std::array<std::uint32_t, 2>> before, seen;
    for (const auto& [slot, pair] : by_slot_) before.insert(pair);
    for (const auto& [slot, pair] : now) {
      ASSERT_TRUE(seen.insert(pair).second);
      const auto same = by_slot_.find(slot);
      const bool is_kept = same != by_slot_.end() && same->second == pair;
      ASSERT_NE(is_kept, fresh.contains(slot));
      ASSERT_EQ(is_kept, before.contains(pair));
    }
    by_slot_ = std::move(now);
  }

 private:
  std::map<std::uint32_t, std::array<std::uint32_t, 2>> by_slot_;
};

// Boxes of whole numbers, and then of quarters, that touch often; or of any.
class Swarm {
 public:
  Swarm(std::size_t count, bool whole, std::uint64_t seed) : random_(seed), whole_(whole) {
    side_ = static_cast<std::int64_t>(std::cbrt(static_cast<double>(count))) + 1;
    for (std::size_t i = 0; i < count; ++i) {
      boxes.push_back(anywhere());
      velocity_.push_back(
          {0.02 * random_.uniform(-1, 1), 0.02 * random_.uniform(-1, 1), 0.02 * random_.uniform(-1, 1)});
    }
  }

  // Most go on, or by whole steps; few jump, grow beyond all bounds, shrink, or rest.
  void move(std::uint32_t i) {
    Box3& box = boxes[i];
    const std::uint64_t kind = random_.below(200);
    if (kind == 0) {
      box.low[random_.below(3)] = -infinity;
    } else if (kind == 1) {
      box.high[random_.below(3)] = infinity;
    } else if (kind < 6 || !std::isfinite(box.low.x + box.low.y + box.low.z + box.high.x + box.high.y + box.high.z)) {
      box = anywhere();
    } else if (kind < 20) {
      box.high = box.low;
    } else if (kind < 150) {
      for (std::size_t k = 0; k < 3; ++k) {
        const double by = whole_ ? static_cast<double>(random_.between(-1, 1)) / 4 : velocity_[i][k];
        box.low[k] += by;
        box.high[k] += by;
      }
    }
  }

  std::vector<Box3> boxes;

 private:
  Box3 anywhere() {
    Box3 box;
    for (std::size_t k = 0; k < 3; ++k) {
      box.low[k] = whole_ ? static_cast<double>(random_.between(-side_, side_))
                          : random_.uniform(-1, 1) * static_cast<double>(side_);
      box.high[k] = box.low[k] + (whole_ ? static_cast<double>(random_.below(3)) : random_.uniform(0, 2));
    }
    return box;
  }

  Random random_;
  bool whole_;
  std::int64_t side_;
  std::vector<Point3> velocity_;
};

void expect_no_pair_lost(bool whole, std::uint64_t seed) {
  std::uint64_t found = 0, near = 0, kept = 0;
  Random random(seed);
  const int rounds = tests::scaled_count(60, 5);
  for (int round = 0; round < rounds; ++round) {
    const std::size_t count = random.below(round % 5 == 0 ? 400 : 40);
    Swarm swarm(count, whole, random.below(1u << 30));
    MovingBoxes moving(swarm.boxes, wanted);
    Slots slots;
    for (int step = 0; step < 40; ++step) {
      Pairs pairs;
      for (const auto& [i, j, slot] : moving.pairs()) {
        if (meet(moving.box(i), moving.box(j))) pairs.push_back({i, j});
      }
      std::sort(pairs.begin(), pairs.end());
      ASSERT_EQ(pairs, meeting_by_all_pairs(swarm.boxes)) << seed << " " << round << " " << step;
      ASSERT_NO_FATAL_FAILURE(slots.follow(moving));
      found += pairs.size();
      near += moving.pairs().size() - pairs.size();
      kept += moving.pairs().size() - moving.fresh().size();
      const std::uint64_t some = random.below(4);  // sometimes all move, sometimes none
      for (std::uint32_t i = 0; i < count; ++i) {
        if (random.below(3) >= some) continue;
        for (std::uint64_t again = random.below(8) == 0 ? 2 : 1; again > 0; --again) {  // twice before an update
          swarm.move(i);
          moving.move(i, swarm.boxes[i]);
        }
      }
      moving.update();
    }
  }
  const auto some = static_cast<std::uint64_t>(rounds);
  EXPECT_GT(found, 20 * some);
  EXPECT_GT(near, some);  // margins are of use
  EXPECT_GT(kept, 20 * some);
}

TEST(MovingBoxes, LosesNoPairOfAnyBoxes) { expect_no_pair_lost(false, tests::chosen_seed(1)); }
TEST(MovingBoxes, LosesNoPairOfBoxesThatTouch) { expect_no_pair_lost(true, tests::chosen_seed(2)); }

TEST(MovingBoxes, NoBoxOneBoxEqualBoxes) {
  const auto all = [](std::uint32_t, std::uint32_t) { return true; };
  EXPECT_TRUE(MovingBoxes({}, all).pairs().empty());
  EXPECT_TRUE(MovingBoxes(std::vector<Box3>(1), all).pairs().empty());
  EXPECT_EQ(MovingBoxes(std::vector<Box3>(100), all).pairs().size(), 4950u);
  constexpr double most = std::numeric_limits<double>::max();
  const Box3 whole{{-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  std::vector<Box3> boxes{whole, {{-most, -most, -most}, {most, most, most}}, {}, {{most, 0, 0}, {infinity, 0, 0}}};
  MovingBoxes moving(boxes, all);
  EXPECT_EQ(moving.pairs().size(), 5u);
  moving.move(3, {});
  moving.update();
  EXPECT_EQ(moving.pairs().size(), 6u);
}

// The margin of what touches by a last bit is neither lost nor too much: what rests is not widened.
TEST(MovingBoxes, RestCostsNothingAndIsNotWidened) {
  std::vector<Box3> boxes;
  for (int i = 0; i < 1000; ++i) {
    const double low = i, high = i + 1 - 0x1p-40;
    boxes.push_back({{low, 0, 0}, {high, 1, 1}});
  }
  MovingBoxes moving(boxes, [](std::uint32_t, std::uint32_t) { return true; });
  EXPECT_TRUE(moving.pairs().empty());
  const std::uint64_t looks = moving.looks();
  for (std::uint32_t i = 0; i < 1000; ++i) moving.move(i, boxes[i]);
  moving.update();
  EXPECT_EQ(moving.looks(), looks);
  EXPECT_TRUE(moving.pairs().empty());
}

// Of n boxes at the density of 6 neighbours that drift, or jump: looks at boxes, a box and step.
double looks_a_box(std::size_t count, double step, int steps) {
  Random random(7);
  const double side = std::cbrt(static_cast<double>(count) * 8 / 6);
  const auto point = [&](double reach) {
    return Point3{reach * random.uniform(-1, 1), reach * random.uniform(-1, 1), reach * random.uniform(-1, 1)};
  };
  std::vector<Point3> at, velocity;
  for (std::size_t i = 0; i < count; ++i) {
    at.push_back(point(side / 2));
    velocity.push_back(point(step));
  }
  const auto box = [&](std::size_t i) {
    const Point3& p = at[i];
    return Box3{p, {p.x + 1, p.y + 1, p.z + 1}};
  };
  std::vector<Box3> boxes;
  for (std::size_t i = 0; i < count; ++i) boxes.push_back(box(i));
  MovingBoxes moving(boxes, [](std::uint32_t, std::uint32_t) { return true; });
  const std::uint64_t before = moving.looks();
  for (int s = 0; s < steps; ++s) {
    for (std::uint32_t i = 0; i < count; ++i) {
      if (step > 1) {
        at[i] = point(side / 2);
      } else {
        at[i] = {at[i].x + velocity[i].x, at[i].y + velocity[i].y, at[i].z + velocity[i].z};
      }
      moving.move(i, box(i));
    }
    moving.update();
  }
  return static_cast<double>(moving.looks() - before) / static_cast<double>(count) / steps;
}

TEST(MovingBoxes, CostsWhatChanges) {
  for (const std::size_t count : {1000u, 4000u, 16000u}) {
    const double slowly = looks_a_box(count, 0.005, 20), by_jumps = looks_a_box(count, 2, 4);
    EXPECT_LT(slowly, 60) << count;
    EXPECT_GT(by_jumps, 20) << count;
    EXPECT_LT(by_jumps, 100 * std::log2(static_cast<double>(count))) << count;
  }
}

}  // namespace
}  // namespace sunder
