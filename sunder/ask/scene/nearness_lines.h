// How near the parts of each of thousands of placements are: what `sunder scene --placements` adds to a line for
// --clearance, --margin and --distance.
#pragma once

#include <sunder/ask/scene/scene_clearance.h>
#include <sunder/ask/scene/scene_input.h>

#include <sunder/scene/clearance.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/scene/timeline.h>

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

// Any number of threads may use one at once.
class NearnessLines {
 public:
  // Keeps references to all three. bodies: their names are what is told.
  NearnessLines(const scene::NearnessQuestion& question, const robot::Cell& cell, std::span<const scene::Body> bodies)
      : question_(question), cell_(cell), bodies_(bodies) {}

  // Each adds to the line that stands at the end of the text.
  void add_text(const scene::Nearness& found, std::string& text) const;
  void add_json(const scene::Nearness& found, std::string& text) const;
  void add_csv(const scene::Nearness& found, std::string& text) const;
  void add_json_header(std::string& text) const;
  void add_csv_header(std::string& text) const;

 private:
  bool is_hull(const scene::PartDistance& pair) const;  // does a hull replace a mesh in it?
  std::string names_of(const scene::PartDistance& pair) const;
  std::string json_of(const scene::PartDistance& pair, bool has_margin) const;

  const scene::NearnessQuestion& question_;
  const robot::Cell& cell_;
  std::span<const scene::Body> bodies_;
};

// Appends what is closer than it has to be, or may be, as certificates take it. Returns how many pairs are.
std::size_t list_closer(const scene::Nearness& found, std::vector<scene::CloserPair>& list);

}  // namespace sunder::ask
