// The rules by which claims are checked: docs/claims.md, "Rules". They know tables and claims, and no question. Each
// throws Refused, with its name, where the claim does not hold.
#pragma once

#include <verifier/cpp/reader.h>
#include <verifier/cpp/tables.h>

#include <array>
#include <compare>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder_verifier {

struct WeightList {
  std::vector<std::size_t> named;
  Numbers values;
};

// A triangle of a face: its first corner, this one and the next; or no face.
struct FaceHome {
  std::size_t face = no_index, corner = 0;
};

struct SweepEvents {
  std::vector<std::int64_t> at;     // an end: 2 i or 2 i + 1; or -1
  std::vector<std::int64_t> below;  // a segment, or -1
  std::vector<std::size_t> begin;   // event k has the segments row[begin[k]] to row[begin[k + 1]]
  std::vector<std::size_t> row;
};

// Two entries of a table, and a kind of contact.
struct StatedContact {
  std::size_t i = 0, j = 0;
  std::string kind;

  friend auto operator<=>(const StatedContact&, const StatedContact&) = default;
};

// Of the named entries; takes the steps. Requires that they are positive: refuses by "weights".
// exponent_of: of what they are weights of; these are then in one unit.
template <class ExponentOf>
Integers positive_weights(const WeightList& list, const ExponentOf& exponent_of) {
  const std::size_t whole = length(list.values);
  take_steps(list.values.size() / 4 + 1, whole, whole);
  Numbers values = list.values;
  for (std::size_t k = 0; k < values.size(); ++k) values[k].e += exponent_of(list.named[k]);
  Integers weights = common(values).integers;
  for (const Integer& weight : weights) require(weight > 0, "weights", "a weight is not positive");
  return weights;
}

struct EndOnLine {
  Numbers point;
  std::size_t side = 0;
};

// A point of a body: of a hull, with a radius or without, one of its core, which the weights make; of others any, which
// the body holds by them.
struct SurfaceEnd {
  WeightList weights;
  Numbers point, from;  // not of a hull; from: of an ellipsoid only
};

// A point of A less one of B.
struct SurfaceCorner {
  SurfaceEnd of_a, of_b;
};

// What a claim brings; the rest is empty.
struct Claim {
  Numbers direction;
  WeightList weights;
  Numbers from;  // of an ellipsoid only
  std::array<std::optional<EndOnLine>, 2> ends;
  SweepEvents events;
  std::vector<std::size_t> order, cones, sectors, along;  // of sectors some are no_index
  std::vector<std::size_t> simplices;                     // likewise
  std::vector<FaceHome> homes;
  std::vector<std::vector<std::size_t>> parts;
  Numbers at;                               // of a polytope of half-spaces
  WeightList of_a, of_b;                    // multipliers of half-spaces
  std::vector<Numbers> planes_a, planes_b;  // half-spaces around polytopes of points
  WeightList multipliers;
  std::vector<std::vector<std::vector<std::size_t>>> fans;  // of vertices, cones of half-spaces
  std::vector<SurfaceCorner> corners;
  std::vector<std::array<std::size_t, 3>> triangles;
};

// What does not count.
struct AllowedContacts {
  bool shared_endpoint = false, touch = false;
};

void check_parted(const Claim& claim, const HullBody& a, const HullBody& b);
void check_parted_weakly(const Claim& claim, const HullBody& a, const HullBody& b);
void check_holds(const Claim& claim, const HullBody& body, const Numbers& point);
void check_slab(const HullBody& a, const HullBody& b, const Numbers& from_a, const Numbers& to_b);
void check_clear(const Claim& claim, const HullBody& a, const HullBody& b, const Number& least);
void check_nearer(const Numbers& from_a, const Numbers& to_b, const Number& least);
void check_inside(const Claim& claim, const HullBody& body, const Numbers& point);

// How deep bodies are in each other (check_surrounds: depth_rules.cpp).
void check_leaves(const Claim& claim, const HullBody& a, const HullBody& b, const Number& most);
void check_surrounds(const Claim& claim, const HullBody& a, const HullBody& b, const Number& least);

// Of bodies that move straight to another place (motion_rules.cpp).
struct StatedMotion {
  const HullBody *begin = nullptr, *end = nullptr;
};
void check_parted_all_along(const Claim& claim, const StatedMotion& a, const StatedMotion& b);
void check_holds_at(const Claim& claim, const StatedMotion& body, const Number& time, const Numbers& point);
void check_not_before(const Claim& claim, const StatedMotion& a, const StatedMotion& b, const Number& time,
                      const Numbers& point);
