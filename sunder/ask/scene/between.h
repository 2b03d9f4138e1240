// What meets on the way from each placement of a table to the next one: `sunder scene --placements FILE --between`.
#pragma once

#include <sunder/ask/scene/row_run.h>

namespace sunder::ask {

// Asks about each step, in chains (scene/chains.h): a line a step, printed, or the files that are asked for.
// Parts that turn are asked about at both ends only, and this is said. Returns the exit code: `yes` where some meet,
// and where, because of such parts, or of a pair that is undecided, it is not known. Throws Error where there are no two
// placements, and for a question that tells touching from overlapping; then no file is written.
int answer_between(RowsAsked asked);

}  // namespace sunder::ask
