// Where a body is, as people write it.
#pragma once

#include <sunder/base/error.h>
#include <sunder/solid/object/pose.h>

#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

// Numbers between commas or blanks. Throws Error bad_call that names the one that is none; `place` says where the text
// is from.
std::vector<double> parse_numbers(std::string_view text, const std::string& place);

// What parse_pose reads, for help texts.
inline constexpr const char* pose_forms =
    "tx,ty,tz (a translation); or qw,qx,qy,qz,tx,ty,tz (a quaternion and a translation); or the 12 or 16 numbers of a "
    "matrix, row by row";

// A pose as text: "tx,ty,tz", "qw,qx,qy,qz,tx,ty,tz", or the 12 or 16 numbers of a matrix row by row.
// Throws Error bad_pose or bad_call, with `place`.
solid::Pose parse_pose(std::string_view text, const std::string& place);

}  // namespace sunder::io
