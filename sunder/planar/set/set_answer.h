// What questions about the members of a set are answered with: do any two have a contact that counts, which have one,
// how many are there?
#pragma once

#include <sunder/base/cost.h>

#include <algorithm>
#include <cstdint>
#include <optional>
#include <vector>

namespace sunder::planar {

// Two members, and how they meet.
template <class Kind>
struct ContactOfTwo {
  std::uint32_t i = 0, j = 0;  // i < j
  Kind kind = Kind::none;      // of a contact that was found never none
  friend auto operator<=>(const ContactOfTwo&, const ContactOfTwo&) = default;
};

// i and j in any order.
template <class Kind>
ContactOfTwo<Kind> contact_of(std::uint32_t i, std::uint32_t j, Kind kind) {
  return {std::min(i, j), std::max(i, j), kind};
}

template <class Found>
struct [[nodiscard]] AnyAnswer {
  std::optional<Found> found;  // a contact that counts; empty: there is none
  Cost cost;                   // each question says what its probes are

  bool meet() const noexcept { return found.has_value(); }
};

template <class Found>
struct [[nodiscard]] AllAnswer {
  std::vector<Found> contacts;
  Cost cost;
};

struct [[nodiscard]] CountAnswer {
  std::uint64_t count = 0;
  Cost cost;
};

}  // namespace sunder::planar
