#include <sunder/ask/report.h>
#include <sunder/picture/segments_picture.h>
#include <sunder/picture/svg_text.h>

#include <sunder/io/text.h>
#include <sunder/planar/pair/segment_segment.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::picture {

using ask::count_of;

namespace {

using planar::ContactKind;
using planar::Segment;
using planar::SegmentsContact;

// Sizes in pixels.
constexpr double width = 1600, border = 40, padding = 28, most_height = 1200, least_height = 72;
constexpr double ring_radius = 9, label_height = 16, letter_width = 7.3, gap = 3;
constexpr double tick_distance = 110, tick_letter_width = 6.2;
constexpr long merged = 3;  // bends nearer than this many tenths are merged

constexpr double longest_side = 20, fitted_side = 4;  // against the other: beyond the first, fitted to the second
constexpr std::size_t most_classes = 8, most_bold = 5000, most_told = 5, most_letters = 9;

// Colours of Okabe and Ito, which colour-blind people can tell apart; broken rings for those who see none.
struct Style {
  ContactKind kind;
  char letter;  // of its class
  const char *colour, *dashes;
};
constexpr std::array<Style, 4> styles{{{ContactKind::shared_endpoint, 's', "#009e73", "2 3"},
                                       {ContactKind::touch, 't', "#0072b2", "8 4"},
                                       {ContactKind::overlap, 'o', "#cc79a7", "none"},
                                       {ContactKind::crossing, 'c', "#d55e00", "none"}}};  // later ones lie over others

std::size_t style_of(ContactKind kind) {
  const auto* found = std::find_if(styles.begin(), styles.end(), [&](const Style& s) { return s.kind == kind; });
  return static_cast<std::size_t>(found - styles.begin());
}

// Of classes of thin lines, in turns.
constexpr std::array<const char*, 6> calm{"#66758c", "#b8965a", "#86a65c", "#a48fc0", "#5fa3ad", "#ad7564"};

// A name out of a file or a call, for XML: one line, not long.
std::string name_text(std::string_view name, std::size_t longest = 40) {
  if (name.size() <= longest) return escaped(io::one_line(name));
  while (longest > 0 && (static_cast<unsigned char>(name[longest]) & 0xc0u) == 0x80) --longest;
  return escaped(io::one_line(name.substr(0, longest))) + "...";
}

std::string about(const Point2& p) { return fmt::format("({:.10g}, {:.10g})", p.x, p.y); }

// One coordinate: from the file's unit, of any size, to pixels.
class Axis {
 public:
  void include(double value) {
    low_ = empty_ ? value : std::min(low_, value);
    high_ = empty_ ? value : std::max(high_, value);
    empty_ = false;
    // Of the order of one, so that a difference neither overflows nor vanishes.
    std::frexp(std::max(std::fabs(low_), std::fabs(high_)), &exponent_);
    from_ = std::ldexp(low_, -exponent_);
    extent_ = std::ldexp(high_, -exponent_) - from_;
  }

  bool flat() const { return extent_ == 0; }

  // How many times the other's extent: may be 0 or infinite.
  double ratio_to(const Axis& other) const { return std::ldexp(extent_ / other.extent_, exponent_ - other.exponent_); }

  // Pixels: of the lowest value, and from there to the highest.
  void place(double start, double length) {
    start_ = start;
    length_ = length;
  }

  double at(double value) const {
    return start_ + length_ * (flat() ? 0.5 : (std::ldexp(value, -exponent_) - from_) / extent_);
  }

