// Checks statements about linear programs (docs/certificates-sets.md): as in sunder_verify_regions.py.
#pragma once

#include "sunder_verify_regions.h"

namespace sunder_verifier {

void add_program_question(const HalfPlanes& given, Questions& questions);

}  // namespace sunder_verifier
