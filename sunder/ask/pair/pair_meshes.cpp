// sunder pair where A or B is a mesh that is not convex: both are asked about as they are.
#include <sunder/ask/evidence.h>
#include <sunder/ask/mesh_memory_option.h>
#include <sunder/ask/pair/pair_bounded.h>
#include <sunder/ask/pair/pair_meshes.h>
#include <sunder/ask/pair/pair_space.h>

#include <sunder/base/error.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_relation.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <variant>

namespace sunder::ask {

namespace {

using MeshMethod = Named<solid::MeshAnswer(const solid::Mesh&, const solid::Pose&, const solid::Mesh&,  //
                                           const solid::Pose&)>;
constexpr std::array<MeshMethod, 2> mesh_methods{
    {SUNDER_METHOD("automatic", solid::mesh_mesh), SUNDER_METHOD("scan", solid::mesh_mesh_by_scan)}};

bool is_flat_polygon(const PlacedBody& placed) {
  return placed.object && placed.object->kind == io::SpaceObject::Kind::polygon;
}

}  // namespace

solid::Mesh mesh_of_placed(const PlacedBody& placed) {
  if (!is_flat_polygon(placed) || placed.mesh.mesh == nullptr) return io::mesh_as_it_is(placed.mesh);
  io::Mesh both = *placed.mesh.mesh;
  const std::vector<std::uint32_t> ring = both.polygon_vertices;
  both.polygon_vertices.insert(both.polygon_vertices.end(), ring.rbegin(), ring.rend());
  both.polygon_begin.push_back(static_cast<std::uint32_t>(both.polygon_vertices.size()));
  return solid::Mesh({both.vertices, both.polygon_begin, both.polygon_vertices});
}

void require_range(const solid::Mesh& mesh, const solid::Pose& pose, const PairSide& side) {
  if (can_be_placed(mesh, pose)) return;
  throw Error(ErrorCode::bad_pose,
              "has entries of 2^1000 and more, and the mesh coordinates of 2^1020; give smaller ones",
              side.option("pose"));
}

PairObject object_of_mesh(const PlacedBody& placed, const solid::Mesh& mesh) {
  const MeshBody& body = placed.mesh;
  const SurfaceTold surface = surface_told(mesh);
  PairObject result{.file = body.file,
                    .name = body.name,
                    .text = fmt::format("{}: {} of {}", body.name, is_flat_polygon(placed) ? "polygon" : "mesh",
                                        count_of(mesh.triangles().size(), "triangle")),
                    .json = {{"name", body.name},
                             {"file", body.file},
                             {"format", body.format},
                             {"shape", "mesh"},
                             {"points", mesh.points().size()},
                             {"triangles", mesh.triangles().size()},
                             {"surface", surface.json}},
                    .vertices = {},
                    .said = placed.said_as_it_is};
  for (std::size_t k = 0; k < surface.lines.size(); ++k) {
    result.text += (k == 0 ? "\nclosed: " : "\n") + surface.lines[k];
  }
  return result;
}

std::size_t open_pieces(const solid::Mesh& mesh) {
  const auto pieces = mesh.pieces();
  return static_cast<std::size_t>(std::count_if(
      pieces.begin(), pieces.end(), [](const auto& piece) { return piece.kind == solid::PieceKind::open; }));
}

void MeshQuestion::tell_what_is_not_enclosed(std::size_t open) {
  if (open == 0) return;
  is_yes_ = is_yes_ || !call.surface;
  verdict_ = "apart (surfaces alone)";
  facts_.push_back(
      {"enclosed", "not asked",
       fmt::format("not asked: {} open, and what an open piece seems to enclose is not inside;\n{}",
                   open == 1 ? "1 piece is" : fmt::format("{} pieces are", open),
                   call.surface ? "surfaces alone are asked about" : "--surface asks about surfaces alone")});
}

namespace {

class MeshPair : public MeshQuestion {
 public:
  MeshPair(const PairCall& asked, MeshMethod method, const PlacedBody& a, const PlacedBody& b,
           const solid::Mesh& mesh_a, const solid::Mesh& mesh_b, const PairFiles& files)
      : MeshQuestion(asked, object_of_mesh(a, mesh_a), object_of_mesh(b, mesh_b), files),
        method_(method),
        pose_a_(a.pose),
        pose_b_(b.pose),
        mesh_a_(mesh_a),
        mesh_b_(mesh_b),
        least_(least_clearance(asked)) {}