  // Round values; if doubles are too coarse for these, the extremes.
  std::vector<std::pair<double, std::string>> ticks() const {
    const auto exact = [](double value) { return std::pair(value, fmt::format("{}", value + 0.0)); };
    if (flat()) return {exact(low_)};
    std::vector<std::pair<double, std::string>> extremes{exact(low_), exact(high_)};
    const double parts = std::clamp(std::floor(std::fabs(length_) / tick_distance), 3.0, 10.0);
    const double least = high_ / parts - low_ / parts;
    if (!std::isnormal(least) || least < 1e-9 * std::max(std::fabs(low_), std::fabs(high_))) return extremes;
    const double decade = std::pow(10, std::floor(std::log10(least)));
    double step = 10 * decade;
    for (const double part : {5.0, 2.0, 1.0}) {
      if (part * decade >= 0.999 * least) step = part * decade;
    }
    if (!std::isnormal(step)) return extremes;
    std::vector<std::pair<double, std::string>> round;
    for (double k = std::ceil(low_ / step); k * step <= high_; ++k) {
      round.emplace_back(k * step, fmt::format("{:.12g}", k * step + 0.0));
    }
    return round.size() < 2 ? extremes : round;
  }

 private:
  bool empty_ = true;
  double low_ = 0, high_ = 0;
  int exponent_ = 0;
  double from_ = 0, extent_ = 0;  // scaled by 2^-exponent
  double start_ = 0, length_ = 0;
};

// In whole tenths.
struct Pixel {
  long x = 0, y = 0;
  friend auto operator<=>(const Pixel&, const Pixel&) = default;
};

// SVG path data of segments, steps relative: short. Segments that share an end with the one before become one line.
class PathData {
 public:
  PathData(const Axis& x, const Axis& y) : x_(x), y_(y) {}

  // next: the segment that is added next, or null. whole: no end of this one is merged.
  void add(const Segment& s, const Segment* next, bool whole) {
    if (open_ && (s.a == end_ || s.b == end_)) {
      line(s.a == end_ ? s.b : s.a, whole);
      return;
    }
    finish();
    const auto is_of_next = [&](const Point2& p) { return next != nullptr && (p == next->a || p == next->b); };
    const bool backwards = is_of_next(s.a) && !is_of_next(s.b);
    open_ = true;
    written_ = false;
    last_ = skipped_ = pixel(backwards ? s.b : s.a);
    line(backwards ? s.a : s.b, whole);
  }

  // Ends the line. One that is all in one place is a dot; a second dot there is left out.
  void finish() {
    if (!open_) return;
    open_ = false;
    if (skipped_ != last_) step(skipped_);
    if (!written_ && dots_.insert(last_).second) step(last_);
  }

  const std::string& text() const { return text_; }

 private:
  Pixel pixel(const Point2& p) const { return {std::lround(10 * x_.at(p.x)), std::lround(10 * y_.at(p.y))}; }

  void line(const Point2& to, bool whole) {
    end_ = to;
    const Pixel p = pixel(to);
    if (whole && skipped_ != last_) step(skipped_);
    if (!whole && std::abs(p.x - last_.x) < merged && std::abs(p.y - last_.y) < merged) {
      skipped_ = p;
    } else {
      step(p);
    }
  }

  void step(const Pixel& p) {
    if (!written_) {
      if (text_.size() - line_begin_ > 200) {
        text_ += '\n';
        line_begin_ = text_.size();
      }
      write('m', last_.x - pen_.x, last_.y - pen_.y);
    }
    write(written_ ? ' ' : 'l', p.x - last_.x, p.y - last_.y);
    written_ = true;
    last_ = skipped_ = pen_ = p;
  }

  void write(char letter, long x, long y) {
    if (letter != ' ' || x >= 0) text_ += letter;
    fmt::format_to(std::back_inserter(text_), "{}{}{}", x, y < 0 ? "" : " ", y);
  }

  const Axis &x_, &y_;
  bool open_ = false, written_ = false;  // written: the line has a step
  Point2 end_;                           // of the last segment added
  Pixel last_, skipped_, pen_;           // last written; the end that was merged with it, if any; where the pen is
  std::set<Pixel> dots_;
  std::string text_;
  std::size_t line_begin_ = 0;
};

// One ring, with the number or numbers of its contacts.
struct Mark {
  double x = 0, y = 0;                 // of its first contact
  std::vector<std::uint32_t> numbers;  // counted from 0; not sorted
  std::uint32_t low = 0, high = 0;     // the first and the last of them

