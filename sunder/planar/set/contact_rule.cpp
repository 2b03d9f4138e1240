#include <sunder/planar/set/contact_rule.h>

namespace sunder::planar {

std::string_view name_of(Allowed allowed) {
  switch (allowed) {
    case Allowed::nothing: return "nothing";
    case Allowed::shared_endpoint: return "shared-endpoint";
    case Allowed::touch: return "touch";
  }
  return "";
}

bool counts(ContactKind kind, Allowed allowed) {
  switch (kind) {
    case ContactKind::none: return false;
    case ContactKind::shared_endpoint: return allowed == Allowed::nothing;
    case ContactKind::touch: return allowed != Allowed::touch;
    case ContactKind::crossing:
    case ContactKind::overlap: return true;
  }
  return true;
}

}  // namespace sunder::planar
