#include <sunder/planar/set/disc_boxes.h>
#include <sunder/planar/set/discs_any_json.h>

#include <array>

namespace sunder::planar {

void DiscsQuestion::write_rows(ClaimsWriter& file) const {
  for (const Disc& c : circles.all()) file.add_row(std::array{c.center.x, c.center.y, c.radius});
}

std::vector<Box2> DiscsQuestion::boxes() const { return rounded_boxes(circles); }

void DiscsQuestion::write_point(ClaimsWriter& file, std::uint32_t i, std::uint32_t j) const {
  const ExactPoint2 p = common_point(circles[i], circles[j]);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
}

}  // namespace sunder::planar