  // XML: "3", "3, 8", "12-37"; where that is long, or would be, how many they are.
  std::string label() const {
    std::string text = fmt::format("{}", low + 1);
    if (numbers.size() == 1) return text;
    text += fmt::format("{}{}", numbers.size() == 2 ? ", " : "-", high + 1);
    const bool whole = numbers.size() == 2 || high - low + 1 == numbers.size();
    return whole && text.size() <= most_letters ? text : fmt::format("{}&#215;", numbers.size());
  }

  double label_width() const {
    const std::string text = label();
    return letter_width * static_cast<double>(text.find('&') == std::string::npos ? text.size() : text.find('&') + 1);
  }

  // Where the label begins: on the right of the ring, or on the left if it would leave the picture.
  double label_left() const {
    const double right = x + ring_radius + gap;
    return right + label_width() < width - border ? right : x - ring_radius - gap - label_width();
  }

  // Both ends of a ring with its label.
  double left() const { return std::min(x - ring_radius, label_left()); }
  double right() const { return std::max(x + ring_radius, label_left() + label_width()); }

  bool overlaps(const Mark& other) const {
    return std::fabs(y - other.y) < 2 * ring_radius + gap && left() < other.right() + gap &&
           other.left() < right() + gap;
  }

  void join(Mark other) {
    if (other.low < low) std::swap(*this, other);
    high = std::max(high, other.high);
    if (numbers.size() < other.numbers.size()) numbers.swap(other.numbers);
    numbers.insert(numbers.end(), other.numbers.begin(), other.numbers.end());
  }
};

// Marks of which no two overlap: one that would is joined with the nearest that it overlaps, until none is left.
class Marks {
 public:
  void add(Mark mark) {
    for (auto [cell, k] = nearest(mark); cell != nullptr; std::tie(cell, k) = nearest(mark)) {
      mark.join(std::move((*cell)[k]));
      cell->erase(cell->begin() + static_cast<std::ptrdiff_t>(k));
    }
    cells_[cell_of(mark)].push_back(std::move(mark));
  }

  using Cell = std::pair<long, long>;  // row, column; never with many marks
  const std::map<Cell, std::vector<Mark>>& cells() const { return cells_; }

 private:
  static Cell cell_of(const Mark& mark) {
    constexpr double cell_width = 2 * ring_radius + 2 * gap + letter_width * (most_letters + 1);  // a mark is no wider
    return {std::lround(mark.y / (2 * ring_radius + gap)), std::lround(mark.x / cell_width)};
  }

  // The nearest of those that it overlaps: its cell and place there.
  std::pair<std::vector<Mark>*, std::size_t> nearest(const Mark& mark) {
    std::pair<std::vector<Mark>*, std::size_t> found(nullptr, 0);
    double least = std::numeric_limits<double>::infinity();
    const auto [row, column] = cell_of(mark);
    for (long r = row - 1; r <= row + 1; ++r) {
      for (long c = column - 2; c <= column + 2; ++c) {
        const auto cell = cells_.find({r, c});
        if (cell == cells_.end()) continue;
        for (std::size_t k = 0; k < cell->second.size(); ++k) {
          const Mark& other = cell->second[k];
          const double away = std::hypot(mark.x - other.x, mark.y - other.y);
          if (away >= least || !mark.overlaps(other)) continue;
          found = {&cell->second, k};
          least = away;
        }
      }
    }
    return found;
  }

