// sunder pair where one is a mesh that is not convex, asked about as it is, and the other one a line, a ray or a plane.
#include <sunder/ask/pair/pair_meshes.h>
#include <sunder/ask/pair/pair_mixed.h>

#include <sunder/base/error.h>
#include <sunder/solid/mesh/mesh_flat_claims.h>
#include <sunder/solid/mesh/mesh_line.h>
#include <sunder/solid/mesh/mesh_plane.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <string>
#include <variant>

namespace sunder::ask {

namespace {

using MeshLineMethod = Named<solid::MeshLine(const solid::Mesh&, const solid::Pose&, const solid::LineLike&)>;
constexpr std::array<MeshLineMethod, 2> mesh_line_methods{
    {SUNDER_METHOD("automatic", solid::mesh_line), SUNDER_METHOD("scan", solid::mesh_line_by_scan)}};
using MeshPlaneMethod = Named<solid::MeshPlane(const solid::Mesh&, const solid::Pose&, const solid::Plane&)>;
constexpr std::array<MeshPlaneMethod, 1> mesh_plane_methods{{SUNDER_METHOD("automatic", solid::mesh_plane)}};

constexpr std::size_t most_told = 8;  // parts of a line, to people

// What both kinds share: who is A, and the file's tables.
class MeshFlatPair : public MeshQuestion {
 public:
  std::string certificate() const {
    return claims_text(origin(), [this](ClaimsWriter& file) {
      const PairObject &of_mesh = is_mesh_a_ ? a_ : b_, &of_flat = is_mesh_a_ ? b_ : a_;
      const solid::StatedMesh stated = solid::add_table(file, {of_mesh.name, mesh_, pose_, of_mesh.said});
      PairClaims pairs(file);
      file.say(of_flat.said);
      const std::uint32_t body = pairs.add_body(of_flat.name, of_flat.vertices, of_flat.ways);
      state(pairs, stated, body);
    });
  }

 protected:
  MeshFlatPair(const PairCall& asked, const PlacedBody& of_mesh, const solid::Mesh& mesh, const PlacedFlat& flat,
               bool is_mesh_a, const PairFiles& files)
      : MeshQuestion(asked, is_mesh_a ? object_of_mesh(of_mesh, mesh) : flat.object_of(asked),
                     is_mesh_a ? flat.object_of(asked) : object_of_mesh(of_mesh, mesh), files),
        mesh_(mesh),
        pose_(of_mesh.pose),
        is_mesh_a_(is_mesh_a) {}
  ~MeshFlatPair() = default;

  virtual void state(PairClaims& pairs, const solid::StatedMesh& mesh, std::uint32_t body) const = 0;

  const char* letter() const { return is_mesh_a_ ? "A" : "B"; }
  const char* other_letter() const { return is_mesh_a_ ? "B" : "A"; }

  // The evidence that the two are apart: planes between parts of the mesh and the other object.
  Fact told(const solid::PartsBeside& parts) const {
    const std::size_t planes = parts.ends.size();
    return {"evidence",
            {{"planes", planes}, {"rays", parts.away.size()}},
            planes == 1 ? fmt::format("a plane with {} on one side and {} on the other", letter(), other_letter())
                        : fmt::format("{} planes, between parts of {} and {}", planes, letter(), other_letter())};
  }

  const solid::Mesh& mesh_;
  const solid::Pose& pose_;
  bool is_mesh_a_;
};

class MeshPlanePair final : public MeshFlatPair {
 public:
  MeshPlanePair(const PairCall& asked, MeshPlaneMethod method, const PlacedBody& of_mesh, const solid::Mesh& mesh,
                const PlacedFlat& plane, bool is_mesh_a, const PairFiles& files)
      : MeshFlatPair(asked, of_mesh, mesh, plane, is_mesh_a, files),
        method_(method),
        plane_(std::get<solid::Plane>(plane.flat)),
        in_file_(plane.body) {}

  void ask() {
    function_ = method_.function;
    answer_ = method_(mesh_, pose_, plane_);
    take(answer_, decided_text(answer_.decided_by));
    facts_ = {{"said_of", "meshes", ""}};
    if (const auto* beside = std::get_if<solid::MeshBesidePlane>(&answer_.evidence)) {
      const bool is_all = beside->all != Sign::zero;
      const char* const side = !is_all ? "both" : beside->all == Sign::positive ? "above" : "below";
      facts_.push_back({"evidence",
                        {{"side", side}},
                        is_all ? fmt::format("all of {} is {} {}", letter(), side, other_letter())
                               : fmt::format("{} has pieces above {} and pieces below it", letter(), other_letter())});
      return;
    }
    const auto& across = std::get<solid::MeshAcrossPlane>(answer_.evidence);
    if (call.classify) contact_ = across.below && across.above ? Relation::overlapping : Relation::touching;
    const Point3 point = nearest(common_point(mesh_, pose_, plane_, across.triangle));
    const std::uint32_t face = mesh_.face_of(across.triangle);
    facts_.push_back({"evidence",
                      {{"point", to_json(point)}, {"face", face}},
                      fmt::format("a common point at about {}, of polygon {} of {}", about(point), face, letter())});
    if (call.classify) not_proved_.emplace_back("whether they touch or overlap");
  }

 private:
  void state(PairClaims& pairs, const solid::StatedMesh& mesh, std::uint32_t body) const override {
    add_claims(pairs, mesh, body, plane_, *in_file_, answer_);
  }

