#include <sunder/planar/set/discs_any.h>

namespace sunder::planar {

DiscsAnswer discs_any(const Discs& circles, const SetOptions& options) { return discs_any_by_grid(circles, options); }

}  // namespace sunder::planar
