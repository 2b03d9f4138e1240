// The rules by which claims are checked: docs/claims.md, "Rules". They know tables and values, and no statement. Each
// throws Refused, with its name, where the claim does not hold.
#pragma once

#include <verifier/cpp/values.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace sunder_verifier {

// A claim, what it brings, "name: shape; name: shape of what", and its rule, which takes that, and then what the claim
// is bound to. In the shapes, `subject` is the first thing that it is bound to.
struct ClaimRow {
  const char *name, *brings;
  Rule rule;
};
using ClaimRows = std::vector<ClaimRow>;

// Of each file of rules, x_rules.cpp.
extern const ClaimRows claims_of_bodies, claims_of_polytopes, claims_of_hulls, claims_of_boundaries, claims_of_sections,
    claims_of_all_pairs, claims_of_meshes, claims_of_holders, claims_of_crossings, claims_of_half_planes,
    claims_of_discs, claims_of_contacts, claims_of_polygons, claims_of_valid_polygons;

// Requires that the body holds the point; `from`: of an ellipsoid only. Is it, if the body has a radius, nearer to the
// core than that?
bool holds(const WeightList& list, const Numbers& from, const HullBody& body, const Numbers& point);

// A point, less how far a body that moves straight from one place to another has come by that time.
Numbers moved_back(const Numbers& point, const Number& time, const HullBody& begin, const HullBody& end);

// Requires by that rule that along the direction, which is not zero, all of the body is further than last * 2^e, and by
// `least`, if that is not 0, in units of the direction's length; `size`: the bits of what that is made of.
struct EndOfPart {
  Integer last;
  std::int64_t e;
  std::size_t size;
};
void require_beyond(const char* rule, const EndOfPart& part, const Integers& direction, const HullBody& body,
                    const Number& least = {});

// Is the point on the segment between the other two, or, where these are one, there?
bool is_between(const Integers& first, const Integers& last, const Integers& point);

// Is it a kind of contact of the entries of that table?
bool is_kind_of(const Value& table, const std::string& kind);

}  // namespace sunder_verifier
