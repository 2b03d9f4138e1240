// Chains of pieces, merged pair by pair until there is one.
// Also called: divide and conquer; merging bottom-up.
#pragma once

#include <sunder/base/interruption.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace sunder::planar {

// Chains one after the other; `ends` tells where each ends. merge(p, q, out) appends the merged one. Cost: as many
// rounds as the logarithm of their number.
template <class Piece, class Merge>
std::vector<Piece> merged_in_pairs(std::vector<Piece> chains, std::vector<std::size_t> ends, const Merge& merge) {
  std::vector<Piece> next;
  std::vector<std::size_t> next_ends;
  while (ends.size() > 1) {
    next.clear();
    next_ends.clear();
    const std::span<const Piece> all(chains);
    std::size_t begin = 0;
    for (std::size_t k = 0; k < ends.size(); k += 2) {
      const auto first = all.subspan(begin, ends[k] - begin);
      may_be_interrupted(static_cast<std::uint32_t>(std::min<std::size_t>(ends[k] - begin, 1u << 20)));
      begin = ends[k];
      if (k + 1 == ends.size()) {
        next.insert(next.end(), first.begin(), first.end());
      } else {
        merge(first, all.subspan(begin, ends[k + 1] - begin), next);
        begin = ends[k + 1];
      }
      next_ends.push_back(next.size());
    }
    chains.swap(next);
    ends.swap(next_ends);
  }
  return chains;
}

}  // namespace sunder::planar
