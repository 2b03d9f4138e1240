#include <sunder/picture/painter.h>
#include <sunder/picture/rings.h>
#include <sunder/picture/scene.h>
#include <sunder/picture/view.h>

#include <sunder/certificate/direction.h>
#include <sunder/certificate/rounded_evidence.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace sunder::picture {

namespace {

// Sizes in pixels.
constexpr double panel_width = 560, panel_height = 540, margin = 44, caption_height = 19;
// Contacts of a placement that are told in words: few in one column, more in two of smaller letters.
constexpr std::size_t most_in_column = 6, most_named = 40, longest_in_two = 38;
constexpr std::size_t longest_note = 66;  // in the widest of usual fonts
constexpr double small_row_height = 15;
constexpr std::array<RingKind, 1> meeting{{{Ink::dark, "meeting"}}};

// Of bodies in turns.
constexpr std::array<Colour, 2> calm{{plain_body, {214, 222, 232}}};
constexpr std::array<Colour, 2> alarming{{{226, 74, 58}, {244, 122, 88}}};

// In lines that fit into a panel, broken between words.
std::vector<std::string> wrapped(std::string_view text) {
  std::vector<std::string> lines;
  while (text.size() > longest_note) {
    const std::size_t blank = text.rfind(' ', longest_note);
    const std::size_t end = blank == std::string_view::npos || blank == 0 ? longest_note : blank;
    lines.emplace_back(text.substr(0, end));
    text.remove_prefix(std::min(end + (end == blank ? 1 : 0), text.size()));
  }
  lines.emplace_back(text);
  return lines;
}

// A part as it is drawn, with its corners in the world, rounded.
struct Placed {
  std::uint32_t body;
  const scene::Part* part;
  solid::DrawnBody drawn;
  std::vector<Point3> points;
};

std::vector<Placed> placed_parts(const ScenePanel& panel) {
  std::vector<Placed> parts;
  for (std::uint32_t b = 0; b < panel.bodies.size(); ++b) {
    for (const scene::Part& part : panel.bodies[b].parts) {
      parts.push_back({b, &part, drawn_as(part.shape), {}});
      const std::span<const Point3> corners = parts.back().drawn.polyhedron.vertices();
      const PlacedVertices vertices{corners, part.pose.affine(), false};
      for (std::uint32_t v = 0; v < corners.size(); ++v) {
        const Vector3<double> p = rounded_image(vertices[v]);
        parts.back().points.push_back({p.x, p.y, p.z});
      }
    }
  }
  return parts;
}

// What of a part is turned towards the viewer. Its facets run counter-clockwise seen from outside, clockwise where the
// pose reflects.
void add_pieces(const Placed& placed, std::uint32_t number, const View& view, std::vector<Piece>& out) {
  const solid::ConvexPolyhedron& shape = placed.drawn.polyhedron;
  std::vector<Seen> points;
  for (const Point3& p : placed.points) points.push_back(view(p));
  if (shape.dimension() < 2) {
    const std::vector<bool> outline(points.size(), true);
    out.push_back({placed.body, number, 1, std::move(points), outline});
    return;
  }
  const auto& m = placed.part->pose.affine().linear;
  const double determinant = dot(Seen{m[0], m[1], m[2]}, cross(Seen{m[3], m[4], m[5]}, Seen{m[6], m[7], m[8]}));
  const double outwards = determinant < 0 ? 1 : -1;         // y runs down
  std::vector<std::uint32_t> facets;                        // those that are seen
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  // of these, as they run
  const auto each_edge = [&](std::uint32_t f, const auto& visit) {
    const auto facet = shape.facet(f);
    for (std::size_t i = 0; i < facet.size(); ++i) visit(facet[i], facet[(i + 1) % facet.size()]);
  };
  for (std::uint32_t f = 0; f < shape.facet_count(); ++f) {
    Piece piece{placed.body, number, 0, {}, {}};
    for (const std::uint32_t v : shape.facet(f)) piece.corners.push_back(points[v]);
    const Seen n = normal_of(piece.corners), normal{outwards * n.x, outwards * n.y, outwards * n.z};
    if (!(normal.z > 0)) continue;
    piece.light = light_on(normal);
    each_edge(f, [&](std::uint32_t from, std::uint32_t to) { edges.insert({from, to}); });
    facets.push_back(f);
    out.push_back(std::move(piece));
  }
  auto piece = out.end() - static_cast<std::ptrdiff_t>(facets.size());
  for (const std::uint32_t f : facets) {
    each_edge(f, [&](std::uint32_t from, std::uint32_t to) { piece->outline.push_back(!edges.contains({to, from})); });
    ++piece;
  }
}

std::string outline_edges(const Piece& piece) {
  PathData path;
  for (std::size_t i = 0; i < piece.corners.size(); ++i) {
    if (!piece.outline[i]) continue;
    path.move(tenths(piece.corners[i]));
    path.line(tenths(piece.corners[(i + 1) % piece.corners.size()]));
  }
  return path.text();
}

class SceneDrawing {
 public:
  explicit SceneDrawing(std::span<const ScenePanel> panels)
      : panels_(panels), canvas_(panel_width * static_cast<double>(panels.size())) {
    for (const ScenePanel& panel : panels) parts_.push_back(placed_parts(panel));
    each_vertex([&](const Point3& p) { floor_ = std::min(floor_, p.z); });
    legend();
    fit();
  }

