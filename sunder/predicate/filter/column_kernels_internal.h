// The loops of predicate/filter/along_columns.h over all points, in registers of two doubles and, where the machine has them,
// of four: the same operations in the same order on each point, so the same numbers.
#pragma once

#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace sunder {

// Of each piece of 16 points the furthest one, where its place has none that is as far.
struct ColumnTops {
  static constexpr std::size_t piece = PointColumns::block / 2;

  std::array<double, Shortlist::most> products;
  std::array<std::uint32_t, Shortlist::most> indices;
};

// The block whose greatest product is the greatest: of equals the first.
struct FurthestBlock {
  std::size_t first = 0;  // point
  double product = -std::numeric_limits<double>::infinity();
};

struct ColumnKernels {
  // Of each block whose number is a multiple of `every`.
  FurthestBlock (*furthest_block)(const PointColumns& points, const ColumnNumbers& direction, std::size_t every);
  // The first point of the first block, from that of `first` on, whose greatest product is not less than the limit; the
  // stride where there is none.
  std::size_t (*next_block)(const PointColumns& points, const ColumnNumbers& direction, std::size_t first,
                            double limit);
  // Of the block of `first`, as many as it has points.
  void (*products_of_block)(const PointColumns& points, const ColumnNumbers& direction, std::size_t first,
                            double* products);
  // Requires that the products of `tops` are lower than all.
  void (*find_tops)(const PointColumns& points, const ColumnNumbers& direction, ColumnTops& tops);
};

// Of so many columns, 2 to 7. The second is nullptr where the machine has no such registers (x86-64: AVX2).
const ColumnKernels& column_kernels_of_two(std::size_t columns);
const ColumnKernels* column_kernels_of_four(std::size_t columns);

// The wider ones.
inline const ColumnKernels& column_kernels(std::size_t columns) {
  const ColumnKernels* const four = column_kernels_of_four(columns);
  return four != nullptr ? *four : column_kernels_of_two(columns);
}

}  // namespace sunder
