// A picture of the placements of a scene, as SVG.
#pragma once

#include <sunder/scene/scene.h>

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::picture {

// One placement and its answer.
struct ScenePanel {
  std::string_view title;
  std::span<const scene::Body> bodies;
  const scene::Answer& answer;

  // Does the hull of a mesh that is not convex stand for it, so that what is said is said of the hull? None: nowhere.
  std::function<bool(std::uint32_t body, std::uint32_t part)> is_hull{};
  std::vector<std::string> notes{};  // below the answer, a line each: what it does not speak of

  // "trunk and upper leg meet as hulls". Requires a pair of the answer that meets.
  std::string told(const scene::PartPair& pair) const;
};

// The placements side by side, at least one, all in the same orthographic view and scale: facets shaded flat, nearer
// ones over farther ones (painter.h); bodies that meet, and may not, in red, with a numbered ring at the common point
// of each such pair (rings.h), and the first 40 of them in words, by number. Bodies with a radius are drawn by
// polyhedra inside of them, which is said (drawn_as). Meshes are drawn as they are, up to 10,000 triangles of a
// placement; else, and where hulls were asked about in their place, hulls are drawn, and it says so. Positions are
// rounded: the picture decides nothing. title: empty: a question.
std::string scene_svg(std::span<const ScenePanel> panels, const std::string& title);

}  // namespace sunder::picture
