#include <sunder/polytope/pair/support.h>

#include <algorithm>
#include <cmath>

namespace sunder::polytope {

namespace {

// The direction times `side` in the frame of the body.
ColumnNumbers pulled_back(const Pose& pose, const Vector& direction, double side) {
  const std::size_t d = pose.dimension();
  ColumnNumbers pulled{};
  if (pose.is_identity()) {
    for (std::size_t c = 0; c < d; ++c) pulled[c] = side * direction[c];
    return pulled;
  }
  for (std::size_t r = 0; r < d; ++r) {
    const double along = side * direction[r];
    for (std::size_t c = 0; c < d; ++c) pulled[c] += along * pose.linear(r, c);
  }
  return pulled;
}

// A product of the frame of the body in the world.
double moved(const Pose& pose, const Vector& direction, double side, double product) {
  if (pose.is_identity()) return side * product;
  double sum = 0;
  for (std::size_t r = 0; r < pose.dimension(); ++r) sum += direction[r] * pose.translation()[r];
  return side * product + sum;
}

}  // namespace

Support support(const Polytope& body, const Pose& pose, const Vector& direction, double side) {
  const FurthestPoint furthest = furthest_along(body.columns(), pulled_back(pose, direction, side));
  return {furthest.index, {moved(pose, direction, side, furthest.product), support_error(body, pose, direction)}};
}

double support_error(const Polytope& body, const Pose& pose, const Vector& direction) {
  const std::size_t d = body.dimension();
  ColumnNumbers sizes{};
  if (pose.is_identity()) {
    for (std::size_t c = 0; c < d; ++c) sizes[c] = std::fabs(direction[c]);
    return product_error(body.columns(), sizes, 2);
  }
  double size = 0;
  for (std::size_t r = 0; r < d; ++r) {
    for (std::size_t c = 0; c < d; ++c) sizes[c] += std::fabs(direction[r] * pose.linear(r, c));
    size += std::fabs(direction[r] * pose.translation()[r]);
  }
  return product_error(body.columns(), sizes, static_cast<int>(d) + 2) +  // sums of d products
         ((static_cast<double>(d) + 8) * 0x1p-53 * size + 0x1p-1060);
}

FurthestPoint likely_support(CandidateRows& candidates, const Pose& pose, const Vector& direction, double side,
                             Cost& cost) {
  FurthestPoint result = candidates.furthest(pulled_back(pose, direction, side), cost);
  result.product = moved(pose, direction, side, result.product);
  return result;
}

FurthestPoint likely_support(TreeWalk& walk, const Pose& pose, const Vector& direction, double side,
                             TreeWalk::Reach reach, Cost& cost) {
  FurthestPoint result = walk.likely_furthest(pulled_back(pose, direction, side), reach, cost);
  result.product = moved(pose, direction, side, result.product);
  return result;
}

bool is_sure(const TreeWalk& walk, const Pose& pose, const Vector& direction, double side, Cost& cost) {
  return walk.was_to_the_end(pulled_back(pose, direction, side), cost);
}

Vector rounded_image(const Polytope& body, const Pose& pose, std::uint32_t k) {
  const std::size_t d = body.dimension();
  const std::span<const double> row = body.row(k);
  Vector image{};
  if (pose.is_identity()) {
    std::copy_n(row.begin(), d, image.begin());
    return image;
  }
  for (std::size_t r = 0; r < d; ++r) {
    image[r] = pose.translation()[r];
    for (std::size_t c = 0; c < d; ++c) image[r] += pose.linear(r, c) * row[c];
  }
  return image;
}

std::array<Interval, most_dimension> enclosed_image(const Polytope& body, const Pose& pose, std::uint32_t k) {
  const std::size_t d = body.dimension();
  const std::span<const double> row = body.row(k);
  std::array<Interval, most_dimension> image{};
  for (std::size_t r = 0; r < d; ++r) {
    if (pose.is_identity()) {
      image[r] = row[r];
      continue;
    }
    image[r] = pose.translation()[r];
    for (std::size_t c = 0; c < d; ++c) image[r] = image[r] + Interval(pose.linear(r, c)) * Interval(row[c]);
  }
  return image;
}

DifferencePoint rounded_difference(const Polytope& a, const Pose& pose_a, std::uint32_t i, const Polytope& b,
                                   const Pose& pose_b, std::uint32_t j) {
  DifferencePoint point{i, j, rounded_image(a, pose_a, i)};
  const Vector of_b = rounded_image(b, pose_b, j);
  for (std::size_t c = 0; c < a.dimension(); ++c) point.at[c] -= of_b[c];
  return point;
}

}  // namespace sunder::polytope
