// How near to touching two curved bodies have to be until it is undecided whether they meet.
#include <tests/support/round_pairs.h>
#include <tests/support/scale.h>

#include <sunder/solid/round/round_round.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdint>
#include <string>

namespace sunder::tests {
namespace {

using solid::RoundVerdict;

// Random curved bodies are brought to touch to the last bit of B's place; then A moves from about the origin, in which
// doubles tell steps of 2^-100. Where it is apart, and where it meets, found by halving, lie as near to each other as
// the header says.
TEST(RoundLastBits, UndecidedAreOnlyPairsWithin2ToTheMinus78) {
  const std::uint64_t seed = chosen_seed(20261128);
  SCOPED_TRACE("seed " + std::to_string(seed));
  RoundPairs pairs(seed);
  constexpr std::array kinds{Primitive::cylinder, Primitive::cone, Primitive::ellipsoid, Primitive::capsule};
  const int count = scaled_count(120, 12);
  int told = 0;
  double widest = 0;
  for (int i = 0; i < count; ++i) {
    const Primitive of_a = kinds[static_cast<std::size_t>(i) % 3], of_b = kinds[static_cast<std::size_t>(i) / 3 % 4];
    const RoundCase c = pairs.next(RoundFamily::general, of_a, of_b);
    const solid::Pose pose_a = solid::Pose::from_matrix(c.pose_a.affine().linear, {0, 0, 0});
    const solid::Pose from = solid::Pose::from_matrix(c.pose_b.affine().linear, {0, 0, 0});
    const Point3 way{pairs.random().uniform(2, 4), pairs.random().uniform(-4, 4), pairs.random().uniform(-4, 4)};
    const auto said = [&](const solid::Pose& a, const solid::Pose& b) { return round_round(c.a, a, c.b, b).verdict(); };
    if (said(pose_a, from) != RoundVerdict::meet || said(pose_a, moved(from, way, 1)) != RoundVerdict::apart) continue;
    const solid::Pose pose_b = moved(from, way, last_meeting(c.a, pose_a, c.b, from, way));
    const auto verdict = [&](double t) { return said(moved(pose_a, way, t), pose_b); };
    constexpr double far = 0x1p-36;  // A comes nearer with t
    if (verdict(-far) != RoundVerdict::apart || verdict(far) != RoundVerdict::meet) continue;
    double apart = -far, high = far;
    while (high - apart > 0x1p-100) {
      const double middle = apart + (high - apart) / 2;
      (verdict(middle) == RoundVerdict::apart ? apart : high) = middle;
    }
    double low = apart, meet = far;
    while (meet - low > 0x1p-100) {
      const double middle = low + (meet - low) / 2;
      (verdict(middle) == RoundVerdict::meet ? meet : low) = middle;
    }
    ++told;
    widest = std::max(widest, meet - apart);
    EXPECT_LE(meet - apart, 0x1p-78) << i << " " << name_of(of_a) << " " << name_of(of_b);
  }
  std::printf("%d of %d pairs; the widest gap 2^%.1f\n", told, count, std::log2(widest));
  EXPECT_GE(told, count / 3);
}

}  // namespace
}  // namespace sunder::tests
