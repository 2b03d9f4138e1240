#include <sunder/planar/set/discs_any_json.h>

#include <array>

namespace sunder {

void write_row(ClaimsWriter& file, const Disc& circle) {
  file.add_row(std::array{circle.center.x, circle.center.y, circle.radius});
}

void write_point(ClaimsWriter& file, const Disc& c, const Disc& d) {
  const ExactPoint2 p = planar::common_point(c, d);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
}

}  // namespace sunder
