// A picture of a region: the half-planes that bound it, and their common part.
#pragma once

#include <sunder/planar/region/region.h>

#include <optional>
#include <span>
#include <string>

namespace sunder::picture {

struct RegionPicture {
  const planar::Constraints& constraints;
  const planar::Region& region;
  std::span<const std::string> names{};  // of the half-planes; may be empty
  std::optional<Point2> best{};          // the best point, where one was asked for
  Point2 objective{};                    // and the way that is better
  std::string title{}, summary{};
};

// As SVG. Rounded numbers, for people: the corners decide what is seen, with as much again around them.
std::string region_svg(const RegionPicture& picture);

}  // namespace sunder::picture
