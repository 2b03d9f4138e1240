// sunder polar FILE: the polar of a body about a point inside it; --check shows what Barba and Langerman 2015, section
// 3, say of polars.
#include <sunder/ask/objects.h>
#include <sunder/ask/report.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/mesh_write.h>
#include <sunder/io/text/text.h>
#include <sunder/picture/polar.h>
#include <sunder/solid/represent/polar_lemmas.h>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace sunder::ask {

namespace {

struct PolarCall {
  std::string file, origin = "0,0,0", out, svg, title;
  std::uint64_t svg_limit = most_drawn;
  bool check = false, require_convex = false, leave_out = false, json = false;
};

Point3 origin_of(const std::string& text) {
  const std::vector<double> n = parse_numbers(text, "--origin");
  if (n.size() != 3) throw Error(ErrorCode::bad_call, "is not a point x,y,z; give three numbers", "--origin");
  return {n[0], n[1], n[2]};
}

solid::PolarAbout polar_of(const MeshBody& body, const Point3& origin) {
  try {
    return polar_about(body.hull, origin);
  } catch (const Error& error) {
    throw Error(error.code(), error.what(), error.code() == ErrorCode::bad_shape ? body.file : "--origin");
  }
}

// The vertices as doubles. Throws Error where one is beyond them.
std::vector<Point3> rounded(const solid::PolarAbout& polar) {
  std::vector<Point3> points;
  for (const solid::PolarVertex& vertex : polar.vertices) {
    const Point3& p = points.emplace_back(nearest_point(vertex));
    if (std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z)) continue;
    throw Error(ErrorCode::bad_value, "the polar has a vertex beyond doubles; give an origin further inside",
                "--origin");
  }
  return points;
}

Json json_of(const solid::PolarLemma& lemma) {
  return {{"name", lemma.name},       {"says", lemma.says}, {"holds", lemma.holds},
          {"checked", lemma.checked}, {"of", lemma.of},     {"there_are", lemma.there_are}};
}

Report run(const PolarCall& call, Talk& talk) {
  const io::MeshFormat format = call.out.empty() ? io::MeshFormat::obj : io::mesh_format_of_name(call.out);
  const Point3 origin = origin_of(call.origin);
  LeftOutList left_out(call.leave_out);
  const MeshBody body = io::read_body(call.file, call.require_convex, left_out, nullptr);
  note_hulls(talk, {&body});
  const solid::PolarAbout polar = polar_of(body, origin);
  const std::vector<Point3> points = rounded(polar);
  Point3 low = points[0], high = points[0];
  for (const Point3& p : points) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], p[k]);
      high[k] = std::max(high[k], p[k]);
    }
  }
  if (!call.out.empty()) {
    talk.write_file(call.out, io::to_text(format, points, polar.facet_begin, polar.facet_vertices));
  }
  if (!call.svg.empty()) {
    require_drawable(body.hull.facet_count() + polar.facet_begin.size() - 1, "facet", 0, call.svg_limit);
    std::string said = fmt::format("the polar about {}: a body{}", about(origin), left_out.clause());
    if (body.shape == io::BodyShape::hull) said += "; said of the hull of the mesh, which is not convex";
    talk.write_file(call.svg,
                    picture::polar_svg({body.hull, polar, points, io::one_line(body.name), said, call.title}));
  }

  Report report{.verb = "polar", .answer = "body", .function = "solid::polar_about"};
  report.notes = talk.notes();
  report.objects.push_back(to_json(body));
  const std::size_t edges = polar.facet_vertices.size() / 2, facets = polar.facet_begin.size() - 1;
  report.tell(fmt::format("{}: the polar about {}: a body{}\n", body.file, about(origin), left_out.clause()));
  report.add(facts_of(left_out));
  report.add("origin", to_json(origin));
  report.add("polar",
             {{"vertices", points.size()},
              {"edges", edges},
              {"facets", facets},
              {"box_about", Json::array({to_json(low), to_json(high)})}},
             fmt::format("  vertices  {}\n  edges     {}\n  facets    {}\n  box       {} to {}, from the origin\n",
                         points.size(), edges, facets, about(low), about(high)));
  if (call.check) {
    report.function = "solid::polar_lemmas";
    Json lemmas = Json::array();
    std::string text;
    for (const solid::PolarLemma& lemma : polar_lemmas(body.hull, polar)) {
      if (!lemma.holds) throw std::logic_error(fmt::format("{} does not hold", lemma.name));
      lemmas.push_back(json_of(lemma));
      text += fmt::format("  {} holds: {} exact signs, of {} of {}\n    {}\n", lemma.name, lemma.checked, lemma.of,
                          lemma.there_are, lemma.says);
    }
    report.add("lemmas", std::move(lemmas), std::move(text));
  }
  report.picture = call.svg;
  report.add("out", call.out.empty() ? Json(nullptr) : Json(call.out), file_line("written", call.out));
  return report;
}

}  // namespace

Verb polar_verb() {
  const auto call = std::make_shared<PolarCall>();
  return {"polar",
          "Compute the polar of a convex body about a point inside it, exactly.",
          "0 the polar was found",
          {{"FILE", &call->file, "a mesh or a set of points: OBJ, STL, PLY, OFF, DAE, glTF, WRL, 3MF", "", true},
           {"--origin", &call->origin, "the point inside the body that is the origin (default: 0,0,0)", "X,Y,Z"},
           {"-o,--out", &call->out,
            "write the polar, as seen from the origin, to FILE: .obj, .off, .ply or .stl, coordinates rounded", "FILE"},
           {"--check", &call->check,
            "check Lemmas 3.1 to 3.6 and Theorem 3.7 of Barba and Langerman 2015 on the body and its polar, exactly"},
           {"--svg", &call->svg, "draw the body and its polar to FILE, with the numbers of facets that become vertices",
            "FILE"},
           title_option(call->title),
           svg_limit_option(call->svg_limit),
           {"--require-convex", &call->require_convex,
            "refuse a mesh that is not exactly convex (default: replace it by its convex hull)"},
           {"--leave-out", &call->leave_out, leave_out_help},
           json_option(call->json)},
          [call](Talk& talk) { return run(*call, talk); }};
}

}  // namespace sunder::ask
