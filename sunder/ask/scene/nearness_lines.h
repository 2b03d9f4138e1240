// How near the parts of each of thousands of placements are: what `sunder scene --placements` adds to a line for
// --clearance, --margin and --distance.
#pragma once

#include <sunder/ask/scene/scene_clearance.h>
#include <sunder/ask/scene/scene_input.h>

#include <sunder/scene/clearance.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/scene_json.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

// What is asked besides which meet.
struct NearnessQuestion {
  std::optional<scene::ClearanceQuestion> clearance;
  bool nearest = false;

  bool asks() const { return clearance || nearest; }
};

// Any number of threads may use one at once.
class NearnessLines {
 public:
  // Keeps references to all three. bodies: their names are what is told.
  NearnessLines(const NearnessQuestion& question, const SceneInput& input, std::span<const scene::Body> bodies,
                const std::vector<std::array<std::uint32_t, 2>>& allowed)
      : question_(question), input_(input), bodies_(bodies), allowed_(allowed) {}

  // Of one placement. follower: what is kept from placement to placement; nothing where no clearance is asked for.
  // Requires a question that asks. Throws Error as closer_pairs does.
  Nearness ask(std::span<const scene::Body> placed, std::optional<scene::ClearanceFollower>& follower) const;

  // One that has been asked nothing.
  std::optional<scene::ClearanceFollower> follower() const;

  // Each adds to the line that stands at the end of the text.
  void add_text(const Nearness& found, std::string& text) const;
  void add_json(const Nearness& found, std::string& text) const;
  void add_csv(const Nearness& found, std::string& text) const;
  void add_json_header(std::string& text) const;
  void add_csv_header(std::string& text) const;

 private:
  bool is_hull(const scene::PartDistance& pair) const;  // does a hull replace a mesh in it?
  std::string names_of(const scene::PartDistance& pair) const;
  std::string json_of(const scene::PartDistance& pair, bool has_margin) const;

  const NearnessQuestion& question_;
  const SceneInput& input_;
  std::span<const scene::Body> bodies_;
  const std::vector<std::array<std::uint32_t, 2>>& allowed_;
};

// Appends what is closer than it has to be, or may be, as certificates take it. Returns how many pairs are.
std::size_t list_closer(const Nearness& found, std::vector<scene::CloserPair>& list);

}  // namespace sunder::ask
