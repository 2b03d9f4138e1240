#include <sunder/polytope/pair/rounded_half_spaces.h>
#include <sunder/predicate/point/cone_weights.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sunder::polytope {

RoundedHalfSpaces::RoundedHalfSpaces(const Polytope& body, const Pose& pose)
    : body_(body), pose_(pose), d_(body.dimension()) {
  for (std::size_t k = 0; k < d_; ++k) inverse_[k * d_ + k] = 1;
  if (pose.is_identity()) return;
  // Of the transposed matrix, and so the transposed inverse.
  is_usable_ = std::isfinite(cone_inverse(pose.linear(), d_, std::span(inverse_).first(d_ * d_)));
}

ColumnNumbers RoundedHalfSpaces::row(std::uint32_t k) const {
  const std::span<const double> numbers = body_.row(k);
  ColumnNumbers result{};
  result[d_] = numbers[d_];
  for (std::size_t c = 0; c < d_; ++c) {
    if (pose_.is_identity()) {
      result[c] = numbers[c];
      continue;
    }
    for (std::size_t r = 0; r < d_; ++r) result[c] += numbers[r] * inverse_[c * d_ + r];
    result[d_] += result[c] * pose_.translation()[c];
  }
  return result;
}

FurthestPoint RoundedHalfSpaces::most_broken(const ColumnNumbers& x, double w, CandidateRows& candidates,
                                             Cost& cost) const {
  ColumnNumbers direction{};
  direction[d_] = -w;
  for (std::size_t c = 0; c < d_; ++c) {
    if (pose_.is_identity()) {
      direction[c] = x[c];
      continue;
    }
    const double moved = x[c] - w * pose_.translation()[c];
    for (std::size_t r = 0; r < d_; ++r) direction[r] += moved * inverse_[c * d_ + r];
  }
  return candidates.furthest(direction, cost);
}

bool RoundedHalfSpaces::keeps(const ColumnNumbers& x, double w, double greatest) const {
  if (!pose_.is_identity()) return false;
  ColumnNumbers sizes{};
  for (std::size_t c = 0; c < d_; ++c) sizes[c] = std::fabs(x[c]);
  sizes[d_] = w;
  return greatest < -product_error(body_.columns(), sizes, 0);
}

double RoundedHalfSpaces::size() const {
  double normals = 0, moved = 0;
  for (std::size_t c = 0; c < d_; ++c) {
    normals = std::max(normals, body_.columns().reach[c]);
    moved = std::max(moved, std::fabs(pose_.translation()[c]));
  }
  double stretched = 0;
  for (const double x : pose_.linear()) stretched = std::max(stretched, std::fabs(x));
  return body_.columns().reach[d_] / normals * stretched + moved;
}

}  // namespace sunder::polytope
