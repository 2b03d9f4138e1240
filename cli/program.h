// The whole program as a function.
#pragma once

namespace sunder::cli {

// Runs the call and returns its exit code (see sunder/ask/verb.h). Prints errors as one line on standard error; throws
// nothing.
int run(int argc, char** argv);

}  // namespace sunder::cli
