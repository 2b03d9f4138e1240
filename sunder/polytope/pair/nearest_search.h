// The search for the point of the difference A - B that is nearest to the origin, in floating point. It proposes, and
// may be wrong.
// Source: Wolfe 1976; Gilbert, Johnson & Keerthi 1988.
#pragma once

#include <sunder/predicate/filter/along_columns.h>

#include <array>
#include <cstddef>
#include <cstdint>

namespace sunder::polytope {

// A point, by two numbers (as of A and of B, where it is a difference), and about where it is.
struct DifferencePoint {
  std::uint32_t a = 0, b = 0;
  ColumnNumbers at{};
};

// From there towards the origin of R^d, the greatest component of size 1, those zero that do not matter. False where
// there is no such direction.
bool towards_origin(const ColumnNumbers& from, std::size_t d, ColumnNumbers& direction);

// What a search does with a point: takes it in, looks once more along the same direction, or stops.
enum class NearestStep : std::uint8_t { take, again, stop };

// Points of up to seven dimensions whose affine hull has its nearest point to the origin inside of their hull, with the
// weights of that point.
class NearestSimplex {
 public:
  explicit NearestSimplex(std::size_t dimension) : d_(dimension) {}

  std::size_t size() const { return size_; }
  bool is_full() const { return size_ == d_ + 1; }  // it holds the origin
  const DifferencePoint& operator[](std::size_t k) const { return points_[k]; }
  const ColumnNumbers& nearest() const { return nearest_; }
  bool has(std::uint32_t a, std::uint32_t b) const;
  double weight(std::size_t k) const { return weights_[k]; }
  // Is the nearest point so near that floating point does not know in which direction the origin is? Points have errors
  // as those of numbers of this size have, or of their own where that is greater. False without points.
  bool is_at_origin(double size = 0) const;

  // Takes in a point, moves to the nearest point of all, and drops points without weight (Wolfe's minor cycles). False
  // where floating point finds no way on. Requires that it is not full.
  bool add(const DifferencePoint& point);

  // The loop of the search: at most so many points come in, each the furthest towards the origin, until the simplex is
  // full or there is no way on. An empty simplex begins with the direction from `from`.
  //   candidates              which points are looked at: bool widen(), narrow() (candidate_rows.h)
  //   probe(direction, next)  finds the next point, and decides: a NearestStep
  template <class Candidates, class Probe>
  void search(const ColumnNumbers& from, int steps, Candidates& candidates, const Probe& probe) {
    ColumnNumbers direction{};
    if (!towards_origin(from, d_, direction)) direction[0] = 1;
    for (int step = 0; step < steps; ++step) {
      if (size_ > 0 && !towards_origin(nearest_, d_, direction)) return;
      DifferencePoint next;
      const NearestStep what = probe(direction, next);
      if (what == NearestStep::stop) return;
      if (what == NearestStep::again) continue;
      if (has(next.a, next.b)) {
        if (!candidates.widen()) return;
        continue;
      }
      if (!add(next) || is_full()) return;
      candidates.narrow();
    }
  }

 private:
  // The weights, which may be negative, of the point of the affine hull that is nearest to the origin.
  bool affine_weights(std::array<double, most_columns + 1>& weights);
  void drop_without_weight();
  void find_nearest();

  std::size_t d_, size_ = 0;
  std::array<DifferencePoint, most_columns + 1> points_{};
  std::array<double, most_columns + 1> weights_{};
  ColumnNumbers nearest_{};
  // Of the edges from the first point the orthogonal parts, as far as they still hold: edge j less its `share` of those
  // before it; and what is left of the first point less its parts along them.
  struct OrthogonalEdge {
    ColumnNumbers part{}, rest{};
    std::array<double, most_columns> share{};
    double inverse_square = 0, along = 0;
  };
  std::size_t known_edges_ = 0;
  std::array<OrthogonalEdge, most_columns> edges_;
};

}  // namespace sunder::polytope
