// The answer to "do these two convex bodies meet?", and its evidence, as plain data.
// Also called: witness of a certifying algorithm; separating plane, separating axis; convex combination.
//
// A body is the convex hull of a table of vertices; its placement is an affine map. Evidence names vertices by their
// position in that table. The objects are closed: touching is meeting.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/predicate/point.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string_view>
#include <utility>
#include <variant>

namespace sunder {

enum class Verdict : std::uint8_t { apart, meet, undecided };

std::string_view name_of(Verdict);  // "undecided"

// How two objects lie to each other. It stands beside a verdict, which tells whether they meet.
enum class Relation : std::uint8_t {
  none,         // they do not meet; or it is not told: not asked for, or undecided
  touching,     // they meet, but their relative interiors do not: some plane parts them weakly
  overlapping,  // their relative interiors meet
  a_inside_b,   // A is in the interior of B
  b_inside_a,
  equal,
  meeting,      // they meet, and it is not known how: one of the two may have no inside
  a_part_of_b,  // what is inside of A is inside of B or on its boundary, and the boundaries meet (of meshes)
  b_part_of_a,
};

// "none", "touching", "overlapping", "A inside B", "B inside A", "equal", "meeting", "A part of B", "B part of A".
std::string_view name_of(Relation);

// A direction in the world. (Planar objects are bodies in the plane z = 0.) Where doubles hold one that does the job,
// it is `given`; otherwise it is named by features of the placed bodies A and B, whose exact coordinates make it, or
// carried as exact numbers.
struct Direction {
  enum class Kind : std::uint8_t {
    given,            // the three doubles
    normal_of_a,      // (a1 - a0) x (a2 - a0): vertices index[0..2] of A
    normal_of_b,      // (b1 - b0) x (b2 - b0): vertices index[0..2] of B
    edge_cross_edge,  // (a1 - a0) x (b1 - b0): vertices index[0..1] of A, index[2..3] of B
    difference,       // b0 - a0: vertices index[0] of A, index[1] of B
    side_of_a,        // a1 - a0, turned to the right by a right angle, of vertices index[0..1] of A, which is in the
    side_of_b,        // plane z = 0: the outward normal of an edge; the same of B
    exact,            // *numbers
  };
  Kind kind = Kind::given;
  bool reversed = false;                 // the named direction times -1 (not used with `given` and `exact`)
  std::array<std::uint32_t, 4> index{};  // meaningless for `given` and `exact`
  Point3 given{};                        // meaningless but for `given`
  std::shared_ptr<const std::array<Dyadic, 3>> numbers{};  // null but for `exact`
};

inline Direction exact_direction(std::array<Dyadic, 3> numbers) {
  return {.kind = Direction::Kind::exact, .numbers = std::make_shared<const std::array<Dyadic, 3>>(std::move(numbers))};
}

// They are apart: extreme_a is a vertex of A furthest along the direction, extreme_b a vertex of B least far along it,
// and the first is strictly less far than the second.
struct Separation {
  static constexpr Verdict verdict = Verdict::apart;
  Direction direction;
  std::uint32_t extreme_a = 0;
  std::uint32_t extreme_b = 0;
};

// They meet: the hulls of these count_a vertices of A and count_b vertices of B have a point in common:
// vertices[0 .. count_a) are of A, vertices[count_a .. count_a + count_b) of B. The two sets are minimal: the weights of
// the common point are unique and positive. Both counts are at least 1, together at most 5.
struct CommonVertices {
  static constexpr Verdict verdict = Verdict::meet;
  std::uint8_t count_a = 0;
  std::uint8_t count_b = 0;
  std::array<std::uint32_t, 5> vertices{};
};

// What is known of two convex hulls of vertices. It names no body, so that whoever reads it must know which two it is of.
using PairCertificate = std::variant<Separation, CommonVertices>;

// The verdict of evidence is that of what it holds: a Verdict, or what answers to other questions than whether two
// objects meet have in place of it.
template <class... Evidence>
auto verdict_of(const std::variant<Evidence...>& evidence) {
  static constexpr std::array verdicts{Evidence::verdict...};
  return verdicts[evidence.index()];
}
template <class... Evidence>
Relation relation_of(const std::variant<Evidence...>& evidence) {
  static constexpr std::array relations{Evidence::relation...};
  return relations[evidence.index()];
}

}  // namespace sunder