  std::map<Cell, std::vector<Mark>> cells_;
};

class Picture {
 public:
  explicit Picture(const SegmentsPicture& picture)
      : file_(picture.file), segments_(picture.segments), contacts_(picture.contacts), y_down_(picture.y_down) {
    in_contact_.resize(segments_.size());
    for (const Segment& s : segments_.all()) {
      for (const Point2& p : {s.a, s.b}) {
        x_.include(p.x);
        y_.include(p.y);
      }
    }
    for (const SegmentsContact& contact : contacts_) {
      in_contact_[contact.i] = in_contact_[contact.j] = true;
      ++count_[style_of(contact.kind)];
    }
  }

  std::string text(const std::string& title) {
    words(border, 46, 22, "#1f2a3a", name_text(title.empty() ? "Which of these segments meet?" : title, 110), 600);
    words(border, 74, 15, "#1f2a3a", summary());
    fit(legend(102));
    frame();
    lines();
    places();
    const double height = notes();
    return fmt::format(
               "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' "
               "height='{1:.0f}'>\n<style>{2}</style>\n<rect width='100%' height='100%' fill='#fff'/>\n",
               width, height, rules()) +
           out_ + "</svg>\n";
  }

 private:
  static std::string rules() {
    std::string text =
        "text{font-family:Inter,'Helvetica Neue',Helvetica,Arial,sans-serif}.k{font-size:11px;fill:#55677f}"
        ".g{stroke:#e9ecf1}.m text{font-size:12px;font-weight:600;fill:#1f2a3a}.m rect{fill:#fff;fill-opacity:.85}"
        ".m circle{fill:#fff;fill-opacity:.35;stroke-width:2.5;stroke:#333}.m:hover circle{stroke-width:5}";
    for (const Style& style : styles) {
      text += fmt::format(".{0} circle{{stroke:{1};stroke-dasharray:{2}}}path.{0}{{stroke:{1}}}", style.letter,
                          style.colour, style.dashes);
    }
    return text;
  }

  void words(double x, double y, double size, const char* colour, const std::string& xml, int weight = 400) {
    out_ += fmt::format("<text x='{:.1f}' y='{:.1f}' font-size='{:.0f}' fill='{}' font-weight='{}'>{}</text>\n", x, y,
                        size, colour, weight, xml);
  }

  std::string summary() const {
    std::string text =
        fmt::format("{} of {}", count_of(file_.segments.size(), "segment"), count_of(file_.features.size(), "feature"));
    if (!file_.layers.empty()) text += ", " + count_of(file_.layers.size(), "layer");
    if (!file_.groups.empty()) text += ", " + count_of(file_.groups.size(), "group");
    if (contacts_.empty()) return text + "; none meet";
    return text + "; " + count_of(contacts_.size(), "pair") + (contacts_.size() == 1 ? " meets" : " meet");
  }

  // Thin lines are in classes: their names, and that of each segment; both empty if all are of one.
  using Classes = std::pair<std::span<const std::string>, std::span<const std::uint32_t>>;
  Classes classes() const {
    if (file_.layers.size() > 1) return {file_.layers, file_.layer};
    const bool some = file_.layers.empty() && file_.groups.size() > 1 && file_.groups.size() <= most_classes;
    return some ? Classes(file_.groups, file_.group) : Classes();
  }

  // Returns its lower end.
  double legend(double y) {
    double x = border;
    const auto entry = [&](const std::string& sign, const std::string& xml, std::size_t letters, bool grey = false) {
      const double size = 34 + 6.9 * static_cast<double>(letters);
      if (x + size > width - border) {
        x = border;
        y += 24;
      }
      out_ += fmt::format("<g transform='translate({:.1f} {:.1f})'>{}</g>\n", x, y, sign);
      words(x + 27, y + 4.5, 13, grey ? "#9aa6b5" : "#1f2a3a", xml);
      x += size + 16;
    };
    for (std::size_t k = contacts_.empty() ? 0 : styles.size(); k-- > 0;) {
      const std::string text = fmt::format("{} {}", name_of(styles[k].kind), count_[k]);
      entry(fmt::format("<g class='m {}'><circle cx='10' r='{}'/></g>", styles[k].letter, ring_radius), text,
            text.size(), count_[k] == 0);
    }
    const auto [names, of_segment] = classes();
    for (std::size_t k = 0; k < std::min(names.size(), most_classes); ++k) {
      const std::string text = name_text(names[k], 24);
      entry(fmt::format("<path d='M0 0h20' stroke-width='3' stroke='{}'/>", calm[k % calm.size()]), text, text.size());
    }
    if (names.size() > most_classes) entry("", fmt::format("and {} more", names.size() - most_classes), 12);
    return x > border ? y + 24 : y;
  }

