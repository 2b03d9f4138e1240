// Checks statements about sets of segments (docs/certificates.md, "Sets"): the twin of sunder_verify_segments.py.
#pragma once

#include "statement.h"

namespace sunder_verifier {

// Adds the questions about the table of segments, if the file has one. Throws Refused where its form is wrong.
void add_segment_questions(const json& top, Questions& questions);

}  // namespace sunder_verifier
