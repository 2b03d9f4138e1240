#include <sunder/picture/plane_picture.h>
#include <sunder/picture/svg_text.h>

#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>

namespace sunder::picture {

namespace {

constexpr double size = 1000, border = 30, most_away = 1e5;  // pixels; what is further away is drawn no further

// Colours of Okabe and Ito, which colour-blind people can tell apart.
struct Look {
  char letter;
  const char *colour, *style;
};
constexpr std::array<Look, 5> looks{{{'g', "#8a97a8", "fill:#8a97a8;fill-opacity:.06;stroke-width:1"},
                                     {'b', "#0072b2", "fill:#0072b2;fill-opacity:.22;stroke-width:2"},
                                     {'a', "#d55e00", "fill:#d55e00;fill-opacity:.30;stroke-width:2.2"},
                                     {'s', "#009e73", "fill:#009e73;fill-opacity:.25;stroke-width:2"},
                                     {'t', "#cc79a7", "fill:#cc79a7;fill-opacity:.25;stroke-width:2"}}};
const Look& look_of(Ink ink) { return looks.at(static_cast<std::size_t>(ink)); }

double within(double x) { return std::isnan(x) ? 0 : std::clamp(x, -most_away, most_away); }

}  // namespace

PlanePicture::PlanePicture(std::span<const Point2> seen) {
  constexpr double most = std::numeric_limits<double>::max();
  double low_x = most, high_x = -most, low_y = most, high_y = -most;
  for (const Point2& p : seen) {  // a sum beyond the doubles counts as the greatest of them
    low_x = std::min(low_x, std::max(p.x, -most));
    high_x = std::max(high_x, std::min(p.x, most));
    low_y = std::min(low_y, std::max(p.y, -most));
    high_y = std::max(high_y, std::min(p.y, most));
  }
  // Of the order of one, so that differences neither overflow nor vanish.
  std::frexp(std::max({std::fabs(low_x), std::fabs(high_x), std::fabs(low_y), std::fabs(high_y)}), &exponent_);
  const auto scaled = [&](double x) { return std::ldexp(x, -exponent_); };
  const double wide = scaled(high_x) - scaled(low_x), high = scaled(high_y) - scaled(low_y);
  const double extent = std::max(wide, high);
  per_unit_ = extent > 0 && std::isfinite(size / extent) ? size / extent : 1;
  left_ = scaled(low_x);
  top_ = scaled(high_y);
  width_ = std::max(wide * per_unit_, size / 4);
  height_ = std::max(high * per_unit_, size / 10);
  left_ -= (width_ / per_unit_ - wide) / 2;
  top_ += (height_ / per_unit_ - high) / 2;
}

Point2 PlanePicture::at(const Point2& p) const {
  return {within((std::ldexp(p.x, -exponent_) - left_) * per_unit_),
          within((top_ - std::ldexp(p.y, -exponent_)) * per_unit_)};
}

void PlanePicture::path(std::string_view data, Ink ink) {
  drawn_ += fmt::format("<path class='{}' d='{}'/>\n", look_of(ink).letter, data);
}

void PlanePicture::circle(const Disc& circle, Ink ink) {
  const Point2 c = at(circle.center);
  const double radius = within(std::ldexp(circle.radius, -exponent_) * per_unit_);
  drawn_ += fmt::format("<circle class='{}' cx='{:.2f}' cy='{:.2f}' r='{:.2f}'/>\n", look_of(ink).letter, c.x, c.y,
                        std::max(radius, 0.5));
}

void PlanePicture::polygon(std::span<const Point2> corners, Ink ink) {
  const std::vector<Point2> ring(corners.begin(), corners.end());
  polygon(std::span(&ring, 1), ink);
}

void PlanePicture::polygon(std::span<const std::vector<Point2>> rings, Ink ink) {
  std::string data;
  for (const std::vector<Point2>& ring : rings) {
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point2 p = at(ring[k]);
      fmt::format_to(std::back_inserter(data), "{}{:.2f} {:.2f}", k == 0 ? "M" : " ", p.x, p.y);
    }
    data += 'Z';
  }
  path(data, ink);
}

void PlanePicture::segment(const Point2& from, const Point2& to, Ink ink) {
  const Point2 p = at(from), q = at(to);
  path(fmt::format("M{:.2f} {:.2f} {:.2f} {:.2f}", p.x, p.y, q.x, q.y), ink);
}

void PlanePicture::line(const Point2& from, const Point2& to, Ink ink) {
  const Point2 p = at(from), q = at(to);
  const double length = std::hypot(q.x - p.x, q.y - p.y);
  if (!(length > 0)) return;
  // From the point nearest to the middle of the picture, both ways over its edges.
  const double x = (q.x - p.x) / length, y = (q.y - p.y) / length;
  const double t = (width_ / 2 - p.x) * x + (height_ / 2 - p.y) * y, reach = width_ + height_;
  path(fmt::format("M{:.2f} {:.2f} {:.2f} {:.2f}", within(p.x + (t - reach) * x), within(p.y + (t - reach) * y),
                   within(p.x + (t + reach) * x), within(p.y + (t + reach) * y)),
       ink);
}

