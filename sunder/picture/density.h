// Where things are too many, or too small, to be seen one by one: squares, the darker the more there are.
#pragma once

#include <sunder/predicate/point.h>

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::picture {

class Density {
 public:
  // Pixels: what lies beyond 0 .. width and 0 .. height is not counted.
  Density(double width, double height);

  void add(const Point2& pixel);
  void add(const Point2& from, const Point2& to);  // once in each square along a segment

  std::uint32_t most() const;  // in one square

  // A path for each of a few shades, by the logarithm of the counts; attributes: the colour of their strokes.
  std::string xml(std::string_view attributes) const;

 private:
  std::size_t columns_, rows_;
  std::vector<std::uint32_t> count_;  // row by row
};

}  // namespace sunder::picture
