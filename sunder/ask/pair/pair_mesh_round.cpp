// sunder pair where one is a mesh that is not convex, asked about as it is, and the other one has a radius.
#include <sunder/ask/evidence.h>
#include <sunder/ask/pair/pair_bounded.h>
#include <sunder/ask/pair/pair_meshes.h>

#include <sunder/base/error.h>
#include <sunder/solid/mesh/mesh_round.h>
#include <sunder/solid/mesh/mesh_round_claims.h>
#include <sunder/solid/round/round_claims.h>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <variant>

namespace sunder::ask {

namespace {

using solid::PlacedRound;

using MeshRoundMethod = Named<solid::MeshRoundAnswer(const solid::Mesh&, const solid::Pose&, const PlacedRound&)>;
constexpr std::array<MeshRoundMethod, 2> mesh_round_methods{
    {SUNDER_METHOD("automatic", solid::mesh_round), SUNDER_METHOD("scan", solid::mesh_round_by_scan)}};

class MeshRoundPair : public MeshQuestion {
 public:
  MeshRoundPair(const PairCall& asked, MeshRoundMethod method, const PlacedBody& of_mesh, const solid::Mesh& mesh,
                const PlacedRoundBody& round, bool is_mesh_a, const PairFiles& files)
      : MeshQuestion(asked, is_mesh_a ? object_of_mesh(of_mesh, mesh) : round.object_of(),
                     is_mesh_a ? round.object_of() : object_of_mesh(of_mesh, mesh), files),
        method_(method),
        mesh_(mesh),
        pose_(of_mesh.pose),
        round_(round.body, round.pose),
        is_mesh_a_(is_mesh_a),
        least_(least_clearance(asked)) {
    if (can_be_placed(round_)) return;
    throw Error(ErrorCode::bad_pose, "has entries of 2^1000 and more; give smaller ones",
                (is_mesh_a ? asked.b : asked.a).option("pose"));
  }

  void ask() {
    function_ = method_.function;
    answer_ = method_(mesh_, pose_, round_);
    take(answer_, answer_.undecided() ? "nothing: the gap or the depth is below some 2^-76 of their size"
                                      : decided_text(answer_.decided_by));
    facts_ = {{"said_of", "meshes", ""}, evidence()};
    if (call.classify && std::holds_alternative<solid::RoundWithinMesh>(answer_.evidence)) {
      contact_ = is_mesh_a_ ? Relation::b_inside_a : Relation::a_inside_b;
      not_proved_.emplace_back("that all of it is inside");
    } else if (call.classify && meet_) {
      facts_.push_back(
          {"contact_unknown", true, "whether they touch or overlap is not asked of a mesh and a body with a radius"});
    }
    measure();
    if (answer_.verdict() == Verdict::apart && parts_ > 1) tell_what_is_not_enclosed(open_pieces(mesh_));
  }

  std::string certificate() const {
    require_decided();
    return claims_text(origin(), [this](ClaimsWriter& file) {
      const PairObject &of_mesh = is_mesh_a_ ? a_ : b_, &of_round = is_mesh_a_ ? b_ : a_;
      const solid::StatedMesh stated = solid::add_table(file, {of_mesh.name, mesh_, pose_, of_mesh.said});
      PairClaims pairs(file);
      file.say(of_round.said);
      const std::uint32_t body = add_round(pairs, of_round.name, round_);
      add_claims(pairs, stated, body, round_, answer_.evidence);
      if (call.distance) state_distance(pairs, stated, body);
      if (least_ > 0) add_clearance(pairs, stated, body, round_, clearance_.evidence, least_);
    });
  }

 private:
  const char* letter_of_mesh() const { return is_mesh_a_ ? "A" : "B"; }
  const char* letter_of_round() const { return is_mesh_a_ ? "B" : "A"; }

  Fact evidence() {
    return {"evidence", evidence_json(answer_.evidence, mesh_, pose_, round_, is_mesh_a_), evidence_text()};
  }

