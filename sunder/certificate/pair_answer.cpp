#include <sunder/certificate/pair_answer.h>

namespace sunder {

std::string_view name_of(DecidedBy decided_by) {
  switch (decided_by) {
    case DecidedBy::filter: return "filter";
    case DecidedBy::evidence: return "evidence";
    case DecidedBy::finishing: return "finishing";
    case DecidedBy::scan: return "scan";
  }
  return "";
}

std::string_view name_of(Contact contact) {
  switch (contact) {
    case Contact::none: return "none";
    case Contact::touching: return "touching";
    case Contact::overlapping: return "overlapping";
  }
  return "";
}

}  // namespace sunder
