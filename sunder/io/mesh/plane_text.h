// Planes of space, and stacks of parallel ones, as people write them.
#pragma once

#include <sunder/base/error.h>
#include <sunder/solid/object/plane.h>

#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// What parse_planes reads, for help texts.
inline constexpr const char* plane_forms =
    "one plane: z=0.5 (or x=, y=), or a,b,c,d for a x + b y + c z = d; or a stack of parallel planes: z=FROM:TO:STEP, "
    "or a,b,c,FROM:TO:STEP";

inline constexpr std::size_t most_planes = 1'000'000;

// Parallel planes: those where normal . x is one of these numbers, in their order.
struct PlaneStack {
  solid::Plane plane;  // through the origin
  std::vector<double> offsets;
  std::string name;  // of what is written before the offset: "z", "1,2,3"
};

// A stack begins with FROM, and goes up by STEP as long as it is not beyond TO. These three are plain decimals of at
// most 15 digits, so that each offset is the double nearest to the decimal that is meant: 0.3, not 3 times 0.1.
// Throws Error bad_call, with `place`, for another text, a step that is not positive, TO below FROM, more than
// most_planes; bad_shape for a normal that is zero.
PlaneStack parse_planes(std::string_view text, const std::string& place);

}  // namespace sunder::io
