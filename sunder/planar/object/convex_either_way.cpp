#include <sunder/planar/object/convex_either_way.h>

#include <sunder/predicate/point/orient.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace sunder::planar {

namespace {

bool runs_clockwise(const std::vector<Point2>& p) {
  const auto is_finite = [](const Point2& q) { return std::isfinite(q.x) && std::isfinite(q.y); };
  if (!std::all_of(p.begin(), p.end(), is_finite)) return false;  // to be refused
  const std::size_t n = p.size();
  std::size_t left = 0, right = 0;
  for (std::size_t v = 0; n > 2 && v < n; ++v) {
    const Sign turn = orient_2d(p[(v + n - 1) % n], p[v], p[(v + 1) % n]);
    if (turn == Sign::positive) ++left;
    if (turn == Sign::negative) ++right;
  }
  return right > left;
}

// The same error, about the vertex from the other end.
[[noreturn]] void throw_turned(const Error& error, std::size_t n) {
  constexpr std::string_view vertex = "vertex ";
  const std::string& place = error.place();
  std::size_t number = 0;
  if (!place.starts_with(vertex)) throw error;
  std::from_chars(place.data() + vertex.size(), place.data() + place.size(), number);
  throw Error(error.code(), std::string(error.what()).substr(place.size() + 2),
              std::string(vertex) + std::to_string(n - 1 - number));
}

}  // namespace

EitherWay convex_either_way(std::vector<Point2> vertices) {
  if (!runs_clockwise(vertices)) return {ConvexPolygon::from_vertices(std::move(vertices)), false};
  const std::size_t n = vertices.size();
  std::reverse(vertices.begin(), vertices.end());
  try {
    return {ConvexPolygon::from_vertices(std::move(vertices)), true};
  } catch (const Error& error) {
    throw_turned(error, n);
  }
}

}  // namespace sunder::planar
