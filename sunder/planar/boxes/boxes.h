// A set of boxes whose sides are parallel to the axes: do any two meet, which, how many?
// Also called: rectangle intersection; axis-aligned bounding boxes.
//
// Boxes are closed, and may be flat. Two are `touching` where their insides do not meet (of a flat one that of the
// segment, or the point), `inside` where one holds the other, else `overlapping`. Questions: set_answers.h, as in
// contacts_any(boxes). Certificates: cover_statement.h (docs/claims.md, "boxes").
#pragma once

#include <sunder/base/error.h>
#include <sunder/near/cover_statement.h>
#include <sunder/near/member_list.h>
#include <sunder/near/set_answers.h>
#include <sunder/planar/discs/discs_any.h>

#include <array>

namespace sunder::planar {

class Boxes : public MemberList<Box2> {
 public:
  // Throws Error bad_value, "box 7: ..", where an end is not finite, or a low one above its high one.
  explicit Boxes(std::vector<Box2> given)
      : MemberList(std::move(given), "box",
                   [](const Box2& b) { return is_box(b) ? nullptr : "its ends are not finite, or not in order"; }) {}
};

// How it is called, where its members lie, how two of them meet.
inline std::string_view table_name(const Boxes&) { return "boxes"; }
inline std::span<const Box2> boxes_of(const Boxes& boxes) { return boxes.all(); }
// Both comparisons of an axis hold where the two are one number there.
inline DiscContact contact_kind(const Boxes& boxes, std::uint32_t i, std::uint32_t j) {
  const Box2 &a = boxes[i], &b = boxes[j];
  if (!meet(a, b)) return DiscContact::none;
  for (std::size_t k = 0; k < 2; ++k) {
    if ((a.low[k] == b.high[k]) != (b.low[k] == a.high[k])) return DiscContact::touching;
  }
  return holds(a, b) || holds(b, a) ? DiscContact::inside : DiscContact::overlapping;
}

}  // namespace sunder::planar

namespace sunder {

// For certificates: its row, and a point of two.
inline void write_row(ClaimsWriter& file, const Box2& b) {
  file.add_row(std::array{b.low.x, b.low.y, b.high.x, b.high.y});
}
inline void write_point(ClaimsWriter& file, const Box2& a, const Box2& b) {
  const Point2 p = common_part(a, b).low;
  file.doubles("point", std::array{p.x, p.y});
}

}  // namespace sunder