// Of all of a body, is none further along the direction than the point x, .., w? No way of it leads on.
bool is_behind(const char* rule, const HullBody& body, const Integers& direction, const Integers& place);

// Of polytopes (polytope_rules.cpp).
void check_parted_by(const Claim& claim, const RowBody& a, const RowBody& b);
void check_parted_by_hyperplanes(const Claim& claim, const RowBody& a, const RowBody& b);
void check_keeps(const Claim& claim, const RowBody& body, const Numbers& point);

// Of half-spaces, which are not placed (half_space_rules.cpp).
void check_contradicted(const Claim& claim, const RowBody& given);
void check_spans(const Claim& claim, const RowBody& given, std::size_t dimension, const std::vector<Numbers>& points);
void check_enclosed(const Claim& claim, const RowBody& given);
void check_recedes(const Claim& claim, const RowBody& given);
void check_rises(const Claim& claim, const RowBody& given, const Numbers& objective);
void check_tops(const Claim& claim, const RowBody& given, const Numbers& objective, const Numbers& point);
void check_tops_only(const Claim& claim, const RowBody& given, const Numbers& objective, const Numbers& point);
// Cones of half-spaces that end in each vertex (vertex_rules.cpp).
void check_normal_fan(const Claim& claim, const RowBody& given, const std::vector<Numbers>& vertices);
void check_another(const Numbers& objective, const Numbers& point, const Numbers& as_good);

void check_surface(const Claim& claim, const HullBody& body, const std::vector<std::vector<std::size_t>>& faces);
void check_outline(const Claim& claim, const HullBody& body, const std::vector<std::size_t>& outline);
void check_between(const HullBody& body, std::size_t i, std::size_t j);
void check_one_point(const HullBody& body);
// Facets are lists of simplices, which are lists of corners (boundary_rules.cpp).
void check_boundary(const Claim& claim, const HullBody& body,
                    const std::vector<std::vector<std::vector<std::size_t>>>& facets);
// Is the point on the segment between the other two, or, where these are one, there?
bool is_between(const Integers& first, const Integers& last, const Integers& point);

// What statements `hull` before have proved, by the indices of their bodies: of a flat one the outline is the one face,
// of a segment its two ends are.
struct ProvedHull {
  std::string verdict;
  std::vector<std::vector<std::size_t>> faces;
};
using ProvedHulls = std::map<std::size_t, ProvedHull>;

// The points x with normal x = level.
struct StatedPlane {
  Integers normal;
  Integer level;
};
void check_beyond(const HullBody& body, const StatedPlane& plane);
void check_touches(const HullBody& body, const StatedPlane& plane,
                   const std::vector<std::pair<std::size_t, std::size_t>>& corners);
void check_outlined(const Claim& claim, const HullBody& body, const StatedPlane& plane,
                    const std::vector<std::pair<std::size_t, std::size_t>>& corners, const ProvedHulls& proved);

// What statements `pair` before have proved, by the indices of their bodies.
struct ProvedPair {
  bool is_apart = false, meet = false, touch = false, overlap = false;
};
using ProvedPairs = std::map<std::pair<std::size_t, std::size_t>, ProvedPair>;

// Two bodies, and the number n 2^e, n odd, that a statement `clearance` before says they are apart, or more; or nearer.
struct ProvedClearance {
  std::size_t a = 0, b = 0;
  Integer n;
  std::int64_t e = 0;
  bool is_kept = false;
  auto tied() const { return std::tie(a, b, e, n, is_kept); }
  bool operator<(const ProvedClearance& other) const { return tied() < other.tied(); }
};
using ProvedClearances = std::set<ProvedClearance>;

struct Proved {
  ProvedPairs pairs;
  ProvedClearances clearances;
  ProvedHulls hulls;
};

struct AllPairs {
  std::vector<std::size_t> members;                          // bodies
  std::vector<std::pair<std::size_t, std::size_t>> besides;  // pairs of members that it does not speak of
};

// groups: empty, or one for each member.
void check_each_pair(const AllPairs& pairs, const std::vector<std::int64_t>& groups, const AllowedContacts& allowed,
                     const ProvedPairs& proved, const std::vector<StatedContact>& contacts);

