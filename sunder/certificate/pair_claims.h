// Writes what is said of pairs of convex bodies into a certificate file (docs/claims.md): the table `bodies`, then
// statements `pair`, as they come.
// None throws, but for want of memory, or what the writer's sink throws.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/certificate/common_point.h>
#include <sunder/certificate/pair.h>
#include <sunder/predicate/disc/round_kind.h>

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sunder {

// The way from one point to another, which a body goes on for ever.
struct Way3 {
  Point3 from, to;
};

// What is said of all pairs of some bodies.
struct AllPairs {
  std::vector<std::uint32_t> members, groups;  // a group for each
  // For each member the mesh of the file that it stands for, or nothing. The mesh is placed as the member is, and a
  // statement before says that the member's body holds all points of the mesh. Empty: no member stands for a mesh.
  std::vector<std::optional<std::uint32_t>> as_meshes{};
  bool touching_allowed = false;
  std::vector<std::array<std::uint32_t, 2>> besides, contacts;
};

// First what the file itself takes (ClaimsWriter::add_origin), then bodies, then pairs, then end(). Nothing is looked
// at again but vertices and poses, for the exact weights of common points. In the plane, third coordinates are zero and
// not written. A name that is empty is written as "unnamed".
class PairClaims {
 public:
  enum class Space : std::uint8_t { planar, solid };

  // Keeps a reference to the file.
  explicit PairClaims(ClaimsWriter& file, Space space = Space::solid) : file_(file), space_(space) {}

  ClaimsWriter& file() const { return file_; }  // for statements that are written elsewhere
  void go_to_statements();                      // ends the table, before such a statement
  void begin_statement(const char* question, std::uint32_t a, std::uint32_t b, const char* verdict);
  void add_combination(const char* claim, const Combination& combination);  // a claim of these weights

  // Adds a body to the table; returns its index. Keeps the span of its vertices, which must stay as they are.
  std::uint32_t add_body(const std::string& name, std::span<const Point3> vertices, std::span<const Way3> ways = {});

  // Adds a body with a radius; returns its index. Keeps the span of its core. Requires Space::solid, a radius that is
  // finite and not negative, and a core of one point at least: two of a cylinder or cone, which differ, also where they
  // are placed, and one of an ellipsoid.
  std::uint32_t add_round_body(const std::string& name, std::span<const Point3> core, RoundKind kind, double radius);

  // Adds a placed body; returns its index. One under its own name where it is stands in the table already. Requires a
  // body that add_body or add_round_body gave.
  std::uint32_t add_placed(const std::string& name, std::uint32_t body, const Affine3& pose);

  // Adds an answer about two of these. It must be true: its exact weights are computed here.
  void add_pair(std::uint32_t a, std::uint32_t b, const PairCertificate& certificate);

  // Adds statements whose proof is known: that A is less far along the direction than B; that both hold the point; that
  // they do, and that A is not further along the direction; that it is inside of both. Of bodies with a radius, too.
  void add_apart(std::uint32_t a, std::uint32_t b, const std::array<Dyadic, 3>& direction);
  void add_meet(std::uint32_t a, std::uint32_t b, const CommonPoint& point);
  void add_touching(std::uint32_t a, std::uint32_t b, const CommonPoint& point, const std::array<Dyadic, 3>& direction);
  void add_overlapping(std::uint32_t a, std::uint32_t b, const CommonPoint& point);

  // That A and B, which go straight to where to_a and to_b are, are apart all along, as along the direction; that they
  // have the point at the time; that this is the first such time, which is not 0, as along the direction (of
  // which they are before it, and not then). Requires to_a and to_b to be a and b, moved: of one matrix; a time from 0
  // to 1.
  void add_motion_apart(std::uint32_t a, std::uint32_t b, std::uint32_t to_a, std::uint32_t to_b,
                        const std::array<Dyadic, 3>& direction);
  void add_motion_meet(std::uint32_t a, std::uint32_t b, std::uint32_t to_a, std::uint32_t to_b,
                       const ExactFraction& time, const CommonPoint& point,
                       const std::array<Dyadic, 3>* first_along = nullptr);

  // That A and B, which is on a line, have in common what is between two points: one of A and B ends at the first along
  // `before`, and at the last along `after`, the other way of the line. Requires that B is no point.
  void add_common_part(std::uint32_t a, std::uint32_t b, const CommonPoint& first, const CommonPoint& last,
                       const std::array<Dyadic, 3>& before, const std::array<Dyadic, 3>& after);

  // That of the points of A none is nearer to B, a hyperplane or half-space, or further within it, than that vertex:
  // along the direction, which is perpendicular to B, out of a half-space, A begins there.
  void add_nearest(std::uint32_t a, std::uint32_t b, std::uint32_t vertex, const std::array<Dyadic, 3>& direction);

  // B lies on a line; each function states which planes through it support A. add_two_supports: two planes have all of
  // A on one side, and the named points of A beside the line lie on them; the directions point out of A.
  // add_one_support: one plane has all of A on one side. add_no_support: no plane has, because the point of B is inside
  // A, of which four points are not in one plane. Requires Space::solid, and A without ways and radius.
  void add_two_supports(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> on_first,
                        std::span<const std::uint32_t> on_last, const std::array<Dyadic, 3>& before,
                        const std::array<Dyadic, 3>& after);
  void add_one_support(std::uint32_t a, std::uint32_t b, std::span<const std::uint32_t> on_plane,
                       const std::array<Dyadic, 3>& direction);
  void add_no_support(std::uint32_t a, std::uint32_t b, const CommonPoint& point,
                      const std::array<std::uint32_t, 4>& spanning);

  // That the points are as near to each other as any two of A and B. Requires different ones, and no body with a
  // radius.
  void add_distance(std::uint32_t a, std::uint32_t b, const PointOf& from_a, const PointOf& to_b);

  // That A and B are `least` apart, or more, as along the direction from A to B; that two of their points are nearer
  // than that. Requires a positive finite `least`.
  void add_clearance(std::uint32_t a, std::uint32_t b, double least, const std::array<Dyadic, 3>& direction);
  void add_clearance_broken(std::uint32_t a, std::uint32_t b, double least, const PointOf& from_a, const PointOf& to_b);

  // That of each two of these bodies, which are of different groups, but for those besides, it is stated before whether
  // they meet; and that these do (which, where touching is allowed, overlap). Pairs are positions in `members`, the
  // first less than the second, in order.
  void add_all_pairs(const AllPairs& pairs);

  // That each two of these bodies, likewise, are stated before to be `least` apart, or more, or to be nearer; and that
  // the latter are those of `contacts`. Touching is neither. Requires a positive finite `least`.
  void add_all_clearances(const AllPairs& pairs, double least);

  // The common point that evidence of meeting names. Its weights are all positive.
  CommonPoint common_point(std::uint32_t a, std::uint32_t b, const CommonVertices& evidence) const;

  bool states_something() const { return states_something_; }

  // Ends the file. (One without statements states nothing, and is refused by checkers.)
  void end();

 private:
  struct Entry {
    std::string name;
    std::span<const Point3> vertices;
    Affine3 pose;
  };
  std::size_t dimension() const { return space_ == Space::planar ? 2 : 3; }
  void begin_entry(const std::string& name);
  void add_points_of_entry(std::span<const Point3> points);
  void begin_motion(std::uint32_t a, std::uint32_t b, std::uint32_t to_a, std::uint32_t to_b, const char* verdict);
  void add_parting(const char* claim, const std::array<Dyadic, 3>& direction);
  void add_points(const char* claim, const PointOf& from_a, const PointOf& to_b);
  void begin_members(const char* question, const AllPairs& pairs);
  void add_pairs(const char* name, const std::vector<std::array<std::uint32_t, 2>>& pairs);
  void add_point_claims(const char* claim, const CommonPoint& point);

  ClaimsWriter& file_;
  Space space_;
  std::vector<Entry> entries_;
  bool states_something_ = false;
};

// What prove() writes of two objects of vertices (asked_pair.h): both as they are given, then where they are, then what
// `state(pairs, index_a, index_b)` states of these.
template <class Asked, class State>
void prove_pair(const TextSink& sink, const Asked& asked, PairClaims::Space space, std::span<const Point3> a,
                const Affine3& at_a, std::span<const Point3> b, const Affine3& at_b, const State& state) {
  ClaimsWriter file(sink);
  file.add_origin(asked.origin);
  PairClaims pairs(file, space);
  const std::uint32_t body_a = pairs.add_body(asked.name_a, a), body_b = pairs.add_body(asked.name_b, b);
  const std::uint32_t index_a = pairs.add_placed(asked.name_a, body_a, at_a);
  state(pairs, index_a, pairs.add_placed(asked.name_b, body_b, at_b));
  pairs.end();
}

}  // namespace sunder
