#include <sunder/planar/set/segments_any.h>

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

SegmentsAnswer segments_any(const Segments& segments, const SegmentsOptions& options) {
  return segments_any_by_sweep(segments, options);
}

}  // namespace sunder::planar
