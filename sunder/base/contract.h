// What a header says under "Requires", checked where SUNDER_CONTRACTS is defined: in debug builds, under sanitizers, in
// fuzzers (the CMake option SUNDER_CONTRACTS). Elsewhere it costs nothing, and its words are not evaluated.
#pragma once

namespace sunder {

// "FILE:LINE: requires WHAT" on standard error; then the program ends by SIGABRT.
[[noreturn]] void requirement_broken(const char* file, int line, const char* what) noexcept;

}  // namespace sunder

#ifdef SUNDER_CONTRACTS
#define SUNDER_REQUIRE(condition) \
  ((condition) ? static_cast<void>(0) : ::sunder::requirement_broken(__FILE__, __LINE__, #condition))
#else
#define SUNDER_REQUIRE(condition) static_cast<void>(sizeof((condition) ? 1 : 0))
#endif
