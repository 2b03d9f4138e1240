// Checks statements about circles with their insides (docs/certificates-sets.md): the twin of sunder_verify_circles.py.
#pragma once

#include "statement.h"

namespace sunder_verifier {

// Adds the questions about the table of circles, if the file has one. Throws Refused where its form is wrong.
void add_circle_questions(const json& top, Questions& questions);

}  // namespace sunder_verifier
