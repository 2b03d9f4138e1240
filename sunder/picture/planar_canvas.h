// Pictures of planar objects: where points of the world are on the sheet, and what is drawn, as SVG.
#pragma once

#include <sunder/predicate/point.h>

#include <array>
#include <span>
#include <string>
#include <vector>

namespace sunder::picture {

// Of A and of B: colours of Okabe and Ito, and names for the legend.
inline constexpr std::array<const char*, 2> pair_colours{"#0072b2", "#d55e00"};

// Rounded numbers, for people. Pixels run to the right and down.
class PlanarCanvas {
 public:
  // A sheet on which all of these points are, with a margin. rows: lines of the legend below. Throws Error bad_call
  // where a coordinate is not finite.
  PlanarCanvas(std::span<const Point2> shown, std::size_t rows);

  Point2 pixel(const Point2& p) const;

  // Closed; of one vertex a dot. Bends nearer than a tenth of a pixel are left out where there are many.
  void polygon(std::span<const Point2> vertices, const char* colour);
  void cross(const Point2& p);
  void add(const std::string& element) { elements_ += element; }

  struct Row {
    std::string text;
    const char* colour = "black";
  };
  // The whole file. As many rows as were announced.
  std::string finish(const std::string& title, const std::vector<Row>& legend) const;

 private:
  double left_ = 0, top_ = 0, scale_ = 1;  // of coordinates divided by `shrink`, so that differences do not overflow
  double height_ = 0, legend_ = 0;
  std::string elements_;
};

}  // namespace sunder::picture
