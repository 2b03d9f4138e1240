// Work that several threads share.
#pragma once

#include <cstddef>
#include <functional>

namespace sunder {

// Does `work` on so many threads at once, this one among them, and returns when all have ended. Where the system gives
// no more threads, or no memory for them, those that there are do it. Requires: `work` does not throw.
void on_threads(std::size_t count, const std::function<void()>& work);

}  // namespace sunder
