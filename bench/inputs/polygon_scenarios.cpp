#include <bench/inputs/polygon_scenarios.h>

#include <tests/support/shapes.h>

#include <sunder/base/random.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>

namespace bench {
namespace {

using sunder::Point2;
using sunder::Random;
namespace tests = sunder::tests;
using sunder::planar::ConvexPolygon;

constexpr double kPi = 3.141592653589793;
constexpr double kLeastAxis = 0.4;
constexpr double kLeastInradius = 0.1;
constexpr std::size_t kExactSize = 1000;  // up to here a shape has exactly n vertices
constexpr std::size_t kEnough = 64000;    // vertices of one side, in all pairs of a size and regime together
constexpr std::size_t kMostPairs = 4000;
constexpr std::size_t kMostTries = 1000;  // for each that is found

// Shapes and moves are rounded to multiples of 2^-47; scaled by 2^-5 at least, they are multiples of 2^-52.
double snapped(double v) { return tests::snapped(v, 47); }
Point2 snapped(const Point2& p) { return {snapped(p.x), snapped(p.y)}; }

double dot(const Point2& u, const Point2& v) { return u.x * v.x + u.y * v.y; }
double cross(const Point2& u, const Point2& v) { return u.x * v.y - u.y * v.x; }
Point2 operator+(const Point2& p, const Point2& q) { return {p.x + q.x, p.y + q.y}; }
Point2 operator-(const Point2& p, const Point2& q) { return {p.x - q.x, p.y - q.y}; }
Point2 operator*(double s, const Point2& p) { return {s * p.x, s * p.y}; }

Point2 unit_vector(Random& random) {
  const double angle = random.uniform(0, 2 * kPi);
  return {std::cos(angle), std::sin(angle)};
}

// --- In integers -----------------------------------------------------------------------------------------------------

__extension__ typedef __int128 Wide;

struct Whole {
  std::int64_t x = 0, y = 0;
};

std::int64_t whole(double v) {
  const double scaled = std::ldexp(v, 52);
  if (!(std::fabs(scaled) < 0x1p55) || scaled != std::nearbyint(scaled)) throw std::logic_error("not on the grid");
  return static_cast<std::int64_t>(scaled);
}
Whole whole(const Point2& p) { return {whole(p.x), whole(p.y)}; }
Whole operator-(const Whole& p, const Whole& q) { return {p.x - q.x, p.y - q.y}; }
Wide dot(const Whole& u, const Whole& v) { return static_cast<Wide>(u.x) * v.x + static_cast<Wide>(u.y) * v.y; }
Wide cross(const Whole& u, const Whole& v) { return static_cast<Wide>(u.x) * v.y - static_cast<Wide>(u.y) * v.x; }

// The edge's direction, turned to the right by a right angle.
Whole outward(const Whole& from, const Whole& to) { return {to.y - from.y, from.x - to.x}; }

// The vertex furthest along d.
std::uint32_t furthest(const ConvexPolygon& p, const Whole& d) {
  std::uint32_t best = 0;
  Wide most = dot(d, whole(p[0]));
  for (std::uint32_t k = 1; k < p.size(); ++k) {
    const Wide height = dot(d, whole(p[k]));
    if (height > most) most = height, best = k;
  }
  return best;
}

std::uint32_t next(const ConvexPolygon& p, std::uint32_t k) { return k + 1 == p.size() ? 0 : k + 1; }

bool strictly_inside(const ConvexPolygon& p, const Point2& point) {
  const Whole at = whole(point);
  for (std::uint32_t k = 0; k < p.size(); ++k) {
    const Whole from = whole(p[k]);
    if (cross(whole(p[next(p, k)]) - from, at - from) <= 0) return false;
  }
  return true;
}

// --- Moving ----------------------------------------------------------------------------------------------------------

struct Move {
  double scale = 1;  // a power of two, or -1
  Point2 shift{};
};

// Exact. The vertices begin with any one.
ConvexPolygon moved(const ConvexPolygon& p, const Move& move, Random& random) {
  std::vector<Point2> points;
  points.reserve(p.size());
  const std::uint32_t first = static_cast<std::uint32_t>(random.below(p.size()));
  for (std::uint32_t i = 0; i < p.size(); ++i) {
    const Point2& v = p[first + i < p.size() ? first + i : first + i - p.size()];
    points.push_back(move.scale * v + move.shift);
    if (points.back() - move.shift != move.scale * v) throw std::logic_error("a move was not exact");
  }
  return ConvexPolygon::from_vertices(std::move(points));
}

// The vertex furthest along d, in doubles.
std::uint32_t furthest(const ConvexPolygon& p, const Point2& d) {
  std::uint32_t best = 0;
  for (std::uint32_t k = 1; k < p.size(); ++k) {
    if (dot(d, p[k]) > dot(d, p[best])) best = k;
  }
  return best;
}

bool boxes_meet(const ConvexPolygon& p, const ConvexPolygon& q, const Point2& shift) {
  for (const Point2& axis : {Point2{1, 0}, Point2{0, 1}}) {
    const Point2 back{-axis.x, -axis.y};
    if (dot(axis, p[furthest(p, axis)]) < dot(axis, q[furthest(q, back)] + shift)) return false;
    if (dot(axis, p[furthest(p, back)]) > dot(axis, q[furthest(q, axis)] + shift)) return false;
  }
  return true;
}

// Does a line at a right angle to d part them, p behind q?
bool parted(const ConvexPolygon& p, const ConvexPolygon& q, const Point2& shift, const Whole& d) {
  const Point2 last = p[furthest(p, d)], first = q[furthest(q, Whole{-d.x, -d.y})] + shift;
  return dot(d, whole(last)) < dot(d, whole(first));
}

double inradius(const ConvexPolygon& p) {
  double least = std::numeric_limits<double>::max();
  for (std::uint32_t k = 0; k < p.size(); ++k) {
    const Point2 along = p[next(p, k)] - p[k];
    least = std::min(least, cross(p[k], along) / std::hypot(along.x, along.y));
  }
  return least;
}

std::uint32_t any_vertex(const ConvexPolygon& p, Random& random) {
  return static_cast<std::uint32_t>(random.below(p.size()));
}

// --- Regimes: how to move q; nothing where this try does not keep the promise
// ------------------------------------------

using Try = std::optional<Move>;

Try move_apart(const ConvexPolygon& p, const ConvexPolygon& q, bool with_boxes, Random& random) {
  const Point2 d = unit_vector(random), aside{-d.y, d.x};
  const double gap = random.uniform(0.1, with_boxes ? 1 : 0.5);
  const double reach = dot(d, p[furthest(p, d)]) - dot(d, q[furthest(q, -1.0 * d)]);
  const Point2 shift = snapped((reach + gap) * d + random.uniform(-0.5, 0.5) * aside);
  const Whole direction{static_cast<std::int64_t>(std::ldexp(d.x, 40)), static_cast<std::int64_t>(std::ldexp(d.y, 40))};
  if (boxes_meet(p, q, shift) == with_boxes || !parted(p, q, shift, direction)) return {};
  return Move{1, shift};
}

// A vertex of q before an edge of p, or behind it.
Try move_near(const ConvexPolygon& p, const ConvexPolygon& q, bool meet, Random& random) {
  const std::uint32_t k = any_vertex(p, random);
  const Point2 &from = p[k], &to = p[next(p, k)];
  const Whole normal = outward(whole(from), whole(to));
  const Point2 along = to - from;
  const Point2 d = 1 / std::hypot(along.x, along.y) * Point2{along.y, -along.x};
  const Point2 nearest = q[furthest(q, Whole{-normal.x, -normal.y})];
  const double gap = random.log_uniform(1e-6, 1e-3);
  const Point2 shift = snapped(from + random.uniform(0.25, 0.75) * along + (meet ? -gap : gap) * d - nearest);
  if (!boxes_meet(p, q, shift)) return {};
  const bool promised = meet ? strictly_inside(p, nearest + shift) : parted(p, q, shift, normal);
  return promised ? Try(Move{1, shift}) : Try();
}

// A vertex of q is inside p; another one is not, and a vertex of p is not in q.
Try move_across(const ConvexPolygon& p, const ConvexPolygon& q, Random& random) {
  const Point2 towards = p[any_vertex(p, random)], inner = q[any_vertex(q, random)];
  const Point2 shift = snapped(random.uniform(0.3, 0.8) * towards - inner);
  if (!strictly_inside(p, inner + shift)) return {};
  if (strictly_inside(p, q[furthest(q, towards)] + shift)) return {};
  if (strictly_inside(q, p[furthest(p, -1.0 * towards)] - shift)) return {};
  return Move{1, shift};
}

// The disc around q fits into the one within p.
Try move_inside(const ConvexPolygon& p, const ConvexPolygon&, Random& random) {
  const double room = 0.9 * inradius(p);
  int power = 0;
  while (std::ldexp(1.0, power) > room) --power;
  if (random.below(2) == 0 && power > -5) --power;
  const double scale = std::ldexp(1.0, power);
  const Point2 shift = snapped(random.uniform(0, room - scale) * unit_vector(random));
  if (!strictly_inside(p, shift)) return {};  // the middle of q
  return Move{scale, shift};
}

Try move_to_touch(const ConvexPolygon& p, const ConvexPolygon& q, Random& random) {
  const std::uint32_t k = any_vertex(p, random);
  const Point2 ends = p[k] + p[next(p, k)];
  switch (random.below(3)) {
    case 0: {
      const Point2 d = std::ldexp(1.0, 40) * unit_vector(random);
      const Whole direction{static_cast<std::int64_t>(d.x), static_cast<std::int64_t>(d.y)};
      return Move{1, p[furthest(p, direction)] - q[furthest(q, Whole{-direction.x, -direction.y})]};
    }
    case 1: {
      const Whole normal = outward(whole(p[k]), whole(p[next(p, k)]));
      return Move{1, 0.5 * ends - q[furthest(q, Whole{-normal.x, -normal.y})]};
    }
    default: return Move{-1, ends};  // of p itself: reflected in the middle of the edge
  }
}

bool regime_meets(PolygonRegime regime, std::size_t number) {
  if (regime == PolygonRegime::near) return number % 2 == 1;
  return regime != PolygonRegime::apart && regime != PolygonRegime::boxes_apart;
}

Try move(PolygonRegime regime, const ConvexPolygon& p, const ConvexPolygon& q, bool meet, Random& random) {
  switch (regime) {
    case PolygonRegime::apart: return move_apart(p, q, false, random);
    case PolygonRegime::near: return move_near(p, q, meet, random);
    case PolygonRegime::overlapping: return move_across(p, q, random);
    case PolygonRegime::contained: return move_inside(p, q, random);
    case PolygonRegime::touching: return move_to_touch(p, q, random);
    case PolygonRegime::boxes_apart: return move_apart(p, q, true, random);
  }
  return {};
}

std::vector<Point2> points_of_ellipse(std::size_t n, bool regular, Random& random) {
  const Point2 along = unit_vector(random), aside = random.uniform(kLeastAxis, 1) * Point2{-along.y, along.x};
  const double phase = random.unit();
  std::vector<Point2> points;
  points.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double turns = regular ? (static_cast<double>(i) + phase) / static_cast<double>(n) : random.unit();
    points.push_back(snapped(std::cos(2 * kPi * turns) * along + std::sin(2 * kPi * turns) * aside));
  }
  return points;
}

std::uint64_t stream(std::uint64_t seed, std::size_t n, std::uint64_t what) {
  return Random(Random(Random(seed).next() + n).next() + what).next();
}

}  // namespace

