// A picture of objects of the plane, as SVG: circles, polygons, lines and dots, to one scale.
#pragma once

#include <sunder/planar/object/discs.h>
#include <sunder/predicate/point.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::picture {

// How a thing is drawn.
enum class Ink : std::uint8_t {
  calm,    // thin and grey: what is given
  bold,    // what is asked for: filled
  accent,  // what matters most: the contact, the best point
  second,  // another kind of it
  third,   // and another
};

// Things are drawn in the order in which they are added; later ones lie over earlier ones.
//   P1. For every finite input the text is well-formed XML, in UTF-8, of finite numbers; the same input gives the same
//       text. Positions are rounded: a picture decides nothing.
//   P2. x and y are to one scale, y upwards; lines in grey tell their numbers. Coordinates are hundredths of a pixel,
//   1000 pixels for the larger extent.
class PlanePicture {
 public:
  // What must be seen: at least one point. What lies outside is cut off.
  explicit PlanePicture(std::span<const Point2> seen);

  void circle(const Disc& circle, Ink ink);
  void polygon(std::span<const Point2> corners, Ink ink);             // closed
  void polygon(std::span<const std::vector<Point2>> rings, Ink ink);  // with holes
  void line(const Point2& from, const Point2& to, Ink ink);           // of the plane, not of its ends
  void segment(const Point2& from, const Point2& to, Ink ink);
  void dot(const Point2& at, Ink ink, std::string_view label = {});  // label: any text
  void legend(Ink ink, std::string_view text) { legend_.push_back({ink, std::string(text)}); }

  // What draw() adds is of that name, which is shown where somebody points at it.
  void named(std::string_view name, const std::function<void()>& draw);

  // An arrow of this length along the direction, from a point.
  void arrow(const Point2& from, const Point2& direction, double pixels, Ink ink);

  std::string text(std::string_view title, std::string_view summary) const;

 private:
  struct Entry {
    Ink ink;
    std::string text;
  };

  Point2 at(const Point2& p) const;  // in pixels
  void path(std::string_view data, Ink ink);
  std::string axes() const;

  int exponent_ = 0;
  double left_ = 0, top_ = 0, per_unit_ = 1;  // of coordinates times 2^-exponent
  double width_ = 0, height_ = 0;             // pixels
  std::vector<Entry> legend_;
  std::string drawn_;
};

}  // namespace sunder::picture
