// The list against a plain vector.
#include <sunder/base/random.h>
#include <sunder/planar/sweep/sweep_status.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

namespace sunder::planar {
namespace {

// From an item of the list to another one, up and down, and beyond its ends.
void expect_walks(const SweepStatus<std::uint64_t>& status, const std::vector<std::uint32_t>& listed, Random& random) {
  const std::size_t from = random.below(listed.size()), to = random.below(listed.size() + 1);
  const std::uint32_t last = to < listed.size() ? listed[to] : SweepStatus<std::uint64_t>::none;
  std::vector<std::uint32_t> walked;
  const auto take = [&](std::uint32_t item) {
    if (item == last) return false;
    walked.push_back(item);
    return true;
  };
  const auto at = [&](std::size_t k) { return listed.begin() + static_cast<std::ptrdiff_t>(k); };
  if (to > from) {
    EXPECT_EQ(status.walk_up(listed[from], take), last);
    EXPECT_EQ(walked, std::vector<std::uint32_t>(at(from + 1), at(to)));
    return;
  }
  EXPECT_EQ(status.walk_down(listed[from], take), to < from ? last : SweepStatus<std::uint64_t>::none);
  std::reverse(walked.begin(), walked.end());
  EXPECT_EQ(walked, std::vector<std::uint32_t>(at(to < from ? to + 1 : 0), at(from)));
}

// Items are ordered by their keys. Grows, shrinks to nothing and grows again, so that blocks are split, dropped,
// reused.
TEST(SweepStatusTest, IsAnOrderedList) {
  Random random(101);
  constexpr std::uint32_t count = 3000;
  std::vector<std::uint64_t> key(count);
  for (std::uint64_t& k : key) k = random.next();
  SweepStatus<std::uint64_t> status(key);
  std::vector<std::uint32_t> listed, absent(count);
  std::iota(absent.begin(), absent.end(), 0u);
  const auto less = [&](std::uint32_t a, std::uint32_t b) { return key[a] < key[b]; };
  std::size_t longest = 0;
  int emptied = 0;
  for (int step = 0; step < 60000; ++step) {
    const bool growing = step / 7500 % 2 == 0;
    const bool insert = listed.empty() || (!absent.empty() && random.below(10) < (growing ? 7u : 2u));
    std::vector<std::uint32_t>& from = insert ? absent : listed;
    const std::size_t pick = random.below(from.size());
    const std::uint32_t item = from[pick];
    from.erase(from.begin() + static_cast<std::ptrdiff_t>(pick));
    const auto place = std::lower_bound(listed.begin(), listed.end(), item, less);
    const std::uint32_t below = place == listed.begin() ? SweepStatus<std::uint64_t>::none : *(place - 1);
    const std::uint32_t above = place == listed.end() ? SweepStatus<std::uint64_t>::none : *place;
    std::uint32_t asked = 0;
    const auto around = insert ? status.insert(item,
                                               [&](std::uint64_t other) {
                                                 ++asked;
                                                 return other < key[item];
                                               })
                               : status.erase(item);
    ASSERT_EQ(around.below, below) << step;
    ASSERT_EQ(around.above, above) << step;
    if (insert) {
      // Halving in the directory and in a block: blocks are at least a single item, so this is generous for few items.
      ASSERT_LE(asked, 2 * std::ceil(std::log2(static_cast<double>(listed.size() + 2))) + 6);
      listed.insert(place, item);
    } else {
      absent.push_back(item);
    }
    longest = std::max(longest, listed.size());
    emptied += listed.empty();
    if (listed.empty()) continue;
    ASSERT_EQ(status.lowest(), listed.front());
    ASSERT_EQ(status.highest(), listed.back());
    if (step % 64 == 0) expect_walks(status, listed, random);
  }
  EXPECT_GT(longest, 1000u);
  EXPECT_GT(emptied, 0);
}

// The list as a map from marks, which items get in the order of the list and exchange with each other. A key is the
// number of its item, so that one that lags behind leads a search astray.
class Marked {
 public:
  explicit Marked(std::uint32_t count) : mark_(count), key_(count), status_(key_) {
    std::iota(key_.begin(), key_.end(), 0u);
  }

