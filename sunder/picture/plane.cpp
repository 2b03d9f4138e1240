#include <sunder/picture/plane.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <map>
#include <utility>

namespace sunder::picture {

namespace {

// Sizes in pixels.
constexpr double padding = 28, least_height = 72, tick_distance = 110, tick_letter_width = 6.2;
constexpr double most_away = 1e5;                     // what is further away is drawn no further
constexpr double longest_side = 20, fitted_side = 4;  // against the other: beyond the first, fitted to the second
constexpr double least_width_part = 0.25, least_height_part = 0.1;  // of the other side, to one scale
constexpr double name_letter_width = 7.4, text_height = 15;         // of names
constexpr double small = 6;  // most_small circles and polygons are drawn as such, if they are no larger than this
constexpr std::size_t many_shapes = 2000, many_corners = 50, most_small = 5000;

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

void PlanePicture::stroke(std::string_view data, Ink ink, std::string_view classes) {
  add(fmt::format("<path class='{} {}' d='{}'>{}</path>\n", classes, class_of(ink), data, title_));
}

void PlanePicture::shape(const std::string& element, Ink ink, const Box2& box) {
  std::string xml = fmt::format("<{0} class='f {1}'>{2}</{3}>\n", element, class_of(ink), title_,
                                element.substr(0, element.find(' ')));
  ++shapes_;
  if (box.high.x - box.low.x < small && box.high.y - box.low.y < small) {
    small_.push_back({ink, box.low, std::move(xml)});
  } else {
    add(xml);
  }
}

void PlanePicture::circle(const Disc& circle, Ink ink) {
  const Point2 c = at(circle.center);
  const double r = std::max(x_.at(circle.center.x / 2 + (circle.center.x / 2 + circle.radius)) - c.x, 0.5);
  shape(fmt::format("circle cx='{:.2f}' cy='{:.2f}' r='{:.2f}'", c.x, c.y, r), ink,
        {{c.x - r, c.y - r}, {c.x + r, c.y + r}});
  take_for_name({{c.x - r, c.y - r}, {c.x + r, c.y + r}});
}

void PlanePicture::polygon(std::span<const Point2> corners, Ink ink) {
  if (corners.size() == 1) return dot(corners[0], ink);
  const std::vector<Point2> ring(corners.begin(), corners.end());
  polygon(std::span(&ring, 1), ink);
}

void PlanePicture::polygon(std::span<const std::vector<Point2>> rings, Ink ink) {
  std::string data;
  std::optional<Box2> box;
  for (const std::vector<Point2>& ring : rings) {
    if (ring.empty()) continue;
    Box2 of_ring{at(ring[0]), at(ring[0])};
    Point2 last;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Point2 p = at(ring[k]);
      // Where there are many, bends nearer than a tenth of a pixel are left out.
      if (k > 0 && ring.size() > many_corners && std::hypot(p.x - last.x, p.y - last.y) < 0.1) continue;
      fmt::format_to(std::back_inserter(data), "{}{:.2f} {:.2f}", k == 0 ? "M" : " ", p.x, p.y);
      of_ring = hull(of_ring, {p, p});
      last = p;
    }
    data += 'Z';
    take_for_name(of_ring);
    box = box ? hull(*box, of_ring) : of_ring;
  }
  if (box) shape(fmt::format("path d='{}'", data), ink, *box);
}

void PlanePicture::segment(const Point2& from, const Point2& to, Ink ink) { stroke(data_of({at(from), at(to)}), ink); }

void PlanePicture::line(const Point2& through, const Point2& direction, Ink ink, Extent extent, bool dashed) {
  const Point2 p = at(through), u = unit(direction);
  const double reach = 3 * (width_ + height_);
  const auto beside = [&](double along, double left) {
    return Point2{p.x + along * u.x - left * u.y, p.y - along * u.y - left * u.x};
  };
  const Point2 from = beside(extent == Extent::ray ? 0 : -reach, 0), to = beside(reach, 0);
  if (extent == Extent::half_plane)
    return stroke(data_of({from, to, beside(reach, reach), beside(-reach, reach)}), ink, "f");
  stroke(data_of({from, to}), ink, dashed ? "l dashed" : "l");
}

void PlanePicture::arrow(const Point2& from, const Point2& direction, double pixels, Ink ink) {
  const Point2 p = at(from), w = unit(direction), u{w.x * pixels, -w.y * pixels}, q{p.x + u.x, p.y + u.y};
  const Point2 left{q.x - 0.2 * u.x + 0.1 * u.y, q.y - 0.2 * u.y - 0.1 * u.x};
  const Point2 right{q.x - 0.2 * u.x - 0.1 * u.y, q.y - 0.2 * u.y + 0.1 * u.x};
  stroke(data_of({p, q, left, q, right}), ink);
}

void PlanePicture::dot(const Point2& where, Ink ink, std::string_view label_text, bool hollow) {
  const Point2 p = at(where);
  add(fmt::format("<circle class='f {} {}' cx='{:.2f}' cy='{:.2f}' r='{}'/>\n", class_of(ink), hollow ? 'v' : 'd', p.x,
                  p.y, hollow ? 2.6 : 4));
  if (!label_text.empty()) label(where, label_text);
}

// A name stands on the widest ring.
void PlanePicture::take_for_name(const Box2& box) {
  if (!widest_ || box.high.x - box.low.x > widest_->high.x - widest_->low.x) widest_ = box;
}

bool PlanePicture::takes(const Point2& at, double width) {
  const Box2 box{{at.x, at.y - text_height + 1}, {at.x + width, at.y}};
  if (std::any_of(texts_.begin(), texts_.end(), [&](const Box2& other) { return meet(box, other); })) return false;
  texts_.push_back(box);
  return true;
}

void PlanePicture::label(const Point2& where, std::string_view text) {
  const double width = name_letter_width * static_cast<double>(text.size());
  Point2 p = at(where);
  p.x += p.x + 8 + width > width_ ? -8 - width : 8;
  for (p.y -= 7; !takes(p, width);) p.y += text_height;
  add(fmt::format("<text class='n' x='{:.2f}' y='{:.2f}'>{}</text>\n", p.x, p.y, xml_text(text)));
}

void PlanePicture::named(std::string_view name, const std::function<void()>& draw) {
  title_ = name.empty() ? "" : fmt::format("<title>{}</title>", xml_text(name));
  widest_.reset();
  draw();
  title_.clear();
  if (!widest_ || name.empty()) return;
  const auto& [low, high] = *widest_;
  const double width = name_letter_width * static_cast<double>(name.size());
  if (high.x - low.x < width + 8 || high.y - low.y < text_height + 4) return;
  captions_.push_back({{(low.x + high.x) / 2, (low.y + high.y) / 2}, width, std::string(name)});
}

// Small things, then names.
void PlanePicture::close() {
  if (std::exchange(is_closed_, true)) return;
  if (small_.size() > most_small) {
    std::map<Ink, Density> crowds;
    for (const Small& s : small_) crowds.try_emplace(s.ink, density()).first->second.add(s.at);
    for (const auto& [ink, crowd] : crowds) add(crowd.xml(fmt::format("class='{}'", class_of(ink))));
    note(fmt::format("What is smaller than {:.0f} pixels is drawn as squares, the darker the more of it is there.",
                     small));
  } else {
    for (const Small& s : small_) add(s.xml);
  }
  for (const auto& [middle, width, name] : captions_) {
    if (!takes({middle.x - width / 2, middle.y + 4.5}, width)) continue;
    add(fmt::format("<text class='n h' x='{:.1f}' y='{:.1f}'>{}</text>\n", middle.x, middle.y + 4.5, xml_text(name)));
  }
  add("</svg>\n");
  if (shapes_ > many_shapes) add("<style>.f{stroke-width:.7}</style>\n");
}

void PlanePicture::rings(std::span<const RingContact> contacts, std::span<const RingKind> kinds,
                         const std::function<std::string(std::uint32_t)>& tell) {
  close();
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
  close();
  add("</g>\n");
  return finish(title, summary, height_ + 36);
}

}  // namespace sunder::picture
