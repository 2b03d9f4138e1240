// The picture of a line, ray or half-plane and a bounded planar object.
#pragma once

#include <sunder/ask/pair/unbounded_certificate.h>
#include <sunder/picture/pair_picture.h>

#include <string>
#include <vector>

namespace sunder::picture {

struct CutPicture {
  PicturedPolygon body;
  const ask::Unbounded& unbounded;
  bool body_is_a = true;
  std::vector<Point2> marks;  // none; or the ends of what is to be shown as common, rounded
  std::string said, title;
};

// As SVG: the line across the sheet, the ray from its beginning on, the half-plane shaded. Rounded numbers, for people.
std::string cut_svg(const CutPicture& picture);

}  // namespace sunder::picture
