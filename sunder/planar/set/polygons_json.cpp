#include <sunder/planar/set/polygon_edges.h>
#include <sunder/planar/set/polygons_common_point.h>
#include <sunder/planar/set/polygons_json.h>
#include <sunder/planar/set/segments_all.h>
#include <sunder/planar/sweep/sweep_json.h>

#include <array>
#include <string_view>

namespace sunder::planar {

namespace {

void write_table(ClaimsWriter& file, std::span<const Polygon> polygons) {
  file.begin_table("polygons");
  for (const Polygon& polygon : polygons) {
    file.begin_list();
    for (std::uint32_t r = 0; r < polygon.ring_count(); ++r) {
      file.begin_list();
      for (std::uint32_t k = polygon.ring_begin(r); k < polygon.ring_begin(r + 1); ++k) {
        file.add_numbers(std::array{polygon.vertices()[k].x, polygon.vertices()[k].y});
      }
      file.end_list();
    }
    file.end_list();
  }
  file.end_table();
}

// The table, and the statement up to its verdict.
void begin(ClaimsWriter& file, const PolygonsAsked& asked, const std::string& verdict) {
  write_table(file, asked.polygons);
  file.begin_statement("polygons");
  file.text("allowed", std::string(name_of(asked.allowed)));
  if (!asked.groups.empty()) file.indices("groups", asked.groups);
  file.text("verdict", verdict);
}

}  // namespace

std::optional<SweepEvents> polygon_events(std::span<const Polygon> polygons, std::size_t most) {
  return sweep_events(PolygonEdges(pointers_to(polygons)).edges(), most);
}

void write_some(ClaimsWriter& file, const PolygonsAsked& asked, const PolygonsContact& found) {
  begin(file, asked, "some");
  file.index("i", found.i);
  file.index("j", found.j);
  const ExactPoint2 p = common_point(asked.polygons[found.i], asked.polygons[found.j], found);
  file.fractions("point", std::array{p.x, p.y}, p.denominator);
  file.begin_claims();
  file.begin_claim("common_point");
  file.end_claim();
  file.end_statement();
}

void write_none(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events) {
  begin(file, asked, "none");
  write_sweep(file, "none_counts", events);
  file.end_statement();
}

void write_these(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events, const VisitPairs& visit) {
  begin(file, asked, "these");
  file.begin_list("contacts");
  visit([&](std::uint32_t i, std::uint32_t j) { file.add_list(std::array{i, j}); });
  file.end_list();
  write_sweep(file, "these_count", events);
  file.end_statement();
}

void write_count(ClaimsWriter& file, const PolygonsAsked& asked, const SweepEvents& events, std::uint64_t number) {
  begin(file, asked, "count");
  file.number("number", number);
  write_sweep(file, "number_counts", events);
  file.end_statement();
}

std::string certificate_text(std::span<const Polygon> polygons, Allowed allowed, const PolygonsAnswer& answer,
                             Groups groups) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  const PolygonsAsked asked{polygons, allowed, groups};
  if (answer.meet()) {
    write_some(file, asked, *answer.found);
  } else {
    write_none(file, asked, *polygon_events(polygons));
  }
  file.end();
  return text;
}

}  // namespace sunder::planar