  void ask() {
    function_ = method_.function;
    answer_ = method_(mesh_a_, pose_a_, mesh_b_, pose_b_);
    take(answer_, answer_.decided_by == DecidedBy::filter     ? "signs, by floating-point filters alone"
                  : answer_.decided_by == DecidedBy::evidence ? "signs, with the help of exact arithmetic"
                                                              : decided_text(answer_.decided_by));
    if (call.classify && meet_) {
      io::MeshMemory::take(call.a.file + ", " + call.b.file, mesh_a_.triangles().size() + mesh_b_.triangles().size(),
                           bytes_of_relation);
      relation_ = mesh_relation(mesh_a_, pose_a_, mesh_b_, pose_b_, answer_);
      if (relation_.relation != Relation::meeting) contact_ = relation_.relation;
    }
    facts_ = {{"said_of", "meshes", ""}, evidence()};
    if (call.classify && meet_) {
      if (relation_.partition) facts_.push_back(told(*relation_.partition));
      add_what_is_unknown();
    }
    measure();
    if (!meet_ && !is_parted_) tell_what_is_not_enclosed(open_pieces(mesh_a_) + open_pieces(mesh_b_));
  }

  std::string certificate() const {
    return claims_text(origin(), [this](ClaimsWriter& file) {
      solid::add_claims(file, {a_.name, mesh_a_, pose_a_, a_.said}, {b_.name, mesh_b_, pose_b_, b_.said}, answer_,
                        &relation_, {&distance_, call.distance, least_});
    });
  }

 private:
  // How far apart, where that is asked.
  void measure() {
    if (!call.distance && least_ == 0) return;
    distance_ = call.method == "scan" ? mesh_distance_by_scan(mesh_a_, pose_a_, mesh_b_, pose_b_)
                                      : mesh_distance(mesh_a_, pose_a_, mesh_b_, pose_b_);
    const solid::NearTriangles* const nearest = nearest_of(distance_);
    Measure found{distance_of(distance_)};
    if (nearest != nullptr) found.between = {of_polygon(mesh_a_, *nearest, true), of_polygon(mesh_b_, *nearest, false)};
    if (call.distance) facts_.push_back(told_distance(found, false));
    cost_ = distance_.cost;
    if (least_ == 0) return;
    const bool is_kept = compare_distance(distance_, least_) != Sign::negative;
    is_yes_ = !is_kept;
    facts_.push_back(told_clearance(is_kept ? Verdict::apart : Verdict::meet, least_, found.length, false));
  }

  static Told of_polygon(const solid::Mesh& mesh, const solid::NearTriangles& nearest, bool is_a) {
    const std::uint32_t polygon = mesh.face_of(is_a ? nearest.of_a : nearest.of_b);
    const Point3 point = nearest.closest.nearest_points()[is_a ? 0 : 1];
    return {{{"face", polygon}, {"point", to_json(point)}},
            fmt::format("{} of polygon {} of {}", about(point), polygon, is_a ? "A" : "B")};
  }

  void add_what_is_unknown() {
    if (contact_ == Relation::none) {
      facts_.push_back({"contact_unknown", true,
                        relation_.is_known
                            ? "whether they touch or overlap is not known: one has an open piece, or no inside"
                            : "whether they touch or overlap is not known"});
    } else if (!relation_.is_known) {
      facts_.push_back({"part_unknown", true, "whether one is a part of the other is not known"});
    }
  }

  Fact evidence() {
    if (!answer_.meet()) return told(mesh_cover(mesh_a_, pose_a_, mesh_b_, pose_b_));
    const std::string point = about(rounded_point_of(mesh_a_, pose_a_, mesh_b_, pose_b_, answer_.evidence));
    std::string text;
    if (const auto* within = std::get_if<solid::PointWithin>(&answer_.evidence)) {
      text = fmt::format("a corner of {}, at about {}, is inside of {}", within->is_of_a ? "A" : "B", point,
                         within->is_of_a ? "B" : "A");
    } else {
      const auto& meeting = std::get<solid::MeetingTriangles>(answer_.evidence);
      text = fmt::format("a common point at about {}, of polygon {} of A and {} of B", point,
                         mesh_a_.face_of(meeting.of_a), mesh_b_.face_of(meeting.of_b));
    }
    return {"evidence", evidence_json(answer_.evidence, mesh_a_, pose_a_, mesh_b_, pose_b_), std::move(text)};
  }