void PlanePicture::arrow(const Point2& from, const Point2& direction, double pixels, Ink ink) {
  const Point2 p = at(from);
  const double greatest = std::max(std::fabs(direction.x), std::fabs(direction.y));
  if (!(greatest > 0)) return;
  const double x = direction.x / greatest, y = -direction.y / greatest, length = std::hypot(x, y) / pixels;
  const Point2 u{x / length, y / length}, q{p.x + u.x, p.y + u.y};
  path(fmt::format("M{:.2f} {:.2f} {:.2f} {:.2f}M{:.2f} {:.2f} {:.2f} {:.2f} {:.2f} {:.2f}", p.x, p.y, q.x, q.y,
                   q.x - 0.2 * u.x - 0.1 * u.y, q.y - 0.2 * u.y + 0.1 * u.x, q.x, q.y, q.x - 0.2 * u.x + 0.1 * u.y,
                   q.y - 0.2 * u.y - 0.1 * u.x),
       ink);
}

void PlanePicture::dot(const Point2& where, Ink ink, std::string_view label) {
  const Point2 p = at(where);
  drawn_ += fmt::format("<circle class='{} d' cx='{:.2f}' cy='{:.2f}' r='4'/>\n", look_of(ink).letter, p.x, p.y);
  if (label.empty()) return;
  const bool left = p.x > width_ - 90;
  drawn_ += fmt::format("<text x='{:.2f}' y='{:.2f}' text-anchor='{}'>{}</text>\n", p.x + (left ? -8 : 8), p.y - 7,
                        left ? "end" : "start", escaped(io::one_line(label)));
}

void PlanePicture::named(std::string_view name, const std::function<void()>& draw) {
  drawn_ += fmt::format("<g><title>{}</title>\n", escaped(io::one_line(name)));
  draw();
  drawn_ += "</g>\n";
}

// Lines at round numbers, some five for the larger extent; none where the numbers would be too long to tell apart.
std::string PlanePicture::axes() const {
  constexpr double some = 5, longest = 1e9;  // of a number, in steps
  const double extent = std::ldexp(std::max(width_, height_) / per_unit_, exponent_);
  if (!(extent > 0) || !std::isfinite(extent)) return "";
  const double power = std::pow(10, std::floor(std::log10(extent / some))), rest = extent / some / power;
  const double step = power * (rest < 2 ? 1 : rest < 5 ? 2 : 5);
  const double left = std::ldexp(left_, exponent_), top = std::ldexp(top_, exponent_);
  if (!(step > 0) || std::max(std::fabs(left), std::fabs(top)) / step > longest) return "";
  std::string text;
  for (double k = std::ceil(left / step); at({k * step, top}).x <= width_; ++k) {
    const double x = at({k * step, top}).x;
    text += fmt::format(
        "<path class='x' d='M{0:.1f} 0 {0:.1f} {1:.1f}'/><text class='n' x='{0:.1f}' y='{2:.1f}' "
        "text-anchor='middle'>{3:.10g}</text>\n",
        x, height_, height_ + 12, k * step);
  }
  for (double k = std::floor(top / step); at({left, k * step}).y <= height_; --k) {
    const double y = at({left, k * step}).y;
    text += fmt::format(
        "<path class='x' d='M0 {0:.1f} {1:.1f} {0:.1f}'/><text class='n' x='2' y='{2:.1f}'>{3:.10g}"
        "</text>\n",
        y, width_, y - 2, k * step);
  }
  return text;
}

std::string PlanePicture::text(std::string_view title, std::string_view summary) const {
  constexpr double head = 92;
  std::string rules = "text{font:13px Inter,'Helvetica Neue',Helvetica,Arial,sans-serif;fill:#1f2a3a}";
  for (const Look& look : looks) rules += fmt::format(".{}{{stroke:{};{}}}", look.letter, look.colour, look.style);
  rules +=
      "path,circle{fill-rule:evenodd;stroke-linejoin:round}.d{fill-opacity:1;stroke:#fff;stroke-width:1.5}.x{stroke:#"
      "e6eaf0}.n{font-size:10px;fill:#8a97a8}";
  const double least = 40 + 7.2 * static_cast<double>(std::max(title.size() + title.size() / 2, summary.size()));
  const double wide = std::max(width_ + 2 * border, std::min(least, size + 2 * border));
  const double high = height_ + head + 2 * border;
  std::string text = fmt::format(
      "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' height='{1:.0f}'>\n"
      "<style>{2}</style>\n<rect width='100%' height='100%' fill='#fff'/>\n",
      wide, high, rules);
  text += fmt::format("<text x='{0}' y='34' style='font-size:20px;font-weight:600'>{1}</text>\n", border,
                      escaped(io::one_line(title)));
  text += fmt::format("<text x='{0}' y='58'>{1}</text>\n", border, escaped(io::one_line(summary)));
  double x = border;
  for (const Entry& entry : legend_) {
    const char letter = look_of(entry.ink).letter;
    text += fmt::format("<circle class='{}' cx='{:.1f}' cy='78' r='6'/><text x='{:.1f}' y='82'>{}</text>\n", letter,
                        x + 6, x + 18, escaped(io::one_line(entry.text)));
    x += 40 + 7 * static_cast<double>(entry.text.size());
  }
  text +=
      fmt::format("<svg x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' viewBox='{:.1f} {:.1f} {:.1f} {:.1f}'>\n",
                  (wide - width_) / 2 - border / 2, head + border / 2, width_ + border, height_ + border, -border / 2,
                  -border / 2, width_ + border, height_ + border);
  return text + axes() + drawn_ + "</svg>\n</svg>\n";
}

}  // namespace sunder::picture