  std::string evidence_text() {
    const char *const mesh = letter_of_mesh(), *const round = letter_of_round();
    if (const auto* near = std::get_if<solid::RoundNearTriangle>(&answer_.evidence)) {
      return fmt::format("they touch, or nearly, at polygon {} of {}", mesh_.face_of(near->triangle), mesh);
    }
    if (!meet_) {
      const solid::PartsBeside parts = parts_beside(mesh_, pose_, round_);
      parts_ = parts.ends.size();
      std::string text = parts_ == 1 ? fmt::format("a plane with {} on one side and {} on the other", mesh, round)
                                     : fmt::format("{} planes, between parts of {} and {}", parts_, mesh, round);
      if (!parts.away.empty()) text += fmt::format(";\n1 ray shows that {} is not inside of {}", round, mesh);
      return text;
    }
    const std::string point = about(rounded_point_of(mesh_, pose_, round_, answer_.evidence));
    if (const auto* meeting = std::get_if<solid::RoundOnTriangle>(&answer_.evidence)) {
      return fmt::format("a common point at about {}, of polygon {} of {}", point, mesh_.face_of(meeting->triangle),
                         mesh);
    }
    return fmt::format("all of {}, which has the point {}, is inside of {}", round, point, mesh);
  }

  // How far apart, where that is asked.
  void measure() {
    if (!call.distance && least_ == 0) return;
    const bool is_scan = call.method == "scan";
    distance_ = is_scan ? mesh_round_distance_by_scan(mesh_, pose_, round_, answer_)
                        : mesh_round_distance(mesh_, pose_, round_, answer_);
    cost_.probes += distance_.cost.probes;
    cost_.iterations += distance_.cost.iterations;
    cost_.exact += distance_.cost.exact;
    if (call.distance) {
      Fact told = told_distance({distance_.distance}, false);
      if (distance_.distance.high > 0) {
        const std::uint32_t face = mesh_.face_of(distance_.nearest);
        told.json["face"] = face;
        told.text += fmt::format(", from polygon {} of {}", face, letter_of_mesh());
      }
      facts_.push_back(std::move(told));
    }
    if (least_ == 0) return;
    clearance_ = is_scan ? mesh_round_clearance_by_scan(mesh_, pose_, round_, least_)
                         : mesh_round_clearance(mesh_, pose_, round_, least_);
    is_yes_ = clearance_.verdict() != Verdict::apart;
    is_undecided_ = is_undecided_ || clearance_.undecided();
    facts_.push_back(told_clearance(clearance_.verdict(), least_, distance_.distance, false));
  }

  // As two clearances: `low` is kept, and the next double above `high` is not.
  void state_distance(PairClaims& pairs, const solid::StatedMesh& stated, std::uint32_t body) const {
    const auto& [low, high] = distance_.distance;
    if (low > 0) add_clearance(pairs, stated, body, round_, solid::MeshAndRoundApart{}, low);
    const double above = std::nextafter(high, std::numeric_limits<double>::infinity());
    if (high > 0 && std::isfinite(above)) {
      add_clearance(pairs, stated, body, round_, solid::RoundOnTriangle{distance_.nearest}, above);
    }
  }

  MeshRoundMethod method_;
  const solid::Mesh& mesh_;
  const solid::Pose& pose_;
  PlacedRound round_;
  bool is_mesh_a_;
  double least_;           // 0: no clearance is asked about
  std::size_t parts_ = 0;  // of the mesh, where they are apart
  solid::MeshRoundAnswer answer_, clearance_;
  solid::MeshRoundDistance distance_;  // where that or a clearance is asked for
};

}  // namespace

Report run_mesh_round_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  const bool is_mesh_a = a.bounded.has_value();
  const PlacedBody& of_mesh = *(is_mesh_a ? a : b).bounded;
  const MeshRoundMethod method =
      method_by(call.method, mesh_round_methods, ", for a mesh that is not convex and a body with a radius");
  const solid::Mesh mesh = mesh_of_placed(of_mesh);
  require_range(mesh, of_mesh.pose, is_mesh_a ? call.a : call.b);
  return answer(MeshRoundPair(call, method, of_mesh, mesh, *(is_mesh_a ? b : a).round, is_mesh_a, files), files.talk);
}

}  // namespace sunder::ask
