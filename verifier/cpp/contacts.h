// All contacts that count, of the entries of a table: found by a search that a claim brings, and compared with what is
// listed.
#pragma once

#include <verifier/cpp/sweep.h>
#include <verifier/cpp/values.h>

#include <cstdint>
#include <functional>
#include <string>

namespace sunder_verifier {

// Told of each two whose contact counts, once: i < j, and the kind, empty for polygons.
using VisitContact = std::function<void(std::size_t i, std::size_t j, const char* kind)>;

// Two ways to go through them: to visit each; and to count them, which may be faster.
struct Contacts {
  std::function<void(const VisitContact& visit)> visit;
  std::function<std::uint64_t()> number;
};

// A visit alone, counted one by one.
Contacts counted_one_by_one(std::function<void(const VisitContact& visit)> visit);

// These keep references. segment_rules.cpp, polygon_rules.cpp, member_rules.cpp
Contacts contacts_of(const SweepEvents& events, const Segments& segments, const Groups& groups,
                     const AllowedContacts& allowed);
Contacts contacts_of(const SweepEvents& events, const PolygonTable& polygons, const Groups& groups,
                     const AllowedContacts& allowed);
Contacts contacts_of(const Indices& order, const Circles& circles, const Groups& groups,
                     const AllowedContacts& allowed);
Contacts contacts_of(const Indices& order, const Boxes& boxes, const Groups& groups, const AllowedContacts& allowed);

// Which points a member holds, and how two of them meet; of discs and boxes the kind is empty where they do not.
bool holds(const PlanarSegment& segment, const SweepPoint& place);
bool holds(const PlanarDisc& disc, const SweepPoint& place);
bool holds(const PlanarBox& box, const SweepPoint& place);
std::string kind_of(const PlanarSegment& s, const PlanarSegment& t);  // requires that they meet
std::string kind_of(const PlanarDisc& c, const PlanarDisc& d);
std::string kind_of(const PlanarBox& a, const PlanarBox& b);

bool counts(const std::string& kind, const AllowedContacts& allowed);

// By how much a point is outside of a disc; not positive: it is in it.
Integer power_of(const PlanarDisc& disc, const SweepPoint& place);

inline Integer square(const Integer& n) { return n * n; }

}  // namespace sunder_verifier
