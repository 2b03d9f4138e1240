// Polytopes of two to six dimensions out of CSV or NPY: points "x1,..,xd", or half-spaces "a1,..,ad,b", a row each.
#pragma once

#include <sunder/base/error.h>
#include <sunder/certificate/origin.h>
#include <sunder/polytope/object/polytope.h>

#include <filesystem>
#include <string_view>

namespace sunder::io {

// Is it an NPY file, by its ending, or a CSV file whose first line names the columns of points, x1 to xd, or of
// half-spaces, a1 to ad and b, for some d from 2 to 6, in this order, small letters or large? False where it is no
// regular file, or cannot be read.
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

}  // namespace sunder::io
