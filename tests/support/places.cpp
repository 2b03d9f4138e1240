#include <tests/support/places.h>

#ifndef SUNDER_PROGRAM
#define SUNDER_PROGRAM ""
#endif

namespace sunder::tests {

std::string cases_folder() { return SUNDER_SOURCE_DIR "/cases"; }

std::string source_folder() { return SUNDER_SOURCE_DIR; }

std::string python() { return SUNDER_PYTHON; }

std::string program() { return SUNDER_PROGRAM; }

}  // namespace sunder::tests