std::string_view name_of(PolygonRegime regime) {
  switch (regime) {
    case PolygonRegime::apart: return "apart";
    case PolygonRegime::near: return "near";
    case PolygonRegime::overlapping: return "overlapping";
    case PolygonRegime::contained: return "contained";
    case PolygonRegime::touching: return "touching";
    case PolygonRegime::boxes_apart: return "boxes apart";
  }
  return "?";
}

std::vector<ConvexPolygon> make_shapes(std::size_t n, std::uint64_t seed) {
  Random random(stream(seed, n, 0));
  const std::size_t count = n >= 100000 ? 4 : n >= 10000 ? 16 : 64;
  const std::size_t least = n <= kExactSize ? n : n - n / 50;
  std::vector<ConvexPolygon> shapes;
  for (std::size_t tries = 0; shapes.size() < count; ++tries) {
    if (tries > count * kMostTries) throw std::logic_error("no polygons of " + std::to_string(n) + " vertices");
    ConvexPolygon shape = ConvexPolygon::hull_of(points_of_ellipse(n, shapes.size() % 2 == 1, random));
    if (shape.size() < least || inradius(shape) < kLeastInradius) continue;
    shapes.push_back(moved(shape, {}, random));
  }
  return shapes;
}

PolygonScenario make_polygon_scenario(std::size_t n, PolygonRegime regime, const std::vector<ConvexPolygon>& shapes,
                                      std::uint64_t seed) {
  Random random(stream(seed, n, 1 + static_cast<std::uint64_t>(regime)));
  PolygonScenario scenario{n, regime, shapes, {}};
  const std::size_t count = std::clamp(kEnough / n, kFewPairs, kMostPairs);
  for (std::size_t tries = 0; scenario.pairs.size() < count; ++tries) {
    if (tries > count * kMostTries) throw std::logic_error("no such pairs: " + std::string(name_of(regime)));
    const bool meet = regime_meets(regime, scenario.pairs.size());
    const std::uint32_t p = static_cast<std::uint32_t>(random.below(shapes.size()));
    std::uint32_t q = static_cast<std::uint32_t>(random.below(shapes.size() - 1));
    q += q >= p;
    const Try found = move(regime, shapes[p], shapes[q], meet, random);
    if (!found) continue;
    const std::uint32_t fresh = static_cast<std::uint32_t>(scenario.polygons.size());
    scenario.polygons.push_back(moved(shapes[found->scale < 0 ? p : q], *found, random));
    scenario.pairs.push_back(random.below(2) == 0 ? PolygonPair{p, fresh, meet} : PolygonPair{fresh, p, meet});
  }
  return scenario;
}

}  // namespace bench
