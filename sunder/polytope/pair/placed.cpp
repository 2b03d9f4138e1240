#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/pair/placed.h>

#include <algorithm>
#include <utility>

namespace sunder::polytope {

Dyadic dot(std::span<const Dyadic> u, std::span<const Dyadic> v) {
  Dyadic sum;
  for (std::size_t k = 0; k < std::min(u.size(), v.size()); ++k) sum = sum + u[k] * v[k];
  return sum;
}

Dyadic dot(std::span<const Dyadic> u, std::span<const double> v) {
  Dyadic sum;
  for (std::size_t k = 0; k < std::min(u.size(), v.size()); ++k) sum = sum + u[k] * Dyadic(v[k]);
  return sum;
}

ExactVector negated(ExactVector v) {
  for (Dyadic& x : v) x = -x;
  return v;
}

ExactVector pulled(const Pose& pose, std::span<const Dyadic> direction) {
  const std::size_t d = pose.dimension();
  if (pose.is_identity()) return {direction.begin(), direction.begin() + static_cast<std::ptrdiff_t>(d)};
  ExactVector result(d);
  for (std::size_t c = 0; c < d; ++c) {
    for (std::size_t r = 0; r < d; ++r) {
      const double entry = pose.linear(r, c);
      if (entry != 0) result[c] = result[c] + direction[r] * Dyadic(entry);
    }
  }
  return result;
}

ExactVector turned(const Pose& pose, std::span<const Dyadic> vector) {
  const std::size_t d = pose.dimension();
  ExactVector result(d);
  for (std::size_t r = 0; r < d; ++r) result[r] = dot(vector, pose.linear().subspan(r * d, d));
  return result;
}

ExactVector Placed::image(std::uint32_t k) const {
  const std::span<const double> row = body_.row(k);
  if (pose_.is_identity()) return {row.begin(), row.end()};
  ExactVector result = turned(pose_, ExactVector(row.begin(), row.end()));
  for (std::size_t r = 0; r < result.size(); ++r) result[r] = result[r] + Dyadic(pose_.translation()[r]);
  return result;
}

ExactFurthest Placed::furthest_row(std::span<const Dyadic> direction, Cost& cost) {
  if (walk_) return walk_->furthest(direction, cost);
  cost.probes += body_.size();
  return exactly_furthest_along(body_.columns(), direction, cost.exact);
}

ExactFurthest Placed::furthest(std::span<const Dyadic> direction, Cost& cost) {
  SUNDER_REQUIRE(body_.is_of_points());
  if (pose_.is_identity()) return furthest_row(direction.first(dimension()), cost);
  ExactFurthest result = furthest_row(pulled(pose_, direction), cost);
  result.product = result.product + dot(direction, pose_.translation());
  return result;
}

ExactFace Placed::face(std::span<const Dyadic> direction, Cost& cost) const {
  SUNDER_REQUIRE(body_.is_of_points() && !walk_);
  cost.probes += body_.size();
  ExactFace result = exact_face_along(body_.columns(), pulled(pose_, direction), cost.exact);
  result.product = result.product + dot(direction, pose_.translation());
  return result;
}

void Placed::invert() {
  if (!inverse_.empty() || pose_.is_identity()) return;
  ExactInverse inverse = *exact_inverse(dimension(), pose_.linear());
  inverse_ = std::move(inverse.numbers);
  scale_ = std::move(inverse.denominator);
}

const Dyadic& Placed::scale() {
  invert();
  return scale_;
}

// With N / s the inverse of the linear part, t the translation: a . x <= b for x = N (y - t) / s is
// (a N) . y <= s b + (a N) . t.
ExactVector Placed::half_space(std::uint32_t k) {
  SUNDER_REQUIRE(!body_.is_of_points());
  const std::size_t d = dimension();
  const std::span<const double> row = body_.row(k);
  if (pose_.is_identity()) return {row.begin(), row.end()};
  invert();
  ExactVector result(d + 1);
  for (std::size_t c = 0; c < d; ++c) {
    for (std::size_t r = 0; r < d; ++r) {
      if (row[r] != 0) result[c] = result[c] + Dyadic(row[r]) * inverse_[r * d + c];
    }
  }
  result[d] = scale_ * Dyadic(row[d]) + dot(result, pose_.translation());
  return result;
}

ExactVector Placed::unplaced(std::span<const Dyadic> p, const Dyadic& w) {
  const std::size_t d = dimension();
  if (pose_.is_identity()) return {p.begin(), p.begin() + static_cast<std::ptrdiff_t>(d)};
  invert();
  ExactVector moved(d), result(d);
  for (std::size_t r = 0; r < d; ++r) moved[r] = p[r] - w * Dyadic(pose_.translation()[r]);
  for (std::size_t r = 0; r < d; ++r) result[r] = dot(moved, std::span<const Dyadic>(inverse_).subspan(r * d, d));
  return result;
}

// (a N) . p - w (s b + (a N) . t) = a . (N (p - w t)) - w s b.
std::optional<ExactFurthest> Placed::most_broken(std::span<const Dyadic> p, const Dyadic& w, Cost& cost) {
  SUNDER_REQUIRE(!body_.is_of_points());
  if (body_.size() == 0) return std::nullopt;
  ExactVector direction = unplaced(p, w);
  direction.push_back(-(w * scale_));
  return furthest_row(direction, cost);
}

bool Placed::breaks_any(std::span<const Dyadic> p, const Dyadic& w, Cost& cost) {
  SUNDER_REQUIRE(!body_.is_of_points());
  if (body_.size() == 0) return false;
  ExactVector direction = unplaced(p, w);
  direction.push_back(-(w * scale_));
  if (!walk_) {
    cost.probes += body_.size();
    return is_any_positive_along(body_.columns(), direction, cost.exact);
  }
  return furthest_row(direction, cost).product.sign() == Sign::positive;
}

}  // namespace sunder::polytope
