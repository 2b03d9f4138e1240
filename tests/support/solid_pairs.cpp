#include <tests/support/shapes.h>
#include <tests/support/solid_pairs.h>

#include <tests/support/doubles.h>
#include <tests/support/solid_shapes.h>

#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <algorithm>
#include <cmath>

namespace sunder::tests {

using solid::ConvexPolyhedron;
using solid::Pose;

std::string_view name_of(Family family) {
  constexpr std::array<std::string_view, family_count> names{
      "general",   "near contact",     "touching",  "last bit", "grid",   "flat",
      "needle",    "tiny or huge",     "contained", "large",    "shapes", "shapes touching",
      "stretched", "stretched turned", "caps",      "plates"};
  return names[static_cast<std::size_t>(family)];
}

namespace {

Point3 plus(const Point3& a, const Point3& b) { return {a.x + b.x, a.y + b.y, a.z + b.z}; }
Point3 times(const Point3& a, double s) { return {a.x * s, a.y * s, a.z * s}; }

std::vector<Point3> mapped(std::span<const Point3> points, auto map) {
  std::vector<Point3> out;
  for (const Point3& p : points) out.push_back(map(p));
  return out;
}

}  // namespace

SolidPairs::SolidPairs(std::uint64_t seed) : random_(seed) {
  for (int i = 0; i < 60; ++i) pool_.push_back(some_body());
  for (int i = 0; i < 4; ++i)
    large_.push_back(ConvexPolyhedron(points_on_sphere(static_cast<std::size_t>(1500 + 1000 * i), random_)));
  for (const SolidShape& shape : all_solid_shapes()) {
    auto& bodies = shape.name == "needle" ? needles_ : shape.name == "prism" ? prisms_ : shapes_;
    const int count = &bodies == &shapes_ ? 5 : 12;
    for (int i = 0; i < count; ++i) {
      // Needles are few: each of their signs takes exact numbers.
      const double n = &bodies == &needles_ ? random_.log_uniform(8, 25) : i == 0 ? 2000 : random_.log_uniform(8, 201);
      bodies.emplace_back(shape.make(static_cast<std::size_t>(n), random_));
    }
  }
  shapes_.insert(shapes_.end(), prisms_.begin(), prisms_.begin() + 5);
}

std::vector<Point3> SolidPairs::grid_points(int n, int side) {
  std::vector<Point3> points;
  const auto coordinate = [&] { return static_cast<double>(random_.between(0, side)); };
  for (int i = 0; i < n; ++i) points.push_back({coordinate(), coordinate(), coordinate()});
  return points;
}

// Four to 64 vertices: on a sphere, in a ball, cospherical with integer coordinates, prisms, boxes.
ConvexPolyhedron SolidPairs::some_body() {
  const int n = static_cast<int>(random_.between(4, 64));
  switch (random_.below(5)) {
    case 0: return ConvexPolyhedron(points_on_sphere(static_cast<std::size_t>(n), random_));
    case 1: {
      auto points = points_on_sphere(static_cast<std::size_t>(n), random_);
      for (Point3& p : points) p = times(p, random_.unit());
      return ConvexPolyhedron(points);
    }
    case 2: {  // cospherical: all signs and permutations of (1, 4, 8) and (4, 4, 7), squares 81
      std::vector<Point3> points;
      for (int i = 0; i < n; ++i) {
        std::array<double, 3> c = random_.below(2) ? std::array<double, 3>{1, 4, 8} : std::array<double, 3>{4, 4, 7};
        for (int k = 2; k > 0; --k)
          std::swap(c[static_cast<std::size_t>(k)], c[random_.below(static_cast<std::uint64_t>(k) + 1)]);
        for (double& x : c) x *= random_.below(2) ? 0.125 : -0.125;
        points.push_back({c[0], c[1], c[2]});
      }
      return ConvexPolyhedron(points);
    }
    case 3: {  // a prism over a rounded regular polygon
      std::vector<Point3> points;
      const int k = std::max(3, n / 2);
      for (int i = 0; i < k; ++i) {
        const double t = 6.283185307179586 * i / k;
        for (const double z : {-0.5, 0.5}) points.push_back({std::cos(t), std::sin(t), z});
      }
      return ConvexPolyhedron(points);
    }
    default: {  // a box
      const Point3 half{random_.uniform(0.1, 1), random_.uniform(0.1, 1), random_.uniform(0.1, 1)};
      std::vector<Point3> points;
      for (int i = 0; i < 8; ++i)
        points.push_back({i & 1 ? half.x : -half.x, i & 2 ? half.y : -half.y, i & 4 ? half.z : -half.z});
      return ConvexPolyhedron(points);
    }
  }
}

// A point, a segment, or a polygon: integer coordinates in half of the cases.
ConvexPolyhedron SolidPairs::some_flat_body() {
  const bool whole = random_.below(2);
  const int n = static_cast<int>(random_.between(1, 8));
  std::vector<Point3> points;
  const auto coordinate = [&] { return whole ? static_cast<double>(random_.between(-2, 2)) : random_.uniform(-1, 1); };
  const Point3 u{coordinate(), coordinate(), coordinate()}, v{coordinate(), coordinate(), coordinate()};
  for (int i = 0; i < n; ++i) {
    const double s = static_cast<double>(random_.between(-2, 2)), t = static_cast<double>(random_.between(-2, 2));
    points.push_back(whole ? plus(times(u, s), times(v, t)) : Point3{coordinate(), coordinate(), 0});
  }
  return ConvexPolyhedron(points);
}

Pose SolidPairs::some_pose(double distance) {
  const Point3 d = times(points_on_sphere(static_cast<std::size_t>(1), random_)[0], distance);
  std::array<double, 4> q;
  for (double& x : q) x = random_.uniform(-1, 1);
  return Pose::from_quaternion(q[0], q[1], q[2], q[3], {d.x, d.y, d.z});
}

// Any invertible map: rotations, also with scale, shear and reflection.
Pose SolidPairs::some_affine_pose() {
  const Pose rotation = some_pose(random_.log_uniform(1e-3, 1e3));
  if (random_.below(3) > 0) return rotation;
  std::array<double, 9> m = rotation.affine().linear;
  for (double& x : m) x += random_.uniform(-0.3, 0.3);
  if (random_.below(2)) {
    for (int i = 0; i < 3; ++i) m[static_cast<std::size_t>(i)] = -m[static_cast<std::size_t>(i)];
  }
  return Pose::from_matrix(m, rotation.affine().translation);
}

// Bisection for the distance of contact along a direction, then a gap or an overlap of log-uniform size.
PairCase SolidPairs::near_contact_case(Family family, const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
  const Pose here = some_pose(0), there = some_pose(1);
  return near_contact_case(family, a, b, here, there);
}
PairCase SolidPairs::near_contact_case(Family family, const ConvexPolyhedron& a, const ConvexPolyhedron& b,
                                       const Pose& here, const Pose& there) {
  const auto at = [&](double distance) {
    const auto& t = there.affine().translation;
    return Pose::from_matrix(there.affine().linear, {t[0] * distance, t[1] * distance, t[2] * distance});
  };
  double meeting = 0, parted = 8;
  for (int i = 0; i < 54 && meeting < parted; ++i) {
    const double middle = (meeting + parted) / 2;
    (polyhedron_polyhedron_by_gjk(a, here, b, at(middle)).meet() ? meeting : parted) = middle;
  }
  const double gap = random_.log_uniform(0x1p-53, 0.1) * (random_.below(2) ? 1 : -1);
  return {family, a, b, here, at(meeting + gap)};
}

// Stretched as the needles are, two spheres in the distance of a general case; in one of four the second is turned.
PairCase SolidPairs::stretched_case(Family family) {
  const auto& a = needles_[random_.below(needles_.size())];
  const auto& b = needles_[random_.below(needles_.size())];
  const Point3 d = times(on_sphere(random_), random_.uniform(0, 2.2));
  const auto linear = family == Family::stretched ? Pose().affine().linear : some_pose(0).affine().linear;
  return {family, a, b, Pose(), Pose::from_matrix(linear, {d.x * 1e300, d.y, d.z * 1e-300})};
}

// A prism on a prism, turned about its axis and shifted along the caps. Prisms are 1 high, from -1/2 to 1/2.
PairCase SolidPairs::caps_case() {
  const auto& a = prisms_[random_.below(prisms_.size())];
  const auto& b = prisms_[random_.below(prisms_.size())];
  const double angle = random_.uniform(0, 6.3), distance = random_.below(4) ? random_.uniform(0, 2.2) : 0;
  const double c = random_.below(2) ? std::cos(angle) : 1, s = c == 1 ? 0 : std::sin(angle);
  const Point2 d = on_circle(random_.unit(), distance);
  const double height = moved_by_bits(1, random_.between(-1, 1));
  PairCase result{Family::caps, a, b, Pose(), Pose::from_matrix({c, -s, 0, s, c, 0, 0, 0, 1}, {d.x, d.y, height})};
  result.touches_exactly = height == 1 && distance < 1.4;  // the caps hold discs of radius 0.707
  if (random_.below(2)) {
    std::swap(result.a, result.b);
    std::swap(result.pose_a, result.pose_b);
  }
  return result;
}

// Turned before they are made thin, so that no axis of their own frames is their thin one.
PairCase SolidPairs::plates_case(const ConvexPolyhedron& a, const ConvexPolyhedron& b) {
  const bool are_parallel = random_.below(3) == 0;
  const Pose turn = some_pose(0);
  const auto flattened = [&](const ConvexPolyhedron& body, const Pose& by) {
    const double thin = random_.log_uniform(1e-14, 1e-3);
    const auto& m = by.affine().linear;
    return ConvexPolyhedron(mapped(body.vertices(), [&](const Point3& v) {
      const double z = v.z * thin;
      return Point3{m[0] * v.x + m[1] * v.y + m[2] * z, m[3] * v.x + m[4] * v.y + m[5] * z,
                    m[6] * v.x + m[7] * v.y + m[8] * z};
    }));
  };
  const ConvexPolyhedron first = flattened(a, turn), second = flattened(b, are_parallel ? turn : some_pose(0));
  const Pose there = some_pose(1);
  const Pose here = are_parallel ? Pose::from_matrix(there.affine().linear, {}) : some_pose(0);
  return near_contact_case(Family::plates, first, second, here, there);
}

// P, and P mirrored in a point x of its surface: 2 x - P lies on the other side of any supporting plane at x, and x is
// in both. Coordinates are multiples of 2^-20 below 4 and x is a dyadic combination of a facet's vertices, so 2 x - p
// is a double. One affine map for both keeps the touch exact. Where the origin is a vertex, nothing need be rounded.
PairCase SolidPairs::touching_case(Family family, const ConvexPolyhedron& body) {
  const auto given = body.vertices();
  const bool at_origin = std::find(given.begin(), given.end(), Point3{}) != given.end();
  const ConvexPolyhedron a = at_origin ? body : ConvexPolyhedron(mapped(given, [](const Point3& p) {
    return Point3{snapped(p.x, 20), snapped(p.y, 20), snapped(p.z, 20)};
  }));
  const auto v = a.vertices();
  Point3 x = at_origin ? Point3{} : v[0];
  if (a.facet_count() > 0 && !at_origin) {
    const auto facet = a.facet(static_cast<std::uint32_t>(random_.below(a.facet_count())));
    const std::size_t n = facet.size(), i = random_.below(n);
    const Point3 &p = v[facet[i]], &q = v[facet[(i + 1) % n]], &r = v[facet[(i + 2) % n]];
    switch (random_.below(a.dimension() == 3 ? 3 : 2)) {  // inside of a flat body the mirror image overlaps it
      case 0: x = p; break;
      case 1: x = plus(times(p, 0.25), times(q, 0.75)); break;
      default: x = plus(times(p, 0.5), plus(times(q, 0.25), times(r, 0.25)));
    }
  }
  const ConvexPolyhedron b(
      mapped(v, [&](const Point3& p) { return Point3{2 * x.x - p.x, 2 * x.y - p.y, 2 * x.z - p.z}; }));
  const Pose pose = random_.below(3) ? some_affine_pose() : Pose();
  PairCase result{family, a, b, pose, pose, true};
  if (family == Family::last_bit) {
    auto linear = pose.affine().linear;
    auto translation = pose.affine().translation;
    double& moved = translation[random_.below(3)];
    moved = moved_by_bits(moved == 0 ? 1 : moved, random_.between(-3, 3));
    if (moved == 1) moved = moved_by_bits(0.5, 1);
    if (pose.affine().translation == std::array<double, 3>{}) {
      // The identity: shift by some units in the last place of 1.
      translation = {};
      translation[random_.below(3)] = static_cast<double>(random_.between(-3, 3)) * 0x1p-52;
    }
    result.pose_b = Pose::from_matrix(linear, translation);
    result.touches_exactly = false;
  }
  return result;
}

Pose reflected(const Pose& pose) {
  Affine3 m = pose.affine();
  for (std::size_t k = 0; k < 3; ++k) m.linear[k] = -m.linear[k];
  m.translation[0] = -m.translation[0];
  return Pose::from_matrix(m.linear, m.translation);
}

Pose scaled_pose(const Pose& pose, double by) {
  Affine3 m = pose.affine();
  for (double& x : m.linear) x *= by;
  for (double& x : m.translation) x *= by;
  return Pose::from_matrix(m.linear, m.translation);
}

Pose shifted(const Pose& pose, double by) {
  Affine3 m = pose.affine();
  m.translation[0] += by;
  m.translation[2] -= by;
  return Pose::from_matrix(m.linear, m.translation);
}

PairCase SolidPairs::next() {
  // One of bodies stretched and turned takes as long as thirty others: every fourth time.
  if (static_cast<Family>(turn_ % family_count) == Family::stretched_turned && turn_ / family_count % 4 != 0) ++turn_;
  return next(static_cast<Family>(turn_++ % family_count));
}

PairCase SolidPairs::next(Family family) {
  const auto& p = pool_[random_.below(pool_.size())];
  const auto& q = pool_[random_.below(pool_.size())];
  switch (family) {
    case Family::general: return {family, p, q, some_pose(0), some_pose(random_.uniform(0, 2.2))};
    case Family::near_contact: return near_contact_case(family, p, q);
    case Family::touching:
    case Family::last_bit: return touching_case(family, p);
    case Family::shapes:
      return near_contact_case(family, shapes_[random_.below(shapes_.size())], shapes_[random_.below(shapes_.size())]);
    case Family::shapes_touching: return touching_case(family, shapes_[random_.below(shapes_.size())]);
    case Family::stretched:
    case Family::stretched_turned: return stretched_case(family);
    case Family::caps: return caps_case();
    case Family::plates: return plates_case(p, q);
    case Family::grid: {
      const int side = static_cast<int>(random_.between(1, 4));
      const auto shift = [&] { return static_cast<double>(random_.between(-side, side)); };
      const ConvexPolyhedron a(grid_points(static_cast<int>(random_.between(1, 12)), side));
      const ConvexPolyhedron b(grid_points(static_cast<int>(random_.between(1, 12)), side));
      const Pose shifted = Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {shift(), shift(), shift()});
      return {family, a, b, Pose(), shifted};
    }
    case Family::flat: {
      const ConvexPolyhedron a = some_flat_body();
      const ConvexPolyhedron b = random_.below(2) ? some_flat_body() : q;
      const bool aligned = random_.below(2);
      return {family, a, b, aligned ? Pose() : some_pose(random_.uniform(0, 1)), Pose()};
    }
    case Family::needle: {
      const auto stretched = [&](const ConvexPolyhedron& body) {
        const double thin = random_.log_uniform(1e-12, 0.1);
        return ConvexPolyhedron(
            mapped(body.vertices(), [&](const Point3& v) { return Point3{v.x * thin, v.y * thin, v.z * 3}; }));
      };
      return {family, stretched(p), stretched(q), some_pose(0), some_pose(random_.log_uniform(1e-12, 3))};
    }
    case Family::tiny_or_huge: {
      const double size = std::ldexp(1.0, static_cast<int>(random_.between(-996, 996)));
      const auto scaled = [&](const ConvexPolyhedron& body, double s) {
        return ConvexPolyhedron(mapped(body.vertices(), [&](const Point3& v) { return times(v, s); }));
      };
      const Pose here = some_pose(0), there = some_pose(random_.uniform(0, 2.2));
      const auto& t = there.affine().translation;
      if (random_.below(4) == 0) {  // of different sizes
        return {family, scaled(p, size), q, here, there};
      }
      const Pose far = Pose::from_matrix(there.affine().linear, {t[0] * size, t[1] * size, t[2] * size});
      return {family, scaled(p, size), scaled(q, size), here, far};
    }
    case Family::contained: {
      const double inner = random_.below(2) ? random_.log_uniform(0x1p-30, 0.5) : 1.0;
      std::vector<Point3> points;
      for (const Point3& v : p.vertices()) {
        if (inner != 1 || random_.below(2)) points.push_back(times(v, inner));
      }
      if (points.empty()) points.push_back(p.vertices()[0]);
      const Pose pose = some_affine_pose();
      return {family, p, ConvexPolyhedron(points), pose, pose};
    }
    case Family::large: break;
  }
  const auto& big = large_[random_.below(large_.size())];
  return {family, big, random_.below(2) ? q : large_[random_.below(large_.size())], some_pose(0),
          some_pose(random_.uniform(1.5, 2.1))};
}

}  // namespace sunder::tests
