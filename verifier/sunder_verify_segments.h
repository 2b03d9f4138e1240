// Checks statements about sets of segments (docs/certificates.md, "Sets"): the twin of sunder_verify_segments.py.
#pragma once

#include "statement_reader.h"
#include "sunder_verify.h"

#include <vector>

namespace sunder_verifier {

// The statements of a file with "sunder_set_certificate", as its pairs; their names are "segments" and the rule.
// Throws Refused where the form is wrong. Time: linear, but for the size of numbers.
std::vector<PairResult> verify_set(const json& top);

}  // namespace sunder_verifier
