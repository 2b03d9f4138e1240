// Which rows of a body a search in floating point looks at for the furthest one.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/predicate/filter/along_columns.h>

#include <cstddef>
#include <cstdint>

namespace sunder::polytope {

// First a sample, of every 4^k-th block, 64 to 256 rows; then, each time that this does not do, all; and after those
// the shortlist of the last direction. Of bodies of few rows, all at once. Keeps a reference to the body.
class CandidateRows {
 public:
  explicit CandidateRows(const Polytope& body);

  // The furthest row of those along the direction, which is one of the body's frame. Probes are rows looked at.
  FurthestPoint furthest(const ColumnNumbers& direction, Cost& cost);

  bool are_all() const { return kind_ == Kind::all; }
  void widen() { kind_ = Kind::all; }
  // To the shortlist of the last direction. Requires that all rows were looked at.
  void narrow();

 private:
  enum class Kind : std::uint8_t { sample, all, shortlist };

  const Polytope& body_;
  std::size_t every_;
  Kind kind_;
  bool has_list_;
  Shortlist list_;
};

// Those of two bodies, which go on together.
struct CandidateRowsOfBoth {
  CandidateRows a, b;

  CandidateRowsOfBoth(const Polytope& of_a, const Polytope& of_b) : a(of_a), b(of_b) {}

  bool are_all() const { return a.are_all() && b.are_all(); }
  // False where they are all already.
  bool widen();
  // Where they are all.
  void narrow();
};

}  // namespace sunder::polytope
