#include <sunder/base/names.h>
#include <sunder/certificate/optimum.h>

namespace sunder {

std::string_view name_of(Optimum outcome) {
  return name_in<Optimum::infeasible>({"one", "many", "all", "unbounded", "infeasible"}, outcome);
}

}  // namespace sunder
