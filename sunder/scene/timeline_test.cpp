#include <sunder/base/random.h>
#include <sunder/scene/timeline.h>

#include <tests/support/shapes.h>

#include <gtest/gtest.h>

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <tuple>
#include <vector>

namespace sunder::scene {
namespace {

using solid::ConvexPolyhedron;
using solid::Pose;

// Four cubes of which the last never moves; some rows cannot be read.
struct TimelineRows {
  std::vector<std::array<Pose, 3>> poses;
  std::size_t unreadable = std::numeric_limits<std::size_t>::max();

  std::size_t size() const { return poses.size(); }
  std::string name(std::size_t row) const { return "row " + std::to_string(row); }
  auto placer() const {
    return [this](std::size_t row, const auto& put) {
      if (row >= unreadable) throw Error(ErrorCode::bad_pose, "no pose", "joint 'j'");
      for (std::uint32_t part = 0; part < 3; ++part) put(part, poses[row][part]);
    };
  }
};

TimelineRows timeline_rows(std::size_t count) {
  Random random(7);
  TimelineRows rows;
  const auto n = [&] { return static_cast<double>(random.between(-12, 12)) / 8; };
  for (std::size_t k = 0; k < count; ++k) {
    rows.poses.push_back({tests::shift(n(), n(), n()), tests::shift(n(), n(), n()), tests::shift(3 + n(), n(), 0)});
  }
  return rows;
}

std::vector<Body> timeline_bodies(const TimelineRows& rows, std::size_t row) {
  const ConvexPolyhedron cube(tests::cube_corners(0, 1));
  std::vector<Body> bodies{{"a", {{"", cube, {}}, {"", cube, {}}}}, {"b", {{"", cube, {}}}}};
  bodies.push_back({"still", {{"", cube, tests::shift(1, 1, 1)}}});
  std::uint32_t part = 0;
  for (Body& body : bodies) {
    for (Part& of : body.parts) {
      if (part < 3) of.pose = rows.poses[row][part++];
    }
  }
  return bodies;
}

template <class Pair>
std::vector<std::string> names_of(const std::vector<Pair>& pairs) {
  std::vector<std::string> names;
  for (const Pair& p : pairs) {
    if constexpr (requires { p.meet(); }) {
      if (!p.meet()) continue;
    }
    names.push_back(std::to_string(p.body_a) + "." + std::to_string(p.part_a) + " " + std::to_string(p.body_b) + "." +
                    std::to_string(p.part_b));
  }
  return names;
}

std::vector<std::string> closer_names(const ClearanceAnswer& answer) {
  std::vector<std::string> names;
  for (const PartDistance& p : answer.closer) {
    names.push_back(std::to_string(p.body_a) + " " + std::to_string(p.body_b) + " " + std::to_string(p.distance.high));
  }
  return names;
}

struct Seen {
  std::vector<std::size_t> rows;
  std::vector<std::vector<std::string>> meeting, closer;
  std::vector<double> nearest;

