// Shamos & Hoey 1976, Theorem 8, by Algorithm 1. The proof, and what is not as in the paper, is in the header.
//
// Discs are numbered anew by their centres' ordinates: ranks. The list along the line is a set of ranks, whose order
// never changes, whatever meets. So the tests of neighbours need not be made at once: they are gathered, and their
// discs fetched, before some of them are tested together.
#include <sunder/base/prefetch.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/sweep/keyed_order.h>
#include <sunder/planar/sweep/rank_set.h>
#include <sunder/predicate/disc/discs.h>

#include <algorithm>
#include <array>

namespace sunder::planar {

namespace {

// The discs from low to high, by their centres; at one height by number.
std::vector<std::uint32_t> by_height(const Discs& circles) {
  std::vector<KeyedItem> items;
  items.reserve(circles.size());
  for (std::uint32_t i = 0; i < circles.size(); ++i) items.push_back({key_of(circles[i].center.y), i});
  sort_by_key(items, [](std::uint32_t i, std::uint32_t j) { return i < j; });
  std::vector<std::uint32_t> order(items.size());
  std::transform(items.begin(), items.end(), order.begin(), [](const KeyedItem& e) { return e.item; });
  return order;
}

// The ends of discs from left to right: 2 k the first of disc k, 2 k + 1 the last. At one abscissa the first ends come
// first, and of these, as of last ends, the lower number. Keys are rounded abscissas: where they differ, they decide.
std::vector<KeyedItem> ends_from_left(const std::vector<Disc>& discs) {
  std::vector<KeyedItem> ends;
  ends.reserve(2 * discs.size());
  for (std::uint32_t k = 0; k < discs.size(); ++k) {
    ends.push_back({key_of(discs[k].center.x - discs[k].radius), 2 * k});
  }
  for (std::uint32_t k = 0; k < discs.size(); ++k) {
    ends.push_back({key_of(discs[k].center.x + discs[k].radius), 2 * k + 1});
  }
  sort_by_key(ends, [&discs](std::uint32_t e, std::uint32_t f) {
    const Disc &c = discs[e / 2], &d = discs[f / 2];
    const Sign sign = compare_sums(c.center.x, e % 2 == 0 ? -c.radius : c.radius,  //
                                   d.center.x, f % 2 == 0 ? -d.radius : d.radius);
    if (sign != Sign::zero) return sign == Sign::negative;
    return e % 2 != f % 2 ? e % 2 < f % 2 : e < f;
  });
  return ends;
}

class Sweep {
 public:
  Sweep(const Discs& circles, const SetOptions& options)
      : options_(options), number_(by_height(circles)), line_(circles.size()) {
    discs_.reserve(circles.size());
    for (const std::uint32_t i : number_) discs_.push_back(circles[i]);
  }

  DiscsAnswer run() {
    const std::vector<KeyedItem> ends = ends_from_left(discs_);
    for (std::size_t k = 0; k < ends.size() && !answer_.meet(); ++k) {
      tell_progress(options_, k, k, ends.size());
      const std::uint32_t end = ends[k].item, disc = end / 2;
      const std::uint32_t below = line_.before(disc), above = line_.after(disc);
      if (end % 2 == 0) {
        line_.insert(disc);
        gather(below, disc);
        gather(disc, above);
      } else {
        line_.erase(disc);
        gather(below, above);
      }
    }
    test_gathered();
    return answer_;
  }

 private:
  void gather(std::uint32_t below, std::uint32_t above) {
    if (below == RankSet::none || above == RankSet::none) return;
    prefetch(discs_[below]);
    prefetch(discs_[above]);
    pairs_[gathered_++] = {below, above};
    if (gathered_ == pairs_.size()) test_gathered();
  }

  void test_gathered() {
    for (std::size_t k = 0; k < gathered_ && !answer_.meet(); ++k) test(pairs_[k][0], pairs_[k][1]);
    gathered_ = 0;
  }

  void test(std::uint32_t below, std::uint32_t above) {
    ++answer_.cost.probes;
    const Disc &c = discs_[below], &d = discs_[above];
    const DiscContact kind = disc_disc(c, d);
    if (!counts(kind, options_.allowed)) return;
    answer_.found = contact_of(number_[below], number_[above], kind);
  }

  const SetOptions& options_;
  const std::vector<std::uint32_t> number_;  // of each rank
  std::vector<Disc> discs_;                  // by rank
  RankSet line_;
  std::array<std::array<std::uint32_t, 2>, 64> pairs_;  // to be tested
  std::size_t gathered_ = 0;
  DiscsAnswer answer_;
};

}  // namespace

DiscsAnswer discs_any_by_sweep(const Discs& circles, const SetOptions& options) {
  check_groups(options.groups, circles.size());
  if (options.groups.empty()) return Sweep(circles, options).run();
  return first_of<DiscsContact>([&](const DiscsVisitor& visit) { return discs_all_by_sweep(circles, options, visit); });
}

}  // namespace sunder::planar
