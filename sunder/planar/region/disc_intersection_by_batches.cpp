// Batches that double: a disc of the second half is compared once with a box around the common part of the first half.
#include <sunder/base/random.h>
#include <sunder/planar/region/discs_prepared.h>
#include <sunder/predicate/disc/disc_powers.h>

#include <algorithm>
#include <numeric>

namespace sunder::planar {

DiscIntersection disc_intersection_by_batches(const Discs& circles) {
  return circles_part(circles, [](const std::vector<Disc>& discs, ArcChains& chains, Cost& cost) {
    constexpr std::size_t first_batch = 16;
    std::vector<std::uint32_t> order(discs.size());
    std::iota(order.begin(), order.end(), 0u);
    Random random(13);
    for (std::size_t k = order.size(); k > 1; --k) std::swap(order[k - 1], order[random.below(k)]);
    const std::span<const std::uint32_t> all(order);
    std::size_t done = std::min(first_batch, all.size());
    std::vector<ArcPiece> part = chains.divide(all.first(done)), next;
    std::vector<std::uint32_t> left;
    while (done < all.size()) {
      const std::size_t batch = std::min(done, all.size() - done);
      const PowerBound box{chains.box(part), 0};
      left.clear();
      for (const std::uint32_t k : all.subspan(done, batch)) {
        if (!is_surely_less(discs[k], box)) left.push_back(k);
      }
      cost.probes += batch;
      done += batch;
      if (left.empty()) continue;
      next.clear();
      chains.merge(part, chains.divide(left), next);
      part.swap(next);
    }
    return part;
  });
}

}  // namespace sunder::planar
