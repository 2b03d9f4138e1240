// Which of many placed bodies meet?
// Also called: collision checking of many bodies; broad phase and narrow phase.
//
// A body is made of parts, convex polyhedra and bodies with a radius (balls, capsules, cylinders, ..), each with its
// own placement; parts of one body are not tested against each other. Boxes are compared first, so that bodies far
// apart cost next to nothing.
//   S1. A pair of parts is reported as meeting iff polyhedron_polyhedron says so, or, where one has a radius,
//       round_round: boxes never hide a pair that meets, not even one that only touches. What is undecided there
//       (round_round.h, R4) is so here: listed, counted, and neither meeting nor apart. Of two parts that are
//       not apart so, and of which one is the hull of a mesh, mesh_mesh tells whether they meet as they are, or
//       mesh_round, where the other one has a radius.
//   S2. Every pair that is listed has its certificate, also where boxes decided (its direction is then an axis); but
//       for the undecided.
//   S3. The list is the same for every compiler and machine, and is ordered by body_a, body_b, part_a, part_b.
#pragma once

#include <sunder/base/error.h>
#include <sunder/solid/mesh/mesh.h>
#include <sunder/solid/mesh/mesh_relation.h>
#include <sunder/solid/mesh/mesh_round.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/round/round_contact.h>
#include <sunder/solid/round/round_round.h>
#include <sunder/solid/round/round_round_warm.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace sunder::scene {

struct Part {
  std::string name;        // for people
  solid::RoundBody shape;  // also a polyhedron: it becomes one of radius 0
  solid::Pose pose;        // of the shape in the world; of a body with a radius as require_rigid (round_body.h) says
  std::shared_ptr<const solid::Mesh> mesh{};  // as it is, of which the shape is the hull; null where the shape is meant
};

struct Body {
  std::string name;         // for people
  std::vector<Part> parts;  // may be empty: a body that meets nothing
};

// "hand", or "hand/2" where the body has several parts. Requires part < body.parts.size().
std::string part_name(const Body& body, std::uint32_t part);

struct Question {
  solid::PolyhedronMethod method = solid::polyhedron_polyhedron;  // of two polyhedra; others are round_round's
  std::vector<std::array<std::uint32_t, 2>> allowed;              // pairs of bodies not to be tested, in any order
  bool allowed_alone = false;     // the other way round: those are tested, and no others
  bool touching_allowed = false;  // a pair that only touches does not count as meeting (implies contacts)
  bool contacts = false;          // find out whether pairs that meet touch or overlap
  bool every_pair = false;        // list the pairs that boxes parted too
};

// Two parts whose hulls meet or may meet, as they are: two meshes, or a mesh and a part with a radius.
struct PairAsMeshes {
  std::variant<solid::MeshAnswer, solid::MeshRoundAnswer> answer;
  solid::MeshRelation relation{};  // of two meshes, if it was asked how they meet: as far as that was found

  Verdict verdict() const {
    return std::visit([](const auto& of) { return of.verdict(); }, answer);
  }
  DecidedBy decided_by() const {
    return std::visit([](const auto& of) { return of.decided_by; }, answer);
  }
  const Cost& cost() const {
    return std::visit([](const auto& of) -> const Cost& { return of.cost; }, answer);
  }
};

struct PartPair {
  std::uint32_t body_a = 0, body_b = 0;  // body_a < body_b
  std::uint32_t part_a = 0, part_b = 0;
  solid::RoundAnswer answer;                     // of the shapes
  std::shared_ptr<const PairAsMeshes> meshes{};  // where these are not apart, and one stands for a mesh: what holds
  bool by_boxes = false;                         // the boxes are apart: no method was called, and answer.cost is zero
  bool counts = false;                           // they meet, and it is not known to be in a way that is allowed
  Relation relation = Relation::none;  // of a pair that meets: touching or overlapping, where that is asked for; of
                                       // meshes also one inside of the other or a part of it, or equal

  Verdict verdict() const { return meshes ? meshes->verdict() : answer.verdict(); }
  bool meet() const { return verdict() == Verdict::meet; }
  bool undecided() const { return verdict() == Verdict::undecided; }
  DecidedBy decided_by() const {
    return meshes ? std::max(answer.decided_by, meshes->decided_by()) : answer.decided_by;
  }
  Cost cost() const;  // of both
};

// What the part is as a mesh: its mesh, or its surface. Null where it has a radius.
const solid::Mesh* mesh_of(const Part& part);

// A common point of two parts that meet, rounded. Requires the parts that the pair is of.
Point3 rounded_common_point(const PartPair& pair, const Part& a, const Part& b);

struct Counts {
  std::uint64_t parts = 0;
  std::uint64_t pairs = 0;           // of parts of different bodies
  std::uint64_t allowed = 0;         // of these, not tested because of question.allowed
  std::uint64_t by_boxes = 0;        // parted by their boxes
  std::uint64_t by_method = 0;       // given to the method; pairs = allowed + by_boxes + by_method
  std::uint64_t undecided = 0;       // of these, those where it is not known whether they meet
  std::uint64_t meeting = 0;         // of these, found to meet
  std::uint64_t touching_only = 0;   // of those, touching where touching is allowed
  std::uint64_t surfaces_alone = 0;  // apart as meshes, of which one has an open piece: what it seems to enclose is not
                                     // asked about

  bool some_meet() const { return meeting > touching_only; }
  bool none_meet() const { return !some_meet() && undecided == 0; }  // all are known to be apart, or allowed
  bool leave_some_open() const { return undecided > 0 || surfaces_alone > 0; }
};

// What is listed of all pairs, in the order of S3, and how many there are of each kind.
template <class Pair, class CountsOfPairs>
struct [[nodiscard]] PairsAnswer {
  std::vector<Pair> pairs;
  CountsOfPairs counts;

  bool some_meet() const { return counts.some_meet(); }
  bool none_meet() const { return counts.none_meet(); }
  std::string_view verdict() const { return some_meet() ? "some" : none_meet() ? "none" : "undecided"; }
};

// Listed is all that the method was asked about; with every_pair all but the allowed.
using Answer = PairsAnswer<PartPair, Counts>;

// Requires indices of bodies in `allowed` to be in range. Throws Error: bad_pose where a part with a radius is at a
// pose that scales or shears.
// Cost for n parts: n log n, one method call for each pair whose boxes meet; n^2 with every_pair.
Answer meeting_pairs(std::span<const Body> bodies, const Question& question = {});

}  // namespace sunder::scene
