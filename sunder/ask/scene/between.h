// What meets on the way from each placement of a table to the next one: `sunder scene --placements FILE --between`.
#pragma once

#include <sunder/ask/scene/placements.h>
#include <sunder/ask/scene/scene_input.h>

#include <sunder/io/robot/joint_table.h>
#include <sunder/scene/scene.h>

#include <span>

namespace sunder::ask {

// Asks about each step, in chains (scene/chains.h): a line a step, printed, or the files that are asked for.
// Parts that turn are asked about at both ends only, and this is said. Returns the exit code: `yes` where some meet,
// and where, because of such parts, or of a pair that is undecided, it is not known. inputs: what a certificate was
// made of. allowed: the pairs of question.allowed, with their reasons. Throws Error where there are no two
// placements, and for a question that tells touching from overlapping;
// then no file is written.
int answer_between(Talk& talk, const PlacementsCall& call, const robot::Cell& cell, const scene::Question& question,
                   const io::JointTable& table, const InputFiles& inputs, std::span<const AllowedPair> allowed = {});

}  // namespace sunder::ask
