#include <sunder/near/set_question.h>

namespace sunder {

std::string_view name_of(Allowed allowed) {
  switch (allowed) {
    case Allowed::nothing: return "nothing";
    case Allowed::shared_endpoint: return "shared-endpoint";
    case Allowed::touch: return "touch";
  }
  return "";
}

}  // namespace sunder
