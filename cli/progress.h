// How far a long piece of work is: on standard error, on a terminal only, after a second.
#pragma once

#include <functional>
#include <string_view>

namespace sunder::cli {

// What is told the part that is done, 0 to 1; its line is wiped when it is gone. Empty where nobody would see it.
std::function<void(double)> progress_on_terminal(std::string_view what);

}  // namespace sunder::cli
