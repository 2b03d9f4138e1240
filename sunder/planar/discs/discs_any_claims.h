// Certificates of answers about a set of circles with their insides (docs/claims.md, "circles").
#pragma once

#include <sunder/near/cover_statement.h>
#include <sunder/planar/discs/disc_boxes.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any.h>

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::planar {

// For cover_statement.h.
inline std::string_view table_name(const Discs&) { return "circles"; }
inline std::vector<Box2> boxes_of(const Discs& circles) { return rounded_boxes(circles); }

// The whole file. Answer: a DiscsAnswer, a DiscsAllAnswer in any order, or a CountAnswer.
template <class Answer>
std::string certificate_text(const Discs& circles, Allowed allowed, const Answer& answer, Groups groups = {}) {
  return cover_certificate_text(CoverQuestion<Discs>{circles, allowed, groups}, answer);
}

}  // namespace sunder::planar

namespace sunder {

// For cover_statement.h, too: its row, and a point of two.
inline void write_row(ClaimsWriter& file, const Disc& circle) {
  file.add_row(std::array{circle.center.x, circle.center.y, circle.radius});
}
inline void write_point(ClaimsWriter& file, const Disc& c, const Disc& d) {
  const ExactPoint2 p = planar::common_point(c, d);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
}

}  // namespace sunder
