#include <sunder/base/names.h>
#include <sunder/certificate/cut.h>

namespace sunder {

std::string_view name_of(CutKind kind) {
  return name_in<CutKind::whole>({"nothing", "point", "along", "across", "part", "whole"}, kind);
}

}  // namespace sunder