  std::size_t size() const { return listed_.size(); }
  bool has(std::uint64_t mark) const { return listed_.count(mark) != 0; }
  std::uint32_t asked() const { return asked_; }

  void insert(std::uint32_t item, std::uint64_t mark) {
    ASSERT_FALSE(status_.holds(item));
    const auto is_above = [&](std::uint32_t other) {
      ++asked_;
      return mark > mark_[other];
    };
    const auto next = listed_.lower_bound(mark);
    expect(status_.around(is_above), next, next);
    asked_ = 0;
    const auto around = status_.insert(item, is_above);
    mark_[item] = mark;
    const auto place = listed_.emplace(mark, item).first;
    expect(around, place, std::next(place));
    expect_known(item);
  }
  // The same, where what stands below is known.
  void insert_above(std::uint32_t item, std::uint64_t mark) {
    const auto place = listed_.emplace(mark, item).first;
    status_.insert_above(place == listed_.begin() ? Status::none : std::prev(place)->second, item);
    mark_[item] = mark;
    expect_known(item);
  }
  void replace(std::uint32_t old, std::uint32_t item) {
    status_.replace(old, item);
    mark_[item] = mark_[old];
    listed_[mark_[item]] = item;
    expect_known(item);
    EXPECT_FALSE(status_.holds(old));
  }
  void erase(std::uint32_t item) {
    const auto place = listed_.find(mark_[item]);
    expect(status_.erase(item), place, std::next(place));
    listed_.erase(place);
    EXPECT_FALSE(status_.holds(item));
  }
  void exchange(std::uint32_t item, std::uint32_t other) {
    if (mark_[item] > mark_[other]) std::swap(item, other);
    status_.exchange(item, other);
    std::swap(mark_[item], mark_[other]);
    listed_[mark_[item]] = item;
    listed_[mark_[other]] = other;
    expect_known(item);
    expect_known(other);
  }
  void expect_known(std::uint32_t item) const {
    EXPECT_TRUE(status_.holds(item));
    const auto place = listed_.find(mark_[item]);
    expect(status_.neighbours_of(item), place, std::next(place));
  }
  // The first one from a mark on.
  std::uint32_t from(std::uint64_t mark) const {
    const auto at = listed_.lower_bound(mark);
    return at == listed_.end() ? listed_.begin()->second : at->second;
  }
  std::uint32_t after(std::uint32_t item) const {
    const auto next = std::next(listed_.find(mark_[item]));
    return next == listed_.end() ? item : next->second;
  }
  std::vector<std::uint32_t> items() const {
    std::vector<std::uint32_t> all;
    for (const auto& [mark, item] : listed_) all.push_back(item);
    return all;
  }

 private:
  using Status = SweepStatus<std::uint32_t>;
  using Place = std::map<std::uint64_t, std::uint32_t>::const_iterator;
  void expect(const Status::Neighbours& around, Place place, Place next) const {
    ASSERT_EQ(around.below, place == listed_.begin() ? Status::none : std::prev(place)->second);
    ASSERT_EQ(around.above, next == listed_.end() ? Status::none : next->second);
  }

