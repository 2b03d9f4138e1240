#include <sunder/picture/planar_canvas.h>
#include <sunder/picture/svg_text.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::picture {

namespace {

constexpr double width = 900, border = 40, most_height = 900, row_height = 18;
constexpr double shrink = 16;

}  // namespace

PlanarCanvas::PlanarCanvas(std::span<const Point2> shown, std::size_t rows)
    : legend_(16 + row_height * static_cast<double>(rows)) {
  Point2 low{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()}, high{-low.x, -low.y};
  for (const Point2& p : shown) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) {
      throw Error(ErrorCode::bad_call, "a point to be drawn is beyond the doubles; leave it out", "--svg");
    }
    low = {std::min(low.x, p.x / shrink), std::min(low.y, p.y / shrink)};
    high = {std::max(high.x, p.x / shrink), std::max(high.y, p.y / shrink)};
  }
  const double w = high.x - low.x, h = high.y - low.y, size = w == 0 && h == 0 ? 1 : std::max(w, h);
  const double scale = std::min((width - 2 * border) / std::max(w, size * 1e-3),
                                (most_height - 2 * border - legend_) / std::max(h, size * 1e-3));
  scale_ = std::min(scale, 1e300);
  height_ = std::min(most_height, h * scale_ + 2 * border + legend_);
  left_ = low.x - ((width / scale_) - w) / 2;
  top_ = high.y + border / scale_;
}

Point2 PlanarCanvas::pixel(const Point2& p) const {
  return {(p.x / shrink - left_) * scale_, (top_ - p.y / shrink) * scale_};
}

void PlanarCanvas::polygon(std::span<const Point2> vertices, const char* colour) {
  std::string path;
  Point2 last{};
  for (const Point2& p : vertices) {
    const Point2 at = pixel(p);
    if (!path.empty() && vertices.size() > 50 && std::hypot(at.x - last.x, at.y - last.y) < 0.1) continue;
    path += fmt::format("{}{:.2f},{:.2f}", path.empty() ? "" : " ", at.x, at.y);
    last = at;
  }
  add(
      fmt::format("<polygon points=\"{}\" fill=\"{}\" fill-opacity=\"0.18\" stroke=\"{}\" stroke-width=\"1.5\" "
                  "stroke-linejoin=\"round\"/>\n",
                  path, colour, colour));
  if (vertices.size() == 1) {
    add(fmt::format("<circle cx=\"{:.2f}\" cy=\"{:.2f}\" r=\"3\" fill=\"{}\"/>\n", last.x, last.y, colour));
  }
}

void PlanarCanvas::cross(const Point2& p) {
  const Point2 at = pixel(p);
  add(fmt::format("<path d=\"M{:.2f},{:.2f}m-7,-7l14,14m0,-14l-14,14\" stroke=\"black\" stroke-width=\"2\"/>\n", at.x,
                  at.y));
}

std::string PlanarCanvas::finish(const std::string& title, const std::vector<Row>& legend) const {
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{0:.0f}\" height=\"{1:.0f}\" viewBox=\"0 0 {0:.0f} {1:.0f}\" "
      "font-family=\"sans-serif\" font-size=\"14\">\n<title>{2}</title>\n"
      "<rect width=\"100%\" height=\"100%\" fill=\"white\"/>\n",
      width, height_, escaped(io::one_line(title)));
  svg += elements_;
  svg += fmt::format("<rect y=\"{0:.0f}\" width=\"100%\" height=\"{1:.0f}\" fill=\"white\" fill-opacity=\"0.9\"/>\n",
                     height_ - legend_, legend_);
  double y = height_ - legend_ + 4;
  for (const Row& row : legend) {
    y += row_height;
    svg += fmt::format("<text x=\"{:.0f}\" y=\"{:.0f}\" fill=\"{}\">{}</text>\n", border, y, row.colour,
                       escaped(io::one_line(row.text)));
  }
  return svg + "</svg>\n";
}

}  // namespace sunder::picture