  std::string text(std::string_view title) {
    double bottom = 0;
    for (std::size_t k = 0; k < panels_.size(); ++k) bottom = std::max(bottom, panel(k));
    return canvas_.finish(title, "", bottom);
  }

 private:
  void each_vertex(const std::function<void(const Point3&)>& visit) const {
    for (const std::vector<Placed>& parts : parts_) {
      for (const Placed& part : parts) std::for_each(part.points.begin(), part.points.end(), visit);
    }
  }

  // Puts all placements, with their shadows, into the same frame.
  void fit() {
    std::optional<Box2> seen;
    each_vertex([&](const Point3& vertex) {
      for (const Seen& s : {view_(vertex), view_({vertex.x, vertex.y, floor_})}) {
        const Point2 p{s.x, s.y};
        if (std::isfinite(p.x) && std::isfinite(p.y)) seen = hull(seen.value_or(Box2{p, p}), {p, p});
      }
    });
    const auto [low, high] = seen.value_or(Box2{});
    const double scale =
        std::min((panel_width - 2 * margin) / (high.x - low.x), (panel_height - 2 * margin) / (high.y - low.y));
    view_.scale = std::isfinite(scale) ? scale : 1;
    view_.x = panel_width / 2 - view_.scale * (low.x + high.x) / 2;
    view_.y = panel_height / 2 - view_.scale * (low.y + high.y) / 2;
  }

  void legend() {
    const auto swatches = [](const std::array<Colour, 2>& colours) {
      return fmt::format(
          "<rect x='-8' y='-6' width='14' height='12' rx='3' fill='{}'/>"
          "<rect x='8' y='-6' width='14' height='12' rx='3' fill='{}'/>",
          shaded(colours[0], 0.8), shaded(colours[1], 0.8));
    };
    canvas_.legend(swatches(calm), "apart, or allowed to meet");
    canvas_.legend(swatches(alarming), "meets another");
    if (some_hull())
      canvas_.legend("", some_mesh() ? "meshes that are not convex are drawn as their hulls"
                                     : "meshes that are not convex are asked about, and drawn, as their hulls");
    if (some_round()) canvas_.legend("", "balls, cylinders and the like are drawn by polyhedra inside of them");
    canvas_.legend("<g class='m x'><circle cx='10' r='9'/></g>", "a common point");
  }

  bool some_hull() const {
    for (const ScenePanel& panel : panels_) {
      for (std::uint32_t b = 0; panel.is_hull && b < panel.bodies.size(); ++b) {
        for (std::uint32_t p = 0; p < panel.bodies[b].parts.size(); ++p) {
          if (panel.is_hull(b, p)) return true;
        }
      }
    }
    return false;
  }

  bool some_mesh() const {
    return std::any_of(panels_.begin(), panels_.end(), [](const ScenePanel& panel) {
      return std::any_of(panel.bodies.begin(), panel.bodies.end(), [](const scene::Body& body) {
        return std::any_of(body.parts.begin(), body.parts.end(),
                           [](const scene::Part& part) { return part.mesh != nullptr; });
      });
    });
  }

  bool some_round() const {
    return std::any_of(parts_.begin(), parts_.end(), [](const std::vector<Placed>& parts) {
      return std::any_of(parts.begin(), parts.end(), [](const Placed& p) { return !p.drawn.is_all; });
    });
  }

