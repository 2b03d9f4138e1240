#include <tests/support/shapes.h>
#include <tests/support/solid_lines.h>

#include <tests/support/doubles.h>
#include <tests/support/solid_shapes.h>

#include <array>
#include <cmath>
#include <span>
#include <utility>

namespace sunder::tests {

using solid::ConvexPolyhedron;
using solid::Pose;

namespace {

Point3 between(const Point3& p, const Point3& q, double t) {
  return {p.x + (q.x - p.x) * t, p.y + (q.y - p.y) * t, p.z + (q.z - p.z) * t};
}

Point3 image(const Pose& pose, const Point3& p) {
  const auto& [m, t] = pose.affine();
  const auto row = [&](std::size_t i) { return m[3 * i] * p.x + m[3 * i + 1] * p.y + m[3 * i + 2] * p.z + t[i]; };
  return {row(0), row(1), row(2)};
}

Point3 stretched(const Point3& p, const Point3& by) { return {p.x * by.x, p.y * by.y, p.z * by.z}; }

std::vector<Point3> rings(Random& random) {
  std::vector<Point3> points;
  const std::int64_t count = random.between(2, 5);
  for (std::int64_t k = 0; k < count; ++k) {
    const double height = static_cast<double>(2 * k) - static_cast<double>(count - 1);
    const double radius = 8 - height * height / 4;
    const std::size_t n = random.below(2) == 0 ? 6 : 17;
    for (const double angle : jittered_angles(n, 0, random)) {
      points.push_back({radius * std::cos(angle), radius * std::sin(angle), height});
    }
  }
  return points;
}

}  // namespace

bool is_same_cut(const solid::PolyhedronCut& found, const solid::PolyhedronCut& other) {
  const auto surface = [](const solid::PolyhedronCut& cut) {
    const auto* along = std::get_if<solid::CutAlong>(&cut.evidence);
    return along != nullptr ? along->surface : solid::CutFeature{};
  };
  return kind_of(found) == kind_of(other) && ends_of(found.evidence) == ends_of(other.evidence) &&
         surface(found) == surface(other) &&
         facets_of(found.evidence).has_value() == facets_of(other.evidence).has_value();
}

std::string_view name_of(LineFamily family) {
  constexpr std::array<std::string_view, line_family_count> names{
      "general",  "round",        "grid",      "features",         "last bit", "features posed",
      "flat",     "boxes",        "prisms",    "bipyramids",       "heights",  "needles",
      "far away", "tiny or huge", "stretched", "stretched turned", "shapes"};
  return names[static_cast<std::size_t>(family)];
}

SolidLines::SolidLines(std::uint64_t seed) : random_(seed) {
  const auto size = [&](double low, double high) { return static_cast<std::size_t>(random_.log_uniform(low, high)); };
  const auto whole = [&](std::int64_t side) { return on_grid(random_, side); };
  for (int i = 0; i < 24; ++i) {
    general_.emplace_back(i % 2 == 0 ? points_on_sphere(size(4, 60), random_) : points_in_cube(size(5, 80), random_));
    std::vector<Point3> points;
    for (std::int64_t n = random_.between(4, 16); n > 0; --n) points.push_back(whole(3));
    grid_.emplace_back(points);
    points.clear();
    const Point3 p = whole(3), q = whole(3), r = whole(3);
    for (std::int64_t n = random_.between(1, 2) * (i % 4); n >= 0; --n) {
      const double s = static_cast<double>(random_.between(-2, 2)), t = static_cast<double>(random_.between(-2, 2));
      const auto sum = [&](double x, double y, double z) { return x + (i % 4 < 2 ? 0 : s * y) + t * z; };
      points.push_back({sum(p.x, q.x, r.x), sum(p.y, q.y, r.y), sum(p.z, q.z, r.z)});
    }
    flat_.emplace_back(points);
    needles_.emplace_back([&] {
      const double by = random_.log_uniform(1e3, 1e8);
      std::vector<Point3> long_ones = points_on_sphere(size(6, 40), random_);
      for (Point3& v : long_ones) v = stretched(v, i % 2 == 0 ? Point3{by, 1, 1} : Point3{by, 1, by});
      return long_ones;
    }());
    heights_.emplace_back(rings(random_));
  }
  for (int i = 0; i < 6; ++i) {
    round_.emplace_back(points_on_sphere(size(100, 300), random_));
    const Point3 sides{static_cast<double>(i + 1), 2, i % 2 == 0 ? 1.0 : 0.3};
    std::vector<Point3> corners = cube_corners(-1, 1);
    for (Point3& p : corners) p = stretched(p, sides);
    boxes_.emplace_back(corners);
    prisms_.emplace_back(solid_shapes::prism(size(8, 120)));
    bipyramids_.emplace_back(solid_shapes::bipyramid(size(8, 120)));
    flat_.emplace_back(solid_shapes::flat(size(8, 200)));
    stretched_.emplace_back(solid_shapes::needle(size(8, 24), random_));
  }
  for (const SolidShape& shape : all_solid_shapes()) {
    if (shape.name == "needle") continue;
    for (int i = 0; i < 2; ++i) shapes_.emplace_back(shape.make(size(8, 150), random_));
  }
}

const ConvexPolyhedron& SolidLines::one_of(const Bodies& bodies) { return bodies[random_.below(bodies.size())]; }

// A rotation, sometimes stretched, sheared or reflected too.
Pose SolidLines::some_pose() {
  const auto number = [&] { return random_.uniform(-1, 1); };
  const double w = number(), x = number(), y = number(), z = number();
  const std::array<double, 3> shift{number(), number(), number()};
  const Pose rotation = Pose::from_quaternion(w, x, y, z, shift);
  const std::uint64_t kind = random_.below(4);
  if (kind < 2) return rotation;
  std::array<double, 9> m = rotation.affine().linear;
  for (std::size_t k = 0; k < 3; ++k) {
    m[k] *= kind == 2 ? -1 : 3;
    m[3 + k] += kind == 2 ? 0 : 0.5 * m[6 + k];
  }
  return Pose::from_matrix(m, shift);
}

Point3 SolidLines::feature_point(const ConvexPolyhedron& body) {
  const auto& vertices = body.vertices();
  const std::uint32_t v = static_cast<std::uint32_t>(random_.below(vertices.size()));
  const std::uint64_t kind = random_.below(4);
  const auto neighbours = body.neighbours(v);
  if (kind < 2 || neighbours.empty()) return vertices[v];
  const double part = random_.below(2) == 0 ? 0.5 : random_.unit();
  if (kind == 2 || body.facet_count() == 0) {
    return between(vertices[v], vertices[neighbours[random_.below(neighbours.size())]], part);
  }
  const auto facet = body.facet(static_cast<std::uint32_t>(random_.below(body.facet_count())));
  const Point3& p = vertices[facet[random_.below(facet.size())]];
  return between(between(vertices[facet[0]], vertices[facet[1]], part), p, 0.5);
}

Point3 SolidLines::near(const ConvexPolyhedron& body, const Pose& pose) {
  const auto [low, high] = body.box();
  // Bodies that have no length along an axis have a unit there.
  const auto along = [&](double from, double to) {
    return from + (to > from ? to - from : 1) * random_.uniform(-0.5, 1.5);
  };
  const double x = along(low.x, high.x), y = along(low.y, high.y), z = along(low.z, high.z);
  return image(pose, {x, y, z});
}

LineCase SolidLines::next() {
  const LineFamily family = static_cast<LineFamily>(turn_);
  turn_ = (turn_ + 1) % line_family_count;
  return next(family);
}

LineCase SolidLines::next(LineFamily family) {
  const auto between_features = [&](const ConvexPolyhedron& body, const Pose& pose) {
    Point3 a = image(pose, feature_point(body)), b = image(pose, feature_point(body));
    while (a == b) b = near(body, pose);
    if (random_.below(4) == 0) b = near(body, pose);
    if (random_.below(3) == 0) a = between(b, a, 2);
    return LineCase{family, body, pose, a, b};
  };
  const auto beside = [&](const ConvexPolyhedron& body, const Pose& pose) {
    const Point3 a = near(body, pose), b = near(body, pose);
    return LineCase{family, body, pose, a, b};
  };
  const auto either = [&](const ConvexPolyhedron& body) {
    const Pose pose = random_.below(2) == 0 ? Pose() : some_pose();
    return random_.below(2) == 0 ? between_features(body, pose) : beside(body, pose);
  };
  const Bodies* any[] = {&general_, &grid_, &boxes_, &prisms_, &heights_, &shapes_};
  LineCase c = [&]() -> LineCase {
    switch (family) {
      case LineFamily::general: return beside(one_of(general_), some_pose());
      case LineFamily::round: return beside(one_of(round_), some_pose());
      case LineFamily::grid: {
        const Point3 a = on_grid(random_, 4), b = on_grid(random_, 4);
        const bool is_turned = random_.below(2) == 0;
        const Pose pose = is_turned ? Pose::from_matrix({0, -1, 0, 2, 0, 1, 0, 0, 1}, {1, 0, 0}) : Pose();
        return {family, one_of(grid_), pose, a, b};
      }
      case LineFamily::features: return between_features(one_of(*any[random_.below(6)]), Pose());
      case LineFamily::last_bit: {
        LineCase moved = between_features(one_of(*any[random_.below(6)]), Pose());
        moved.a[random_.below(3)] = moved_by_bits(moved.a.x, random_.between(-3, 3));
        for (std::size_t k = 0; k < 3; ++k) moved.b[k] = moved_by_bits(moved.b[k], random_.between(-2, 2));
        return moved;
      }
      case LineFamily::features_posed: return between_features(one_of(*any[random_.below(6)]), some_pose());
      case LineFamily::flat: return either(one_of(flat_));
      case LineFamily::boxes: return either(one_of(boxes_));
      case LineFamily::prisms: return either(one_of(prisms_));
      case LineFamily::bipyramids: return either(one_of(bipyramids_));
      case LineFamily::heights: return either(one_of(heights_));
      case LineFamily::needles: return either(one_of(needles_));
      case LineFamily::far_away: {
        LineCase far = either(one_of(general_));
        far.b = between(far.a, far.b, random_.log_uniform(1e2, 1e12));
        if (random_.below(2) == 0) std::swap(far.a, far.b);
        return far;
      }
      case LineFamily::tiny_or_huge: {
        const double scale = std::ldexp(1.0, static_cast<int>(random_.between(-1000, 1000)));
        const LineCase plain = either(one_of(general_));
        if (random_.below(2) == 0) {  // by the pose
          const double part = std::sqrt(scale);
          auto [m, t] = plain.pose.affine();
          for (double& x : m) x *= part;
          for (double& x : t) x *= part;
          const Point3 by{part, part, part};
          return {family, plain.body, Pose::from_matrix(m, t), stretched(plain.a, by), stretched(plain.b, by)};
        }
        std::vector<Point3> points;
        const Point3 by{scale, scale, scale};
        for (const Point3& p : plain.body.vertices()) points.push_back(stretched(p, by));
        const ConvexPolyhedron body(points);
        return random_.below(2) == 0 ? between_features(body, Pose()) : beside(body, Pose());
      }
      case LineFamily::stretched: {
        const ConvexPolyhedron& body = one_of(stretched_);
        return random_.below(2) == 0 ? between_features(body, Pose()) : beside(body, Pose());
      }
      case LineFamily::stretched_turned: {
        const ConvexPolyhedron& body = one_of(stretched_);
        const Pose pose = some_pose();
        return random_.below(2) == 0 ? between_features(body, pose) : beside(body, pose);
      }
      case LineFamily::shapes: return either(one_of(shapes_));
    }
    return beside(one_of(general_), Pose());
  }();
  const auto is_finite = [](const Point3& p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); };
  return is_finite(c.a) && is_finite(c.b) && !(c.a == c.b) ? c : next(family);
}

}  // namespace sunder::tests
