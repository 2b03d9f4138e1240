// How near are the parts of a scene? sunder scene --clearance, --margin, --distance.
#pragma once

#include <sunder/ask/scene/scene_input.h>

#include <sunder/scene/timeline.h>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace sunder::ask {

// What the options say.
struct ClearanceCall {
  std::string least;                 // a number; empty: pairs without a margin have none
  std::vector<std::string> margins;  // "a,b=c" each
  bool nearest = false;

  bool asks() const { return nearest || !least.empty() || !margins.empty(); }
};

// What they ask, with the pairs allowed. A note says which margins are of allowed pairs. Nothing where the call has no
// margin. Throws Error bad_call for what is no distance, bodies that do not exist, and a pair with two margins.
std::optional<scene::ClearanceQuestion> clearance_question(Talk& talk, const ClearanceCall& call,
                                                           const robot::Cell& cell,
                                                           const std::vector<std::array<std::uint32_t, 2>>& allowed);

struct Placed;
struct SceneReport;

// Adds the clearances and nearest parts of all placements: "clearance" and "nearest" in JSON, and lines of text.
void add_nearness(const SceneReport& scene, Report& report);

}  // namespace sunder::ask