  void add(const Seen& other) {
    const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
    append(rows, other.rows);
    append(meeting, other.meeting);
    append(closer, other.closer);
    append(nearest, other.nearest);
  }
};

TEST(Timeline, EveryRowIsAsTheQuestionsAloneSay) {
  const TimelineRows rows = timeline_rows(300);
  const ClearanceQuestion clearance{0.5, {}, {}};
  const MomentFollower start(timeline_bodies(rows, 5), {}, {clearance, true, {}});
  for (const std::size_t threads : {1u, 3u}) {
    Seen all;
    const std::size_t asked = run_timeline<Seen>(
        practised(start, rows), rows, threads,
        [](std::size_t k, const Moment& moment, Seen& seen) {
          seen.rows.push_back(k);
          seen.meeting.push_back(names_of(moment.meeting.pairs));
          seen.closer.push_back(closer_names(*moment.near.clearance));
          seen.nearest.push_back(moment.near.nearest->distance.high);
          return true;
        },
        [&](const Seen& seen, std::size_t done) {
          all.add(seen);
          EXPECT_EQ(done, all.rows.size());
          return true;
        });
    ASSERT_EQ(asked, rows.size());
    ASSERT_EQ(all.rows.size(), rows.size());
    std::size_t meeting = 0, closer = 0;
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const std::vector<Body> bodies = timeline_bodies(rows, k);
      ASSERT_EQ(all.rows[k], k);
      ASSERT_EQ(all.meeting[k], names_of(meeting_pairs(bodies).pairs)) << k;
      ASSERT_EQ(all.closer[k], closer_names(closer_pairs(bodies, clearance))) << k;
      ASSERT_EQ(all.nearest[k], nearest_parts(bodies)->distance.high) << k;
      meeting += !all.meeting[k].empty();
      closer += all.closer[k].size() > all.meeting[k].size();
    }
    EXPECT_TRUE(20 < meeting && meeting < 280 && closer > 20) << meeting << ' ' << closer;
  }
}

TEST(Timeline, EveryStepIsAsTheMotionAloneSays) {
  const TimelineRows rows = timeline_rows(200);
  for (const std::size_t threads : {1u, 3u}) {
    Seen all;
    const std::size_t asked = run_timeline<Seen>(
        StepFollower(timeline_bodies(rows, 9), {}), rows, threads,
        [](std::size_t k, const SweptAnswer& answer, Seen& seen) {
          seen.rows.push_back(k);
          seen.meeting.push_back(names_of(answer.pairs));
          return true;
        },
        [&](const Seen& seen, std::size_t) {
          all.add(seen);
          return true;
        });
    ASSERT_EQ(asked, rows.size() - 1);
    ASSERT_EQ(all.meeting.size(), asked);
    for (std::size_t k = 0; k < asked; ++k) {
      ASSERT_EQ(all.meeting[k],
                names_of(meeting_on_the_way(timeline_bodies(rows, k), timeline_bodies(rows, k + 1)).pairs))
          << k;
    }
  }
}

TEST(Timeline, EndsWhereTheVisitorSaysSo) {
  const TimelineRows rows = timeline_rows(300);
  for (const std::size_t threads : {1u, 3u}) {
    Seen all;
    const std::size_t asked = run_timeline<Seen>(
        MomentFollower(timeline_bodies(rows, 0), {}), rows, threads,
        [](std::size_t k, const Moment&, Seen& seen) {
          seen.rows.push_back(k);
          return k != 150;
        },
        [&](const Seen& seen, std::size_t) {
          all.add(seen);
          return all.rows.back() != 150;
        });
    EXPECT_EQ(asked, 151u);
    EXPECT_EQ(all.rows.size(), 151u);
  }
}

TEST(Timeline, NamesTheFirstRowThatHasAnError) {
  TimelineRows rows = timeline_rows(300);
  rows.unreadable = 100;
  const auto run = [&](const auto& start, std::size_t threads) {
    std::size_t done = 0;
    try {
      run_timeline<int>(
          start, rows, threads, [](auto&&...) { return true; },
          [&](int, std::size_t asked) {
            done = asked;
            return true;
          });
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::bad_pose);
      return std::to_string(done) + ": " + error.what();
    }
    return std::string("none");
  };
  const std::vector<Body> bodies = timeline_bodies(rows, 0);
  for (const std::size_t threads : {1u, 3u}) {
    EXPECT_EQ(run(practised(MomentFollower(bodies, {}), rows), threads), "64: row 100: joint 'j': no pose");
    EXPECT_EQ(run(StepFollower(bodies, {}), threads), "64: row 100: joint 'j': no pose");
  }
  rows.unreadable = 0;
  EXPECT_EQ(run(practised(MomentFollower(bodies, {}), rows), 1), "0: row 0: joint 'j': no pose");
  EXPECT_EQ(run(MomentFollower(bodies, {}), 1), "0: row 0: joint 'j': no pose");
}

TEST(Timeline, OfNoRowsNothingIsAsked) {
  const TimelineRows rows = timeline_rows(1), none{};
  const auto run = [](const auto& start, const TimelineRows& of) {
    return run_timeline<int>(start, of, 2, [](auto&&...) { return true; }, [](int, std::size_t) { return true; });
  };
  const std::vector<Body> bodies = timeline_bodies(rows, 0);
  EXPECT_EQ(run(MomentFollower(bodies, {}), none), 0u);
  EXPECT_EQ(run(StepFollower(bodies, {}), none), 0u);
  EXPECT_EQ(run(StepFollower(bodies, {}), rows), 0u) << "one placement is no step";
  std::size_t seen = 0;
  run_timeline<int>(MomentFollower(bodies, {}), timeline_rows(100), 1, [&](auto&&...) { ++seen; }, [](auto&&...) {});
  EXPECT_EQ(seen, 100u) << "visitors that say nothing want all";
}

}  // namespace
}  // namespace sunder::scene
