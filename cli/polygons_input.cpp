#include <cli/polygons_input.h>
#include <cli/progress.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>
#include <sunder/planar/set/polygon_simple.h>

#include <fmt/format.h>

namespace sunder::cli {

namespace {

std::string about(const planar::Segment& s) {
  return fmt::format("({:.10g}, {:.10g}) to ({:.10g}, {:.10g})", s.a.x, s.a.y, s.b.x, s.b.y);
}

void require_simple(const planar::Polygon& polygon) {
  const planar::PolygonSimpleAnswer answer = polygon_simple(polygon);
  if (answer.simple()) return;
  const auto edge = [&](std::uint32_t k) {
    return fmt::format("edge {} of ring {}, {}", k - polygon.ring_begin(polygon.ring_of(k)), polygon.ring_of(k),
                       about(polygon.edge(k)));
  };
  throw Error(ErrorCode::bad_shape, fmt::format("is not simple: {} and {} ({}); mend it, see sunder simple",
                                                edge(answer.i), edge(answer.j), name_of(answer.kind)));
}

}  // namespace

std::string PolygonsInput::name(std::uint32_t polygon) const {
  return file.features[file.source[file.rings[first_ring[polygon]].first].feature];
}
std::uint32_t PolygonsInput::line(std::uint32_t polygon) const {
  return file.source[file.rings[first_ring[polygon]].first].line;
}

PolygonsInput read_polygons(const std::string& name, bool drop_z, bool simple, const std::string& group) {
  if (group == "ring") {
    throw Error(ErrorCode::bad_call, "rings belong to polygons; group by feature, or by a property", "--group");
  }
  PolygonsInput input;
  {
    Progress progress("reading");
    io::LineOptions options;
    options.drop_z = drop_z;
    options.group = group;
    options.progress = progress.reporter();
    input.file = io::read_lines(name, options);
  }
  const io::LineFile& file = input.file;
  if (file.rings.empty()) io::fail_file(name, "has no polygons; for lines, ask sunder segments");
  for (std::uint32_t r = 0; r < file.rings.size();) {
    const std::uint32_t first = r, number = file.rings[r].polygon;
    std::vector<std::vector<Point2>> rings;
    for (; r < file.rings.size() && file.rings[r].polygon == number; ++r) {
      std::vector<Point2>& ring = rings.emplace_back();
      for (std::uint32_t k = 0; k < file.rings[r].count; ++k) ring.push_back(file.segments[file.rings[r].first + k].a);
      ring.push_back(ring.front());  // as in the file: Polygon leaves out exactly this one
    }
    input.first_ring.push_back(first);
    if (!group.empty()) input.groups.push_back(file.group[file.rings[first].first]);
    try {
      input.polygons.emplace_back(rings);
      if (simple) require_simple(input.polygons.back());
    } catch (const Error& error) {
      io::fail_file(name,
                    fmt::format("feature {}: {}", input.name(static_cast<std::uint32_t>(input.first_ring.size() - 1)),
                                error.what()));
    }
  }
  return input;
}

}  // namespace sunder::cli
