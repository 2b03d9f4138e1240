// A polytope under its pose, as exact methods look at it: each product with a direction of the world is one with a
// direction of the body's frame, so rows stay the doubles that they are.
#pragma once

#include <sunder/number/dyadic.h>
#include <sunder/polytope/object/polytope.h>
#include <sunder/polytope/object/pose.h>
#include <sunder/predicate/along_columns.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

namespace sunder::polytope {

using ExactVector = std::vector<Dyadic>;

Dyadic dot(std::span<const Dyadic> u, std::span<const Dyadic> v);  // of as many numbers as the shorter one has
Dyadic dot(std::span<const Dyadic> u, std::span<const double> v);

// linear^T times a direction of the world, and linear times a vector of the body.
ExactVector pulled(const Pose& pose, std::span<const Dyadic> direction);
ExactVector turned(const Pose& pose, std::span<const Dyadic> vector);

// Keeps references to both.
class Placed {
 public:
  Placed(const Polytope& body, const Pose& pose) : body_(body), pose_(pose) {}

  const Polytope& body() const { return body_; }
  const Pose& pose() const { return pose_; }
  std::size_t dimension() const { return body_.dimension(); }

  // Of points. The image of point k; the first of the points that are furthest along the direction, and its product.
  ExactVector image(std::uint32_t k) const;
  ExactFurthest furthest(std::span<const Dyadic> direction, std::uint32_t& exact_looks) const;

  // Of half-spaces, times scale(): row k as a1, .., ad, b of the world. The first of those that are broken most at the
  // point p / w, w >= 0, that is, whose a . p - w b is greatest, and that number; nothing where there are none.
  ExactVector half_space(std::uint32_t k);
  std::optional<ExactFurthest> most_broken(std::span<const Dyadic> p, const Dyadic& w, std::uint32_t& exact_looks);
  const Dyadic& scale();  // positive
  // The point p / w in the frame of the body, over w scale().
  ExactVector unplaced(std::span<const Dyadic> p, const Dyadic& w);

 private:
  void invert();

  const Polytope& body_;
  const Pose& pose_;
  ExactVector inverse_;  // of the linear part, over scale_; empty: not made yet
  Dyadic scale_{1.0};
};

}  // namespace sunder::polytope
