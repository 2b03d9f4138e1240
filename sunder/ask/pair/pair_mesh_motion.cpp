// sunder pair A B --to-a POSE --to-b POSE where A or B is a mesh that is not convex: both move as they are.
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_meshes.h>
#include <sunder/ask/pair/pair_motion.h>

#include <sunder/base/error.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/mesh/mesh_motion.h>

#include <fmt/format.h>

#include <array>
#include <string>
#include <utility>
#include <variant>

namespace sunder::ask {

namespace {

using solid::Translation;
using MeshMotionMethod = Named<solid::MeshMotion(const solid::Mesh&, const Translation&, const solid::Mesh&,  //
                                                 const Translation&)>;
constexpr std::array<MeshMotionMethod, 2> mesh_motion_methods{
    {SUNDER_METHOD("automatic", solid::mesh_motion), SUNDER_METHOD("scan", solid::mesh_motion_by_scan)}};

class MeshMotionPair : public MeshQuestion {
 public:
  MeshMotionPair(const PairCall& asked, MeshMotionMethod method, const PlacedBody& a, const PlacedBody& b,
                 const solid::Mesh& mesh_a, const solid::Mesh& mesh_b, const Translation& of_a, const Translation& of_b,
                 const PairFiles& files)
      : MeshQuestion(asked, object_of_mesh(a, mesh_a), object_of_mesh(b, mesh_b), files),
        method_(method),
        mesh_a_(mesh_a),
        mesh_b_(mesh_b),
        of_a_(of_a),
        of_b_(of_b) {
    tell_motion(of_a_, a_);
    tell_motion(of_b_, b_);
  }

  void ask() {
    function_ = method_.function;
    answer_ = method_(mesh_a_, of_a_, mesh_b_, of_b_);
    take(answer_, answer_.decided_by == DecidedBy::filter     ? "floating point alone"
                  : answer_.decided_by == DecidedBy::evidence ? "floating point, with the help of exact arithmetic"
                                                              : decided_text(answer_.decided_by));
    verdict_ = meet_ ? "meet on the way" : "apart all the way";
    facts_ = {{"said_of", "meshes", ""}};
    if (!meet_) return tell_apart();
    facts_.push_back(told_point());
    facts_.push_back(told_first_time(first_time_of(answer_).enclosure()));
  }

  std::string certificate() const {
    return claims_text(origin(), [this](ClaimsWriter& file) {
      solid::add_claims(file, {a_.name, mesh_a_, of_a_, a_.said}, {b_.name, mesh_b_, of_b_, b_.said}, answer_);
    });
  }

 private:
  void tell_apart() {
    const solid::MeshCover cover = mesh_cover_on_the_way(mesh_a_, of_a_, mesh_b_, of_b_);
    const std::size_t planes = cover.directions.size(), rays = cover.rays_a.size() + cover.rays_b.size();
    std::string text =
        planes == 1
            ? "all the way a direction along which A ends before B begins"
            : fmt::format("{} directions, along which parts of A end all the way before parts of B begin", planes);
    if (rays > 0) {
      text += fmt::format(";\n{} that neither is inside of the other at the beginning",
                          rays == 1 ? "1 ray shows" : fmt::format("{} rays show", rays));
    }
    facts_.push_back({"evidence", {{"planes", planes}, {"rays", rays}}, std::move(text)});
    if (planes > 1) tell_what_is_not_enclosed(open_pieces(mesh_a_) + open_pieces(mesh_b_));
  }

  Fact told_point() const {
    if (const solid::SweepContact* contact = contact_on_the_way(answer_)) {
      const auto& later = std::get<solid::TrianglesOnTheWay>(answer_.evidence);
      const Point3 at = nearest(contact->point.at), p{at.x + 0.0, at.y + 0.0, at.z + 0.0};
      const std::uint32_t face_a = mesh_a_.face_of(later.of_a), face_b = mesh_b_.face_of(later.of_b);
      return {"evidence",
              {{"point", to_json(p)}, {"face_a", face_a}, {"face_b", face_b}},
              fmt::format("a common point then at about {}, of polygon {} of A and {} of B", about(p), face_a, face_b)};
    }
    const solid::MeshEvidence at_start = evidence_at_start(answer_);
    const std::string point = about(rounded_point_of(mesh_a_, of_a_.begin(), mesh_b_, of_b_.begin(), at_start));
    const auto* within = std::get_if<solid::PointWithin>(&at_start);
    return {"evidence", evidence_json(at_start, mesh_a_, of_a_.begin(), mesh_b_, of_b_.begin()),
            within == nullptr ? fmt::format("a common point then at about {}", point)
                              : fmt::format("a corner of {}, then at about {}, is inside of {}",
                                            within->is_of_a ? "A" : "B", point, within->is_of_a ? "B" : "A")};
  }

  MeshMotionMethod method_;
  const solid::Mesh &mesh_a_, &mesh_b_;
  const Translation &of_a_, &of_b_;
  solid::MeshMotion answer_;
};

}  // namespace

Report run_mesh_motion_pair(const PairCall& call, const PlacedBody& a, const PlacedBody& b, const PairFiles& files) {
  require_pair_fit(call, {pair_kind::moving, pair_kind::moving_meshes});
  const MeshMotionMethod method =
      method_by(call.method, mesh_motion_methods, ", for meshes that move and are not convex");
  const Translation of_a = motion_of(a.pose, &a, call.a), of_b = motion_of(b.pose, &b, call.b);
  const solid::Mesh mesh_a = mesh_of_placed(a), mesh_b = mesh_of_placed(b);
  require_range(mesh_a, a.pose, call.a);
  require_range(mesh_b, b.pose, call.b);
  return answer(MeshMotionPair(call, method, a, b, mesh_a, mesh_b, of_a, of_b, files), files.talk);
}

}  // namespace sunder::ask
