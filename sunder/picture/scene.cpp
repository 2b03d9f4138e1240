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
constexpr std::size_t most_drawn_triangles = 10000;  // of meshes
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

// About.
double volume_of(const solid::Mesh& mesh) {
  const auto at = [&](std::uint32_t point) {
    const Point3 &p = mesh.points()[point], &low = mesh.box().low;
    return Seen{p.x - low.x, p.y - low.y, p.z - low.z};
  };
  double sum = 0;
  for (const auto& [a, b, c] : mesh.triangles()) sum += dot(at(a), cross(at(b), at(c))) / 6;
  return sum;
}

// A part as it is drawn, with its corners in the world, rounded.
struct Placed {
  std::uint32_t body;
  const scene::Part* part;
  const solid::Mesh* mesh;  // null: not drawn as a mesh
  solid::DrawnBody drawn;   // else it is not
  std::vector<Point3> points;

  // Faces run counter-clockwise seen from outside, clockwise where the pose reflects.
  std::uint32_t face_count() const {
    return mesh != nullptr ? static_cast<std::uint32_t>(mesh->triangles().size()) : drawn.polyhedron.facet_count();
  }
  std::span<const std::uint32_t> face(std::uint32_t f) const {
    return mesh != nullptr ? std::span<const std::uint32_t>(mesh->triangles()[f]) : drawn.polyhedron.facet(f);
  }
  // Is only what is turned to the viewer seen? Else one may see into it, or all is turned inwards.
  bool has_an_outside() const {
    return mesh == nullptr || (mesh->is_closed() && mesh->is_by_winding() && volume_of(*mesh) > 0);
  }
};

// Are meshes drawn as they are? The painter compares every two triangles, and a picture has a path for each.
bool draws_meshes(const ScenePanel& panel) {
  std::size_t triangles = 0;
  for (const scene::Body& body : panel.bodies) {
    for (const scene::Part& part : body.parts) triangles += part.mesh != nullptr ? part.mesh->triangles().size() : 0;
  }
  return triangles <= most_drawn_triangles;
}

std::vector<Placed> placed_parts(const ScenePanel& panel) {
  const bool as_meshes = draws_meshes(panel);
  std::vector<Placed> parts;
  for (std::uint32_t b = 0; b < panel.bodies.size(); ++b) {
    for (const scene::Part& part : panel.bodies[b].parts) {
      const solid::Mesh* const mesh = as_meshes ? part.mesh.get() : nullptr;
      parts.push_back(
          {b, &part, mesh, mesh != nullptr ? solid::DrawnBody{part.shape.core()} : drawn_as(part.shape), {}});
      const std::span<const Point3> corners =
          mesh != nullptr ? mesh->points() : parts.back().drawn.polyhedron.vertices();
      const PlacedVertices vertices{corners, part.pose.affine(), false};
      for (std::uint32_t v = 0; v < corners.size(); ++v) {
        const Vector3<double> p = rounded_image(vertices[v]);
        parts.back().points.push_back({p.x, p.y, p.z});
      }
    }
  }
  return parts;
}

// What of a part is seen. `number`: of its first piece; those of a mesh, which may hide each other, have each their own.
// Returns the next number.
std::uint32_t add_pieces(const Placed& placed, std::uint32_t number, const View& view, std::vector<Piece>& out) {
  std::vector<Seen> points;
  for (const Point3& p : placed.points) points.push_back(view(p));
  if (placed.mesh == nullptr && placed.drawn.polyhedron.dimension() < 2) {
    const std::vector<bool> outline(points.size(), true);
    out.push_back({placed.body, number, 1, std::move(points), outline});
    return number + 1;
  }
  const auto& m = placed.part->pose.affine().linear;
  const double determinant = dot(Seen{m[0], m[1], m[2]}, cross(Seen{m[3], m[4], m[5]}, Seen{m[6], m[7], m[8]}));
  const double outwards = determinant < 0 ? 1 : -1;  // y runs down
  const bool has_an_outside = placed.has_an_outside();
  std::vector<std::uint32_t> facets;                        // those that are seen
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;  // of these, as they run
  const auto each_edge = [&](std::uint32_t f, const auto& visit) {
    const auto facet = placed.face(f);
    for (std::size_t i = 0; i < facet.size(); ++i) visit(facet[i], facet[(i + 1) % facet.size()]);
  };
  for (std::uint32_t f = 0; f < placed.face_count(); ++f) {
    Piece piece{placed.body, number, 0, {}, {}};
    for (const std::uint32_t v : placed.face(f)) piece.corners.push_back(points[v]);
    const Seen n = normal_of(piece.corners);
    const double sign = has_an_outside || outwards * n.z > 0 ? outwards : -outwards;
    const Seen normal{sign * n.x, sign * n.y, sign * n.z};
    if (!(normal.z > 0)) continue;
    if (placed.mesh != nullptr) ++number;
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
  return number + 1;
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
    if (some_hull() && !some_mesh()) {
      canvas_.legend("", "meshes that are not convex are asked about, and drawn, as their hulls");
    } else if (some_hull() && !std::all_of(panels_.begin(), panels_.end(), draws_meshes)) {
      canvas_.legend(
          "", fmt::format("meshes that are not convex, of more than {} triangles together, are drawn as their hulls",
                          most_drawn_triangles));
    }
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
    std::uint32_t number = 0;
    for (const Placed& part : parts) number = add_pieces(part, number, view, pieces);
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
