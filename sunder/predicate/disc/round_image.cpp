#include <sunder/base/lanes.h>
#include <sunder/predicate/disc/round_image.h>

#include <algorithm>
#include <cmath>

namespace sunder {

namespace {

using V = Vector3<double>;

constexpr double most_size = 0x1p60, least_size = 0x1p-300, least_length = 0x1p-100, least_entry = 0x1p-500;

double image_length(const V& v) { return std::sqrt(dot(v, v)); }

V turned(const Affine3& pose, double x, double y, double z) {
  const auto& m = pose.linear;
  return {m[0] * x + m[1] * y + m[2] * z, m[3] * x + m[4] * y + m[5] * z, m[6] * x + m[7] * y + m[8] * z};
}
V pulled_back(const Affine3& pose, const V& d) {
  const auto& m = pose.linear;
  return {m[0] * d.x + m[3] * d.y + m[6] * d.z, m[1] * d.x + m[4] * d.y + m[7] * d.z,
          m[2] * d.x + m[5] * d.y + m[8] * d.z};
}
V image_of(const Affine3& pose, const Point3& p) {
  const V v = turned(pose, p.x, p.y, p.z);
  return {v.x + pose.translation[0], v.y + pose.translation[1], v.z + pose.translation[2]};
}

Guess guess_beyond(double value, double error) {
  return value > error ? Guess::positive : value < -error ? Guess::negative : Guess::unsure;
}

}  // namespace

void set_image(RoundImage& image, RoundKind kind, const Affine3& pose, const Point3* points, std::uint32_t ends,
               double radius, double size, double greatest) {
  image.kind = kind;
  image.ends = ends;
  image.pose = &pose;
  image.radius = radius;
  image.greatest = greatest;
  image.from = image_of(pose, points[0]);
  image.size = size + radius;
  if (ends == 2) {
    image.to = image_of(pose, points[1]);
    image.axis = turned(pose, points[1].x - points[0].x, points[1].y - points[0].y, points[1].z - points[0].z);
  }
  image.is_tame = is_moderate_size(image.size);
  if (kind == RoundKind::ellipsoid) {
    image.size = size + 3 * greatest * radius;
    image.is_tame = is_moderate_size(image.size) && greatest >= least_length && radius >= least_length;
  } else if (kind != RoundKind::hull) {
    image.length = image_length(image.axis);
    if (!(image.length >= least_length && image.length <= most_size)) image.is_tame = false;
    const double by = 1 / image.length;
    image.axis = {image.axis.x * by, image.axis.y * by, image.axis.z * by};
  }
}

void set_image(RoundImage& image, const Affine3& pose, const double* all, std::uint32_t count, double radius,
               double size, double greatest) {
  image.kind = RoundKind::hull;
  image.ends = 0;
  image.pose = &pose;
  image.radius = radius;
  image.size = size + radius;
  image.greatest = greatest;
  image.is_tame = is_moderate_size(image.size) && greatest >= least_entry && greatest <= 1 / least_entry;
  image.all = all;
  image.count = count;
}

void set_image(RoundImage& image, const Affine3& pose, const Point3* range, double radius, double size,
               double greatest) {
  set_image(image, pose, nullptr, 0, radius, size, greatest);
  image.range = range;
}

double reach_along(const RoundImage& image, const V& d) {
  switch (image.kind) {
    case RoundKind::hull: {
      const double round = image.radius > 0 ? image.radius * image_length(d) : 0;
      if (image.ends == 1) return dot(d, image.from) + round;
      if (image.ends == 2) return std::max(dot(d, image.from), dot(d, image.to)) + round;
      const V e = pulled_back(*image.pose, d);
      const auto& t = image.pose->translation;
      const double moved = d.x * t[0] + d.y * t[1] + d.z * t[2];
      if (image.range != nullptr) {
        // The same sum as of each corner, and rounding is monotone: so this is the greatest of them.
        const Point3 &low = image.range[0], &high = image.range[1];
        return std::max(e.x * low.x, e.x * high.x) + std::max(e.y * low.y, e.y * high.y) +
               std::max(e.z * low.z, e.z * high.z) + moved + round;
      }
      const double *x = image.all, *y = x + image.count, *z = y + image.count;
      Lanes furthest = e.x * lanes_at(x) + e.y * lanes_at(y) + e.z * lanes_at(z);
      for (std::uint32_t j = 2; j < image.count; j += 2) {
        furthest = greater_of(furthest, e.x * lanes_at(x + j) + e.y * lanes_at(y + j) + e.z * lanes_at(z + j));
      }
      return std::max(furthest[0], furthest[1]) + moved + round;
    }
    case RoundKind::ellipsoid: return dot(d, image.from) + image.radius * image_length(pulled_back(*image.pose, d));
    case RoundKind::cylinder:
      return std::max(dot(d, image.from), dot(d, image.to)) + image.radius * image_length(cross(d, image.axis));
    case RoundKind::cone: break;
  }
  return std::max(dot(d, image.from) + image.radius * image_length(cross(d, image.axis)), dot(d, image.to));
}

Guess gap_guess(const V& d, const RoundImage& a, const RoundImage& b) {
  const double gap = -reach_along(b, {-d.x, -d.y, -d.z}) - reach_along(a, d);
  const Guess guess = guess_beyond(gap, round_image_error * (a.size + b.size));
  return a.is_tame && b.is_tame ? guess : Guess::unsure;
}

Guess side_guess(const RoundImage& image, const V& x, double size) {
  if (!image.is_tame) return Guess::unsure;
  const V from = x - image.from;
  if (image.kind == RoundKind::ellipsoid) {
    // adj(L) (x - t) against det r. With g the greatest entry and v = x - t an adjoint's entry is at most 2 g^2 in
    // size, and off by 6 u g^2; so its product with v by at most 14 u g^2 |v|_1, the length of all by 40 u of that, and
    // the determinant by 42 u g^3.
    const auto& m = image.pose->linear;
    const V p{m[0], m[3], m[6]}, q{m[1], m[4], m[7]}, r{m[2], m[5], m[8]};
    const V of_p = cross(q, r);
    const double determinant = std::fabs(dot(p, of_p));
    const double way = image_length({dot(of_p, from), dot(cross(r, p), from), dot(cross(p, q), from)});
    const double g = image.greatest;
    const double sizes = std::fabs(from.x) + std::fabs(from.y) + std::fabs(from.z) + g * image.radius + 5 * size;
    if (!(sizes <= most_size)) return Guess::unsure;
    return guess_beyond(image.radius * determinant - way, 0x1p-46 * (g * g * sizes) + least_size);
  }
  const double far = image_length(from);
  if (!(far <= most_size)) return Guess::unsure;
  const double along = dot(from, image.axis), across = image_length(cross(from, image.axis)),
               rest = image.length - along;
  const double error = round_image_error * (image.size + size + far);
  double reach = image.radius, of_reach = error;
  if (image.kind == RoundKind::cone) {
    const double slope = image.radius / image.length;
    if (!(slope <= most_size)) return Guess::unsure;
    reach = slope * rest;
    of_reach = error * (1 + slope);
  }
  if (along < -error || rest < -error || reach - across < -of_reach) return Guess::negative;
  return along > error && rest > error && reach - across > of_reach ? Guess::positive : Guess::unsure;
}

Guess nearness_guess(const V& p, const V& q, double reach, double size) {
  if (!(is_moderate_size(size) && reach <= most_size)) return Guess::unsure;
  const double far = image_length(q - p);
  return guess_beyond(reach - far, round_image_error * (size + far));
}

}  // namespace sunder
