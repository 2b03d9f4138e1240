// A picture of the placements of a scene, as SVG.
#pragma once

#include <sunder/scene/scene.h>

#include <span>
#include <string>
#include <string_view>

namespace sunder::picture {

// One placement and its answer.
struct ScenePanel {
  std::string_view title;
  std::span<const scene::Body> bodies;
  const scene::Answer& answer;
};

// The placements side by side, at least one, all in the same orthographic view and scale: facets shaded flat, nearer
// ones over farther ones (painter.h); bodies that meet, and may not, in red, with a numbered ring at the common point
// of each such pair (rings.h), and the first 40 of them in words, by number. Bodies with a radius are drawn by
// polyhedra inside of them, which is said (round.h). Positions are rounded: the picture decides nothing. title: empty:
// a question.
std::string scene_svg(std::span<const ScenePanel> panels, const std::string& title);

}  // namespace sunder::picture
