// The contacts of a set in the order of i, then j, without holding more of them than a stated number.
#pragma once

#include <sunder/near/lanes_box.h>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <utility>
#include <vector>

namespace sunder {

// The numbers first .. last - 1.
struct Block {
  std::uint32_t first = 0, last = 0;
  constexpr std::uint32_t size() const { return last - first; }
  bool holds(std::uint32_t i) const { return first <= i && i < last; }
};

// How the contacts of a block of a set of N are found: each member against all that come after it, by boxes, at most
// size of block * N looks; or all k contacts of the set again, of which those of the block are kept. In a block that
// holds as many contacts as may be held, k is about most_held(N) * N / size of block; finding one again costs some 32
// looks.
constexpr std::size_t most_held(std::uint32_t size) {
  return std::max(std::size_t{1} << 20, 16 * static_cast<std::size_t>(size));  // memory stays O(N)
}
constexpr bool is_narrow(const Block& block, std::uint32_t size) {
  return std::size_t{block.size()} * block.size() <= 32 * most_held(size);
}

// Calls of_pair(i, j), i < j, for each i of the block and each j whose boxes meet, until it returns false. Boxes, or
// what has one: see box_grid.h.
template <class Boxed, class OfPair>
void for_each_near_pair_of(const Block& block, std::span<const Boxed> boxes, const OfPair& of_pair) {
  for (std::uint32_t i = block.first; i < block.last; ++i) {
    const LanesBox box = lanes_box_of(boxes[i]);
    for (std::uint32_t j = i + 1; j < boxes.size(); ++j) {
      if (meet(box, lanes_box_of(boxes[j])) && !of_pair(i, j)) return;
    }
  }
}

// Contact: members i and j, i < j, and an order by i, then j. In a set of N, let k be the number of contacts.
//   P1. At most max(most, N) contacts are held at any time, and four bytes for each of the set.
//   P2. Each contact is handed over once, in order.
// Few contacts are asked for once, and held. Of more, only the number for each i is kept; they are asked for again
// block by block of i, each with as many i as fit: at most 2 k / most + 1 blocks.
template <class Contact>
class ContactsInOrder {
 public:
  using Take = std::function<void(const Contact&)>;
  // Calls `take` for each contact whose i the block holds, in any order: the same ones whenever it is asked.
  using Ask = std::function<void(const Block&, const Take& take)>;

  // Asks for all. `ask` is kept.
  ContactsInOrder(std::uint32_t size, std::size_t most, Ask ask) : size_(size), most_(most), ask_(std::move(ask)) {
    ask_({0, size}, [this](const Contact& c) { add(c); });
    if (number_of_.empty()) std::sort(held_.begin(), held_.end());
  }
  // Of contacts that are known, in order.
  explicit ContactsInOrder(std::vector<Contact> held) : count_(held.size()), held_(std::move(held)) {}
  ContactsInOrder(const ContactsInOrder&) = delete;
  ContactsInOrder& operator=(const ContactsInOrder&) = delete;

  std::uint64_t count() const { return count_; }

  // Calls until the visitor returns false.
  template <class Visitor>
  void visit(const Visitor& visitor) {
    if (number_of_.empty()) {
      static_cast<void>(std::all_of(held_.begin(), held_.end(), visitor));
      return;
    }
    for (Block block; block.last < size_;) {
      block = {block.last, block.last + 1};
      std::uint64_t number = number_of_[block.first];
      while (block.last < size_ && number + number_of_[block.last] <= most_) number += number_of_[block.last++];
      if (number == 0) continue;
      held_.clear();
      ask_(block, [this](const Contact& c) { held_.push_back(c); });
      std::sort(held_.begin(), held_.end());
      if (!std::all_of(held_.begin(), held_.end(), visitor)) return;
    }
  }

 private:
  void add(const Contact& c) {
    if (++count_ <= most_) {
      held_.push_back(c);
      return;
    }
    if (number_of_.empty()) {
      number_of_.resize(size_);
      for (const Contact& before : held_) ++number_of_[before.i];
    }
    ++number_of_[c.i];
  }

  std::uint32_t size_ = 0;
  std::size_t most_ = 0;
  Ask ask_;
  std::uint64_t count_ = 0;
  std::vector<Contact> held_;
  std::vector<std::uint32_t> number_of_;  // of contacts with this i; empty where all are held
};

}  // namespace sunder
