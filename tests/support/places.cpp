#include <tests/support/places.h>

namespace sunder::tests {

std::string cases_folder() { return SUNDER_SOURCE_DIR "/cases"; }

std::string source_folder() { return SUNDER_SOURCE_DIR; }

std::string python() { return SUNDER_PYTHON; }

}  // namespace sunder::tests