  Fact told(const solid::MeshPartition& partition) const {
    const std::size_t planes = partition.planes.size(), cells = partition.cells.size();
    const char* const none = contact_ == Relation::touching      ? "inside of both"
                             : contact_ == Relation::a_part_of_b ? "inside of A alone"
                             : contact_ == Relation::b_part_of_a ? "inside of B alone"
                                                                 : "inside of one alone";
    return {"partition",
            {{"planes", planes}, {"cells", cells}},
            fmt::format("{} space into {} cells, none of which is {}",
                        planes == 1 ? "a plane cuts" : fmt::format("{} planes cut", planes), cells, none)};
  }

  Fact told(const solid::MeshCover& cover) {
    const std::size_t planes = cover.directions.size(), rays = cover.rays_a.size() + cover.rays_b.size();
    is_parted_ = planes == 1;
    std::string text = planes == 1 ? "a plane with A on one side and B on the other"
                                   : fmt::format("{} planes, between parts of A and parts of B", planes);
    if (rays > 0) {
      text += fmt::format(";\n{} that neither is inside of the other",
                          rays == 1 ? "1 ray shows" : fmt::format("{} rays show", rays));
    }
    return {"evidence", {{"planes", planes}, {"rays", rays}}, text};
  }

  MeshMethod method_;
  const solid::Pose &pose_a_, &pose_b_;
  const solid::Mesh &mesh_a_, &mesh_b_;
  solid::MeshAnswer answer_;
  bool is_parted_ = false;        // by one plane
  solid::MeshRelation relation_;  // where --classify asks for it
  double least_;                  // 0: no clearance is asked about
  solid::MeshDistance distance_;  // where that or --distance asks for it
};

bool is_hull_with_radius(const SpaceInput& input) { return input.round && input.round->is_hull(); }

// Throws Error for what is asked of convex objects alone.
void require_meshes_are_asked(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const MeshBody& mesh) {
  const auto refuse = [&](const std::string& what, const std::string& place) {
    throw Error(ErrorCode::bad_call,
                fmt::format("{} is not exactly convex ({}), and {}; give --hull to ask about its convex hull",
                            io::quote(mesh.file), mesh.why_hull, what),
                place);
  };
  const bool are_bounded = a.bounded && b.bounded;
  const std::pair<bool, const char*> options[] = {{call.depth, "--depth"},
                                                  {!call.a.to.empty() && !are_bounded, "--to-a"},
                                                  {!call.b.to.empty() && !are_bounded, "--to-b"},
                                                  {is_hull_with_radius(a), "--radius-a"},
                                                  {is_hull_with_radius(b), "--radius-b"},
                                                  {call.support, "--support"}};
  for (const auto& [is_given, option] : options) {
    if (!is_given) continue;
    const bool is_motion = std::string_view(option).starts_with("--to-");
    refuse(is_motion ? "motion is asked of two meshes, or of convex objects" : "this option is for convex objects",
           option);
  }
}

}  // namespace

const MeshBody* mesh_that_is_not_convex(const SpaceInput& a, const SpaceInput& b) {
  for (const SpaceInput* input : {&a, &b}) {
    const PlacedBody* const body = input->bounded                       ? &*input->bounded
                                   : input->round && input->round->core ? &*input->round->core
                                                                        : nullptr;
    if (body != nullptr && body->is_hull()) return &body->mesh;
  }
  return nullptr;
}

Report run_mesh_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  require_meshes_are_asked(call, a, b, *mesh_that_is_not_convex(a, b));
  if (a.round || b.round) {
    if (!a.flat && !b.flat) return run_mesh_round_pair(call, a, b, files);
    throw Error(ErrorCode::bad_call,
                "a body with a radius is asked about with what is bounded; give no line, ray or plane");
  }
  if (a.flat || b.flat) return run_mesh_flat_pair(call, a, b, files);
  if (!call.a.to.empty() || !call.b.to.empty()) return run_mesh_motion_pair(call, *a.bounded, *b.bounded, files);
  const MeshMethod method = method_by(call.method, mesh_methods, ", for meshes that are not convex");
  const solid::Mesh mesh_a = mesh_of_placed(*a.bounded), mesh_b = mesh_of_placed(*b.bounded);
  require_range(mesh_a, a.bounded->pose, call.a);
  require_range(mesh_b, b.bounded->pose, call.b);
  return answer(MeshPair(call, method, *a.bounded, *b.bounded, mesh_a, mesh_b, files), files.talk);
}

std::string mesh_method_names() { return method_names(mesh_methods); }

}  // namespace sunder::ask
