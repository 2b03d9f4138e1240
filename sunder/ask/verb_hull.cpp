// sunder hull FILE: the exact convex hull of a mesh or a set of points.
#include <sunder/ask/hull_polytope.h>
#include <sunder/ask/objects.h>
#include <sunder/ask/report.h>
#include <sunder/ask/said_of.h>
#include <sunder/ask/verb.h>

#include <sunder/io/mesh/mesh_write.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/polytopes.h>
#include <sunder/io/text/text.h>
#include <sunder/solid/mesh/mesh_claims.h>
#include <sunder/solid/object/hull_claims.h>

#include <fmt/format.h>

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

std::size_t edge_count(const solid::ConvexPolyhedron& hull) {
  std::size_t ends = 0;
  for (std::uint32_t v = 0; v < hull.vertices().size(); ++v) ends += hull.neighbours(v).size();
  return ends / 2;
}

Report run(const HullCall& call, Talk& talk) {
  if (call.half_spaces || io::names_polytope(call.file)) return run_polytope_hull(call, talk);
  const io::MeshFormat format = call.out.empty() ? io::MeshFormat::obj : io::mesh_format_of_name(call.out);
  LeftOutList left_out(call.leave_out);
  InputFiles inputs;
  const auto [object, mesh] = io::read_hull(call.file, left_out, call.certificate.empty() ? nullptr : &inputs);
  note_remarks(talk, {&object});
  const solid::ConvexPolyhedron& hull = object.hull;
  if (!call.out.empty()) talk.write_file(call.out, io::to_text(format, hull));
  const bool is_convex = object.shape == io::BodyShape::convex, is_other = object.shape == io::BodyShape::hull;
  const bool is_proved_convex = is_convex && hull.dimension() == 3;
  std::optional<std::uint32_t> off_hull;  // of a mesh that is not convex, a polygon that shows it
  if (!call.certificate.empty()) {
    const solid::MeshView polygons{mesh.vertices, mesh.polygon_begin, mesh.polygon_vertices};
    if (is_other && hull.dimension() == 3) off_hull = solid::face_off_hull(polygons, hull);
    write_proof(talk, call.certificate, {inputs, left_out.texts()}, [&](ClaimsWriter& claims) {
      const bool is_of_points = object.shape == io::BodyShape::points;
      claims.say(said_of_file(is_of_points ? Said::Source::points : Said::Source::vertices, inputs, call.file, "",
                              missing_of(object, left_out)));
      solid::write_hull(claims, object.name.empty() ? "unnamed" : object.name, mesh.vertices, hull);
      if (is_proved_convex || off_hull) solid::write_mesh(claims, polygons, hull, off_hull);
    });
  }

  Report report{.verb = "hull", .answer = dimension_name(hull.dimension())};
  report.notes = talk.notes();
  if (is_convex && !is_proved_convex) report.not_proved.emplace_back("exactly convex");
  if (is_other && !off_hull) report.not_proved.emplace_back("not exactly convex");
  const auto [low, high] = hull.box();
  Json told = to_json(object);
  told["edges"] = edge_count(hull);
  told["mesh"] = {{"in_use", object.mesh_vertices}, {"polygons", object.mesh_polygons}};
  told["box"] = Json::array({to_json(low), to_json(high)});
  report.objects.push_back(std::move(told));
  report.tell(fmt::format("{}: hull of dimension {}: a {}{}\n", object.file, hull.dimension(),
                          dimension_name(hull.dimension()), left_out.clause()));
  report.tell(fmt::format("  vertices  {} of {}\n", hull.vertices().size(), object.mesh_vertices));
  report.tell(fmt::format("  edges     {}\n  facets    {}\n", edge_count(hull), hull.facet_count()));
  report.tell(fmt::format("  box       {} to {}\n", about(low), about(high)));
  if (is_convex) report.tell("  mesh      exactly convex: it bounds its hull\n");
  if (is_other) {
    report.tell(fmt::format("  mesh      not exactly convex: {}\n", object.why_hull));
  }
  if (object.departure) report.tell(fmt::format("            {}\n", departure_text(object)));
  report.add(facts_of(left_out));
  add_files(call, call.out, report);
  return report;
}

}  // namespace

Verb hull_verb() {
  const auto call = std::make_shared<HullCall>();
  return {"hull",
          "Compute the exact convex hull of points in 2 to 6 dimensions, or the vertices of half-spaces.",
          "0 the hull or the vertices; 1 the half-spaces have no common point, or their intersection is unbounded",
          {{"FILE", &call->file,
            "a mesh or a set of points (OBJ, STL, PLY, OFF, DAE, glTF, WRL, 3MF); points x1,..,xd in 2 to 6 dimensions "
            "(CSV, "
            "NPY); or half-spaces a1 x1 + .. + ad xd <= b (CSV, NPY: a1,..,ad,b)",
            "", true},
           {"-o,--out", &call->out, "write the hull to FILE: .obj, .off, .ply or .stl for a mesh; .csv for CSV or NPY",
            "FILE"},
           certificate_option(call->certificate),
           {"--half-spaces", &call->half_spaces,
            "each row of FILE (CSV without column names, or NPY) is a half-space a1,..,ad,b"},
           {"--leave-out", &call->leave_out, leave_out_help},
           json_option(call->json)},
          [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask
