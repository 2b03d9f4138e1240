// Arrays of two dimensions out of NPY files, as NumPy's save() writes them.
#pragma once

#include <sunder/base/error.h>

#include <cstddef>
#include <string_view>
#include <vector>

namespace sunder::io {

struct NpyArray {
  std::size_t rows = 0, columns = 0;
  std::vector<double> values;  // row by row, finite
};

// Do the bytes begin as those of an NPY file?
bool is_npy(std::string_view bytes);

// The array, of float64, float32 or whole numbers of 1 to 8 bytes, in either byte order, in C or Fortran order. place:
// the file's name, for messages.
// Throws Error bad_file with the file, or its row: an array of another kind or shape, or of no numbers; one that is not
// finite, or a whole number beyond 2^53, as near-by ones are no doubles; a file that is cut off or goes on too long.
// Cost: linear.
NpyArray parse_npy(std::string_view bytes, std::string_view place);

}  // namespace sunder::io
