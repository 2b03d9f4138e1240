#include <sunder/base/contract.h>

#include <cstdio>
#include <cstdlib>

namespace sunder {

void requirement_broken(const char* file, int line, const char* what) noexcept {
  std::fprintf(stderr, "%s:%d: requires %s\n", file, line, what);
  std::abort();
}

}  // namespace sunder
