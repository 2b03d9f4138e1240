// Which of many bodies meet at any time, while all of them go straight from where they are to where they will be?
// Also called: continuous collision detection; swept broad phase.
//
// The question of scene.h between two placements of the same bodies, in which all parts move at once, from time 0 to 1.
//   W1. A pair of parts that do not turn is asked about all the way, the ends included, as round_round_sweep says (of
//       polyhedra polyhedron_polyhedron_sweep); boxes never hide one that meets. Where one is curved it may be
//       undecided (round_round_sweep.h, W3): then it is listed and counted as that. Where the shapes are not apart all
//       the way, and one is the hull of a mesh and neither has a radius, the meshes are asked about as they are
//       (mesh_motion.h). A mesh and a part with a radius are asked about by the hull of the mesh.
//   W2. Any other pair, of which a part turns or changes its size, is asked about at both ends only, and counted as
//       that: what it does between is not known. (One placement and the next do not say how a part turns.)
// Touching is meeting.
#pragma once

#include <sunder/base/error.h>
#include <sunder/number/interval.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/mesh/mesh_motion.h>
#include <sunder/solid/round/round_round_sweep.h>

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <variant>

namespace sunder::scene {

// They meet on the way, at this first contact.
struct MeetOnTheWay {
  static constexpr Verdict verdict = Verdict::meet;
  std::shared_ptr<const solid::RoundFirstContact> first;  // not null
};

// Two meshes as they are meet on the way.
struct MeshesMeetOnTheWay {
  static constexpr Verdict verdict = Verdict::meet;
  std::shared_ptr<const solid::MeshMotion> motion;  // not null
  Point3 point;                                     // of both, at the first time: rounded
};

// Asked at both ends only: they meet at this one, 0 or 1.
struct MeetAtAnEnd {
  static constexpr Verdict verdict = Verdict::meet;
  double time = 0;
  std::shared_ptr<const PartPair> pair;  // as they are there; not null
};

// They are apart all the way, as along this direction from A to B.
struct ApartOnTheWay {
  static constexpr Verdict verdict = Verdict::apart;
  std::shared_ptr<const std::array<Dyadic, 3>> direction;  // not null
};

// The shapes are not, but the meshes are apart all the way.
struct MeshesApartOnTheWay {
  static constexpr Verdict verdict = Verdict::apart;
};

// It is undecided whether they meet on the way; of those asked at both ends only, there.
struct UndecidedPair {
  static constexpr Verdict verdict = Verdict::undecided;
  bool all_the_way = true;
};

struct SweptPair {
  std::uint32_t body_a = 0, body_b = 0;  // body_a < body_b
  std::uint32_t part_a = 0, part_b = 0;
  std::variant<UndecidedPair, MeetOnTheWay, MeshesMeetOnTheWay, MeetAtAnEnd, ApartOnTheWay, MeshesApartOnTheWay>
      evidence{};

  Verdict verdict() const { return verdict_of(evidence); }
  bool meet() const { return verdict() == Verdict::meet; }
  bool undecided() const { return verdict() == Verdict::undecided; }

  bool is_of_meshes() const;  // is what is said of the parts as meshes?
  bool all_the_way() const;   // false: asked at its ends only
  Interval time() const;      // encloses the first time; of one asked at its ends, that end. Requires that they meet
};

struct SweptCounts {
  std::uint64_t pairs = 0;         // of parts of different bodies
  std::uint64_t allowed = 0;       // of these, not asked about
  std::uint64_t by_boxes = 0;      // parted all the way by the boxes of their ways
  std::uint64_t by_method = 0;     // asked about all the way
  std::uint64_t at_ends_only = 0;  // pairs = allowed + by_boxes + by_method + at_ends_only
  std::uint64_t meeting = 0;
  std::uint64_t undecided = 0;       // all the way; or at an end, of those asked there, that meet at no end
  std::uint64_t surfaces_alone = 0;  // apart all the way as meshes, of which one has an open piece: what it seems to
                                     // enclose is not asked about
  std::uint64_t looks = 0;           // at boxes, in the tree that finds those near each other (near/box_tree.h)

  bool some_meet() const { return meeting > 0; }
  // All are known to be apart, or allowed.
  bool none_meet() const { return meeting == 0 && undecided == 0 && at_ends_only == 0; }
};

// Listed are those that meet or are undecided; with every_pair also apart ones.
using SweptAnswer = PairsAnswer<SweptPair, SweptCounts>;

// question: its method is not looked at, nor what it says of contacts. With every_pair all that are apart all the way
// are listed, too, with their directions. Requires the same bodies with the same parts in both placements, and indices
// of bodies in question.allowed to be in range. Throws Error as meeting_pairs does. Cost for n parts: a search in
// a tree of boxes for each, O(n log n) where these are spread, and a sweep for each pair whose boxes meet; n^2 with
// every_pair.
SweptAnswer meeting_on_the_way(std::span<const Body> begin, std::span<const Body> end, const Question& question = {});

}  // namespace sunder::scene
