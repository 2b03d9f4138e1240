#include <sunder/picture/scene_picture.h>
#include <sunder/picture/scene_view.h>
#include <sunder/picture/svg_text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>
#include <string_view>

namespace sunder::picture {

using ask::part_name;
using ask::Placed;
using ask::SceneReport;

namespace {

// Sizes in pixels.
constexpr double panel_width = 560, panel_height = 560, margin = 44, header = 84, footer = 112;
constexpr double label_size = 14, label_height = 22, letter_width = 0.62;  // a letter's part of the size
constexpr std::size_t most_labels = 6;                                     // of one placement

struct Colour {
  double red, green, blue;
};

// Of bodies in turns.
constexpr std::array<Colour, 2> calm{{{164, 186, 212}, {214, 222, 232}}};
constexpr std::array<Colour, 2> alarming{{{226, 74, 58}, {244, 122, 88}}};

std::string shaded(const Colour& c, double light) {
  const double k = 0.58 + 0.46 * light;
  const auto channel = [&](double x) { return static_cast<int>(std::min(255.0, x * k)); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(c.red), channel(c.green), channel(c.blue));
}

// A rectangle that grows with what it must hold.
struct Bounds {
  double left = 0, right = 0, top = 0, bottom = 0;
  bool empty = true;

  void include(double x, double y) {
    if (!std::isfinite(x) || !std::isfinite(y)) return;
    left = empty ? x : std::min(left, x);
    right = empty ? x : std::max(right, x);
    top = empty ? y : std::min(top, y);
    bottom = empty ? y : std::max(bottom, y);
    empty = false;
  }
};

// From the picture's plane to pixels.
struct Frame {
  double scale = 1, x = 0, y = 0;

  double px(const Seen& p) const { return x + scale * p.x; }
  double py(const Seen& p) const { return y + scale * p.y; }
};

// SVG path data in whole tenths of pixels, steps relative: short.
class PathData {
 public:
  explicit PathData(const Frame& frame) : frame_(frame) {}

  void move(const Seen& p) { step('M', p, 0, 0); }
  void line(const Seen& p) { step('l', p, x_, y_); }
  void close() { text_ += 'z'; }
  const std::string& text() const { return text_; }

 private:
  void step(char letter, const Seen& p, long from_x, long from_y) {
    x_ = std::lround(10 * frame_.px(p));
    y_ = std::lround(10 * frame_.py(p));
    text_ += fmt::format("{}{}{}{}", letter, x_ - from_x, y_ - from_y < 0 ? "" : " ", y_ - from_y);
  }

  const Frame& frame_;
  long x_ = 0, y_ = 0;
  std::string text_;
};

std::string outline_of(const std::vector<Seen>& corners, const Frame& frame) {
  PathData path(frame);
  path.move(corners.front());
  for (std::size_t i = 1; i < corners.size(); ++i) path.line(corners[i]);
  path.close();
  return path.text();
}

std::string edges_of(const Piece& piece, Edge kind, const Frame& frame) {
  PathData path(frame);
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    if (piece.edges[i] != kind) continue;
    path.move(piece.corners[i]);
    path.line(piece.corners[(i + 1) % piece.corners.size()]);
  }
  return path.text();
}

class Picture {
 public:
  explicit Picture(const SceneReport& report) : report_(report) {
    bool first = true;
    each_vertex([&](const Point3& p) {
      floor_ = first ? p.z : std::min(floor_, p.z);
      first = false;
    });
    fit();
  }

  std::string text(const std::string& title) {
    const double width = panel_width * static_cast<double>(report_.placements.size());
    const double height = header + panel_height + footer;
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" "
        "height=\"{1:.0f}\" "
        "font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\">\n"
        "<style>.o,.r{{fill:none;stroke-width:10}}.o{{stroke:#46586f}}.r{{stroke:#7d2115}}</style>\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" rx=\"18\" fill=\"#fbfcfe\"/>\n",
        width, height);
    write_text(margin, 50, 24, "#1f2a3a", 600, title);
    for (std::size_t i = 0; i < report_.placements.size(); ++i) panel(i);
    legend(height - 26);
    return out_ + "</svg>\n";
  }

 private:
  template <class Visit>
  void each_vertex(const Visit& visit) const {
    for (const Placed& placed : report_.placements) {
      for (const scene::Body& body : placed.bodies) {
        for (const scene::Part& part : body.parts) {
          for (const Point3& p : world_vertices(part)) visit(p);
        }
      }
    }
  }

