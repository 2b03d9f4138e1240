// What `sunder scene` tells: text, JSON, and the certificate file.
#pragma once

#include <sunder/ask/scene/scene_input.h>

#include <sunder/certificate/claims.h>
#include <sunder/scene/scene.h>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace sunder::ask {

// One placement and its answer.
struct Placed {
  Placement placement;
  std::string title;  // for people: the placement's name, or its number
  std::vector<scene::Body> bodies;
  scene::Answer answer;
  double seconds = 0;  // of the question itself, without reading files
};

struct SceneReport {
  std::vector<Placed> placements;  // at least one, all with the same bodies
  std::vector<std::array<std::uint32_t, 2>> allowed;
  std::vector<std::string> allowed_because;  // as the user wrote it
  std::string method;
  const LeftOutList* left_out = nullptr;   // set
  std::vector<std::vector<bool>> is_hull;  // of each part of each body: does a hull stand for a mesh?
  bool contacts = false;
  bool touching_allowed = false;
  bool colour = false;  // mark what meets by terminal colours

  bool some_meet() const;
  // Do the parts meet, and is this said of hulls in the stead of meshes?
  bool meet_as_hulls(const scene::PartPair& pair) const;
};

// The common point of a pair that meets, rounded.
Point3 point_about(const Placed& placed, const scene::PartPair& pair);

std::string scene_text(const SceneReport& report);
Json scene_json(const SceneReport& report, const std::vector<const MeshBody*>& objects);

// Of all pairs that are listed in the answers, of which there is one at least.
void write_scene_certificate(const SceneReport& report, const InputFiles& inputs, const TextSink& sink);

}  // namespace sunder::ask
