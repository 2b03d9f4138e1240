// How bodies of space are seen in pictures: from where, in which light, in which colours.
#pragma once

#include <sunder/picture/canvas.h>
#include <sunder/picture/painter.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

namespace sunder::picture {

struct Colour {
  double red, green, blue;
};

constexpr Colour plain_body{164, 186, 212};

inline std::string shaded(const Colour& c, double light) {
  const double k = 0.58 + 0.46 * light;
  const auto channel = [&](double x) { return static_cast<int>(std::min(255.0, x * k)); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(c.red), channel(c.green), channel(c.blue));
}

// From the world to pixels, from one side and a little from above; depths are in pixels too.
struct View {
  double scale = 1, x = 0, y = 0;

  Seen operator()(const Point3& p) const {
    static const double azimuth = -0.30 * std::numbers::pi, elevation = 0.11 * std::numbers::pi;
    static const double ca = std::cos(azimuth), sa = std::sin(azimuth);
    static const double ce = std::cos(elevation), se = std::sin(elevation);
    const double away = ca * p.x + sa * p.y;
    return {x + scale * (ca * p.y - sa * p.x), y + scale * (se * away - ce * p.z), scale * (ce * away + se * p.z)};
  }
};

// 0 dark .. 1 full light, which comes from above the viewer's left shoulder.
inline double light_on(const Seen& normal) {
  static const double length = std::hypot(0.5, 0.75, 0.55);
  return std::max(0.0, dot(normal, Seen{-0.5, -0.75, 0.55}) / length);
}

inline PathData::Tenths tenths(const Seen& p) { return PathData::tenths({p.x, p.y}); }

inline std::string outline_of(const std::vector<Seen>& corners) {
  PathData path;
  path.move(tenths(corners.front()));
  for (std::size_t i = 1; i < corners.size(); ++i) path.line(tenths(corners[i]));
  path.close();
  return path.text();
}

}  // namespace sunder::picture
