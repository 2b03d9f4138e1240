// Numbered rings where things meet. No two lie over each other: where many crowd, one ring tells how many they are.
#pragma once

#include <sunder/picture/canvas.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>

namespace sunder::picture {

// A kind of contact: the colour of its rings, and what it is called.
struct RingKind {
  Ink ink;
  std::string_view name;
};

struct RingContact {
  Point2 at;             // in pixels
  std::uint32_t number;  // from 0; shown as one more
  std::size_t kind;      // a position in the kinds
};

// Draws the contacts, with notes of what the reader must know. right: where labels on the right of their ring must end.
// tell(number): a sentence about the contact, shown where somebody points at its ring.
//   R1. Every contact has a dot. Where rings, or their labels, would lie over each other, one ring around the first
//       contact stands for all of them, with their numbers, "3, 8" or "12-37", or how many they are, with a
//       multiplication sign. A ring that stands for several kinds is dark.
//       Of more than 10,000 contacts there are no rings: squares in the colours of their kinds, the darker the more.
//   R2. The same contacts in the same order give the same text. Cost: n log n for n contacts; there is room for about
//       2000 rings.
void draw_rings(Canvas& canvas, std::span<const RingContact> contacts, std::span<const RingKind> kinds, double right,
                const std::function<std::string(std::uint32_t)>& tell);

}  // namespace sunder::picture
