// What a question comes to, as a number.
#pragma once

namespace sunder::ask::exit_code {

constexpr int no = 0;        // apart, none meet, accepted; also `hull` and `info`
constexpr int yes = 1;       // meet, some meet, refused
constexpr int bad = 2;       // bad input or call; one line on standard error
constexpr int internal = 3;  // a fault of the program itself

}  // namespace sunder::ask::exit_code
