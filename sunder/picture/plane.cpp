#include <sunder/picture/plane.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace sunder::picture {

namespace {

// Sizes in pixels.
constexpr double padding = 28, least_height = 72, tick_distance = 110, tick_letter_width = 6.2;
constexpr double most_away = 1e5;                     // what is further away is drawn no further
constexpr double longest_side = 20, fitted_side = 4;  // against the other: beyond the first, fitted to the second
constexpr double least_width_part = 0.25, least_height_part = 0.1;  // of the other side, to one scale
constexpr std::size_t many_shapes = 2000, many_corners = 50;

double within(double x) { return std::isnan(x) ? 0 : std::clamp(x, -most_away, most_away); }

std::string data_of(std::initializer_list<Point2> pixels) {
  std::string data;
  for (const Point2& p : pixels) data += fmt::format("{}{:.2f} {:.2f}", data.empty() ? "M" : " ", p.x, p.y);
  return data;
}

// Of length one; zero where there is none.
Point2 unit(const Point2& direction) {
  const double greatest = std::max(std::fabs(direction.x), std::fabs(direction.y));
  if (!(greatest > 0) || !std::isfinite(greatest)) return {0, 0};
  const double length = std::hypot(direction.x / greatest, direction.y / greatest);
  return {direction.x / greatest / length, direction.y / greatest / length};
}

}  // namespace

Point2 foot(const Point2& through, const Point2& direction, const Point2& p) {
  const Point2 d = unit(direction);
  const double along = (p.x / 16 - through.x / 16) * d.x + (p.y / 16 - through.y / 16) * d.y;
  return {(through.x / 16 + along * d.x) * 16, (through.y / 16 + along * d.y) * 16};
}

void Axis::include(double value) {
  value = std::clamp(value, std::numeric_limits<double>::lowest(), std::numeric_limits<double>::max());
  low_ = std::min(low_, value);
  high_ = std::max(high_, value);
  // Of the order of one, so that a difference neither overflows nor vanishes.
  int exponent = 0;
  std::frexp(std::max(std::fabs(low_), std::fabs(high_)), &exponent);
  scale(exponent);
}

void Axis::scale(int exponent) {
  exponent_ = exponent;
  from_ = std::ldexp(low_, -exponent_);
  extent_ = std::ldexp(high_, -exponent_) - from_;
}

void Axis::widen(const Axis& other, double part) {
  if (!(ratio_to(other) < part)) return;
  scale(std::max(exponent_, other.exponent_));
  const double wider = part * std::ldexp(other.extent_, other.exponent_ - exponent_);
  from_ -= (wider - extent_) / 2;
  extent_ = wider;
}

double Axis::ratio_to(const Axis& other) const {
  return std::ldexp(extent_ / other.extent_, exponent_ - other.exponent_);
}

void Axis::place(double start, double length) {
  start_ = start;
  length_ = length;
}

double Axis::at(double value) const {
  return within(start_ + length_ * (is_flat() ? 0.5 : (std::ldexp(value, -exponent_) - from_) / extent_));
}

std::vector<std::pair<double, std::string>> Axis::ticks() const {
  const auto exact = [](double value) { return std::pair(value, fmt::format("{}", value + 0.0)); };
  if (low_ == high_) return {exact(low_)};
  std::vector<std::pair<double, std::string>> extremes{exact(low_), exact(high_)};
  const double low = std::ldexp(from_, exponent_), high = std::ldexp(from_ + extent_, exponent_);
  const double parts = std::clamp(std::floor(std::fabs(length_) / tick_distance), 3.0, 10.0);
  const double least = high / parts - low / parts;
  if (!std::isnormal(least) || least < 1e-9 * std::max(std::fabs(low), std::fabs(high))) return extremes;
  const double decade = std::pow(10, std::floor(std::log10(least)));
  double step = 10 * decade;
  for (const double part : {5.0, 2.0, 1.0}) {
    if (part * decade >= 0.999 * least) step = part * decade;
  }
  if (!std::isnormal(step)) return extremes;
  std::vector<std::pair<double, std::string>> round;
  for (double k = std::ceil(low / step); k * step <= high; ++k) {
    round.emplace_back(k * step, fmt::format("{:.12g}", k * step + 0.0));
  }
  return round.size() < 2 ? extremes : round;
}

