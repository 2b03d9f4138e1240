// The placements of a scene in space, as glTF 2.0, for any viewer.
#pragma once

#include <sunder/base/error.h>
#include <sunder/picture/scene.h>

#include <cstdint>
#include <span>
#include <string>

namespace sunder::picture {

enum class GltfForm : std::uint8_t {
  json,    // .gltf, its buffer within as base64
  binary,  // .glb
};

// One scene of the file a placement, the first one shown: a node that lays z up as glTF has y up, in it a node a body,
// and where it has several parts a node for each, by their names; and a node without a mesh at the common point of each
// pair that meets and may not, named as "a and b meet", or "meet as hulls"; the panel's
// notes are its extras. Three materials: "apart", "meets", "undecided". Facets are flat; meshes are as they are.
// Positions are in single precision, and bodies with a radius polyhedra inside of them (drawn_as): for the eye alone,
// which asset.extras says. Throws Error bad_value where a coordinate is beyond single precision. Cost: linear in what
// is drawn.
std::string scene_gltf(std::span<const ScenePanel> panels, GltfForm form);

}  // namespace sunder::picture
