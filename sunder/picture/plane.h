// A picture of objects of the plane: circles, polygons, lines and dots in a frame with axes.
#pragma once

#include <sunder/picture/density.h>
#include <sunder/picture/rings.h>
#include <sunder/planar/object/discs.h>

#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::picture {

// One coordinate: from the world's unit, of any size, to pixels of the frame.
class Axis {
 public:
  void include(double value);

  // Shows at least this part of what the other one shows, for one scale.
  void widen(const Axis& other, double part);

  bool is_flat() const { return extent_ == 0; }

  // How many times the other's extent: may be 0 or infinite.
  double ratio_to(const Axis& other) const;

  // Pixels: of the lowest value, and from there to the highest.
  void place(double start, double length);
  double at(double value) const;

  // Round values; if doubles are too coarse for these, the extremes.
  std::vector<std::pair<double, std::string>> ticks() const;

 private:
  void scale(int exponent);

  double low_ = std::numeric_limits<double>::infinity(), high_ = -low_;  // of what is included
  int exponent_ = 0;
  double from_ = 0, extent_ = 0;  // scaled by 2^-exponent: of what is shown
  double start_ = 0, length_ = 0;
};

// The point next to p of the line through a point; rounded, without overflow.
Point2 foot(const Point2& through, const Point2& direction, const Point2& p);

struct Sheet {
  double width = 1100, most_height = 900;  // of the picture; of what is seen in it
  bool one_scale = true;  // else only where neither extent is more than 20 times the other; a note says where not
  bool y_down = false;    // as boards have it
};

// Things are drawn in the order in which they are added; later ones lie over earlier ones, rings over all.
//   P1. For every finite input the text is well-formed XML, in UTF-8, of finite numbers; the same input gives the same
//       text. Positions are rounded: a picture decides nothing.
//   P2. The frame has axes with round numbers. Coordinates are hundredths of a pixel.
//   P3. Of circles and polygons of a few pixels, where there are very many, the density is drawn (density.h).
class PlanePicture : public Canvas {
 public:
  // What must be seen: at least one point. What lies outside is cut off.
  explicit PlanePicture(std::span<const Point2> seen, const Sheet& sheet = {});

  // In pixels of the frame; what is very far away is drawn less far.
  Point2 at(const Point2& p) const;
  Density density() const { return {width_, height_}; }  // of nothing yet, of all of the frame

  void circle(const Disc& circle, Ink ink);                           // to one scale
  void polygon(std::span<const Point2> corners, Ink ink);             // closed; of one corner a dot
  void polygon(std::span<const std::vector<Point2>> rings, Ink ink);  // with holes
  void segment(const Point2& from, const Point2& to, Ink ink);

  // A line through a point near to what is seen, to one scale, y up; a ray from there; the half-plane to the left.
  enum class Extent : std::uint8_t { line, ray, half_plane };
  void line(const Point2& through, const Point2& direction, Ink ink, Extent extent = Extent::line, bool dashed = false);

  void dot(const Point2& at, Ink ink, std::string_view label = {}, bool hollow = false);  // label: any text
  void arrow(const Point2& from, const Point2& direction, double pixels, Ink ink);
  void label(const Point2& at, std::string_view text);

  // What draw() adds is of that name, which is shown where somebody points at it, and on circles and polygons where
  // there is room.
  void named(std::string_view name, const std::function<void()>& draw);

  // Rings at contacts, over all; see rings.h. Once, as the last.
  void rings(std::span<const RingContact> contacts, std::span<const RingKind> kinds,
             const std::function<std::string(std::uint32_t)>& tell);

  std::string text(std::string_view title, std::string_view summary);  // once

 private:
  struct Small {
    Ink ink;
    Point2 at;  // in pixels
    std::string xml;
  };
  struct Caption {
    Point2 at;  // its middle, in pixels
    double width;
    std::string name;
  };

  void fit();
  std::string axes() const;
  void stroke(std::string_view data, Ink ink, std::string_view classes = "l");
  void shape(const std::string& element, Ink ink, const Box2& box);  // box: in pixels
  void take_for_name(const Box2& box);
  bool takes(const Point2& at, double width);  // room for a text of one line, if there is any
  void close();                                // the frame: what is drawn last in it

  Sheet sheet_;
  Axis x_, y_;
  double left_ = 0, width_ = 0, height_ = 0;  // of the frame, in pixels
  std::size_t shapes_ = 0;
  bool is_closed_ = false;
  std::string title_;           // XML, of what is drawn
  std::optional<Box2> widest_;  // of the rings and circles of that name, in pixels
  std::vector<Small> small_;
  std::vector<Caption> captions_;
  std::vector<Box2> texts_;  // where they are, so that none lies over another
};

}  // namespace sunder::picture
