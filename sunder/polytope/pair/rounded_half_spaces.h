// Half-spaces under their pose, as floating point has them: row (a, b) of the body is (a N, b + a N t) in the world,
// where N is the inverse of the linear part and t the translation.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/polytope/pair/candidate_rows.h>
#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder::polytope {

// Keeps references to both.
class RoundedHalfSpaces {
 public:
  RoundedHalfSpaces(const Polytope& body, const Pose& pose);

  // Is there anything to search, and an inverse?
  bool is_usable() const { return is_usable_ && body_.size() > 0; }

  ColumnNumbers row(std::uint32_t k) const;

  // The row, of those looked at, whose a . x - w b is greatest, and that number.
  FurthestPoint most_broken(const ColumnNumbers& x, double w, CandidateRows& candidates, Cost& cost) const;

  // Does no row break the point x / w, surely, where this was the greatest number of all rows? False where the body is
  // moved.
  bool keeps(const ColumnNumbers& x, double w, double greatest) const;

  // About how far from the origin its boundary is.
  double size() const;

 private:
  const Polytope& body_;
  const Pose& pose_;
  std::size_t d_;
  std::array<double, most_dimension * most_dimension> inverse_{};
  bool is_usable_ = true;
};

}  // namespace sunder::polytope
