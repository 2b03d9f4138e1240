#include <sunder/base/error.h>
#include <sunder/planar/object/segments.h>

#include <cmath>
#include <string>
#include <utility>

namespace sunder::planar {

Segments::Segments(std::vector<Segment> given) : segments_(std::move(given)) {
  if (segments_.size() >= std::size_t{1} << 31) {
    throw Error(ErrorCode::bad_shape, "a set holds fewer than 2^31 segments; split it");
  }
  for (Segment& s : segments_) {
    for (const double x : {s.a.x, s.a.y, s.b.x, s.b.y}) {
      if (std::isfinite(x)) continue;
      throw Error(ErrorCode::bad_value, "a coordinate is not finite; every number must be: repair the data",
                  "segment " + std::to_string(&s - segments_.data()));
    }
    s = sorted(s);
    extents_.add(box_of(s));
  }
}

}  // namespace sunder::planar
