// What meets on the way from each placement of a table to the next one: `sunder scene --placements FILE --between`.
#pragma once

#include <sunder/ask/scene/scene_input.h>

#include <sunder/io/joint_table.h>
#include <sunder/scene/scene.h>

namespace sunder::ask {

// A line a step on standard output. Parts that turn are asked about at both ends only, and this is said. Returns the
// exit code: `yes` where some meet, and where, because of such parts, it is not known. Throws Error where there are no
// two placements, and for a question that tells touching from overlapping.
int answer_between(const SceneInput& input, const scene::Question& question, const io::JointTable& table);

}  // namespace sunder::ask
