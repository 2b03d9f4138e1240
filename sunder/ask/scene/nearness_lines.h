// How near the parts of each of thousands of placements are: what `sunder scene --placements` adds to a line for
// --clearance, --margin and --distance.
#pragma once

#include <sunder/ask/scene/scene_clearance.h>
#include <sunder/ask/scene/scene_input.h>

#include <sunder/scene/clearance.h>

#include <array>
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

  // Of one placement. Requires a question that asks. Throws Error as closer_pairs does.
  Nearness ask(std::span<const scene::Body> placed) const;

  // Each adds to the line that stands at the end of the text.
  void add_text(const Nearness& found, std::string& text) const;
  void add_json(const Nearness& found, std::string& text) const;
  void add_csv(const Nearness& found, std::string& text) const;
  void add_json_header(std::string& text) const;
  void add_csv_header(std::string& text) const;

 private:
  std::string names_of(const scene::PartDistance& pair) const;
  std::string json_of(const scene::PartDistance& pair, bool has_margin) const;

  const NearnessQuestion& question_;
  const SceneInput& input_;
  std::span<const scene::Body> bodies_;
  const std::vector<std::array<std::uint32_t, 2>>& allowed_;
};

}  // namespace sunder::ask
