// The picture of a line, ray or half-plane and a bounded planar object.
#pragma once

#include <cli/pair_picture.h>
#include <cli/unbounded_certificate.h>

#include <string>
#include <vector>

namespace sunder::cli {

struct CutPicture {
  PicturedPolygon body;
  const Unbounded& unbounded;
  bool body_is_a = true;
  std::vector<Point2> marks;  // none; or the ends of what is to be shown as common, rounded
  std::string said, title;
};

// As SVG: the line across the sheet, the ray from its beginning on, the half-plane shaded. Rounded numbers, for people.
std::string cut_svg(const CutPicture& picture);

}  // namespace sunder::cli
