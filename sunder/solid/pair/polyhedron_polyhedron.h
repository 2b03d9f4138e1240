// Do two placed convex polyhedra meet?
//
// The objects are closed: touching is meeting. The answer is exactly right for the doubles given, and comes with its
// certificate.
//   P1. The verdict is that of the exact images of the vertices under the poses.
//   P2. Swapping the objects, and scaling or shifting both exactly, does not change the verdict.
//   P3. The certificate passes the absolute check of certificate/check.h.
//   P4. The answer, the certificate and the counts are the same for every compiler, thread count and vector unit.
// All methods have one signature. None throws, and none allocates while filters decide.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/pair.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/object/pose.h>

#include <cstdint>
#include <string_view>

namespace sunder {

// How an answer came about.
enum class DecidedBy : std::uint8_t {
  filter,     // the search's evidence in doubles, accepted by filters alone
  evidence,   // the search's evidence, made or accepted with the help of exact arithmetic
  finishing,  // an exact method, because the search's evidence did not hold
};

std::string_view name_of(DecidedBy);

// Where two objects that meet have their common points.
enum class Contact : std::uint8_t {
  none,         // apart
  touching,     // they meet, but their relative interiors do not: some plane parts them weakly
  overlapping,  // their relative interiors meet
};

std::string_view name_of(Contact);

namespace solid {

struct PairAnswer {
  PairCertificate evidence;
  DecidedBy decided_by = DecidedBy::filter;
  Cost cost;

  bool meet() const { return evidence.verdict == Verdict::meet; }
  const PairCertificate& certificate() const { return evidence; }
};

// The front door: the fastest method measured.
PairAnswer polyhedron_polyhedron(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                 const ConvexPolyhedron& b, const Pose& pose_b);

// By a floating-point search over the vertex graph (Gilbert, Johnson, Keerthi 1988), which proposes evidence, and an
// exact simplex method with the graph as its pricing for what the search could not certify.
PairAnswer polyhedron_polyhedron_by_gjk(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                        const ConvexPolyhedron& b, const Pose& pose_b);

// By one exact linear program over all vertices: slow and obvious, the oracle of the others. O(n) memory.
PairAnswer polyhedron_polyhedron_by_scan(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                         const ConvexPolyhedron& b, const Pose& pose_b);

// Touching or overlapping? May cost more than the question whether they meet.
Contact polyhedron_polyhedron_contact(const ConvexPolyhedron& a, const Pose& pose_a,  //
                                      const ConvexPolyhedron& b, const Pose& pose_b);

}  // namespace solid

// The front door under its short name.
inline solid::PairAnswer intersect(const solid::ConvexPolyhedron& a, const solid::Pose& pose_a,
                                   const solid::ConvexPolyhedron& b, const solid::Pose& pose_b) {
  return solid::polyhedron_polyhedron(a, pose_a, b, pose_b);
}
inline solid::PairAnswer intersect(const solid::ConvexPolyhedron& a, const solid::ConvexPolyhedron& b) {
  return solid::polyhedron_polyhedron(a, solid::Pose(), b, solid::Pose());
}

}  // namespace sunder
