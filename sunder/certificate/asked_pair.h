// Two placed objects that a question is about, and what a proof of its answer says besides.
#pragma once

#include <sunder/certificate/claims.h>

#include <string>

namespace sunder {

// prove(sink, AskedPair{a, at_a, b, at_b}, answer) writes the certificate file of the answer, whole: of polygons in
// planar/pair/contact_evidence.h, of polyhedra in solid/pair/contact_evidence.h, of bodies with a radius in
// solid/round/round_claims.h, of polytopes in polytope/pair/polytope_claims.h. Keeps references to all that it is made
// with.
template <class Object, class Pose>
struct AskedPair {
  const Object& a;
  const Pose& at_a;
  const Object& b;
  const Pose& at_b;
  std::string name_a = "A", name_b = "B";
  bool tells_relation = false;  // of objects that meet: proves that they touch, or overlap (not of polytopes)
  Origin origin{};
};

}  // namespace sunder
