// sunder region FILE: what is the common part of half-planes, of circles, of convex polygons? Its best point?
#include <sunder/ask/region/region_question.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <memory>
#include <string>
#include <vector>

namespace sunder::ask {

namespace {

std::vector<Option> region_options(RegionCall& call) {
  const std::vector<std::string> polygons{"polygons"};
  return {
      {"FILE", &call.file,
       "half-planes a x + b y <= c: CSV, one in each row: a,b,c, and optionally a name; for other kinds see --of", "",
       true},
      {"--of", &call.of,
       "what FILE holds: half-planes (the default); half-spaces a1 x1 + .. + ad xd <= b in 2 to 6 dimensions (CSV: "
       "a1,..,ad,b; not needed if the first line names these columns); circles (CSV: x,y,r); or polygons, which must "
       "be convex (WKT, GeoJSON)",
       "KIND"},
      only_of({"half-planes", "half-spaces"}, {"--maximize", &call.maximize,
                                               "half-planes and half-spaces: at which point of the intersection is p x "
                                               "+ q y greatest? For half-spaces give "
                                               "one "
                                               "number for each dimension",
                                               "P,Q"}),
      {"--method", &call.method,
       fmt::format("for half-planes: {}; for polygons: {}; for circles: {}; for half-spaces with --maximize: {}",
                   half_plane_method_names(), polygon_method_names(), circle_method_names(), half_space_method_names()),
       "NAME"},
      certificate_option(call.certificate,
                         "write the proof to FILE: of the intersection, or with --maximize of the best point"),
      only_of({"half-planes", "circles", "polygons"}, {"--svg", &call.svg, "draw the intersection to FILE", "FILE"}),
      title_option(call.title),
      svg_limit_option(call.svg_limit),
      only_of(polygons, {"--mend", &call.polygons.mend, "polygons: remove repeated and collinear vertices"}),
      only_of(polygons, {"--skip-invalid", &call.polygons.skip_invalid,
                         "polygons: answer for the convex ones, and list the others"}),
      only_of(polygons,
              {"--leave-out", &call.polygons.leave_out, "polygons: leave out points and lines, and list them"}),
      only_of(polygons, {"--name", &call.polygons.name,
                         "polygons: the property that holds their names (default: name, NAME or id)", "FIELD"}),
      only_of(polygons, {"--drop-z", &call.polygons.drop_z, "polygons: ignore the third coordinate of each point"}),
      only_of(polygons, {"--mixed-crs", &call.polygons.mixed_crs, fmt::format("polygons: {}", mixed_crs_help)}),
      json_option(call.json)};
}

Report run_region(const RegionCall& call, Talk& talk) {
  const bool of_half_planes = call.of == "half-planes", of_polygons = call.of == "polygons";
  const bool of_half_spaces = is_of_half_spaces(call);
  if (!of_half_planes && !of_half_spaces && !of_polygons && call.of != "circles") {
    throw Error(ErrorCode::bad_call,
                fmt::format("there is no common part of {}; there are half-planes, half-spaces, circles, polygons",
                            io::quote(call.of)),
                "--of");
  }
  RegionCall given = call, unless_given;
  require_fit(region_options(given), region_options(unless_given), {of_half_spaces ? "half-spaces" : call.of});
  return of_half_spaces   ? run_region_half_spaces(call, talk)
         : of_half_planes ? run_region_half_planes(call, talk)
         : of_polygons    ? run_region_polygons(call, talk)
                          : run_region_circles(call, talk);
}

}  // namespace

Verb region_verb() {
  const auto call = std::make_shared<RegionCall>();
  return {"region", "What is the intersection of all half-planes, half-spaces, discs or convex polygons of a file?",
          "0 they have a common point; 1 they have none", region_options(*call),
          [call](Talk& talk) { return run_region(*call, talk); }};
}

}  // namespace sunder::ask
