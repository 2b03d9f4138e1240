#include <sunder/base/names.h>
#include <sunder/certificate/pair_answer.h>

namespace sunder {

std::string_view name_of(DecidedBy decided_by) {
  return name_in<DecidedBy::scan>({"filter", "evidence", "finishing", "scan"}, decided_by);
}

std::string_view name_of(Contact contact) {
  return name_in<Contact::overlapping>({"none", "touching", "overlapping"}, contact);
}

}  // namespace sunder
