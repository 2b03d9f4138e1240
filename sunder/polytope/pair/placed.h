// A polytope under its pose, as exact methods look at it: each product with a direction of the world is one with a
// direction of the body's frame, so rows stay the doubles that they are.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/certificate/common_point.h>
#include <sunder/number/exact_fraction.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/polytope/represent/hierarchical_tree.h>
#include <sunder/predicate/filter/along_columns.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

using ExactVector = std::vector<Dyadic>;

Dyadic dot(std::span<const Dyadic> u, std::span<const Dyadic> v);  // of as many numbers as the shorter one has
Dyadic dot(std::span<const Dyadic> u, std::span<const double> v);

ExactVector negated(ExactVector v);

// linear^T times a direction of the world, and linear times a vector of the body.
ExactVector pulled(const Pose& pose, std::span<const Dyadic> direction);
ExactVector turned(const Pose& pose, std::span<const Dyadic> vector);

// Adds weight v to the sum: as many numbers of it as that has.
template <class Numbers>
void add_multiple(ExactVector& sum, const Dyadic& weight, const Numbers& v) {
  for (std::size_t c = 0; c < sum.size(); ++c) sum[c] = sum[c] + weight * v[c];
}

// The sum of weights times rows, each of at least `size` numbers; nothing where a weight is negative or names no row,
// or their denominator is not positive.
template <class Rows>
std::optional<ExactVector> weighted_sum(const Weights& weights, const Rows& row, std::size_t rows, std::size_t size) {
  if (weights.denominator.sign() != Sign::positive) return std::nullopt;
  ExactVector sum(size);
  for (const auto& [index, weight] : weights.parts) {
    if (index >= rows || weight.sign() == Sign::negative) return std::nullopt;
    add_multiple(sum, weight, row(index));
  }
  return sum;
}

// An upper bound of the products with a direction of the world, of what is within the half-spaces a1, .., ad, b of the
// frame of the body: that which the multipliers prove; nothing where they prove none.
template <class Rows>
std::optional<ExactFraction> bound_along(const Pose& pose, std::span<const Dyadic> direction,
                                         const Weights& multipliers, const Rows& half_space, std::size_t count) {
  const ExactVector wanted = pulled(pose, direction);
  const auto sum = weighted_sum(multipliers, half_space, count, wanted.size() + 1);
  if (!sum) return std::nullopt;
  const Dyadic& w = multipliers.denominator;
  for (std::size_t c = 0; c < wanted.size(); ++c) {
    if (!((*sum)[c] == wanted[c] * w)) return std::nullopt;
  }
  return ExactFraction{sum->back() + dot(direction, pose.translation()) * w, w};
}

// Keeps references to both. What is furthest is found by a scan of all rows, or by a walk down the tree of the body.
class Placed {
 public:
  Placed(const Polytope& body, const Pose& pose) : body_(body), pose_(pose) {}
  Placed(const HierarchicalTree& tree, const Pose& pose) : body_(tree.body()), pose_(pose), walk_(tree) {}
  // Body and pose must outlive this: temporary ones are refused.
  Placed(const Polytope&, const Pose&&) = delete;
  Placed(const Polytope&&, const Pose&) = delete;
  Placed(const HierarchicalTree&, const Pose&&) = delete;

  const Polytope& body() const { return body_; }
  const Pose& pose() const { return pose_; }
  std::size_t dimension() const { return body_.dimension(); }

  // Of points. The image of point k; one of the points that are furthest along the direction, and its product. Of a
  // tree: of those points that walks so deep may find.
  ExactVector image(std::uint32_t k) const;
  ExactFurthest furthest(std::span<const Dyadic> direction, Cost& cost);
  // All points that are furthest. Of a body that is scanned.
  ExactFace face(std::span<const Dyadic> direction, Cost& cost) const;

  // Of a tree: from now on walks go a level deeper. False where they went to the leaves already, and of a scan.
  bool deepen() { return walk_ && walk_->deepen(); }
  std::uint32_t scans() const { return walk_ ? walk_->scans() : 0; }

  // Of half-spaces, times scale(): row k as a1, .., ad, b of the world. One of those that are broken most at the
  // point p / w, w >= 0, that is, whose a . p - w b is greatest, and that number; nothing where there are none. Is
  // any broken, that is, this number positive? (A tree: of those that walks so deep may find.)
  ExactVector half_space(std::uint32_t k);
  std::optional<ExactFurthest> most_broken(std::span<const Dyadic> p, const Dyadic& w, Cost& cost);
  bool breaks_any(std::span<const Dyadic> p, const Dyadic& w, Cost& cost);
  const Dyadic& scale();  // positive
  // The point p / w in the frame of the body.
  ExactPointN in_frame(std::span<const Dyadic> p, const Dyadic& w) { return {unplaced(p, w), w * scale()}; }

 private:
  void invert();
  ExactVector unplaced(std::span<const Dyadic> p, const Dyadic& w);  // over w scale()
  ExactFurthest furthest_row(std::span<const Dyadic> direction, Cost& cost);

  const Polytope& body_;
  const Pose& pose_;
  std::optional<TreeWalk> walk_;
  ExactVector inverse_;  // of the linear part, over scale_; empty: not made yet, or not needed
  Dyadic scale_{1.0};
};

}  // namespace sunder::polytope
