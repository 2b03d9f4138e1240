#include <sunder/solid/object/translation.h>

namespace sunder::solid {

bool is_translation(const Pose& begin, const Pose& end) { return begin.affine().linear == end.affine().linear; }

Translation::Translation(const Pose& begin, const Pose& end) : begin_(begin), end_(end) {
  if (!is_translation(begin, end)) {
    throw Error(
        ErrorCode::bad_pose,
        "the two poses have different linear parts, so the body turns on its way; give the second the rotation of "
        "the first, number by number",
        "pose at the end");
  }
}

}  // namespace sunder::solid
