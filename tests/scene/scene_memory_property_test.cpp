// How much memory bodies and scenes hold, as their headers say: live bytes, counted where they are allocated.
#include <tests/support/live_bytes.h>
#include <tests/support/shapes.h>
#include <tests/support/thread_sanitizer.h>

#include <sunder/near/moving_boxes.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/follower.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/round/round_body.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using scene::Body;
using scene::Follower;
using solid::ConvexPolyhedron;
using solid::RoundBody;

// Of what `make` makes, once it is there.
template <class Make>
double held(const Make& make) {
  const std::int64_t before = live;
  const auto made = make();
  return static_cast<double>(live - before);
}

constexpr double bytes_a_vertex = 420;                                   // as round_body.h says
constexpr double bytes_a_part = 1100, bytes_a_meeting_pair = 500;        // as follower.h says
constexpr double bytes_a_clearance_part = 250, bytes_a_near_pair = 450;  // as clearance_follower.h says
constexpr double bytes_a_box = 200, bytes_a_pair = 32;                   // as moving_boxes.h says

class SceneMemory : public testing::Test {
  void SetUp() override {
    if (SUNDER_UNDER_THREAD_SANITIZER) GTEST_SKIP() << "nothing is counted under the thread sanitizer";
  }
};

TEST_F(SceneMemory, OfABodyByVertex) {
  for (const std::size_t n : {100u, 1000u, 10000u}) {
    Random random(n);
    const std::vector<Point3> points = points_on_sphere(n, random);
    const double bytes = held([&] { return ConvexPolyhedron(points); }) / static_cast<double>(n);
    std::printf("%zu vertices: %.0f bytes a vertex\n", n, bytes);
    EXPECT_LE(bytes, bytes_a_vertex);
    EXPECT_GE(bytes, bytes_a_vertex / 2);
    // A radius costs nothing, nor does a copy; parts cost themselves.
    const ConvexPolyhedron core(points);
    EXPECT_EQ(held([&] { return RoundBody::rounded(core, 0.5); }), 0);
    constexpr std::size_t count = 10;
    const double parts = held([&] {
      std::vector<scene::Part> made;
      made.reserve(count);
      for (std::size_t k = 0; k < count; ++k)
        made.push_back({"", RoundBody(core), shift(0, 0, static_cast<double>(k))});
      return made;
    });
    EXPECT_LE(parts, count * sizeof(scene::Part) + 16);
  }
}

// Cubes on a line: each meets as many of the next ones as its length says.
std::vector<Body> cubes_in_line(std::size_t n, double apart) {
  const RoundBody cube(ConvexPolyhedron(cube_corners(0, 1)));
  std::vector<Body> bodies;
  for (std::size_t k = 0; k < n; ++k) {
    bodies.push_back({"", {{"", cube, shift(apart * static_cast<double>(k), 0, 0)}}});
  }
  return bodies;
}

TEST_F(SceneMemory, OfAFollowerByPartAndMeetingPair) {
  for (const std::size_t n : {1000u, 10000u}) {
    const auto bytes_of = [&](double apart, std::size_t& near) {
      const std::vector<Body> bodies = cubes_in_line(n, apart);
      return held([&] {
        Follower follower(bodies);
        near = follower.ask().counts.by_method;
        return follower;
      });
    };
    std::size_t none = 0, many = 0;
    const double far = bytes_of(8, none), close = bytes_of(0.24, many);
    EXPECT_EQ(none, 0u);
    EXPECT_GT(many, 3 * n);
    const double by_part = far / static_cast<double>(n), by_pair = (close - far) / static_cast<double>(many);
    std::printf("%zu parts: %.0f bytes a part; %zu near pairs that meet: %.0f bytes a pair\n", n, by_part, many,
                by_pair);
    EXPECT_LE(by_part, bytes_a_part);
    EXPECT_GE(by_part, bytes_a_part / 2);
    EXPECT_LE(by_pair, bytes_a_meeting_pair);
    EXPECT_GE(by_pair, bytes_a_meeting_pair / 4);
  }
}

TEST_F(SceneMemory, OfAClearanceFollowerByPartAndNearPair) {
  for (const std::size_t n : {1000u, 10000u}) {
    const auto bytes_of = [&](double apart, std::size_t& near) {
      const std::vector<Body> bodies = cubes_in_line(n, apart);
      return held([&] {
        scene::ClearanceFollower follower(bodies, {0.5, {}, {}});
        near = follower.ask(bodies).by_method;
        return follower;
      });
    };
    std::size_t none = 0, some = 0;
    const double far = bytes_of(8, none), close = bytes_of(1.25, some);
    EXPECT_EQ(none, 0u);
    EXPECT_EQ(some, n - 1);
    const double by_part = far / static_cast<double>(n), by_pair = (close - far) / static_cast<double>(some);
    std::printf("%zu parts: %.0f bytes a part; %zu near pairs: %.0f bytes a pair\n", n, by_part, some, by_pair);
    EXPECT_LE(by_part, bytes_a_clearance_part);
    EXPECT_GE(by_part, bytes_a_clearance_part / 2);
    EXPECT_LE(by_pair, bytes_a_near_pair);
    EXPECT_GE(by_pair, bytes_a_near_pair / 4);
  }
}

TEST_F(SceneMemory, OfMovingBoxesByBoxAndPair) {
  for (const std::size_t n : {1000u, 10000u}) {
    const auto bytes_of = [&](double apart, std::size_t& pairs) {
      std::vector<Box3> boxes;
      for (std::size_t k = 0; k < n; ++k) {
        const double x = apart * static_cast<double>(k);
        boxes.push_back({{x, 0, 0}, {x + 1, 1, 1}});
      }
      return held([&] {
        auto moving = std::make_unique<MovingBoxes>(boxes, [](std::uint32_t, std::uint32_t) { return true; });
        for (std::uint32_t k = 0; k < n; ++k) {
          Box3 box = boxes[k];
          box.low.y += 0.5, box.high.y += 0.5;
          moving->move(k, box);
        }
        moving->update();
        pairs = moving->pairs().size();
        return moving;
      });
    };
    std::size_t none = 0, many = 0;
    const double far = bytes_of(8, none), close = bytes_of(0.24, many);
    EXPECT_EQ(none, 0u);
    EXPECT_GT(many, 3 * n);
    const double by_box = far / static_cast<double>(n), by_pair = (close - far) / static_cast<double>(many);
    std::printf("%zu boxes: %.0f bytes a box; %zu pairs: %.0f bytes a pair\n", n, by_box, many, by_pair);
    EXPECT_LE(by_box, bytes_a_box);
    EXPECT_GE(by_box, bytes_a_box / 2);
    EXPECT_LE(by_pair, bytes_a_pair);
  }
}

}  // namespace
}  // namespace sunder::tests