  // Gives the axes their pixels, below `top`.
  void fit(double top) {
    top_ = top;
    left_ = border;
    for (int turn = 0; turn < 2; ++turn) {  // room for the ticks' texts is known after the first
      const double room = width - left_ - border - 2 * padding;
      double ratio = fitted_side;
      if (!x_.flat() && !y_.flat()) {
        ratio = x_.ratio_to(y_);
        to_scale_ = ratio <= longest_side && ratio >= 1 / longest_side;
        if (!to_scale_) ratio = ratio > 1 ? fitted_side : 1 / fitted_side;
      }
      double x_length = std::min(room, most_height * ratio), y_length = x_length / ratio;
      if (x_.flat() && !y_.flat()) std::tie(x_length, y_length) = std::pair(4 * least_height, most_height);
      if (y_.flat()) y_length = least_height;
      width_ = x_length + 2 * padding;
      height_ = y_length + 2 * padding;
      x_.place(left_ + padding, x_length);
      y_.place(y_down_ ? top_ + padding : top_ + padding + y_length, y_down_ ? y_length : -y_length);
      std::size_t letters = 0;
      for (const auto& tick : y_.ticks()) letters = std::max(letters, tick.second.size());
      if (turn == 0) left_ = std::max(border, 20 + tick_letter_width * static_cast<double>(letters));
    }
    left_ += std::max(0.0, (width - left_ - border - width_) / 2);
    x_.place(left_ + padding, width_ - 2 * padding);
  }

  void frame() {
    const double right = left_ + width_, bottom = top_ + height_;
    std::string grid;
    std::array<double, 2> taken{};  // up to here, two rows of texts
    for (const auto& [value, text] : x_.ticks()) {
      const double x = x_.at(value), half = tick_letter_width * static_cast<double>(text.size()) / 2;
      const std::size_t row = x - half < taken[0] ? 1 : 0;
      if (x - half < taken[row]) continue;
      taken[row] = x + half + 8;
      grid += fmt::format("M{:.1f} {:.1f}V{:.1f}", x, top_, bottom);
      out_ += fmt::format("<text class='k' x='{:.1f}' y='{:.1f}' text-anchor='middle'>{}</text>\n",
                          std::clamp(x, half + 4, width - half - 4), bottom + (row == 0 ? 17 : 32), text);
    }
    for (const auto& [value, text] : y_.ticks()) {
      const double y = y_.at(value);
      grid += fmt::format("M{:.1f} {:.1f}H{:.1f}", left_, y, right);
      out_ +=
          fmt::format("<text class='k' x='{:.1f}' y='{:.1f}' text-anchor='end'>{}</text>\n", left_ - 7, y + 4, text);
    }
    out_ += fmt::format("<path class='g' d='{}'/>\n", grid);
    out_ += fmt::format("<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{:.1f}' fill='none' stroke='#c5ccd6'/>\n",
                        left_, top_, width_, height_);
  }

  void path(const std::string& attributes, const std::string& data) {
    if (!data.empty()) out_ += fmt::format("<path {} d='{}'/>\n", attributes, data);
  }

