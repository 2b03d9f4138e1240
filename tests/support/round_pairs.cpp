#include <tests/support/round_pairs.h>
#include <tests/support/shapes.h>

#include <cmath>

namespace sunder::tests {

namespace {

using solid::ConvexPolyhedron;
using solid::Pose;
using solid::RoundBody;

std::vector<Point3> box_corners(const Point3& low, const Point3& high) {
  std::vector<Point3> corners;
  for (int k = 0; k < 8; ++k) {
    corners.push_back({k % 2 == 0 ? low.x : high.x, k / 2 % 2 == 0 ? low.y : high.y, k < 4 ? low.z : high.z});
  }
  return corners;
}

Pose some_rotation(Random& random, double distance) {
  const auto part = [&] { return random.uniform(-1, 1); };
  const auto shift = [&] { return random.uniform(-distance, distance); };
  return Pose::from_quaternion(part(), part(), part(), part() + 0.01, {shift(), shift(), shift()});
}

Point3 scaled_point(double s, const Point3& p) { return {s * p.x, s * p.y, s * p.z}; }

std::vector<Point3> scaled(std::vector<Point3> points, double by) {
  for (Point3& p : points) p = scaled_point(by, p);
  return points;
}

// The same body, lengths times a power of two.
RoundBody scaled(const RoundBody& body, double by) {
  const auto points = body.points();
  const double r = body.radius() * by;
  switch (body.kind()) {
    case RoundKind::hull: return RoundBody::rounded(ConvexPolyhedron(scaled({points.begin(), points.end()}, by)), r);
    case RoundKind::cylinder: return RoundBody::cylinder(scaled_point(by, points[0]), scaled_point(by, points[1]), r);
    case RoundKind::cone: return RoundBody::cone(scaled_point(by, points[0]), scaled_point(by, points[1]), r);
    case RoundKind::ellipsoid: break;
  }
  const auto& [m, t] = body.frame();
  return RoundBody::ellipsoid({t[0] * by, t[1] * by, t[2] * by}, {m[0] * by, m[4] * by, m[8] * by});
}

Pose with_scaled_translation(const Pose& pose, double by) {
  const auto& [m, t] = pose.affine();
  return Pose::from_matrix(m, {t[0] * by, t[1] * by, t[2] * by});
}

RoundBody of_radius(const RoundBody& body, double r) {
  const auto points = body.points();
  switch (body.kind()) {
    case RoundKind::hull: return RoundBody::rounded(body.core(), r);
    case RoundKind::cylinder: return RoundBody::cylinder(points[0], points[1], r);
    case RoundKind::cone: return RoundBody::cone(points[0], points[1], r);
    case RoundKind::ellipsoid: break;
  }
  return body;
}

double whole(Random& random, std::int64_t low, std::int64_t high) {
  return static_cast<double>(random.between(low, high));
}

// Rests on the plane z = 0 from above, at the origin, in small whole numbers.
RoundBody resting(Primitive primitive, Random& random) {
  const double r = whole(random, 1, 4), h = whole(random, 1, 5);
  const bool lies = random.below(2) == 0;
  switch (primitive) {
    case Primitive::ball: return RoundBody::ball({0, 0, r}, r);
    case Primitive::capsule:
      return lies ? RoundBody::capsule({-h, -1, r}, {h, 1, r}, r) : RoundBody::capsule({0, 0, r}, {1, 2, r + h}, r);
    case Primitive::rounded_box:
      return RoundBody::rounded(ConvexPolyhedron(box_corners({-h, -2, r}, {1, h, r + h})), r);
    case Primitive::rounded_hull: {
      const std::array points{Point3{0, 0, r}, Point3{h, 1, r + 2}, Point3{-1, h, r + 1}, Point3{-h, -2, r + 1}};
      return RoundBody::rounded(ConvexPolyhedron(points), r);
    }
    case Primitive::box: return RoundBody::rounded(ConvexPolyhedron(box_corners({-h, -2, 0}, {1, h, h})), 0);
    case Primitive::polyhedron: {
      const std::array points{Point3{0, 0, 0}, Point3{h, 1, 2}, Point3{-1, h, 1}, Point3{-h, -2, lies ? 0.0 : 1.0}};
      return RoundBody::rounded(ConvexPolyhedron(points), 0);
    }
    case Primitive::cylinder:
      return lies ? RoundBody::cylinder({-h, -1, r}, {h, 1, r}, r) : RoundBody::cylinder({0, 0, 0}, {0, 0, h}, r);
    case Primitive::cone:
      return lies ? RoundBody::cone({0, 0, h}, {0, 0, 0}, r) : RoundBody::cone({0, 0, 0}, {0, 0, h}, r);
    case Primitive::ellipsoid: break;
  }
  return RoundBody::ellipsoid({0, 0, h}, {r, whole(random, 1, 4), h});
}

}  // namespace

std::string_view name_of(RoundFamily family) {
  constexpr std::array<std::string_view, round_family_count> names{
      "general", "near_contact", "touching", "last_bit", "grid", "nested", "degenerate", "tiny_or_huge"};
  return names[static_cast<std::size_t>(family)];
}

std::string_view name_of(Primitive primitive) {
  constexpr std::array<std::string_view, primitive_count> names{
      "ball", "capsule", "rounded box", "rounded hull", "box", "polyhedron", "cylinder", "cone", "ellipsoid"};
  return names[static_cast<std::size_t>(primitive)];
}

RoundBody some_primitive(Primitive primitive, Random& random) {
  const auto length = [&] { return random.log_uniform(0.1, 2); };
  const auto box = [&] {
    const Point3 high{length(), length(), length()};
    return ConvexPolyhedron(box_corners(scaled_point(-1, high), high));
  };
  const auto hull = [&] {
    const std::size_t n = 4 + random.below(random.below(8) == 0 ? 120 : 12);
    const std::vector<Point3> points = scaled(points_on_sphere(n, random), length());
    return ConvexPolyhedron(points);
  };
  switch (primitive) {
    case Primitive::ball: return RoundBody::ball(scaled_point(0.3, in_cube(random)), length());
    case Primitive::capsule: return RoundBody::capsule(in_cube(random), in_cube(random), length());
    case Primitive::rounded_box: return RoundBody::rounded(box(), length());
    case Primitive::rounded_hull: return RoundBody::rounded(hull(), length());
    case Primitive::box: return RoundBody::rounded(box(), 0);
    case Primitive::polyhedron: return RoundBody::rounded(hull(), 0);
    case Primitive::cylinder: return RoundBody::cylinder(in_cube(random), in_cube(random), length());
    case Primitive::cone: return RoundBody::cone(in_cube(random), in_cube(random), length());
    case Primitive::ellipsoid: break;
  }
  return RoundBody::ellipsoid(scaled_point(0.3, in_cube(random)), {length(), length(), length()});
}

Pose moved(const Pose& pose, const Point3& way, double t) {
  const auto& [m, at] = pose.affine();
  return Pose::from_matrix(m, {at[0] + t * way.x, at[1] + t * way.y, at[2] + t * way.z});
}

double last_meeting(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& from, const Point3& way) {
  double low = 0, high = 1;
  while (true) {
    const double middle = low + (high - low) / 2;
    if (!(low < middle && middle < high)) return high;
    (round_round(a, pose_a, b, moved(from, way, middle)).meet() ? low : high) = middle;
  }
}

RoundCase RoundPairs::near_contact(Primitive of_a, Primitive of_b) {
  const RoundBody a = some_primitive(of_a, random_), b = some_primitive(of_b, random_);
  const Pose pose_a = some_rotation(random_, 0.2), from = some_rotation(random_, 0.2);
  const Point3 way = scaled_point(16, on_sphere(random_));
  double t = 0;
  // They meet at about t = 0 and are apart at 1; where they do not, this finds some place all the same.
  if (round_round(a, pose_a, b, from).meet()) t = last_meeting(a, pose_a, b, from, way);
  if (random_.below(4) != 0) t += (random_.below(2) == 0 ? 1 : -1) * random_.log_uniform(1e-17, 1e-2);
  return {RoundFamily::near_contact, of_a, of_b, a, b, pose_a, moved(from, way, t)};
}

RoundCase RoundPairs::next(RoundFamily family, Primitive of_a, Primitive of_b) {
  const auto some = [&](Primitive p) { return some_primitive(p, random_); };
  switch (family) {
    case RoundFamily::general:
      return {family, of_a, of_b, some(of_a), some(of_b), some_rotation(random_, 2), some_rotation(random_, 2)};
    case RoundFamily::near_contact: return near_contact(of_a, of_b);
    case RoundFamily::touching:
    case RoundFamily::last_bit: {
      const RoundBody a = resting(of_a, random_), b = resting(of_b, random_);
      const double x = whole(random_, -9, 9), y = whole(random_, -9, 9), z = whole(random_, -9, 9);
      std::array<double, 3> at{x, y, z};
      if (family == RoundFamily::last_bit) {
        const std::size_t k = random_.below(4) == 0 ? random_.below(2) : 2;
        at[k] = std::nextafter(at[k], random_.below(2) == 0 ? -100 : 100);
      }
      return {family,
              of_a,
              of_b,
              a,
              b,
              Pose::from_matrix({0, 1, 0, 1, 0, 0, 0, 0, -1}, {x, y, z}),
              Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, at)};
    }
    case RoundFamily::grid: {
      const auto shift = [&] { return whole(random_, -4, 4); };
      const auto pose = [&] {
        return random_.below(2) == 0 ? Pose::from_matrix({0, 1, 0, 0, 0, 1, 1, 0, 0}, {shift(), shift(), shift()})
                                     : Pose::from_matrix({1, 0, 0, 0, 0, -1, 0, 1, 0}, {shift(), shift(), shift()});
      };
      const RoundBody a = resting(of_a, random_), b = resting(of_b, random_);
      return {family, of_a, of_b, a, b, pose(), pose()};
    }
    case RoundFamily::nested: {
      const RoundBody a = some(of_a), b = scaled(some(of_b), 0x1p-6);
      return {family, of_a, of_b, a, b, some_rotation(random_, 0.1), some_rotation(random_, 0.4)};
    }
    case RoundFamily::degenerate: {
      constexpr std::array<double, 5> radii{0, 5e-324, 1e-200, 1e6, 1e200};
      const RoundBody a = of_radius(some(of_a), radii[random_.below(radii.size())]);
      const RoundBody b = random_.below(2) == 0 ? some(of_b) : of_radius(some(of_b), radii[random_.below(3)]);
      return {family, of_a, of_b, a, b, some_rotation(random_, 2), some_rotation(random_, 2)};
    }
    case RoundFamily::tiny_or_huge: break;
  }
  const double by = std::ldexp(1.0, static_cast<int>(random_.between(-990, 990)));
  RoundCase c = random_.below(2) == 0 ? next(RoundFamily::general, of_a, of_b) : near_contact(of_a, of_b);
  return {family,
          of_a,
          of_b,
          scaled(c.a, by),
          scaled(c.b, by),
          with_scaled_translation(c.pose_a, by),
          with_scaled_translation(c.pose_b, by)};
}

std::string named(const RoundCase& c) {
  return std::string(name_of(c.family)) + ": " + std::string(name_of(c.of_a)) + ", " + std::string(name_of(c.of_b));
}

double size_of(const solid::PlacedRound& body) {
  const double of_map = body.kind() == RoundKind::ellipsoid ? 2 * body.pose.linear_range().greatest : 1;
  return std::max(body.core.size, body.radius() * of_map);
}

RoundCase RoundPairs::next() {
  const int turn = turn_++;
  const int pair = turn / round_family_count % (primitive_count * primitive_count);
  return next(static_cast<RoundFamily>(turn % round_family_count), static_cast<Primitive>(pair % primitive_count),
              static_cast<Primitive>(pair / primitive_count));
}

}  // namespace sunder::tests
