// How near to touching two curved bodies have to be until it is undecided whether they meet.
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>

#include <sunder/solid/round/round_round.h>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>

namespace sunder::tests {
namespace {

// Random curved bodies are brought to touch to the last bit of B's place; then A moves from about the origin, in which
// doubles tell steps of 2^-100, to where it is last known to be apart. About there are verdicts at gaps and depths of
// some 2^-k: how many are undecided is what the header says. (An ellipsoid's centre is rounded as it is placed.)
TEST(RoundLastBits, UndecidedAreOnlyPairsWithin2ToTheMinus76) {
  const std::uint64_t seed = chosen_seed(20261128);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  constexpr std::array of_a{Primitive::cylinder, Primitive::cone};
  constexpr std::array of_b{Primitive::cylinder, Primitive::cone, Primitive::ellipsoid, Primitive::capsule};
  constexpr std::array powers{60, 68, 72, 76};
  constexpr int places = 10;  // on either side
  std::array<int, powers.size()> undecided{};
  const int count = scaled_count(100, 12);
  int told = 0;
  for (int i = 0; i < count; ++i) {
    const auto k = static_cast<std::size_t>(i);
    const RoundCase c = pairs.next(RoundFamily::general, of_a[k % 2], of_b[k / 2 % 4]);
    const solid::Pose pose_a = solid::Pose::from_matrix(c.pose_a.affine().linear, {0, 0, 0});
    const solid::Pose from = solid::Pose::from_matrix(c.pose_b.affine().linear, {0, 0, 0});
    const Point3 way{pairs.random().uniform(2, 4), pairs.random().uniform(-4, 4), pairs.random().uniform(-4, 4)};
    const auto said = [&](const solid::Pose& a, const solid::Pose& b) { return round_round(c.a, a, c.b, b).verdict(); };
    if (said(pose_a, from) != Verdict::meet || said(pose_a, moved(from, way, 1)) != Verdict::apart) continue;
    const solid::Pose pose_b = moved(from, way, last_meeting(c.a, pose_a, c.b, from, way));
    const auto verdict = [&](double t) { return said(moved(pose_a, way, t), pose_b); };
    double apart = -0x1p-36, nearer = 0x1p-36;  // A comes nearer with t
    if (verdict(apart) != Verdict::apart || verdict(nearer) != Verdict::meet) continue;
    while (nearer - apart > 0x1p-100) {
      const double middle = apart + (nearer - apart) / 2;
      (verdict(middle) == Verdict::apart ? apart : nearer) = middle;
    }
    ++told;
    for (std::size_t p = 0; p < powers.size(); ++p) {
      for (int place = -places; place < places; ++place) {
        const double t = apart + std::ldexp((place + 0.5) / places, -powers[p]);
        undecided[p] += verdict(t) == Verdict::undecided;
      }
    }
  }
  const int asked = 2 * places * told;
  for (std::size_t p = 0; p < powers.size(); ++p) {
    std::printf("within 2^-%d: %d of %d undecided\n", powers[p], undecided[p], asked);
  }
  EXPECT_GE(told, count / 3);
  EXPECT_LE(20 * undecided[0], asked);
  EXPECT_LE(20 * undecided[2], asked);
  EXPECT_LE(8 * undecided[3], asked);
  if (asked < 1000) return;
  EXPECT_LE(200 * undecided[0], asked);
  EXPECT_LE(200 * undecided[2], asked);
  EXPECT_LE(30 * undecided[3], asked);
}

}  // namespace
}  // namespace sunder::tests