  std::string data_of(const std::vector<std::uint32_t>& members, bool bold) const {
    PathData data(x_, y_);
    for (std::size_t k = 0; k < members.size(); ++k) {
      const Segment* next = k + 1 < members.size() ? &segments_[members[k + 1]] : nullptr;
      data.add(segments_[members[k]], next, bold || in_contact_[members[k]]);
    }
    data.finish();
    return data.text();
  }

  void lines() {
    out_ += "<g transform='scale(.1)' fill='none' stroke-linejoin='round' stroke-linecap='round'>\n";
    const auto [names, of_segment] = classes();
    std::vector<std::vector<std::uint32_t>> members(std::max(names.size(), std::size_t{1}));
    for (std::uint32_t i = 0; i < segments_.size(); ++i) members[names.empty() ? 0 : of_segment[i]].push_back(i);
    const int thin = segments_.size() <= 200 ? 16 : segments_.size() <= 5000 ? 11 : 8;
    for (std::size_t k = 0; k < members.size(); ++k) {
      path(fmt::format("stroke='{}' stroke-width='{}'", calm[k % calm.size()], thin), data_of(members[k], false));
    }
    std::array<std::set<std::uint32_t>, styles.size()> bold;
    PathData bands(x_, y_);
    for (const SegmentsContact& contact : contacts_.first(std::min(contacts_.size(), most_bold))) {
      bold[style_of(contact.kind)].insert({contact.i, contact.j});
      if (contact.kind != ContactKind::overlap) continue;
      bands.add(common_part(segments_[contact.i], segments_[contact.j]), nullptr, true);
    }
    bands.finish();
    for (std::size_t k = 0; k < styles.size(); ++k) {
      path(fmt::format("class='{}' stroke-width='22'", styles[k].letter),
           data_of({bold[k].begin(), bold[k].end()}, true));
    }
    path("class='o' stroke-width='70' stroke-opacity='.5'", bands.text());
    out_ += "</g>\n";
  }

  // Where a contact is drawn; of an overlap, in the middle.
  void places() {
    std::set<Pixel> dots;
    Marks marks;
    for (std::uint32_t k = 0; k < contacts_.size(); ++k) {
      const Segment &s = segments_[contacts_[k].i], &t = segments_[contacts_[k].j];
      if (contacts_[k].kind == ContactKind::overlap) {
        common_.push_back(common_part(s, t));
      } else {
        const Point2 point = planar::common_point_rounded(s, t);
        common_.push_back({point, point});
      }
      const auto& [a, b] = common_.back();
      Mark mark{(x_.at(a.x) + x_.at(b.x)) / 2, (y_.at(a.y) + y_.at(b.y)) / 2, {k}, k, k};
      dots.insert({std::lround(mark.x), std::lround(mark.y)});
      marks.add(std::move(mark));
    }
    std::string data;
    for (const Pixel& p : dots) data += fmt::format("M{} {}h0", p.x, p.y);
    path("stroke='#1f2a3a' stroke-width='2.6' stroke-linecap='round'", data);
    for (const auto& [cell, some] : marks.cells()) {
      for (const Mark& mark : some) write(mark);
    }
  }

