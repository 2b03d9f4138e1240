#include <sunder/base/interruption.h>
#include <sunder/polytope/hull/pulling.h>

#include <algorithm>

namespace sunder::polytope {

namespace {

class Pulling {
 public:
  Pulling(std::uint64_t most, std::vector<std::uint32_t>& simplices) : most_(most), simplices_(simplices) {}

  // Adds the simplices of a face, of `corners` each and those pulled before; false where there are too many.
  bool add(const Bits& face, const std::vector<Bits>& others, std::size_t corners) {
    if (size_of(face) == corners) {
      if (most_-- == 0) return false;
      simplices_.insert(simplices_.end(), pulled_.begin(), pulled_.end());
      for_each(face, [&](std::uint32_t vertex) { simplices_.push_back(vertex); });
      return true;
    }
    const std::vector<Bits> facets = facets_of(face, others, corners - 1);
    const std::uint32_t apex = least_of(face);
    pulled_.push_back(apex);
    const bool is_done = std::all_of(facets.begin(), facets.end(), [&](const Bits& facet) {
      return has(facet, apex) || add(facet, facets, corners - 1);
    });
    pulled_.pop_back();
    return is_done;
  }

  std::uint64_t left() const { return most_; }

 private:
  // The greatest of what the face has in common with others that do not hold it, of that many vertices at least.
  std::vector<Bits> facets_of(const Bits& face, const std::vector<Bits>& others, std::size_t least) {
    std::vector<Bits> result;
    for (const Bits& other : others) {
      common_ = face;
      keep_common(common_, other);
      if (size_of(common_) < least || common_ == face) continue;
      if (std::any_of(result.begin(), result.end(), [&](const Bits& facet) { return is_within(common_, facet); })) {
        continue;
      }
      std::erase_if(result, [&](const Bits& facet) { return is_within(facet, common_); });
      result.push_back(common_);
    }
    return result;
  }

  std::uint64_t most_;
  std::vector<std::uint32_t> pulled_;
  Bits common_;
  std::vector<std::uint32_t>& simplices_;
};

}  // namespace

bool pulled_simplices(std::size_t d, std::span<const Bits> facets, std::span<const std::vector<std::uint32_t>> next,
                      std::uint64_t most, std::vector<std::vector<std::uint32_t>>& simplices) {
  for (std::size_t f = 0; f < facets.size(); ++f) {
    may_be_interrupted(100);
    std::vector<Bits> others;
    for (const std::uint32_t other : next[f]) others.push_back(facets[other]);
    simplices.emplace_back();
    Pulling pulling(most, simplices.back());
    if (!pulling.add(facets[f], others, d)) return false;
    most = pulling.left();
  }
  return true;
}

}  // namespace sunder::polytope
