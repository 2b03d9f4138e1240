// Pairs of placed bodies with a radius for differential tests: random and nasty, from a seed; without GoogleTest, so
// that benchmarks use them too.
#pragma once

#include <sunder/base/random.h>
#include <sunder/solid/round/round_body.h>
#include <sunder/solid/round/round_round.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {

enum class RoundFamily : int {
  general,       // random bodies, random rotations, near enough that about half meet
  near_contact,  // moved along a line to where the verdict changes, then by a log-uniform gap, down to the last bit
  touching,      // two that rest on one plane from both sides, in one point of doubles: they touch exactly
  last_bit,      // the same, moved across that plane by a unit in the last place, or along it
  grid,          // small whole numbers
  nested,        // one well inside the other
  degenerate,    // radii of 0, 5e-324, and far above the size of the core
  tiny_or_huge,  // all lengths times 1e-300 to 1e300
};
inline constexpr int round_family_count = 8;
std::string_view name_of(RoundFamily);

// What people call the bodies.
enum class Primitive : int { ball, capsule, rounded_box, rounded_hull, box, polyhedron, cylinder, cone, ellipsoid };
inline constexpr int primitive_count = 9;
std::string_view name_of(Primitive);

struct RoundCase {
  RoundFamily family;
  Primitive of_a, of_b;
  solid::RoundBody a, b;
  solid::Pose pose_a, pose_b;
};

std::string named(const RoundCase& c);

// About how long the body is.
double size_of(const solid::PlacedRound& body);

// Of a size about 1.
solid::RoundBody some_primitive(Primitive primitive, Random& random);

// An endless stream of cases: all families, and in each all pairs of primitives, in turn.
class RoundPairs {
 public:
  explicit RoundPairs(std::uint64_t seed) : random_(seed) {}
  RoundCase next();
  RoundCase next(RoundFamily family, Primitive a, Primitive b);

  Random& random() { return random_; }

 private:
  RoundCase near_contact(Primitive a, Primitive b);

  Random random_;
  int turn_ = 0;
};

// Where a moved body first meets the other, to the last bit: the pose of B is `from` moved by t along `way`, t in
// doubles from 0, where they meet, to 1, where they do not. Returns the least t that is found at which they are not
// said to meet, whose neighbour below is. Undecided counts as apart.
double last_meeting(const solid::RoundBody& a, const solid::Pose& pose_a, const solid::RoundBody& b,
                    const solid::Pose& from, const Point3& way);
solid::Pose moved(const solid::Pose& pose, const Point3& way, double t);

}  // namespace sunder::tests
