// Checks statements about polygons with holes (docs/certificates-sets.md): the twin of sunder_verify_polygons.py.
#pragma once

#include "statement.h"

namespace sunder_verifier {

// Adds the questions about the table of polygons, if the file has one. Throws Refused where its form is wrong.
void add_polygon_questions(const json& top, Questions& questions);

}  // namespace sunder_verifier