  MeshPlaneMethod method_;
  const solid::Plane& plane_;
  const std::optional<solid::FlatBody>& in_file_;
  solid::MeshPlane answer_;
};

class MeshLinePair final : public MeshFlatPair {
 public:
  MeshLinePair(const PairCall& asked, MeshLineMethod method, const PlacedBody& of_mesh, const solid::Mesh& mesh,
               const PlacedFlat& line, bool is_mesh_a, const PairFiles& files)
      : MeshFlatPair(asked, of_mesh, mesh, line, is_mesh_a, files), method_(method), ends_(line.object.points) {
    if (const auto* ray = std::get_if<solid::Ray>(&line.flat)) {
      line_ = *ray;
    } else {
      line_ = std::get<solid::Line>(line.flat);
    }
  }

  void ask() {
    function_ = method_.function;
    answer_ = method_(mesh_, pose_, line_);
    take(answer_, decided_text(answer_.decided_by));
    facts_ = {{"said_of", "meshes", ""}};
    const auto* in_mesh = std::get_if<solid::LineInMesh>(&answer_.evidence);
    if (in_mesh == nullptr) {
      const solid::PartsBeside parts = parts_beside(mesh_, pose_, line_);
      facts_.push_back(told(parts));
      return;
    }
    facts_.push_back(told(*in_mesh));
    if (call.classify) classify(*in_mesh);
    not_proved_.emplace_back("the common part, but for one point");
  }

 private:
  void state(PairClaims& pairs, const solid::StatedMesh& mesh, std::uint32_t body) const override {
    add_claims(pairs, mesh, body, line_, answer_);
  }

  void classify(const solid::LineInMesh& in_mesh) {
    const auto any = [&](bool solid::LinePart::* is) {
      return std::any_of(in_mesh.parts.begin(), in_mesh.parts.end(), [&](const auto& part) { return part.*is; });
    };
    if (any(&solid::LinePart::is_through)) {
      contact_ = Relation::overlapping;
    } else if (mesh_.is_closed() && !any(&solid::LinePart::is_next_near)) {
      contact_ = Relation::touching;
    } else {
      facts_.push_back({"contact_unknown", true, "whether they touch or overlap is not known"});
      return;
    }
    not_proved_.emplace_back("whether they touch or overlap");
  }

  // An end of a part: where it is, and on which polygon.
  Told end(const ExactFraction& t, const std::optional<std::uint32_t>& triangle) const {
    const Vector3<Dyadic> a = coordinates<Dyadic>(ends_[0]), way = coordinates<Dyadic>(ends_[1]) - a;
    const auto row = [&](const Dyadic& from, const Dyadic& by) { return from * t.denominator + by * t.numerator; };
    const Point3 p = nearest(ExactPoint3{row(a.x, way.x), row(a.y, way.y), row(a.z, way.z), t.denominator});
    Told of{{{"point", to_json(p)}, {"along_line", t.text()}}, "about " + about(p)};
    if (triangle) {
      const std::uint32_t face = mesh_.face_of(*triangle);
      of.json["face"] = face;
      of.text += fmt::format(", polygon {} of {}", face, letter());
    } else {
      of.json["beginning"] = true;
      of.text += ", its beginning";
    }
    const std::string text = t.text();
    of.text += text.size() <= 20 ? ", t = " + text : ", t = about " + about(t.nearest());
    return of;
  }

  Fact told(const solid::LineInMesh& in_mesh) const {
    const std::size_t count = in_mesh.parts.size();
    Fact fact{"common", {{"kind", "parts"}, {"hits", in_mesh.hits.size()}, {"parts", Json::array()}}, ""};
    fact.text = count == 1 ? "" : fmt::format("{} parts:\n", count);
    for (std::size_t k = 0; k < count; ++k) {
      const solid::LinePart& part = in_mesh.parts[k];
      const Told first = end(part.first, part.enters), last = end(part.last, part.leaves);
      Json json{{"first", first.json}, {"last", last.json}};
      if (part.is_next_near) json["is_next_near"] = true;
      fact.json["parts"].push_back(std::move(json));
      if (k >= most_told) continue;
      const bool is_point = part.first == part.last;
      fact.text += (k > 0 ? "\n" : "") +
                   (is_point ? "one point, " + first.text : fmt::format("from {}\nto {}", first.text, last.text)) +
                   (part.is_next_near ? "\n(and perhaps on to the next part, which is too near to look between)" : "");
    }
    if (count > most_told) fact.text += fmt::format("\nand {} more", count - most_told);
    return fact;
  }

  using MeshFlatPair::told;

  MeshLineMethod method_;
  std::vector<Point3> ends_;
  solid::LineLike line_;
  solid::MeshLine answer_;
};

}  // namespace

Report run_mesh_flat_pair(const PairCall& call, const SpaceInput& a, const SpaceInput& b, const PairFiles& files) {
  const bool is_mesh_a = a.bounded.has_value();
  const PlacedBody& of_mesh = *(is_mesh_a ? a : b).bounded;
  const PlacedFlat& flat = *(is_mesh_a ? b : a).flat;
  if (call.distance || !call.clearance.empty()) {
    throw Error(ErrorCode::bad_call, "is for objects that are bounded; leave it out",
                call.distance ? "--distance" : "--clearance");
  }
  const solid::Mesh mesh = mesh_of_placed(of_mesh);
  require_range(mesh, of_mesh.pose, is_mesh_a ? call.a : call.b);
  if (std::holds_alternative<solid::Plane>(flat.flat)) {
    const MeshPlaneMethod method =
        method_by(call.method, mesh_plane_methods, ", for a mesh that is not convex and a plane");
    return answer(MeshPlanePair(call, method, of_mesh, mesh, flat, is_mesh_a, files), files.talk);
  }
  const MeshLineMethod method = method_by(call.method, mesh_line_methods, ", for a mesh that is not convex and a line");
  return answer(MeshLinePair(call, method, of_mesh, mesh, flat, is_mesh_a, files), files.talk);
}

}  // namespace sunder::ask
