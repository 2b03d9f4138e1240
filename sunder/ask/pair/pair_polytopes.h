// sunder pair where A and B are polytopes of two to six dimensions, out of CSV: points, or half-spaces.
#pragma once

#include <sunder/ask/pair/pair_question.h>

namespace sunder::ask {

// Is the pair asked about so: by --polytopes, or by the names of columns of one of the files?
bool are_polytopes(const PairCall& call);

// Their methods, for help texts.
std::string polytope_method_names();

// Answers. Throws Error for bad input, and for options that are not for polytopes.
Report run_polytope_pair(const PairCall& call, Talk& talk);

}  // namespace sunder::ask
