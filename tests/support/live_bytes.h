// Counts the bytes that a thread holds, where they are allocated. Replaces operator new and delete of the whole
// executable: one of its tests may include this.
#pragma once

#include <tests/support/thread_sanitizer.h>

#include <malloc.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <new>

// What this thread has allocated and not freed, as large as the allocator made it, without its own header; and the most
// since it was set.
inline constinit thread_local std::int64_t live = 0, most = 0;

#if !SUNDER_UNDER_THREAD_SANITIZER
[[gnu::noinline]] void* operator new(std::size_t size) {
  void* p = std::malloc(size == 0 ? 1 : size);
  if (p == nullptr) throw std::bad_alloc();
  live += static_cast<std::int64_t>(malloc_usable_size(p));
  most = std::max(most, live);
  return p;
}
[[gnu::noinline]] void operator delete(void* p) noexcept {
  if (p != nullptr) live -= static_cast<std::int64_t>(malloc_usable_size(p));
  std::free(p);
}
[[gnu::noinline]] void operator delete(void* p, std::size_t) noexcept { operator delete(p); }
#endif
