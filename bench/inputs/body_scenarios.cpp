#include <bench/inputs/body_scenarios.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <stdexcept>

namespace bench {
namespace {

using sunder::Random;

Vec operator+(const Vec& a, const Vec& b) { return {a[0] + b[0], a[1] + b[1], a[2] + b[2]}; }
Vec operator-(const Vec& a, const Vec& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Vec operator-(const Vec& a) { return {-a[0], -a[1], -a[2]}; }
Vec operator*(double s, const Vec& a) { return {s * a[0], s * a[1], s * a[2]}; }
double dot(const Vec& a, const Vec& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Vec cross(const Vec& a, const Vec& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Vec& a) { return std::sqrt(dot(a, a)); }
Vec unit(const Vec& a) { return (1 / length(a)) * a; }

// Uniform on the sphere (Marsaglia 1972); plain arithmetic, so the same with every compiler but for the square root.
Vec random_direction(Random& random) {
  for (;;) {
    const double x = random.uniform(-1, 1), y = random.uniform(-1, 1);
    const double s = x * x + y * y;
    if (s >= 1) continue;
    const double r = 2 * std::sqrt(1 - s);
    return {r * x, r * y, 1 - 2 * s};
  }
}

// A uniformly random rotation, by a quaternion (Shoemake's by rejection in the four-dimensional cube).
std::array<double, 9> random_rotation(Random& random) {
  for (;;) {
    double w = random.uniform(-1, 1), x = random.uniform(-1, 1), y = random.uniform(-1, 1), z = random.uniform(-1, 1);
    const double s = w * w + x * x + y * y + z * z;
    if (s > 1 || s < 1e-3) continue;
    const double k = 1 / std::sqrt(s);
    w *= k, x *= k, y *= k, z *= k;
    return {1 - 2 * (y * y + z * z), 2 * (x * y - w * z),     2 * (x * z + w * y),
            2 * (x * y + w * z),     1 - 2 * (x * x + z * z), 2 * (y * z - w * x),
            2 * (x * z - w * y),     2 * (y * z + w * x),     1 - 2 * (x * x + y * y)};
  }
}

std::array<double, 9> random_signed_permutation(Random& random) {
  std::array<int, 3> axis{0, 1, 2};
  std::swap(axis[0], axis[random.below(3)]);
  std::swap(axis[1], axis[1 + random.below(2)]);
  std::array<double, 9> m{};
  for (int i = 0; i < 3; ++i) m[3 * i + axis[i]] = random.below(2) != 0 ? 1 : -1;
  const double det =
      m[0] * (m[4] * m[8] - m[5] * m[7]) - m[1] * (m[3] * m[8] - m[5] * m[6]) + m[2] * (m[3] * m[7] - m[4] * m[6]);
  if (det < 0) {
    for (int i = 0; i < 3; ++i) m[i] = -m[i];
  }
  return m;
}

double round_to(double x, double unit_of_grid) { return std::nearbyint(x / unit_of_grid) * unit_of_grid; }

Vec rotate(const std::array<double, 9>& m, const Vec& p) {
  return {m[0] * p[0] + m[1] * p[1] + m[2] * p[2], m[3] * p[0] + m[4] * p[1] + m[5] * p[2],
          m[6] * p[0] + m[7] * p[1] + m[8] * p[2]};
}

std::vector<Vec> rotate(const std::array<double, 9>& m, const std::vector<Vec>& points) {
  std::vector<Vec> out;
  out.reserve(points.size());
  for (const Vec& p : points) out.push_back(rotate(m, p));
  return out;
}

Vec mean(const std::vector<Vec>& points) {
  Vec sum{};
  for (const Vec& p : points) sum = sum + p;
  return (1.0 / static_cast<double>(points.size())) * sum;
}

std::uint32_t furthest(const std::vector<Vec>& points, const Vec& direction) {
  std::uint32_t best = 0;
  double best_value = dot(points[0], direction);
  for (std::uint32_t i = 1; i < points.size(); ++i) {
    const double value = dot(points[i], direction);
    if (value > best_value) best = i, best_value = value;
  }
  return best;
}

// A vertex of the Minkowski difference A - B, seen from its inner point.
struct Corner {
  std::uint32_t a = 0, b = 0;
  Vec w{};
};

// Where the ray from the inner point of A - B (the difference of the means) leaves it.
struct Portal {
  std::array<Corner, 3> corners;
  Vec normal{};      // of unit length, outwards
  double reach = 0;  // along the unit direction, from the inner point
};

// Walks over triangles with corners on the boundary of A - B which the ray pierces, each further out, until one lies in
// a facet (Snethen's portal refinement). Nothing where rounding spoils it: the caller tries another direction.
std::optional<Portal> find_portal(const std::vector<Vec>& a, const std::vector<Vec>& b, const Vec& inner,
                                  const Vec& ray) {
  const auto support = [&](const Vec& d) {
    Corner c;
    c.a = furthest(a, d);
    c.b = furthest(b, -d);
    c.w = a[c.a] - b[c.b] - inner;
    return c;
  };
  std::array<Corner, 3> c;
  c[0] = support(ray);
  c[1] = support(cross(c[0].w, ray));
  Vec n = cross(c[0].w, c[1].w);
  if (dot(n, ray) < 0) std::swap(c[0], c[1]), n = -n;
  c[2] = support(n);
  for (int step = 0; step < 100; ++step) {
    if (dot(cross(c[0].w, c[2].w), ray) < 0) {
      c[1] = c[2];
    } else if (dot(cross(c[2].w, c[1].w), ray) < 0) {
      c[0] = c[2];
    } else {
      break;
    }
    c[2] = support(cross(c[0].w, c[1].w));
  }
  for (int step = 0; step < 1000; ++step) {
    // Oriented so that the ray leaves through the triangle.
    n = cross(c[1].w - c[0].w, c[2].w - c[0].w);
    if (dot(n, ray) < 0) std::swap(c[1], c[2]), n = -n;
    if (!(dot(n, n) > 0)) return std::nullopt;
    n = unit(n);
    const Corner next = support(n);
    if (dot(next.w - c[0].w, n) <= 1e-14) {
      const double along = dot(n, ray);
      if (!(along > 1e-6)) return std::nullopt;
      return Portal{c, n, dot(c[0].w, n) / along};
    }
    // The plane of the ray and the new corner, and so on: which of the three new triangles does the ray pierce?
    bool found = false;
    for (int i = 0; i < 3 && !found; ++i) {
      std::array<Corner, 3> t = c;
      t[i] = next;
      const double s0 = dot(cross(t[0].w, t[1].w), ray), s1 = dot(cross(t[1].w, t[2].w), ray),
                   s2 = dot(cross(t[2].w, t[0].w), ray);
      if ((s0 >= 0 && s1 >= 0 && s2 >= 0) || (s0 <= 0 && s1 <= 0 && s2 <= 0)) {
        c = t;
        found = true;
      }
    }
    if (!found) return std::nullopt;
  }
  return std::nullopt;
}

Query general_query(const std::vector<Body>& pool, Regime regime, bool out, Random& random) {
  for (;;) {
    Query query;
    query.a = static_cast<std::uint32_t>(random.below(pool.size()));
    query.b = static_cast<std::uint32_t>(random.below(pool.size()));
    query.pose_a.linear = random_rotation(random);
    query.pose_b.linear = random_rotation(random);
    const std::vector<Vec> a = rotate(query.pose_a.linear, pool[query.a].points);
    const std::vector<Vec> b = rotate(query.pose_b.linear, pool[query.b].points);
    const Vec inner = mean(a) - mean(b);
    const Vec ray = random_direction(random);
    const std::optional<Portal> portal = find_portal(a, b, inner, ray);
    if (!portal) continue;
    const Vec contact = inner + portal->reach * ray;  // B moved by this touches A, weakly parted along the normal
    Vec shift;
    if (regime == Regime::far) {
      shift = contact + random.uniform(0.1, 1) * portal->normal;
      query.expected = Expected::apart;
    } else if (regime == Regime::near) {
      const double gap = random.log_uniform(1e-6, 1e-3);
      if (out) {
        shift = contact + gap * portal->normal;
        query.expected = Expected::apart;
      } else {
        const double back = gap / dot(portal->normal, ray);  // straight back inwards: certainly inside
        if (back >= portal->reach) continue;
        shift = contact - back * ray;
        query.expected = Expected::meet;
      }
    } else {
      shift = inner + random.uniform(0, 0.15) * portal->reach * ray;
      query.expected = Expected::meet;
    }
    query.pose_a.translation = {random.uniform(-10, 10), random.uniform(-10, 10), random.uniform(-10, 10)};
    query.pose_b.translation = query.pose_a.translation + shift;
    return query;
  }
}

// Exact touching. All coordinates are integers here: the world's doubles times 2^36 (points), which are exact.

__extension__ typedef __int128 Wide;
using Cell = std::array<Wide, 3>;

constexpr double kBodyGrid = 0x1p-20;
constexpr double kLinearGrid = 0x1p-14;
constexpr double kWorldScale = 0x1p36;  // 20 + 14 bits of an image, two more for the weights of a point in a facet

Wide integer(double x) {
  const double scaled = x * kWorldScale;
  if (scaled != std::nearbyint(scaled) || std::fabs(scaled) > 0x1p52) throw std::logic_error("off the grid");
  return static_cast<Wide>(static_cast<std::int64_t>(scaled));
}
Cell integer(const Vec& p) { return {integer(p[0]), integer(p[1]), integer(p[2])}; }
Cell operator-(const Cell& a, const Cell& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
Wide dot(const Cell& a, const Cell& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Cell cross(const Cell& a, const Cell& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

// Is every point of A (images without translation) weakly below x along the normal, and every point of B + shift
// weakly above it? Images are below 2^38, differences below 2^40, normals below 2^81, products below 2^123.
bool parted_weakly(const std::vector<Vec>& a, const std::vector<Vec>& b, const Vec& shift, const Vec& x,
                   const Cell& normal) {
  const Cell cx = integer(x), cs = integer(shift);
  for (const Vec& p : a) {
    if (dot(normal, integer(p) - cx) > 0) return false;
  }
  for (const Vec& p : b) {
    if (dot(normal, integer(p) - (cx - cs)) < 0) return false;
  }
  return true;
}

Vec quarters(const Vec& p, const Vec& q, const Vec& r) { return 0.5 * p + 0.25 * q + 0.25 * r; }

// The pool holds bodies and, `mirrored` places further on, their reflections in the origin.
Query touching_query(const std::vector<Body>& pool, std::size_t mirrored, Regime regime, std::size_t number,
                     Random& random) {
  const bool general = number % 2 != 0;  // of the linear parts
  const bool out = number / 2 % 2 != 0;  // of last_bit
  const std::size_t family = number / 4 % kFamilies.size();
  for (;;) {
    Query query;
    query.family = static_cast<std::uint8_t>(family);
    query.a = static_cast<std::uint32_t>(random.below(mirrored));
    query.b = static_cast<std::uint32_t>(random.below(mirrored));
    const auto linear = [&] {
      if (!general) return random_signed_permutation(random);
      std::array<double, 9> m = random_rotation(random);
      for (double& x : m) x = round_to(x, kLinearGrid);
      return m;
    };
    query.pose_a.linear = linear();
    query.pose_b.linear = linear();
    if (family >= 4) {
      query.b = query.a + static_cast<std::uint32_t>(mirrored);
      query.pose_b.linear = query.pose_a.linear;
    }
    const std::vector<Vec> a = rotate(query.pose_a.linear, pool[query.a].points);
    const std::vector<Vec> b = rotate(query.pose_b.linear, pool[query.b].points);
    const Vec ray = random_direction(random);
    Vec x{}, y{};  // the point of A, and that of B, which coincide
    Cell normal{};
    if (family == 0) {  // a vertex on a vertex
      Vec d = ray;
      for (double& t : d) t = round_to(t, kBodyGrid);
      normal = integer(d);
      x = a[furthest(a, d)];
      y = b[furthest(b, -d)];
    } else {
      const std::optional<Portal> portal = find_portal(a, b, mean(a) - mean(b), ray);
      if (!portal) continue;
      const auto& c = portal->corners;
      std::vector<std::uint32_t> of_a, of_b;
      for (const Corner& corner : c) {
        if (std::find(of_a.begin(), of_a.end(), corner.a) == of_a.end()) of_a.push_back(corner.a);
        if (std::find(of_b.begin(), of_b.end(), corner.b) == of_b.end()) of_b.push_back(corner.b);
      }
      if (family >= 4) {  // of a body and its own reflection: any facet of A will do
        if (of_a.size() != 3) continue;
        const Vec &p = a[of_a[0]], &q = a[of_a[1]], &r = a[of_a[2]];
        normal = cross(integer(q) - integer(p), integer(r) - integer(p));
        x = family == 4 ? 0.5 * p + 0.5 * q : quarters(p, q, r);
        y = -x;
      } else if (of_a.size() == 3 && of_b.size() == 1) {  // a vertex of B on a facet of A
        if (family != 1) continue;
        const Vec &p = a[of_a[0]], &q = a[of_a[1]], &r = a[of_a[2]];
        normal = cross(integer(q) - integer(p), integer(r) - integer(p));
        x = quarters(p, q, r);
        y = b[of_b[0]];
      } else if (of_a.size() == 1 && of_b.size() == 3) {  // a vertex of A on a facet of B
        if (family != 2) continue;
        const Vec &p = b[of_b[0]], &q = b[of_b[1]], &r = b[of_b[2]];
        normal = cross(integer(q) - integer(p), integer(r) - integer(p));
        x = a[of_a[0]];
        y = quarters(p, q, r);
      } else if (of_a.size() == 2 && of_b.size() == 2) {  // crossing edges
        if (family != 3) continue;
        const Vec &p = a[of_a[0]], &q = a[of_a[1]], &r = b[of_b[0]], &s = b[of_b[1]];
        normal = cross(integer(q) - integer(p), integer(s) - integer(r));
        x = 0.5 * p + 0.5 * q;
        y = 0.5 * r + 0.5 * s;
      } else {
        continue;
      }
      Wide along = 0;
      for (int i = 0; i < 3; ++i) along += normal[i] * integer(round_to(portal->normal[i], kBodyGrid));
      if (along < 0) normal = {-normal[0], -normal[1], -normal[2]};
    }
    const Vec shift = x - y;
    if (!parted_weakly(a, b, shift, x, normal)) continue;
    const auto offset = [&] { return round_to(random.uniform(-4, 4), kBodyGrid); };
    query.pose_a.translation = {offset(), offset(), offset()};
    query.pose_b.translation = query.pose_a.translation + shift;
    if (integer(query.pose_b.translation) - integer(query.pose_a.translation) != integer(shift)) continue;
    query.expected = Expected::meet;
    if (regime == Regime::last_bit) {
      int i = 0;
      const auto size = [&](int k) { return normal[k] < 0 ? -normal[k] : normal[k]; };
      for (int k = 1; k < 3; ++k) {
        if (size(k) > size(i)) i = k;
      }
      const bool up = (normal[i] > 0) == out;
      query.pose_b.translation[i] = std::nextafter(query.pose_b.translation[i], up ? HUGE_VAL : -HUGE_VAL);
      query.expected = out ? Expected::apart : Expected::unknown;
    }
    return query;
  }
}

}  // namespace

std::string_view name_of(Regime regime) {
  switch (regime) {
    case Regime::far: return "far";
    case Regime::near: return "near";
    case Regime::deep: return "deep";
    case Regime::touching: return "touching";
    case Regime::last_bit: return "last bit";
  }
  return "";
}

std::vector<Vec> sphere_points(std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec> points;
  points.reserve(n);
  while (points.size() < n) points.push_back(random_direction(random));
  return points;
}

Scenario make_scenario(std::size_t n, Regime regime, std::size_t bodies, std::size_t queries, std::uint64_t seed) {
  Scenario scenario;
  scenario.n = n;
  scenario.regime = regime;
  Random random(seed);
  const bool on_grid = regime == Regime::touching || regime == Regime::last_bit;
  for (std::size_t i = 0; i < bodies; ++i) {
    Body body{sphere_points(n, random.next())};
    if (on_grid) {
      for (Vec& p : body.points) {
        for (double& x : p) x = round_to(x, kBodyGrid);
      }
    }
    scenario.pool.push_back(std::move(body));
  }
  if (on_grid) {
    for (std::size_t i = 0; i < bodies; ++i) {
      Body body = scenario.pool[i];
      for (Vec& p : body.points) p = -p;
      scenario.pool.push_back(std::move(body));
    }
  }
  for (std::size_t i = 0; i < queries; ++i) {
    scenario.queries.push_back(on_grid ? touching_query(scenario.pool, bodies, regime, i, random)
                                       : general_query(scenario.pool, regime, i % 2 == 0, random));
  }
  return scenario;
}

Scenario make_near_scenario(std::vector<Body> pool, std::size_t queries, std::uint64_t seed) {
  Scenario scenario;
  scenario.n = pool.front().points.size();
  scenario.regime = Regime::near;
  scenario.pool = std::move(pool);
  Random random(seed);
  for (std::size_t i = 0; i < queries; ++i) {
    scenario.queries.push_back(general_query(scenario.pool, Regime::near, i % 2 == 0, random));
  }
  return scenario;
}

}  // namespace bench
