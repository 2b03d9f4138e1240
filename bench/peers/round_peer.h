// Pairs of primitives for bench_round, and how another library answers them.
#pragma once

#include <bench/contest/contest.h>

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace bench {

enum class RoundShapeKind : int { ball, capsule, box, cylinder, cone, ellipsoid };
constexpr std::size_t kRoundShapeKinds = 6;

// About the origin, along z: of a cone the apex is up.
struct RoundPrimitive {
  RoundShapeKind kind = RoundShapeKind::ball;
  std::array<double, 3> half{};  // ball: radius; capsule, cylinder, cone: radius, and half the length of the axis; box:
                                 // half its sides; ellipsoid: semi-axes
  std::array<double, 9> linear{};  // its pose, a rotation, row by row
  std::array<double, 3> translation{};
};

struct RoundQuestion {
  RoundPrimitive a, b;
};

struct RoundWay {
  std::string library, method;
  Run (*run)(const std::vector<RoundQuestion>& questions);
};

std::vector<RoundWay> fcl_round_ways();

}  // namespace bench