  // Returns its lower end.
  double panel(std::size_t number_of_panel) {
    const ScenePanel& panel = panels_[number_of_panel];
    const std::vector<Placed>& parts = parts_[number_of_panel];
    const double left = panel_width * static_cast<double>(number_of_panel);
    View view = view_;
    view.x += left;
    std::vector<const scene::PartPair*> contacts;
    std::set<std::uint32_t> alarmed;
    for (const scene::PartPair& pair : panel.answer.pairs) {
      if (!pair.counts) continue;
      contacts.push_back(&pair);
      alarmed.insert({pair.body_a, pair.body_b});
    }
    canvas_.add("<g transform='scale(.1)' stroke-linejoin='round' stroke-linecap='round'>\n");
    shadows(parts, view);
    std::vector<Piece> pieces;
    for (std::uint32_t k = 0; k < parts.size(); ++k) add_pieces(parts[k], k, view, pieces);
    canvas_.add("<g stroke-width='5'>\n");
    for (const Piece& piece : in_painters_order(std::move(pieces))) {
      const bool red = alarmed.contains(piece.body);
      draw(piece, (red ? alarming : calm).at(piece.body % 2), red ? 'r' : 'b');
    }
    canvas_.add("</g>\n</g>\n");

    const auto told = [&](std::size_t k) { return panel.told(*contacts[k]); };
    std::vector<RingContact> places;
    for (std::uint32_t k = 0; k < contacts.size(); ++k) {
      const Seen at = view(common_point(panel, *contacts[k]));
      places.push_back({{at.x, at.y}, k, 0});
    }
    draw_rings(canvas_, places, meeting, left + panel_width,
               [&](std::uint32_t k) { return fmt::format("contact {}: {}", k + 1, told(k)); });

    double y = panel_height + 18;
    const auto row = [&](double size, const char* colour, const std::string& text, const char* weight) {
      canvas_.add(words(left + margin, y, size, colour, text, weight));
      y += caption_height;
    };
    if (panels_.size() > 1) row(18, text_colour, std::string(panel.title), "font-weight='600'");
    const scene::Counts& c = panel.answer.counts;
    const std::uint64_t meet = c.meeting - c.touching_only, asked = c.pairs - c.allowed;
    y += 4;
    row(15, meet > 0 ? "#c23b22" : "#2f7d5b",
        meet > 0 ? fmt::format("{} of {} pairs meet{}", meet, asked, meet == 1 ? "s" : "")
                 : fmt::format("none of {} pairs {}", asked, c.undecided > 0 ? "is known to meet" : "meet"),
        "font-weight='600'");
    if (c.undecided > 0) row(13, text_colour, fmt::format("undecided: {}", c.undecided), "");
    const std::size_t named = std::min(contacts.size(), most_named);
    if (named <= most_in_column) {
      for (std::size_t k = 0; k < named; ++k) {
        row(13, text_colour, fmt::format("{}. {}", k + 1, shortened(told(k), 70)), "");
      }
    } else {
      const std::size_t rows = (named + 1) / 2;
      for (std::size_t k = 0; k < named; ++k) {
        const double x = left + margin + (k < rows ? 0 : (panel_width - margin) / 2);
        canvas_.add(words(x, y + small_row_height * static_cast<double>(k < rows ? k : k - rows), 11, text_colour,
                          fmt::format("{}. {}", k + 1, shortened(told(k), longest_in_two))));
      }
      y += small_row_height * static_cast<double>(rows) + 4;
    }
    if (contacts.size() > most_named)
      row(13, faint_colour, fmt::format("and {} more", contacts.size() - most_named), "");
    for (const std::string& note : panel.notes) {
      for (const std::string& line : wrapped(note)) row(13, faint_colour, line, "");
    }
    return y;
  }

  static Point3 common_point(const ScenePanel& panel, const scene::PartPair& pair) {
    return rounded_common_point(pair, panel.bodies[pair.body_a].parts[pair.part_a],
                                panel.bodies[pair.body_b].parts[pair.part_b]);
  }

  // Of each part, on the lowest plane, the light straight above.
  void shadows(const std::vector<Placed>& parts, const View& view) {
    canvas_.add("<g fill='#26374d' opacity='0.10'>\n");
    for (const Placed& part : parts) {
      std::vector<Point3> points = part.points;
      for (Point3& p : points) p.z = floor_;
      const solid::ConvexPolyhedron shadow(points);
      if (shadow.dimension() < 2) continue;
      std::vector<Seen> corners;
      for (const std::uint32_t v : shadow.facet(0)) corners.push_back(view(shadow.vertices()[v]));
      canvas_.add(fmt::format("<path d='{}'/>\n", outline_of(corners)));
    }
    canvas_.add("</g>\n");
  }

  void draw(const Piece& piece, const Colour& colour, char outline_class) {
    const std::string fill = shaded(colour, piece.light), data = outline_of(piece.corners);
    if (piece.corners.size() < 3) {
      canvas_.add(fmt::format("<path d='{}' stroke='{}' stroke-width='40'/>\n", data, fill));
      return;
    }
    // Strokes hide the seams between neighbours; a little lighter, they show the facets.
    const std::string edge = piece.is_cut ? fill : shaded(colour, piece.light + 0.1);
    canvas_.add(fmt::format("<path d='{}' fill='{}' stroke='{}'/>\n", data, fill, edge));
    const std::string outline = outline_edges(piece);
    if (!outline.empty()) canvas_.add(fmt::format("<path class='{}' d='{}'/>\n", outline_class, outline));
  }

  std::span<const ScenePanel> panels_;
  std::vector<std::vector<Placed>> parts_;  // of each panel
  Canvas canvas_;
  double floor_ = std::numeric_limits<double>::infinity();
  View view_;
};

}  // namespace

std::string ScenePanel::told(const scene::PartPair& pair) const {
  const bool as_hulls =
      !pair.meshes && is_hull && (is_hull(pair.body_a, pair.part_a) || is_hull(pair.body_b, pair.part_b));
  return fmt::format("{} and {} meet{}", part_name(bodies[pair.body_a], pair.part_a),
                     part_name(bodies[pair.body_b], pair.part_b), as_hulls ? " as hulls" : "");
}

std::string scene_svg(std::span<const ScenePanel> panels, const std::string& title) {
  return SceneDrawing(panels).text(title.empty() ? "Which of these bodies meet?" : title);
}

}  // namespace sunder::picture
