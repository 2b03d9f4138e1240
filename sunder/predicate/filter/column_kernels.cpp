#include <sunder/base/lanes.h>
#include <sunder/predicate/filter/column_kernels_internal.h>

#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>

namespace sunder {

namespace {

// WideAt by typedef: in `using` Clang passes over `aligned`, and then loads as if addresses were those of whole
// registers.

namespace of_two {

using Wide = Lanes;
typedef double WideAt __attribute__((vector_size(16), aligned(8), may_alias));  // NOLINT(modernize-use-using)
static_assert(alignof(WideAt) == alignof(double));
#define SUNDER_KERNEL
#define SUNDER_GREATER(a, b) greater_of(a, b)
#define SUNDER_BITS(mask) bits_of(mask)
#include <sunder/predicate/filter/column_loops.inc>
#undef SUNDER_KERNEL
#undef SUNDER_GREATER
#undef SUNDER_BITS

}  // namespace of_two

#if defined(__x86_64__)
#define SUNDER_HAS_FOUR 1

namespace of_four {

using Wide = double __attribute__((vector_size(32)));
typedef double WideAt __attribute__((vector_size(32), aligned(8), may_alias));  // NOLINT(modernize-use-using)
static_assert(alignof(WideAt) == alignof(double));
#define SUNDER_KERNEL __attribute__((target("avx2")))
#define SUNDER_GREATER(a, b) __builtin_ia32_maxpd256(b, a)
#define SUNDER_BITS(mask) static_cast<std::uint32_t>(__builtin_ia32_movmskpd256(reinterpret_cast<Wide>(mask)))
#include <sunder/predicate/filter/column_loops.inc>
#undef SUNDER_KERNEL
#undef SUNDER_GREATER
#undef SUNDER_BITS

}  // namespace of_four

#endif

// Of 2 to 7 columns.
template <template <std::size_t> class Loops>
constexpr std::array<ColumnKernels, most_columns + 1> kernels_of() {
  const auto of = []<std::size_t D>() {
    return ColumnKernels{Loops<D>::furthest_block, Loops<D>::next_block, Loops<D>::products_of_block,
                         Loops<D>::find_tops};
  };
  return {
    {{},
     {},
     of.template operator()<2>(),
     of.template operator()<3>(),
     of.template operator()<4>(),
     of.template operator()<5>(),
     of.template operator()<6>(),
     of.template operator()<7>()}
  };
}

constexpr std::array<ColumnKernels, most_columns + 1> two = kernels_of<of_two::Loops>();
#ifdef SUNDER_HAS_FOUR
constexpr std::array<ColumnKernels, most_columns + 1> four = kernels_of<of_four::Loops>();
#endif

}  // namespace

const ColumnKernels& column_kernels_of_two(std::size_t columns) { return two[columns]; }

const ColumnKernels* column_kernels_of_four([[maybe_unused]] std::size_t columns) {
#ifdef SUNDER_HAS_FOUR
  static const bool is_here = __builtin_cpu_supports("avx2") != 0;
  return is_here ? &four[columns] : nullptr;
#else
  return nullptr;
#endif
}

}  // namespace sunder
