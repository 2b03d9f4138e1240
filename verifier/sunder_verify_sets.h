// Checks statements about sets and regions (docs/certificates-sets.md): the twin of sunder_verify_sets.py.
#pragma once

#include "statement_reader.h"
#include "sunder_verify.h"

#include <vector>

namespace sunder_verifier {

// The statements of a file with "sunder_set_certificate", as its pairs; their names are what the statement is about,
// and the rule or what is asked for. Throws Refused where the form is wrong. Time: linear, but for the size of numbers.
std::vector<PairResult> verify_set(const json& top);

}  // namespace sunder_verifier
