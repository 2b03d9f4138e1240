#include <sunder/near/set_statement.h>
#include <sunder/planar/polygons/polygon_edges.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/polygons/polygons_common_point.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/sweep_claims.h>

#include <array>
#include <string_view>

namespace sunder::planar {

namespace {

void begin(ClaimsWriter& file, const PolygonsAsked& asked, std::string_view verdict) {
  begin_set_statement(file, "polygons", asked.polygons, asked.allowed, asked.groups, verdict);
}

// The end of a statement `some`.
void end_some(ClaimsWriter& file, const PolygonsContact& found, const ExactPoint2& point) {
  file.index("i", found.i);
  file.index("j", found.j);
  file.fractions("point", std::array{point.x, point.y}, point.denominator);
  file.begin_claims();
  file.claim("common_point");
  file.end_statement();
}

}  // namespace

void write_row(ClaimsWriter& file, const Polygon& polygon) {
  file.begin_list();
  for (std::uint32_t r = 0; r < polygon.ring_count(); ++r) write_ring(file, polygon.ring(r));
  file.end_list();
}

void write_row(ClaimsWriter& file, const ConvexPolygon& polygon) {
  file.begin_list();
  write_ring(file, polygon.vertices());
  file.end_list();
}

void write_ring(ClaimsWriter& file, std::span<const Point2> ring) {
  file.begin_list();
  for (const Point2& p : ring) file.add_numbers(std::array{p.x, p.y});
  file.end_list();
}

std::optional<SweepEvents> polygon_events(std::span<const Polygon> polygons, std::size_t most) {
  return sweep_events(PolygonEdges(pointers_to(polygons)).edges(), most);
}

void write_some(ClaimsWriter& file, const PolygonsAsked& asked, const PolygonsContact& found) {
  begin(file, asked, "some");
  end_some(file, found, common_point(asked.polygons[found.i], asked.polygons[found.j], found));
  if (asked.allowed == Allowed::touch) return;
  const std::array<const Polygon*, 2> pair{&asked.polygons[found.i], &asked.polygons[found.j]};
  file.begin_statement("two_polygons");
  file.indices("pair", std::array{found.i, found.j});
  file.text("verdict", name_of(found.contact));
  const PolygonEdges edges({pair.begin(), pair.end()});
  write_sweep(file, "how_two_meet", *sweep_events(edges.edges(), std::numeric_limits<std::size_t>::max()));
  file.end_statement();
}

void write_none(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events) {
  begin(file, asked, "none");
  write_sweep(file, "none_counts", events);
  file.end_statement();
}

void write_these(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events,
                 const VisitContacts& visit) {
  const bool has_kinds = asked.allowed != Allowed::touch;
  begin(file, asked, has_kinds ? "these_kinds" : "these");
  file.begin_list(has_kinds ? "kinds" : "contacts");
  visit([&](const PolygonsContact& c) {
    if (has_kinds) file.add_contact(c.i, c.j, name_of(c.contact));
    if (!has_kinds) file.add_list(std::array{c.i, c.j});
  });
  file.end_list();
  write_sweep(file, has_kinds ? "these_kinds" : "these_count", events);
  file.end_statement();
  visit([&](const PolygonsContact& c) {
    file.begin_statement("polygons");
    file.text("allowed", name_of(Allowed::nothing));
    file.text("verdict", "some");
    end_some(file, c, found_point(asked.polygons[c.i], asked.polygons[c.j], c));
  });
}

void write_count(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events, std::uint64_t overlapping,
                 std::uint64_t touching) {
  const bool has_kinds = asked.allowed != Allowed::touch;
  begin(file, asked, has_kinds ? "count_kinds" : "count");
  file.number(has_kinds ? "overlapping" : "number", overlapping);
  if (has_kinds) file.number("touching", touching);
  write_sweep(file, has_kinds ? "kinds_count" : "number_counts", events);
  file.end_statement();
}

std::string certificate_text(std::span<const Polygon> polygons, Allowed allowed, const PolygonsAnswer& answer,
                             Groups groups) {
  return claims_text({}, [&](ClaimsWriter& file) {
    const PolygonsAsked asked{polygons, allowed, groups};
    if (answer.meet()) {
      write_some(file, asked, *answer.found);
    } else {
      write_none(file, asked, *polygon_events(polygons));
    }
  });
}

}  // namespace sunder::planar