// least: as of ProvedClearance.
void check_each_clearance(const AllPairs& pairs, const std::vector<std::int64_t>& groups, const Number& least,
                          const ProvedClearances& proved, const std::vector<StatedContact>& nearer);

void check_feasible(const Tables& tables, const Numbers& point);
void check_bounds(const Claim& claim, const Tables& tables, const Numbers& objective, const Numbers& point);
void check_bounds_only(const Claim& claim, const Tables& tables, const Numbers& objective, const Numbers& point);
void check_no_objective(const Numbers& objective);
void check_contradict(const Claim& claim, const Constraints& given);
void check_goes_on(const Claim& claim, const Tables& tables, const Numbers& objective);
void check_ends(const Claim& claim, const Tables& tables, const Numbers& objective, const Numbers& point);

// groups: empty, or one for each segment.
void check_contact(const std::vector<PlanarSegment>& segments, std::int64_t exponent, std::size_t bits,
                   const StatedContact& contact, const Numbers& point, const std::vector<std::int64_t>& groups,
                   const AllowedContacts& allowed);
void check_common_point(const Tables& tables, const StatedContact& contact, const Numbers& point,
                        const std::vector<std::int64_t>& groups, const AllowedContacts& allowed);

enum class ValidRule : std::uint8_t { valid, simple, with_self_touch };

void check_valid(const Claim& claim, const PartTable& parts, ValidRule rule);
void check_falls_apart(const Claim& claim, const PartTable& parts);
void check_too_few_points(const PartTable& parts, std::size_t ring);
void check_comes_twice(const PartTable& parts, ValidRule rule, std::size_t ring, const Numbers& point);
void check_crosses(const PartTable& parts, std::size_t ring, const Numbers& point);
void check_misplaced(const PartTable& parts, std::size_t ring, const Numbers& point);
void check_circle(const PartTable& parts, const std::vector<std::size_t>& rings, const std::vector<Numbers>& points);
void check_repeated(const PartTable& parts, ValidRule rule, std::size_t edge);
void check_rings_touch(const PartTable& parts, ValidRule rule, std::size_t ring, std::size_t other,
                       const Numbers& point);

// Told of each two whose contact counts, once: i < j, and the kind, empty for polygons.
using VisitContact = std::function<void(std::size_t i, std::size_t j, const char* kind)>;
using ContactsOf = std::function<void(const VisitContact&)>;
// All contacts by the sweep that the claim brings. Keep references.
ContactsOf contacts_of_segments(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                                const AllowedContacts& allowed);
ContactsOf contacts_of_polygons(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                                const AllowedContacts& allowed);

// Those that count are those listed, by i, then j; or are so many. Refuses by that rule.
void check_listed(const char* rule, const ContactsOf& contacts, const std::vector<StatedContact>& listed);
void check_number(const char* rule, std::uint64_t count, std::uint64_t number);

// How many contacts there are: visited; of segments, in time of those at each event.
std::uint64_t number_of(const ContactsOf& contacts);
std::uint64_t number_of_segments(const Claim& claim, const Tables& tables, const std::vector<std::int64_t>& groups,
                                 const AllowedContacts& allowed);

// These bound the common part of the half-planes, which is of that kind.
void check_cones(const Claim& claim, const Constraints& given, const std::string& verdict,
                 const std::vector<std::size_t>& sides);

void check_in_discs(const Tables& tables, const Numbers& point, bool is_region);
void check_powers(const Claim& claim, const Tables& tables, bool is_point);
void check_arcs(const Claim& claim, const Tables& tables, const Numbers& point, const std::vector<std::size_t>& arcs);

// Of the members of a set (member_rules.cpp).
bool is_kind_of_full(const std::string& kind);  // is it a kind of contact of two full ones?
template <class Member>
void check_member_contact(const MemberTable<Member>& members, const StatedContact& contact, const Numbers& point,
                          const std::vector<std::int64_t>& groups, const AllowedContacts& allowed);
// The contacts that count are those listed, or are so many.
template <class Member>
void check_cover(const Claim& claim, const MemberTable<Member>& members, const std::vector<std::int64_t>& groups,
                 const AllowedContacts& allowed, const std::vector<StatedContact>& listed);
template <class Member>
void check_cover_number(const Claim& claim, const MemberTable<Member>& members, const std::vector<std::int64_t>& groups,
                        const AllowedContacts& allowed, std::uint64_t number);

}  // namespace sunder_verifier
