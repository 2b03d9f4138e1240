#include <cli/scene_picture.h>
#include <cli/scene_view.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <numbers>
#include <set>
#include <string_view>

namespace sunder::cli {

namespace {

// Sizes in pixels.
constexpr double panel_width = 560, panel_height = 560, margin = 44, header = 84, footer = 112;
constexpr std::size_t most_labels = 5;  // of one placement

struct Colour {
  double red, green, blue;
};

constexpr std::array<Colour, 2> calm{{{164, 186, 212}, {214, 222, 232}}};  // bodies in turns
constexpr std::array<Colour, 2> alarming{{{226, 74, 58}, {244, 122, 88}}};

std::string shaded(const Colour& c, double light) {
  const double k = 0.58 + 0.46 * light;
  const auto channel = [&](double x) { return static_cast<int>(std::min(255.0, x * k)); };
  return fmt::format("#{:02x}{:02x}{:02x}", channel(c.red), channel(c.green), channel(c.blue));
}

std::string escaped(std::string_view text) {
  std::string out;
  for (const char c : text) {
    switch (c) {
      case '&': out += "&amp;"; break;
      case '<': out += "&lt;"; break;
      case '>': out += "&gt;"; break;
      case '"': out += "&quot;"; break;
      default: out += c;
    }
  }
  return out;
}

// A rectangle on the picture's plane that grows with what it must hold.
struct Bounds {
  double left = 0, right = 0, top = 0, bottom = 0;
  bool empty = true;

  void include(const Seen& p) {
    if (!std::isfinite(p.x) || !std::isfinite(p.y)) return;
    left = empty ? p.x : std::min(left, p.x);
    right = empty ? p.x : std::max(right, p.x);
    top = empty ? p.y : std::min(top, p.y);
    bottom = empty ? p.y : std::max(bottom, p.y);
    empty = false;
  }
};

// From the picture's plane to pixels of one panel.
struct Frame {
  double scale = 1, x = 0, y = 0;

  double px(const Seen& p) const { return x + scale * p.x; }
  double py(const Seen& p) const { return y + scale * p.y; }
};

class Picture {
 public:
  Picture(const SceneReport& report, const std::string& title) : report_(report), title_(title) {
    floor_ = lowest();
    fit();
  }

  std::string text() {
    const double n = static_cast<double>(report_.placements.size());
    const double width = n * panel_width, height = header + panel_height + footer;
    out_ = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {0:.0f} {1:.0f}\" width=\"{0:.0f}\" height=\"{1:.0f}\" "
        "font-family=\"Inter, 'Helvetica Neue', Helvetica, Arial, sans-serif\">\n"
        "<rect width=\"{0:.0f}\" height=\"{1:.0f}\" rx=\"18\" fill=\"#fbfcfe\"/>\n",
        width, height);
    write_text(margin, 50, 24, "#1f2a3a", "600", title_);
    for (std::size_t i = 0; i < report_.placements.size(); ++i) panel(i);
    legend(height);
    return out_ + "</svg>\n";
  }

 private:
  double lowest() const {
    double low = 0;
    bool first = true;
    each_vertex([&](const Point3& p) {
      low = first ? p.z : std::min(low, p.z);
      first = false;
    });
    return low;
  }

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
    each_vertex([&](const Point3& p) {
      bounds.include(view_(p));
      bounds.include(view_({p.x, p.y, floor_}));
    });
    const double wide = bounds.right - bounds.left, high = bounds.bottom - bounds.top;
    const double scale = std::min((panel_width - 2 * margin) / wide, (panel_height - 2 * margin) / high);
    frame_.scale = std::isfinite(scale) ? scale : 1;
    frame_.x = panel_width / 2 - frame_.scale * (bounds.left + bounds.right) / 2;
    frame_.y = header + panel_height / 2 - frame_.scale * (bounds.top + bounds.bottom) / 2;
  }

