#include <sunder/ask/simple_mesh.h>

#include <sunder/ask/mesh_memory_option.h>
#include <sunder/ask/objects.h>
#include <sunder/ask/question.h>
#include <sunder/ask/said_of.h>

#include <sunder/base/error.h>
#include <sunder/io/mesh/space_objects.h>
#include <sunder/io/text/file.h>
#include <sunder/solid/mesh/mesh_crossings.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

namespace sunder::ask {

namespace {

using solid::CrossingTriangles;
using solid::MeshCrossings;

using CrossingMethod = MeshCrossings(const solid::Mesh&, std::size_t);
constexpr std::array<Named<CrossingMethod>, 2> crossing_methods{
    {SUNDER_METHOD("automatic", solid::mesh_crossings), SUNDER_METHOD("scan", solid::mesh_crossings_by_scan)}};

constexpr std::size_t most_listed = 20;  // to people

class MeshValid {
 public:
  static constexpr const char *verb = "simple", *drawn_noun = "triangle";
  const SimpleMeshCall& call;

  MeshValid(const SimpleMeshCall& asked, Talk& told)
      : call(asked),
        talk_(told),
        method_(method_by(asked.method, crossing_methods, ", for meshes")),
        left_out_(asked.leave_out),
        limit_(limit_of(asked, bytes_of_crossings)),
        body_(io::read_body(asked.file, false, left_out_, asked.proves() ? &inputs_ : nullptr)),
        mesh_(mesh_as_it_is(body_)) {
    if (body_.mesh == nullptr) io::fail_file(call.file, "is a set of points, and no mesh");
    note_remarks(talk_, {&body_});
  }

  static std::uint64_t drawn() { return 0; }
  static std::string picture() { return ""; }

  void ask() {
    found_ = method_(mesh_, call.all ? solid::all_crossings : 1);
    const auto pieces = mesh_.pieces();
    is_closed_ = std::all_of(pieces.begin(), pieces.end(),
                             [](const auto& piece) { return piece.kind == solid::PieceKind::oriented; });
    has_area_ = found_.without_area < mesh_.triangles().size();
  }

  std::string certificate() const {
    const bool are_none = found_.pairs.empty();
    const auto cover = are_none && found_.t_junctions == 0 ? mesh_self_cover(mesh_) : std::nullopt;
    if (are_none && !cover) {
      throw Error(ErrorCode::bad_call,
                  "that no triangles of a mesh cross has no proof where one has no area, or an edge ends inside "
                  "another one; leave it out",
                  "--certificate");
    }
    return claims_text(origin_of(talk_, inputs_, left_out_.texts()), [&](ClaimsWriter& file) {
      solid::MeshClaims claims(file);
      const std::uint32_t index = claims.add_mesh(body_.name, mesh_, said_of_triangles(body_, inputs_, left_out_));
      claims.end_table();
      if (cover) claims.add_no_crossings(index, *cover);
      for (const CrossingTriangles& pair : found_.pairs) claims.add_crossing(index, mesh_, pair);
    });
  }

  Report report() const {
    const bool is_valid = is_closed_ && has_area_ && found_.pairs.empty() && mesh_.crossing_faces().empty();
    Report report{.answer = is_valid ? "valid" : "not valid", .code = is_valid ? exit_code::no : exit_code::yes};
    report.function = method_.function;
    report.cost = found_.cost;
    const SurfaceTold surface = surface_told(mesh_);
    report.objects = Json::array({Json{{"name", body_.name},
                                       {"file", body_.file},
                                       {"format", body_.format},
                                       {"shape", "mesh"},
                                       {"points", mesh_.points().size()},
                                       {"triangles", mesh_.triangles().size()},
                                       {"surface", surface.json}}});
    report.tell(fmt::format("{}: {}{}\n", body_.file, is_valid ? "valid" : "not valid", left_out_.clause()));
    report.tell(titled("mesh", fmt::format("{}, {}", count_of(mesh_.triangles().size(), "triangle"), body_.format)));
    std::string closed;
    for (const std::string& line : surface.lines) closed += (closed.empty() ? "" : "\n") + line;
    report.tell(titled("closed", closed));
    report.add(facts_of(left_out_));
    report.add("crossings", json(), titled("crossings", text()));
    if (call.proves()) report.not_proved = not_proved();
    return report;
  }

 private:
  Point3 point_of(const CrossingTriangles& pair) const { return nearest(crossing_point(mesh_, pair).at); }

  Json json() const {
    Json list = Json::array();
    for (const CrossingTriangles& pair : found_.pairs) {
      list.push_back({{"triangles", {pair.first, pair.second}},
                      {"faces", {mesh_.face_of(pair.first), mesh_.face_of(pair.second)}},
                      {"point", to_json(point_of(pair))}});
    }
    return {{"list", std::move(list)},
            {"are_all", found_.are_all},
            {"t_junctions", found_.are_all ? Json(found_.t_junctions) : Json(nullptr)},
            {"without_area", found_.without_area}};
  }

  std::string text() const {
    const std::size_t count = found_.pairs.size();
    std::string text = count == 0        ? "none"
                       : !found_.are_all ? "some; --all lists all"
                                         : count_of(count, "pair") + " of triangles";
    for (std::size_t k = 0; k < count && k < most_listed; ++k) {
      const CrossingTriangles& pair = found_.pairs[k];
      const auto [first, second] = std::minmax({mesh_.face_of(pair.first), mesh_.face_of(pair.second)});
      text += fmt::format("\npolygons {} and {} at about {}", first, second, about(point_of(pair)));
    }
    if (count > most_listed) text += fmt::format("\nand {} more; --json has all", count - most_listed);
    if (found_.are_all && found_.t_junctions > 0) {
      text += fmt::format("\nbesides, {} of triangles meet where an edge ends inside another (T-junctions)",
                          count_of(found_.t_junctions, "pair"));
    }
    if (found_.without_area > 0) {
      text += fmt::format("\nnot asked about: {} without area", count_of(found_.without_area, "triangle"));
    }
    return text;
  }

  std::vector<std::string> not_proved() const {
    std::vector<std::string> list;
    if (!mesh_.is_closed()) list.emplace_back("that the mesh is not closed");
    if (mesh_.is_closed() && !is_closed_) list.emplace_back("that the mesh is not turned the same way everywhere");
    if (call.all) list.emplace_back("that there are no other crossings");
    return list;
  }

  Talk& talk_;
  Named<CrossingMethod> method_;
  LeftOutList left_out_;
  io::MeshMemory limit_;
  InputFiles inputs_;
  io::MeshBody body_;
  solid::Mesh mesh_;
  MeshCrossings found_;
  bool is_closed_ = false;  // each piece, and turned the same way everywhere
  bool has_area_ = false;   // some triangle
};

}  // namespace

Report run_simple_mesh(const SimpleMeshCall& call, Talk& talk) { return answer(MeshValid(call, talk), talk); }

}  // namespace sunder::ask