PlanePicture::PlanePicture(std::span<const Point2> seen, const Sheet& sheet) : Canvas(sheet.width), sheet_(sheet) {
  for (const Point2& p : seen) {
    x_.include(p.x);
    y_.include(p.y);
  }
  fit();
  add(fmt::format("<g transform='translate({:.1f} 0)'>\n", left_) + axes());
  add(fmt::format("<svg width='{:.1f}' height='{:.1f}'>\n", width_, height_));
}

// Gives the axes their pixels.
void PlanePicture::fit() {
  if (sheet_.one_scale) {
    x_.widen(y_, least_width_part);
    y_.widen(x_, least_height_part);
  }
  std::size_t letters = 0;  // room for the numbers of y
  y_.place(0, sheet_.most_height);
  for (const auto& tick : y_.ticks()) letters = std::max(letters, tick.second.size());
  left_ = std::max(border, 20 + tick_letter_width * static_cast<double>(letters));
  const double room = sheet_.width - left_ - border;
  double ratio = fitted_side;
  if (!x_.is_flat() && !y_.is_flat()) {
    ratio = x_.ratio_to(y_);
    if (!sheet_.one_scale && (ratio > longest_side || ratio < 1 / longest_side)) {
      ratio = ratio > 1 ? fitted_side : 1 / fitted_side;
      note("Not to one scale: x and y are each fitted to the frame.");
    }
  }
  if (sheet_.y_down) note("y grows downwards.");
  double x_length = std::min(room - 2 * padding, sheet_.most_height * ratio), y_length = x_length / ratio;
  if (x_.is_flat() && !y_.is_flat()) {
    x_length = 4 * least_height;
    y_length = sheet_.most_height;
  }
  if (y_.is_flat()) y_length = least_height;
  width_ = x_length + 2 * padding;
  height_ = y_length + 2 * padding;
  left_ += std::max(0.0, (room - width_) / 2);
  x_.place(padding, x_length);
  y_.place(sheet_.y_down ? padding : padding + y_length, sheet_.y_down ? y_length : -y_length);
}

Point2 PlanePicture::at(const Point2& p) const { return {x_.at(p.x), y_.at(p.y)}; }

void PlanePicture::path(std::string_view data, std::string_view classes, Ink ink) {
  add(fmt::format("<path class='{} {}' d='{}'/>\n", classes, class_of(ink), data));
  ++shapes_;
}

void PlanePicture::circle(const Disc& circle, Ink ink) {
  const Point2 c = at(circle.center);
  const double edge = x_.at(circle.center.x / 2 + (circle.center.x / 2 + circle.radius));
  add(fmt::format("<circle class='f {}' cx='{:.2f}' cy='{:.2f}' r='{:.2f}'/>\n", class_of(ink), c.x, c.y,
                  std::max(edge - c.x, 0.5)));
  ++shapes_;
}

void PlanePicture::polygon(std::span<const Point2> corners, Ink ink) {
  if (corners.size() == 1) return dot(corners[0], ink);
  const std::vector<Point2> ring(corners.begin(), corners.end());
  polygon(std::span(&ring, 1), ink);
}

void PlanePicture::polygon(std::span<const std::vector<Point2>> rings, Ink ink) {
  std::string data;
  for (const std::vector<Point2>& ring : rings) {
    Point2 last;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point2 p = at(ring[k]);
      // Where there are many, bends nearer than a tenth of a pixel are left out.
      if (k > 0 && ring.size() > many_corners && std::hypot(p.x - last.x, p.y - last.y) < 0.1) continue;
      fmt::format_to(std::back_inserter(data), "{}{:.2f} {:.2f}", k == 0 ? "M" : " ", p.x, p.y);
      last = p;
    }
    data += 'Z';
  }
  path(data, "f", ink);
}

void PlanePicture::segment(const Point2& from, const Point2& to, Ink ink) {
  path(data_of({at(from), at(to)}), "l", ink);
}

