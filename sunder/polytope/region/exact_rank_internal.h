// Ranks, and directions across, of few exact vectors.
#pragma once

#include <sunder/number/integer_internal.h>
#include <sunder/polytope/pair/placed.h>

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

// The span of vectors, one added after the other. By elimination without fractions.
class ExactSpan {
 public:
  explicit ExactSpan(std::size_t width) : width_(width) {}

  // Does it raise the rank? A vector of `width` numbers.
  bool add(std::span<const Dyadic> vector);
  std::size_t rank() const { return rows_.size(); }

  // Some vector that is orthogonal to all, and not zero; nothing where the rank is `width`.
  std::optional<ExactVector> across() const;

 private:
  struct Row {
    std::vector<Integer> numbers;
    std::size_t pivot;  // where no other row has a number
  };
  std::size_t width_;
  std::vector<Row> rows_;
};

}  // namespace sunder::polytope