  std::vector<std::uint64_t> mark_;
  std::vector<std::uint32_t> key_;
  Status status_;
  std::map<std::uint64_t, std::uint32_t> listed_;
  std::uint32_t asked_ = 0;
};

// Three levels of nodes from 1800 items on, four from 54000 on where they come in order.
TEST(SweepStatusTest, DeepTrees) {
  for (const std::string order : {"upwards", "downwards", "any"}) {
    Random random(103);
    const std::uint32_t count = order == "upwards" ? 60000 : 9000;
    Marked list(count);
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint64_t mark = (order == "any" ? random.next() >> 24 : order == "upwards" ? k : count - k) << 20 | k;
      list.insert(k, mark);
      // Nodes are at least half full: a comparison more a level, at worst.
      ASSERT_LE(list.asked(), std::log2(k + 1.0) + 5) << order << " " << k;
      if (HasFailure()) FAIL() << order << " " << k;
    }
    // Neighbours and others change places: the first of leaves and of inner nodes among them.
    std::vector<std::uint32_t> items = list.items();
    for (std::uint32_t k = 0; k < count; ++k) {
      const std::uint32_t item = list.from(random.next());
      list.exchange(items[k], list.after(items[k]));
      list.exchange(items[k], item);
      if (HasFailure()) FAIL() << order << " " << k;
    }
    // Whole leaves and inner nodes vanish, from either end and in the middle, and come back.
    items = list.items();
    const std::size_t from = count / 3, to = 2 * from;
    for (std::size_t k = from; k < to; ++k) list.erase(items[k]);
    for (std::size_t k = 0; k < from / 2; ++k) list.erase(items[k]);
    for (std::size_t k = count; k-- > to + from / 2;) list.erase(items[k]);
    if (HasFailure()) FAIL() << order;
    const auto return_of = [&](std::size_t k) {
      std::uint64_t mark = random.next() >> (random.below(2) ? 0 : 20);
      while (list.has(mark)) ++mark;
      list.insert(items[k], mark);
    };
    for (std::size_t k = from; k < to; ++k) return_of(k);
    for (std::size_t k = 0; k < from / 2; ++k) return_of(k);
    if (HasFailure()) FAIL() << order;
    for (const std::uint32_t item : list.items()) list.expect_known(item);
    // To nothing, in no order; then again.
    items = list.items();
    for (std::size_t k = items.size(); k > 0; --k) {
      std::swap(items[k - 1], items[random.below(k)]);
      list.erase(items[k - 1]);
    }
    ASSERT_EQ(list.size(), 0u);
    for (std::uint32_t k = 0; k < 100; ++k) list.insert(k, random.next());
    if (HasFailure()) FAIL() << order;
  }
}

// All at once, in short runs: what a sweep does.
TEST(SweepStatusTest, MixedSteps) {
  Random random(104);
  constexpr std::uint32_t count = 20000;
  Marked list(count);
  std::vector<std::uint32_t> absent(count), present;
  std::iota(absent.begin(), absent.end(), 0u);
  std::size_t longest = 0;
  for (int step = 0; step < 150000; ++step) {
    const bool growing = step / 25000 % 2 == 0;
    const std::uint64_t what = random.below(10);
    if (present.size() > 1 && what < 4) {
      const std::uint32_t item = present[random.below(present.size())];
      const std::uint32_t other = what < 2 ? list.after(item) : present[random.below(present.size())];
      if (item != other) list.exchange(item, other);
    } else if (!absent.empty() && (present.empty() || what < (growing ? 9u : 5u))) {
      std::uint64_t mark = random.next() >> random.below(8);
      while (list.has(mark)) ++mark;
      random.below(2) == 0 ? list.insert(absent.back(), mark) : list.insert_above(absent.back(), mark);
      present.push_back(absent.back());
      absent.pop_back();
    } else if (!absent.empty() && random.below(2) == 0) {
      std::uint32_t& item = present[random.below(present.size())];
      list.replace(item, absent.back());
      std::swap(item, absent.back());
    } else {
      std::swap(present[random.below(present.size())], present.back());
      list.erase(present.back());
      absent.push_back(present.back());
      present.pop_back();
    }
    longest = std::max(longest, present.size());
    if (HasFailure()) FAIL() << step;
  }
  EXPECT_GT(longest, 5000u);
}

}  // namespace
}  // namespace sunder::planar
