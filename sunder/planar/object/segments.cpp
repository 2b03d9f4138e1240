#include <sunder/base/error.h>
#include <sunder/planar/object/segments.h>

#include <cmath>
#include <string>

namespace sunder::planar {

Segments::Segments(std::span<const Segment> given) {
  if (given.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "a set holds fewer than 2^31 segments; split it");
  }
  segments_.reserve(given.size());
  for (const Segment& s : given) {
    for (const double x : {s.a.x, s.a.y, s.b.x, s.b.y}) {
      if (std::isfinite(x)) continue;
      throw Error(ErrorCode::bad_value, "a coordinate is not finite; every number must be: repair the data",
                  "segment " + std::to_string(segments_.size()));
    }
    segments_.push_back(sorted(s));
    extents_.add(box_of(segments_.back()));
  }
}

}  // namespace sunder::planar
