// What is left out, in the words and reports of the verbs.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/io/left_out.h>

namespace sunder::ask {

using io::LeftOutList;

// The option's help.
extern const char* const leave_out_help;

// [{"kind", "count", "of": [...]}], with all owners.
Json to_json(const LeftOutList& list);

}  // namespace sunder::ask
