#include <sunder/polytope/pair/support.h>

#include <cmath>

namespace sunder::polytope {

Support support(const Polytope& body, const Pose& pose, const Vector& direction, double side, std::size_t every) {
  const std::size_t d = body.dimension();
  ColumnNumbers pulled{}, sizes{};
  int roundings = 0;
  if (pose.is_identity()) {
    for (std::size_t c = 0; c < d; ++c) {
      pulled[c] = side * direction[c];
      sizes[c] = std::fabs(direction[c]);
    }
  } else {  // sums of d products
    roundings = static_cast<int>(d);
    for (std::size_t r = 0; r < d; ++r) {
      const double along = side * direction[r];
      for (std::size_t c = 0; c < d; ++c) {
        const double product = along * pose.linear(r, c);
        pulled[c] += product;
        sizes[c] += std::fabs(product);
      }
    }
  }
  const FurthestPoint furthest = furthest_along(body.columns(), pulled, every);
  Support result{furthest.index, {side * furthest.product, product_error(body.columns(), sizes, roundings + 2)}};
  if (pose.is_identity()) return result;
  double moved = 0, size = 0;
  for (std::size_t r = 0; r < d; ++r) {
    const double product = direction[r] * pose.translation()[r];
    moved += product;
    size += std::fabs(product);
  }
  result.product.product += moved;
  result.product.error += (static_cast<double>(d) + 8) * 0x1p-53 * size + 0x1p-1060;
  return result;
}

Vector rounded_image(const Polytope& body, const Pose& pose, std::uint32_t k) {
  const std::size_t d = body.dimension();
  const std::span<const double> row = body.row(k);
  Vector image{};
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

std::size_t first_sample(const Polytope& body) {
  std::size_t every = 1;
  while (body.columns().stride / PointColumns::block / every >= 8) every *= 4;
  return every;
}

}  // namespace sunder::polytope
