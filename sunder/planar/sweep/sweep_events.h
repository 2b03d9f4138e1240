// What a sweep over segments met, point by point: the evidence of statements about sets (docs/claims.md, "Sweeps").
// Also called: event points of a plane sweep; trace.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

inline constexpr std::uint32_t no_segment = 0xffffffffu, at_crossing = 0xffffffffu;

// Event k is at the point of at[k]: the first end of segment i for 2 i, its last for 2 i + 1; or, for at_crossing,
// where the first and the last of what goes on cross. below[k] is the segment just below the point, or no_segment.
struct SweepEvents {
  std::vector<std::uint32_t> at, below;
  std::vector<std::uint32_t> begin{0};  // of what goes on from event k in `row`; one entry more than events
  std::vector<std::uint32_t> row;

  std::size_t size() const { return at.size(); }
  friend bool operator==(const SweepEvents&, const SweepEvents&) = default;
  bool empty() const { return at.empty(); }
  std::size_t entries() const { return 2 * at.size() + row.size(); }  // numbers in a file
  std::span<const std::uint32_t> goes_on(std::size_t k) const {
    return std::span(row).subspan(begin[k], begin[k + 1] - begin[k]);
  }

  // What goes on is added to `row` before.
  void add(std::uint32_t end, std::uint32_t lower) {
    at.push_back(end);
    below.push_back(lower);
    begin.push_back(static_cast<std::uint32_t>(row.size()));
  }
};

}  // namespace sunder::planar
