// Checks statements about convex polygons (docs/certificates-sets.md): the twin of sunder_verify_convex.py.
#pragma once

#include "statement.h"

namespace sunder_verifier {

// Adds the questions about the table of convex polygons, if the file has one. Throws Refused where its form is wrong.
void add_convex_questions(const json& top, Questions& questions);

}  // namespace sunder_verifier