  void write(const Mark& mark) {
    std::vector<std::uint32_t> numbers = mark.numbers;
    std::sort(numbers.begin(), numbers.end());
    std::array<std::size_t, styles.size()> of_kind{};
    for (const std::uint32_t k : numbers) ++of_kind[style_of(contacts_[k].kind)];
    const std::size_t first = style_of(contacts_[numbers[0]].kind);
    const bool mixed = of_kind[first] < numbers.size();
    some_mixed_ = some_mixed_ || mixed;
    some_counted_ = some_counted_ || mark.label().find('&') != std::string::npos;
    std::vector<std::string> told;
    if (numbers.size() > 1) {
      std::vector<std::string> kinds;
      for (std::size_t k = styles.size(); k-- > 0;) {
        if (of_kind[k] > 0) kinds.push_back(fmt::format("{} {}", of_kind[k], name_of(styles[k].kind)));
      }
      told.push_back(fmt::format("{} contacts: {}", numbers.size(), fmt::join(kinds, ", ")));
    }
    for (std::size_t k = 0; k < std::min(numbers.size(), most_told); ++k) told.push_back(sentence(numbers[k]));
    if (numbers.size() > most_told) told.push_back(fmt::format("and {} more", numbers.size() - most_told));
    out_ += fmt::format(
        "<g class='m {}'><title>{}</title><circle cx='{:.1f}' cy='{:.1f}' r='{}'/>"
        "<rect x='{:.1f}' y='{:.1f}' width='{:.1f}' height='{}' rx='3'/><text x='{:.1f}' y='{:.1f}'>{}</text></g>\n",
        mixed ? 'x' : styles[first].letter, fmt::join(told, "\n"), mark.x, mark.y, ring_radius, mark.label_left(),
        mark.y - label_height / 2, mark.label_width(), label_height, mark.label_left() + 1, mark.y + 4.3, mark.label());
  }

  // "contact 3: crossing of segment 12 (feature A, line 4) and segment 77 (feature B, line 9) at (x, y)"
  std::string sentence(std::uint32_t k) const {
    const SegmentsContact& contact = contacts_[k];
    std::string text = fmt::format("contact {}: {} of {} and {} ", k + 1, name_of(contact.kind), source_of(contact.i),
                                   source_of(contact.j));
    const auto& [a, b] = common_[k];
    return text + (a == b ? "at " + about(a) : fmt::format("from {} to {}", about(a), about(b)));
  }

  std::string source_of(std::uint32_t i) const {
    const io::LineSource& source = file_.source[i];
    std::string text = fmt::format("segment {} (feature {}", i, name_text(file_.features[source.feature]));
    if (!file_.groups.empty()) text += ", group " + name_text(file_.groups[file_.group[i]]);
    if (!file_.layers.empty()) text += ", layer " + name_text(file_.layers[file_.layer[i]]);
    if (source.line > 0) text += fmt::format(", line {}", source.line);
    return text + ")";
  }

  // What the reader must know; returns the picture's lower end.
  double notes() {
    double y = top_ + height_ + 58;
    const auto note = [&](const std::string& xml) {
      words(border, y, 12, "#55677f", xml);
      y += 19;
    };
    if (!to_scale_) note("Not to one scale: x and y are each fitted to the frame.");
    if (y_down_) note("y grows downwards.");
    if (some_counted_)
      note(
          "5&#215;: five contacts whose rings would lie over each other. Dots are the places of all; pointing at the "
          "ring "
          "tells about the first.");
    if (some_mixed_) note("Dark rings stand for contacts of several kinds.");
    if (contacts_.size() > most_bold) note(fmt::format("Bold: segments of the first {} contacts.", most_bold));
    return y + 6;
  }

  const io::LineFile& file_;
  const planar::Segments& segments_;
  std::span<const SegmentsContact> contacts_;
  bool y_down_ = false;
  Axis x_, y_;
  double left_ = 0, top_ = 0, width_ = 0, height_ = 0;  // the frame
  bool to_scale_ = true, some_mixed_ = false, some_counted_ = false;
  std::vector<bool> in_contact_;                    // by segment
  std::array<std::size_t, styles.size()> count_{};  // of contacts, by kind
  std::vector<Segment> common_;                     // by contact: the common point, twice, or part
  std::string out_;
};

}  // namespace

planar::Segment common_part(const planar::Segment& s, const planar::Segment& t) {
  // On one line, the lexicographic order is the order along it.
  return {planar::lexicographically_less(s.a, t.a) ? t.a : s.a, planar::lexicographically_less(s.b, t.b) ? s.b : t.b};
}

std::string segments_svg(const SegmentsPicture& picture) { return Picture(picture).text(picture.title); }

}  // namespace sunder::picture
