#include <sunder/planar/set/contact_rule.h>

namespace sunder::planar {

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
