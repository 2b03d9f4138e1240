// A picture of the placements of a scene, as SVG.
#pragma once

#include <cli/scene_report.h>

#include <string>

namespace sunder::cli {

// The placements side by side, each in the same orthographic view: facets shaded flat, nearer ones over farther ones;
// bodies that meet in red, each common point marked and labelled. Deterministic, and of no other file.
std::string scene_picture(const SceneReport& report, const std::string& title);

}  // namespace sunder::cli