  void write_text(double x, double y, double size, const char* colour, const char* weight, const std::string& text,
                  const std::string& more = "") {
    out_ += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\" font-size=\"{:.0f}\" fill=\"{}\" font-weight=\"{}\"{}>{}</text>\n",
                        x, y, size, colour, weight, more, escaped(text));
  }

  std::string path(const std::vector<Seen>& corners, const Frame& frame) const {
    std::string d;
    for (const Seen& p : corners) d += fmt::format("{}{:.1f} {:.1f}", d.empty() ? "M" : "L", frame.px(p), frame.py(p));
    return d + "z";
  }

  void panel(std::size_t i) {
    const Placed& placed = report_.placements[i];
    Frame frame = frame_;
    frame.x += static_cast<double>(i) * panel_width;
    std::set<std::uint32_t> alarmed;
    for (const scene::PartPair& pair : placed.answer.pairs) {
      if (pair.counts) alarmed.insert({pair.body_a, pair.body_b});
    }

    out_ += "<g fill=\"#26374d\" opacity=\"0.10\">\n";
    for (const auto& shadow : shadows(placed.bodies, view_, floor_)) {
      out_ += fmt::format("<path d=\"{}\"/>\n", path(shadow, frame));
    }
    out_ += "</g>\n";

    out_ += "<g stroke-linejoin=\"round\" stroke-linecap=\"round\" stroke-width=\"0.5\">\n";
    for (const SeenFacet& facet : facets_in_order(placed.bodies, view_)) {
      const bool red = alarmed.contains(facet.body);
      draw(facet, (red ? alarming : calm)[facet.body % 2], red ? "#8d2a1b" : "#55677f", frame);
    }
    out_ += "</g>\n";
    mark(placed, frame, i);
    caption(placed, i);
  }

  void draw(const SeenFacet& facet, const Colour& colour, const char* outline, const Frame& frame) {
    if (facet.corners.size() < 3) {
      const Seen &p = facet.corners.front(), &q = facet.corners.back();
      out_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"{}\" stroke-width=\"4\"/>\n", frame.px(p),
                          frame.py(p), frame.px(q), frame.py(q), shaded(colour, 0.6));
      return;
    }
    out_ += fmt::format("<path d=\"{}\" fill=\"{}\" stroke=\"{}\"/>\n", path(facet.corners, frame),
                        shaded(colour, facet.light), shaded(colour, std::min(1.0, facet.light + 0.12)));
    std::string edges;
    for (std::size_t i = 0; i < facet.corners.size(); ++i) {
      if (!facet.on_outline[i]) continue;
      const Seen &p = facet.corners[i], &q = facet.corners[(i + 1) % facet.corners.size()];
      edges += fmt::format("M{:.1f} {:.1f}L{:.1f} {:.1f}", frame.px(p), frame.py(p), frame.px(q), frame.py(q));
    }
    if (!edges.empty()) out_ += fmt::format("<path d=\"{}\" fill=\"none\" stroke=\"{}\" stroke-width=\"1.1\"/>\n", edges, outline);
  }

  // The common points, and beside them who meets.
  void mark(const Placed& placed, const Frame& frame, std::size_t number) {
    std::size_t labels = 0;
    const double left = static_cast<double>(number) * panel_width;
    for (const scene::PartPair& pair : placed.answer.pairs) {
      if (!pair.counts) continue;
      const Seen at = view_(point_about(placed, pair));
      const double x = frame.px(at), y = frame.py(at);
      out_ += fmt::format(
          "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"11\" fill=\"#ffffff\" fill-opacity=\"0.35\" stroke=\"#ffffff\" "
          "stroke-width=\"5\"/>\n<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"11\" fill=\"none\" stroke=\"#1f2a3a\" "
          "stroke-width=\"2\"/>\n<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"3\" fill=\"#1f2a3a\"/>\n",
          x, y);
      if (labels++ >= most_labels) continue;
      const bool to_right = x < left + panel_width / 2;
      const double lx = x + (to_right ? 46 : -46), ly = y - 40 - 18 * static_cast<double>(labels - 1);
      out_ += fmt::format("<path d=\"M{:.1f} {:.1f}L{:.1f} {:.1f}\" stroke=\"#1f2a3a\" stroke-width=\"1.2\" fill=\"none\"/>\n",
                          x + (to_right ? 8 : -8), y - 8, lx - (to_right ? 4 : -4), ly + 2);
      const std::string label = part_name(placed.bodies[pair.body_a], pair.part_a) + " meets " +
                                part_name(placed.bodies[pair.body_b], pair.part_b);
      const std::string anchor = to_right ? "" : " text-anchor=\"end\"";
      write_text(lx, ly, 14, "#fbfcfe", "600", label,
                 anchor + " stroke=\"#fbfcfe\" stroke-width=\"5\" stroke-linejoin=\"round\"");  // a halo
      write_text(lx, ly, 14, "#1f2a3a", "600", label, anchor);
    }
  }

  void caption(const Placed& placed, std::size_t number) {
    const double left = static_cast<double>(number) * panel_width + margin, top = header + panel_height;
    const scene::Counts& c = placed.answer.counts;
    const std::uint64_t alarms = c.meeting - c.touching_only, asked = c.pairs - c.allowed;
    if (report_.placements.size() > 1) write_text(left, top + 18, 18, "#1f2a3a", "600", placed.title);
    write_text(left, top + 42, 15, alarms > 0 ? "#c23b22" : "#2f7d5b", "600",
               alarms > 0 ? fmt::format("{} of {} pairs meet", alarms, asked) : fmt::format("none of {} pairs meet", asked));
  }

  void legend(double height) {
    const double y = height - 26;
    double x = margin;
    const auto swatch = [&](const std::string& fill, double width) {
      out_ += fmt::format("<rect x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"12\" rx=\"3\" fill=\"{}\"/>\n", x, y - 10,
                          width, fill);
      x += width + 3;
    };
    const auto words = [&](const std::string& text) {
      write_text(x + 5, y, 13, "#55677f", "400", text);
      x += 34 + 6.6 * static_cast<double>(text.size());
    };
    swatch(shaded(calm[0], 0.8), 14);
    swatch(shaded(calm[1], 0.8), 14);
    words("apart from all, or allowed");
    swatch(shaded(alarming[0], 0.8), 14);
    swatch(shaded(alarming[1], 0.8), 14);
    words("meets another");
    out_ += fmt::format("<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"6\" fill=\"none\" stroke=\"#1f2a3a\" stroke-width=\"1.5\"/>\n"
                        "<circle cx=\"{0:.1f}\" cy=\"{1:.1f}\" r=\"1.8\" fill=\"#1f2a3a\"/>\n", x + 7, y - 4);
    x += 17;
    words("common point, exact in the certificate");
  }

  const SceneReport& report_;
  const std::string& title_;
  View view_{-0.30 * std::numbers::pi, 0.11 * std::numbers::pi};
  double floor_ = 0;
  Frame frame_;
  std::string out_;
};

}  // namespace

std::string scene_picture(const SceneReport& report, const std::string& title) {
  return Picture(report, title.empty() ? "Which of these bodies meet?" : title).text();
}

}  // namespace sunder::cli
