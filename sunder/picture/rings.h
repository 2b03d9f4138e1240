// Numbered rings where things meet. No two lie over each other: where many crowd, one ring tells how many they are.
#pragma once

#include <sunder/picture/canvas.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::picture {

// A kind of contact: the colour of its rings, and what it is called.
struct RingKind {
  Ink ink;
  std::string_view name;
};

//   R1. Every contact has a dot. Where rings, or their labels, would lie over each other, one ring around the first
//       contact stands for all of them, with their numbers, "3, 8" or "12-37", or how many they are, with a
//       multiplication sign. A ring that stands for several kinds is dark.
//   R2. The same contacts in the same order give the same text. Cost: n log n for n contacts; there is room for about
//       2000 rings.
class Rings {
 public:
  // right: where labels on the right of their ring must end, in pixels. What `kinds` holds must stay.
  Rings(std::span<const RingKind> kinds, double right) : kinds_(kinds), right_(right) {}

  // Contact `number`, from 0, which is shown as one more. kind: a position in `kinds`.
  void add(const Point2& pixel, std::uint32_t number, std::size_t kind);

  // As XML. tell(number): a sentence about it, shown where somebody points at its ring.
  std::string text(const std::function<std::string(std::uint32_t)>& tell) const;

  // What the reader must know of them.
  std::vector<std::string> notes() const;

 private:
  struct Contact {
    std::uint32_t number;
    std::uint32_t kind;
    friend auto operator<=>(const Contact&, const Contact&) = default;
  };
  struct Ring {
    Point2 at;                        // of its first contact
    std::vector<Contact> contacts;    // not sorted
    std::uint32_t low = 0, high = 0;  // the first and the last number of them

    bool is_counted() const;
    std::string label() const;
    bool is_mixed() const;
  };
  struct Extent {
    double left, right, label_left, label_width;  // of a ring with its label
  };
  using Place = std::pair<long, double>;  // row, x

  Extent extent_of(const Ring& ring) const;
  std::map<Place, Ring>::iterator nearest_overlapped(const Ring& ring);
  std::string text_of(const Ring& ring, const std::function<std::string(std::uint32_t)>& tell) const;

  std::span<const RingKind> kinds_;
  double right_;
  std::map<Place, Ring> rings_;
  std::set<std::pair<long, long>> dots_;  // whole pixels
};

}  // namespace sunder::picture
