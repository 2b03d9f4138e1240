// How far a long piece of work is: on standard error, on a terminal only, after a second.
#pragma once

#include <functional>
#include <string_view>

namespace sunder::cli {

// Returns a function that shows on the terminal which part of the work is done, 0 to 1. The line is erased when the
// function is destroyed. Returns an empty function if standard error is not a terminal.
std::function<void(double)> progress_on_terminal(std::string_view what);

}  // namespace sunder::cli
