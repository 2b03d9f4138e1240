// A picture of a region: the half-planes that bound it, and their common part.
#pragma once

#include <sunder/planar/region/region.h>

#include <optional>
#include <string>

namespace sunder::picture {

struct RegionPicture {
  const planar::Constraints& constraints;
  const planar::Region& region;
  std::optional<Point2> best{};  // the best point, where one was asked for
  Point2 objective{};            // and the way that is better
  std::string title{}, summary{};
};

// As SVG. Rounded numbers, for people: the corners decide what is seen, with as much again around them.
std::string region_svg(const RegionPicture& picture);

// The corners of half-planes a x + b y <= c within a box, counter-clockwise, rounded. For pictures.
std::vector<Point2> clipped(const planar::Constraints& constraints, const std::vector<std::uint32_t>& sides,
                            const Point2& low, const Point2& high);

}  // namespace sunder::picture
