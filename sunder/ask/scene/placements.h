// Thousands of placements of a robot in one call of `sunder scene`: a line a placement.
#pragma once

#include <sunder/ask/scene/row_run.h>

#include <sunder/io/robot/joint_table.h>
#include <sunder/io/robot/joint_values.h>

#include <cstdint>
#include <string>
#include <vector>

namespace sunder::ask {

// Counts placements where something meets, or where that is undecided, and all pairs that meet; then placements where
// something is closer than it has to be, or where that is undecided, and all pairs that are known to be closer.
struct PlacementsCounts {
  std::uint64_t some = 0, undecided = 0, meeting = 0, not_kept = 0, closer = 0;
  std::uint64_t surfaces_alone = 0;  // pairs, as scene::Counts has them, of all placements

  void add(const PlacementsCounts& other);
  int code(bool surfaces_consented) const {
    const bool is_open = surfaces_alone > 0 && !surfaces_consented;
    return some + undecided + not_kept > 0 || is_open ? exit_code::yes : exit_code::no;
  }
};

// The table with the names of its joints. Throws Error, also where they are not so many as there are columns.
io::JointTable read_placements(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, InputFiles* inputs);

// The same as values by name, one placement after another, named by their numbers, from 0.
std::vector<io::JointValues> joint_values_of(const io::JointTable& table);

// The least and the greatest value of each joint.
std::vector<io::JointValues> extremes_of(const io::JointTable& table);

// Asks the question of each placement, in chains (scene/timeline.h), and writes what comes out: lines of text,
// printed, or the files that are asked for. Of the nearest no certificate is written. Throws Error; then no file is
// written.
PlacementsCounts answer_placements(const RowsAsked& asked);

}  // namespace sunder::ask
