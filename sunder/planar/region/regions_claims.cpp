#include <sunder/planar/region/half_plane_intersection.h>
#include <sunder/planar/region/regions_claims.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/sweep_claims.h>

#include <algorithm>
#include <array>
#include <limits>
#include <type_traits>
#include <utility>

namespace sunder::planar {

namespace {

std::array<double, 3> numbers_of(const Constraint& h) { return {h.a, h.b, h.c}; }

std::array<double, 4> numbers_of(const LeftOf& h) { return {h.from.x, h.from.y, h.to.x, h.to.y}; }

template <class Given>
void write_table(ClaimsWriter& file, const Given& given) {
  file.begin_table("half_planes");
  for (std::uint32_t k = 0; k < given.size(); ++k) file.add_row(numbers_of(given[k]));
  file.end_table();
}

template <class Given>
void write_contradiction(ClaimsWriter& file, const Given& given, const Region& region) {
  const std::vector<Dyadic> of_sides = multipliers(given, region);
  std::vector<Weight> weights;
  for (std::size_t k = 0; k < of_sides.size(); ++k) weights.push_back({region.sides[k], of_sides[k]});
  file.begin_claims();
  file.weights_claim("contradict", weights);
}

// The verdict, the sides and the claims of the statement that is open, and its end.
template <class Given>
void write_region(ClaimsWriter& file, const Given& given, const Region& region) {
  file.text("verdict", name_of(region.kind));
  if (region.empty()) {
    write_contradiction(file, given, region);
  } else {
    file.indices("sides", region.sides);
    file.begin_claims();
    file.begin_claim("cones");
    file.indices("cones", region.cones);
    file.end_claim();
  }
  file.end_statement();
}

// The table.
template <class Given>
void begin(ClaimsWriter& file, const Given& half_planes) {
  write_half_planes(file, half_planes);
}
void begin(ClaimsWriter& file, const PolygonSides& polygon) {
  file.begin_table("rings");
  file.begin_rows();
  for (const Point2& p : polygon.vertices()) file.add_row(std::array{p.x, p.y});
  file.end_rows();
  file.end_table();
}

// That the ring is simple.
void write_simple(ClaimsWriter& file, const PolygonSides& polygon) {
  const std::span<const Point2> ring = polygon.vertices();
  std::vector<Segment> edges;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    edges.push_back(sorted({ring[k], ring[k + 1 < ring.size() ? k + 1 : 0]}));
  }
  file.begin_statement("ring");
  file.index("ring", 0);
  file.text("verdict", "simple");
  write_sweep(file, "valid", *sweep_events(Segments(std::move(edges)), std::numeric_limits<std::size_t>::max()));
  file.end_statement();
}

HalfPlane x_at_most(double x) { return HalfPlane::left_of({x, 0}, {x, 1}); }
HalfPlane x_at_least(double x) { return HalfPlane::left_of({x, 1}, {x, 0}); }
HalfPlane y_at_most(double y) { return HalfPlane::left_of({1, y}, {0, y}); }
HalfPlane y_at_least(double y) { return HalfPlane::left_of({0, y}, {1, y}); }

}  // namespace

void write_half_planes(ClaimsWriter& file, const Constraints& given) { write_table(file, given); }

void write_half_planes(ClaimsWriter& file, const HalfPlanes& given) { write_table(file, given); }

template <class Given>
void write_region_statement(ClaimsWriter& file, const Given& given, const Region& region) {
  if constexpr (std::is_same_v<Given, PolygonSides>) {
    file.begin_statement("kernel");
    file.index("ring", 0);
  } else {
    file.begin_statement("half_planes");
  }
  write_region(file, given, region);
}

template void write_region_statement(ClaimsWriter&, const Constraints&, const Region&);
template void write_region_statement(ClaimsWriter&, const HalfPlanes&, const Region&);

template <class Given>
std::string certificate_text(const Given& given, const Region& region, const Origin& origin) {
  return claims_text(origin, [&](ClaimsWriter& file) {
    begin(file, given);
    write_region_statement(file, given, region);
    if constexpr (std::is_same_v<Given, PolygonSides>) write_simple(file, given);
  });
}

template std::string certificate_text(const Constraints&, const Region&, const Origin&);
template std::string certificate_text(const HalfPlanes&, const Region&, const Origin&);
template std::string certificate_text(const PolygonSides&, const Region&, const Origin&);

std::vector<HalfPlane> sides_of(std::span<const ConvexPolygon> polygons) {
  std::vector<HalfPlane> sides;
  for (const ConvexPolygon& polygon : polygons) {
    const std::uint32_t n = polygon.size();
    const Point2 &p = polygon[0], &q = polygon[n - 1];
    if (n == 1) {
      sides.insert(sides.end(), {x_at_most(p.x), y_at_most(p.y), x_at_least(p.x), y_at_least(p.y)});
      continue;
    }
    for (std::uint32_t k = 0; k < n; ++k) {
      sides.push_back(HalfPlane::left_of(polygon[k], polygon[polygon.next(k)]));
    }
    if (n > 2) continue;
    if (p.x != q.x) {
      sides.insert(sides.end(), {x_at_most(std::max(p.x, q.x)), x_at_least(std::min(p.x, q.x))});
    } else {
      sides.insert(sides.end(), {y_at_most(std::max(p.y, q.y)), y_at_least(std::min(p.y, q.y))});
    }
  }
  return sides;
}

std::string certificate_text(std::span<const ConvexPolygon> polygons, const Origin& origin) {
  const std::vector<HalfPlane> half = sides_of(polygons);
  const HalfPlanes sides(half);  // keeps a reference
  return claims_text(origin, [&](ClaimsWriter& file) {
    file.begin_table("convex_polygons");
    for (const ConvexPolygon& polygon : polygons) {
      file.begin_rows();
      for (const Point2& p : polygon.vertices()) file.add_row(std::array{p.x, p.y});
      file.end_rows();
    }
    file.end_table();
    file.begin_statement("convex_polygons_common_part");
    write_region(file, sides, half_plane_intersection(sides, {.evidence = true}));
  });
}

}  // namespace sunder::planar
