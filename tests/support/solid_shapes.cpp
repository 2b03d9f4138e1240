#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <array>
#include <cmath>

namespace sunder::tests {

namespace {

double number(std::size_t k) { return static_cast<double>(k); }

// n points of a circle around the z axis, at a height.
std::vector<Point3> ring(std::size_t n, double z) {
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const Point2 p = on_circle(number(k) / number(n));
    points.push_back({p.x, p.y, z});
  }
  return points;
}

// The least power of two that is not less.
double power_of_two_from(double x) { return std::exp2(std::ceil(std::log2(x))); }

}  // namespace

namespace solid_shapes {

std::vector<Point3> sphere(std::size_t n, Random& random) { return points_on_sphere(n, random); }

std::vector<Point3> bipyramid(std::size_t n) {
  std::vector<Point3> points = ring(n - 2, 0);
  points.push_back({0, 0, 1});
  points.push_back({0, 0, -1});
  return points;
}

std::vector<Point3> prism(std::size_t n) {
  std::vector<Point3> points = ring(n / 2, -0.5);
  for (const Point3& p : ring(n / 2, 0.5)) points.push_back(p);
  return points;
}

std::vector<Point3> cone(std::size_t n) {
  std::vector<Point3> points = ring(n - 1, 0);
  points.push_back({0, 0, 1});
  return points;
}

std::vector<Point3> wedge(std::size_t n) {
  std::vector<Point3> points{{0, -0.125, 1}, {0, -0.125, -1}};
  for (std::size_t k = 0; k < n - 2; ++k) {
    const Point2 p = on_circle(number(k) / number(2 * (n - 3)));
    points.push_back({p.x, p.y, 0});
  }
  return points;
}

// The floor is z = x^2 m 2^-51 at the multiples x of 1/m, whose slopes grow by 2^-50 from one to the next.
std::vector<Point3> chain(std::size_t n) {
  const std::size_t half = n / 2 - 2;  // on each side
  const double m = power_of_two_from(number(half));
  std::vector<Point3> points;
  for (const double y : {0., 1.}) {
    for (std::size_t k = 0; k < half; ++k) {
      const double i = number(k) - number(half / 2);
      points.push_back({i / m, y, i * i / m * 0x1p-51});
    }
    points.push_back({-1, y, 1});
    points.push_back({1, y, 1});
  }
  return points;
}

std::vector<Point3> moment_curve(std::size_t n) {
  const double m = power_of_two_from(number(n));
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const double t = (number(2 * k) - number(n)) / m;  // a multiple of 2^-16 for n up to 2^17, its cube one of 2^-48
    points.push_back({t, t * t, t * t * t});
  }
  return points;
}

std::vector<Point3> helix(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = 0.9 * number(k) / number(n - 1);
    const Point2 p = on_circle(turn);
    points.push_back({p.x, p.y, 4 * turn});
  }
  return points;
}

std::vector<Point3> saddle(std::size_t n) {
  std::vector<Point3> points;
  for (std::size_t k = 0; k < n; ++k) {
    const double turn = number(k) / number(n);
    const Point2 p = on_circle(turn);
    points.push_back({p.x, p.y, on_circle(2 * turn).x});
  }
  return points;
}

// The points of the cone at distance 1 / w from its apex, with w a function over the circle of their directions: a
// plane that misses the apex is an affine function w, and the points of the body are those above all of them. Let a, b
// be on the circle with an angle h between them, e another h on, and c half way from a to b. Then c is above the plane
// through a, b, e, so that it does not see the facet, if w(c) > 3/8 w(a) + 3/4 w(b) - 1/8 w(e) (for small h). With b of
// a round, a and e are of earlier ones. So w = 1.2^round does: 1.2^2 > 3/8 + 3/4 1.2.
std::vector<Point3> stacked(std::size_t n) {
  std::vector<Point3> points{{0, 0, 1}};
  const auto add = [&](double turn, double w) {
    const Point2 p = on_circle(turn, 1 / w);
    points.push_back({p.x, p.y, 1 - 1 / w});
  };
  for (const double k : {0., 1., 2.}) add(k / 3, 1);
  double w = 1;
  for (std::size_t facets = 3; points.size() < n; facets *= 2) {
    w *= 1.2;
    for (std::size_t k = 0; k < facets && points.size() < n; ++k) add((number(k) + 0.5) / number(facets), w);
  }
  return points;
}

std::vector<Point3> flat(std::size_t n) {
  std::vector<Point3> points;
  for (const Point3& p : ring(n, 0)) points.push_back({p.x, p.y, p.x});
  return points;
}

std::vector<Point3> needle(std::size_t n, Random& random) {
  std::vector<Point3> points;
  for (const Point3& p : points_on_sphere(n, random)) points.push_back({p.x * 1e300, p.y, p.z * 1e-300});
  return points;
}

std::vector<Point3> grid(std::size_t n) {
  std::size_t side = 2;
  while ((side + 1) * (side + 1) * (side + 1) <= n) ++side;
  std::vector<Point3> points;
  for (std::size_t x = 0; x < side; ++x) {
    for (std::size_t y = 0; y < side; ++y) {
      for (std::size_t z = 0; z < side; ++z) points.push_back({number(x), number(y), number(z)});
    }
  }
  return points;
}

}  // namespace solid_shapes

std::span<const SolidShape> all_solid_shapes() {
  namespace s = solid_shapes;
  using Count = std::size_t;
  constexpr auto all = [](Count n) { return n; };
  constexpr auto even = [](Count n) { return n / 2 * 2; };
  constexpr auto eight = [](Count) { return Count{8}; };
  constexpr auto three = [](Count) { return Count{3}; };
  constexpr auto two = [](Count) { return Count{2}; };
  constexpr auto all_others = [](Count n) { return n - 1; };
  static const std::array shapes{
      SolidShape{"sphere", s::sphere, all, nullptr},
      SolidShape{"bipyramid", [](Count n, Random&) { return s::bipyramid(n); }, all, [](Count n) { return n - 2; }},
      SolidShape{"prism", [](Count n, Random&) { return s::prism(n); }, even, three},
      SolidShape{"cone", [](Count n, Random&) { return s::cone(n); }, all, all_others},
      SolidShape{"wedge", [](Count n, Random&) { return s::wedge(n); }, all, all_others},
      SolidShape{"chain", [](Count n, Random&) { return s::chain(n); }, even, three},
      SolidShape{"moment curve", [](Count n, Random&) { return s::moment_curve(n); }, all, all_others},
      SolidShape{"helix", [](Count n, Random&) { return s::helix(n); }, all, all_others},
      SolidShape{"saddle", [](Count n, Random&) { return s::saddle(n); }, all, nullptr},
      SolidShape{"stacked", [](Count n, Random&) { return s::stacked(n); }, all, all_others},
      SolidShape{"flat", [](Count n, Random&) { return s::flat(n); }, all, two},
      SolidShape{"needle", s::needle, all, nullptr},
      SolidShape{"grid", [](Count n, Random&) { return s::grid(n); }, eight, three}};
  return shapes;
}

}  // namespace sunder::tests