  // Puts all placements, with their shadows, into the same frame.
  void fit() {
    Bounds bounds;
    const auto include = [&](const Seen& p) { bounds.include(p.x, p.y); };
    each_vertex([&](const Point3& p) {
      include(view_(p));
      include(view_({p.x, p.y, floor_}));
    });
    const double scale = std::min((panel_width - 2 * margin) / (bounds.right - bounds.left),
                                  (panel_height - 2 * margin) / (bounds.bottom - bounds.top));
    frame_.scale = std::isfinite(scale) ? scale : 1;
    frame_.x = panel_width / 2 - frame_.scale * (bounds.left + bounds.right) / 2;
    frame_.y = header + panel_height / 2 - frame_.scale * (bounds.top + bounds.bottom) / 2;
  }

  void write_text(double x, double y, double size, const char* colour, int weight, const std::string& text,
                  const std::string& more = "") {
    out_ +=
        fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.0f}\" fill=\"{}\" font-weight=\"{}\"{}>{}</text>\n",
                    x, y, size, colour, weight, more, escaped(text));
  }

  void circle(double x, double y, double radius, const char* more) {
    out_ += fmt::format("<circle cx=\"{:.1f}\" cy=\"{:.1f}\" r=\"{}\" {}/>\n", x, y, radius, more);
  }

  void panel(std::size_t number) {
    const Placed& placed = report_.placements[number];
    const double left = panel_width * static_cast<double>(number);
    Frame frame = frame_;
    frame.x += left;
    std::set<std::uint32_t> alarmed;
    for (const scene::PartPair& pair : placed.answer.pairs) {
      if (pair.counts) alarmed.insert({pair.body_a, pair.body_b});
    }

    out_ += "<g transform=\"scale(.1)\" stroke-linejoin=\"round\" stroke-linecap=\"round\">\n";
    out_ += "<g fill=\"#26374d\" opacity=\"0.10\">\n";
    for (const auto& shadow : shadows(placed.bodies, view_, floor_)) {
      out_ += fmt::format("<path d=\"{}\"/>\n", outline_of(shadow, frame));
    }
    out_ += "</g>\n<g stroke-width=\"5\">\n";
    const std::vector<Piece> pieces = seen_pieces(placed.bodies, view_);
    for (const Piece& piece : pieces) {
      const bool red = alarmed.contains(piece.body);
      draw(piece, (red ? alarming : calm)[piece.body % 2], red ? 'r' : 'o', frame);
    }
    out_ += "</g>\n</g>\n";
    mark(placed, pieces, frame, left);
    caption(placed, left + margin);
  }

  void draw(const Piece& piece, const Colour& colour, char outline_class, const Frame& frame) {
    const std::string fill = shaded(colour, piece.light);
    if (piece.corners.size() < 3) {
      out_ +=
          fmt::format("<path d=\"{}\" stroke=\"{}\" stroke-width=\"40\"/>\n", outline_of(piece.corners, frame), fill);
      return;
    }
    // Strokes hide the seams between neighbours; a little lighter, they show the facets.
    const bool cut = std::find(piece.edges.begin(), piece.edges.end(), Edge::cut) != piece.edges.end();
    const std::string edge = shaded(colour, piece.light + 0.1);
    out_ += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", outline_of(piece.corners, frame), fill,
                        cut ? fill : edge);
    const std::string inner = cut ? edges_of(piece, Edge::inner, frame) : "";
    const std::string outline = edges_of(piece, Edge::outline, frame);
    if (!inner.empty()) out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\"/>\n", inner, edge);
    if (!outline.empty()) out_ += fmt::format("<path class=\"{}\" d=\"{}\"/>\n", outline_class, outline);
  }

  // The common points, and beside the bodies who meets there.
  void mark(const Placed& placed, const std::vector<Piece>& pieces, const Frame& frame, double left) {
    std::vector<Bounds> taken;
    for (const Piece& piece : pieces) {
      Bounds of_piece;
      for (const Seen& p : piece.corners) of_piece.include(frame.px(p), frame.py(p));
      taken.push_back(of_piece);
    }
    std::size_t labels = 0;
    for (const scene::PartPair& pair : placed.answer.pairs) {
      if (!pair.counts) continue;
      const Seen at = view_(point_about(placed, pair));
      const double x = frame.px(at), y = frame.py(at);
      if (labels++ < most_labels) {
        const std::string text = part_name(placed.bodies[pair.body_a], pair.part_a) + " meets " +
                                 part_name(placed.bodies[pair.body_b], pair.part_b);
        const Bounds place =
            free_place(x, y, letter_width * label_size * static_cast<double>(text.size()), taken, left);
        taken.push_back(place);
        label(x, y, place, text);
      }
      circle(x, y, 11, "fill=\"#fff\" fill-opacity=\".4\" stroke=\"#fff\" stroke-width=\"5\"");
      circle(x, y, 11, "fill=\"none\" stroke=\"#1f2a3a\" stroke-width=\"2\"");
      circle(x, y, 3, "fill=\"#1f2a3a\"");
    }
  }

  // A text in its place, and a line to it; both with a halo.
  void label(double x, double y, const Bounds& place, const std::string& text) {
    const double to_x = std::clamp(x, place.left - 4, place.right + 4),
                 to_y = std::clamp(y, place.top + 2, place.bottom);
    const std::string line =
        fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" fill=\"none\" stroke=", x, y, to_x, to_y);
    out_ += line + "\"#fbfcfe\" stroke-width=\"4\"/>\n" + line + "\"#1f2a3a\" stroke-width=\"1.3\"/>\n";
    const double middle = (place.left + place.right) / 2;
    const std::string centred = " text-anchor=\"middle\"";
    write_text(middle, place.bottom - 6, label_size, "#fbfcfe", 600, text,
               centred + " stroke=\"#fbfcfe\" stroke-width=\"5\"");
    write_text(middle, place.bottom - 6, label_size, "#1f2a3a", 600, text, centred);
  }

  // A place for a label of this width as near to (x, y) as can be found, within the panel and over nothing that is
  // taken; where there is none, at (x, y).
  static Bounds free_place(double x, double y, double width, const std::vector<Bounds>& taken, double left) {
    constexpr double step = 11, gap = 16, border = 10;
    const double most_left = left + border, most_right = std::max(most_left, left + panel_width - border - width);
    Bounds best{most_left, most_left + width, y - label_height / 2, y + label_height / 2, true};
    double least = 0;
    const int rows = static_cast<int>((panel_height - label_height) / step) + 1;
    const int columns = static_cast<int>((most_right - most_left) / step) + 1;
    for (int row = 0; row < rows; ++row) {
      const double top = header + row * step;
      for (int column = 0; column < columns; ++column) {
        const double first = most_left + column * step;
        const Bounds place{first, first + width, top, top + label_height, false};
        const double dx = x - std::clamp(x, place.left, place.right), dy = y - std::clamp(y, place.top, place.bottom);
        const double beside = x - (place.left + place.right) / 2;  // a centred place is a little better
        const double cost = dx * dx + dy * dy + 0.05 * beside * beside;
        if (dx * dx + dy * dy < 4 * gap * gap || (!best.empty && cost >= least)) continue;
        const bool is_free = std::none_of(taken.begin(), taken.end(), [&](const Bounds& b) {
          return b.left - gap < place.right && place.left < b.right + gap && b.top - 2 < place.bottom &&
                 place.top < b.bottom + 2;
        });
        if (!is_free) continue;
        best = place;
        least = cost;
      }
    }
    return best;
  }

  void caption(const Placed& placed, double left) {
    const double top = header + panel_height;
    const scene::Counts& c = placed.answer.counts;
    const std::uint64_t meeting = c.meeting - c.touching_only, asked = c.pairs - c.allowed;
    if (report_.placements.size() > 1) write_text(left, top + 18, 18, "#1f2a3a", 600, placed.title);
    write_text(
        left, top + 42, 15, meeting > 0 ? "#c23b22" : "#2f7d5b", 600,
        meeting > 0 ? fmt::format("{} of {} pairs meet", meeting, asked) : fmt::format("none of {} pairs meet", asked));
  }

  void legend(double y) {
    double x = margin;
    const auto swatch = [&](const Colour& colour) {
      out_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"14\" height=\"12\" rx=\"3\" fill=\"{}\"/>\n", x,
                          y - 10, shaded(colour, 0.8));
      x += 17;
    };
    const auto words = [&](const std::string& text) {
      write_text(x + 5, y, 13, "#55677f", 400, text);
      x += 28 + 6.6 * static_cast<double>(text.size());
    };
    for (const Colour& colour : calm) swatch(colour);
    words("apart, or allowed to meet");
    for (const Colour& colour : alarming) swatch(colour);
    words("meets another");
    circle(x + 7, y - 4, 6, "fill=\"none\" stroke=\"#1f2a3a\" stroke-width=\"1.5\"");
    circle(x + 7, y - 4, 1.8, "fill=\"#1f2a3a\"");
    x += 17;
    words("a common point");
  }

  const SceneReport& report_;
  View view_{-0.30 * std::numbers::pi, 0.11 * std::numbers::pi};
  double floor_ = 0;
  Frame frame_;
  std::string out_;
};

}  // namespace

std::string scene_picture(const SceneReport& report, const std::string& title) {
  return Picture(report).text(title.empty() ? "Which of these bodies meet?" : title);
}

}  // namespace sunder::picture
