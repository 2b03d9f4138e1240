// Fetching small things before their turn comes: where their order has nothing to do with memory, all else waits for
// them.
#pragma once

namespace sunder {

// Both of its cache lines: it may begin in one and end in the next.
template <class T>
void prefetch(const T& value) {
  static_assert(sizeof(T) <= 64);
  const char* const first = reinterpret_cast<const char*>(&value);
  __builtin_prefetch(first);
  __builtin_prefetch(first + sizeof(T) - 1);
}

}  // namespace sunder
