// What counts as a contact of two segments of a set.
#pragma once

#include <sunder/planar/pair/segment_segment.h>

#include <cstdint>
#include <span>
#include <string_view>

namespace sunder::planar {

// What does not count as a contact. Each allows what the one before does.
enum class Allowed : std::uint8_t {
  nothing,
  shared_endpoint,  // one common point that is an end of both: roads at a junction, consecutive edges
  touch,            // any contact in one point that is an end of one of them
};

std::string_view name_of(Allowed);  // "shared-endpoint"
bool counts(ContactKind kind, Allowed allowed);

// A group for each segment, as numbers: the members of one (the same net, ring, road) may meet and cross one another.
// Empty: there are none. Kept by reference.
using Groups = std::span<const std::uint32_t>;

inline bool may_meet(Groups groups, std::uint32_t i, std::uint32_t j) {
  return !groups.empty() && groups[i] == groups[j];
}

}  // namespace sunder::planar
