// A picture of the placements of a scene, as SVG.
#pragma once

#include <sunder/ask/scene/scene_report.h>

#include <string>

namespace sunder::picture {

// The placements side by side, all in the same orthographic view and scale: facets shaded flat, nearer ones over
// farther ones (by the depth of their middles, so that bodies in each other are drawn roughly); bodies that meet, and
// may not, in red, with the common point of each such pair marked. Positions are rounded: the picture decides nothing.
std::string scene_picture(const ask::SceneReport& report, const std::string& title);

}  // namespace sunder::picture
