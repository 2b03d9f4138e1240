// Polytopes of two to six dimensions out of CSV or NPY: points "x1,..,xd", or half-spaces "a1,..,ad,b", a row each; and
// poses of these.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>

#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace sunder::io {

// Is it an NPY file, by its ending, or a CSV file whose first line names the columns of points, x1 to xd, or of
// half-spaces, a1 to ad and b, for some d from 2 to 6, in this order, small letters or large? Empty lines before it do
// not count. False for a CSV file that is no regular file, or cannot be read.
bool names_polytope(const std::filesystem::path& path);

// All rows of the file are one polytope. Without names in the first line, and in NPY, they are of the form `unnamed`,
// of as many numbers as the first one has. Numbers of CSV are rounded once to the nearest double. Throws Error
// bad_file: "FILE:LINE: what; remedy", or "FILE: row N: ..", also for rows of another length than the first, and where
// the names are of points and `unnamed` is not.
polytope::Polytope read_polytope(const std::filesystem::path& path, InputFiles* inputs = nullptr,
                                 polytope::Form unnamed = polytope::Form::points);

// The same from memory. place: the file's name, for messages. It is NPY iff it begins as such files do.
polytope::Polytope parse_polytope(std::string_view text, std::string_view place,
                                  polytope::Form unnamed = polytope::Form::points);

// A pose of d dimensions, of d numbers: a translation; or of d (d + 1) numbers: d rows, each a row of the linear part
// and one number of the translation. Throws Error bad_call, or bad_pose, at the place.
polytope::Pose polytope_pose(std::span<const double> numbers, std::size_t d, const std::string& place);

// Such a pose for each row of a CSV or NPY file; some may be translations, others matrices. A first line of names is
// refused, as names would tell which number is which, and they are not asked. Throws Error bad_file.
std::vector<polytope::Pose> read_polytope_poses(const std::filesystem::path& path, std::size_t d,
                                                InputFiles* inputs = nullptr);

}  // namespace sunder::io