void PlanePicture::line(const Point2& through, const Point2& direction, Ink ink, Extent extent, bool dashed) {
  const Point2 p = at(through), u = unit(direction);
  const double reach = 3 * (width_ + height_);
  const auto beside = [&](double along, double left) {
    return Point2{p.x + along * u.x - left * u.y, p.y - along * u.y - left * u.x};
  };
  const Point2 from = beside(extent == Extent::ray ? 0 : -reach, 0), to = beside(reach, 0);
  if (extent == Extent::half_plane)
    return path(data_of({from, to, beside(reach, reach), beside(-reach, reach)}), "f", ink);
  path(data_of({from, to}), dashed ? "l dashed" : "l", ink);
}

void PlanePicture::arrow(const Point2& from, const Point2& direction, double pixels, Ink ink) {
  const Point2 p = at(from), w = unit(direction), u{w.x * pixels, -w.y * pixels}, q{p.x + u.x, p.y + u.y};
  const Point2 left{q.x - 0.2 * u.x + 0.1 * u.y, q.y - 0.2 * u.y - 0.1 * u.x};
  const Point2 right{q.x - 0.2 * u.x - 0.1 * u.y, q.y - 0.2 * u.y + 0.1 * u.x};
  path(data_of({p, q, left, q, right}), "l", ink);
}

void PlanePicture::dot(const Point2& where, Ink ink, std::string_view label_text, bool hollow) {
  const Point2 p = at(where);
  add(fmt::format("<circle class='f {} {}' cx='{:.2f}' cy='{:.2f}' r='{}'/>\n", class_of(ink), hollow ? 'v' : 'd', p.x,
                  p.y, hollow ? 2.6 : 4));
  if (!label_text.empty()) label(where, label_text);
}

void PlanePicture::label(const Point2& where, std::string_view text) {
  Point2 p = at(where);
  const bool left = p.x > width_ - 90;
  const double width = tick_letter_width * 1.2 * static_cast<double>(text.size());
  const auto is_taken = [&](const Point2& other) {
    return std::fabs(other.x - p.x) < width && std::fabs(other.y - p.y) < 14;
  };
  while (std::any_of(labels_.begin(), labels_.end(), is_taken)) p.y += 14;
  labels_.push_back(p);
  add(fmt::format("<text class='n' x='{:.2f}' y='{:.2f}' text-anchor='{}'>{}</text>\n", p.x + (left ? -8 : 8), p.y - 7,
                  left ? "end" : "start", xml_text(text)));
}

void PlanePicture::named(std::string_view name, const std::function<void()>& draw) {
  add(name.empty() ? "<g>\n" : fmt::format("<g><title>{}</title>\n", xml_text(name)));
  draw();
  add("</g>\n");
}

void PlanePicture::rings(std::span<const RingContact> contacts, std::span<const RingKind> kinds,
                         const std::function<std::string(std::uint32_t)>& tell) {
  add("</svg>\n");
  has_rings_ = true;
  draw_rings(*this, contacts, kinds, sheet_.width - border - left_, tell);
}

std::string PlanePicture::axes() const {
  std::string text, grid;
  double taken = -left_;  // up to here by numbers of x
  for (const auto& [value, number] : x_.ticks()) {
    const double x = x_.at(value), half = tick_letter_width * static_cast<double>(number.size()) / 2;
    grid += fmt::format("M{:.1f} 0V{:.1f}", x, height_);
    const double middle = std::clamp(x, half + 4 - left_, sheet_.width - left_ - half - 4);
    if (middle - half < taken) continue;
    taken = middle + half + 8;
    text += fmt::format("<text class='k' x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n", middle, height_ + 17,
                        number);
  }
  for (const auto& [value, number] : y_.ticks()) {
    const double y = y_.at(value);
    grid += fmt::format("M0 {:.1f}H{:.1f}", y, width_);
    text += fmt::format("<text class='k' x='-7' y='{:.1f}' text-anchor='end'>{}</text>\n", y + 4, number);
  }
  return text +
         fmt::format("<path class='a' d='{}'/>\n<rect width='{:.1f}' height='{:.1f}' fill='none' stroke='#c5ccd6'/>\n",
                     grid, width_, height_);
}

std::string PlanePicture::text(std::string_view title, std::string_view summary) {
  if (!has_rings_) add("</svg>\n");
  if (shapes_ > many_shapes) add("<style>.f{stroke-width:.7}</style>\n");
  add("</g>\n");
  return finish(title, summary, height_ + 36);
}

}  // namespace sunder::picture
