// Which kinds of contact of two segments count.
#pragma once

#include <sunder/near/set_question.h>
#include <sunder/planar/pair/segment_segment.h>

namespace sunder::planar {

inline bool counts(ContactKind kind, Allowed allowed) {
  if (kind == ContactKind::shared_endpoint) return allowed == Allowed::nothing;
  if (kind == ContactKind::touch) return allowed != Allowed::touch;
  return kind != ContactKind::none;
}

}  // namespace sunder::planar
