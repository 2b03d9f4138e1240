#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>
#include <sunder/scene/parts_as_meshes.h>
#include <sunder/scene/scene.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>
#include <sunder/solid/represent/of.h>

#include <algorithm>
#include <utility>

namespace sunder::scene {

namespace {

class Scene {
 public:
  Scene(std::span<const Body> bodies, const Question& question)
      : bodies_(bodies), question_(question), members_(bodies, question.allowed, question.allowed_alone) {
    for (std::uint32_t i = 0; i < members_.size(); ++i) boxes_.push_back(box_of(members_.part(bodies, i)));
  }

  Answer answer() {
    if (question_.every_pair) {
      for (std::uint32_t i = 0; i < members_.size(); ++i) {
        for (std::uint32_t j = i + 1; j < members_.size(); ++j) look_at(i, j);
      }
    } else {
      for (const auto& [i, j] : meeting_boxes(std::span<const solid::WorldBox>(boxes_))) look_at(i, j);
    }
    std::sort(answer_.pairs.begin(), answer_.pairs.end(), is_listed_before);
    members_.complete(answer_.counts);
    return std::move(answer_);
  }

 private:
  // Requires i < j; members are in the order of the bodies.
  void look_at(std::uint32_t i, std::uint32_t j) {
    if (!members_.are_asked_about(i, j)) return;
    PartPair pair = members_.pair(i, j);
    const Part &a = members_.part(bodies_, i), &b = members_.part(bodies_, j);
    if (auto apart = apart_by_boxes(a.shape, boxes_[i], b.shape, boxes_[j])) {
      pair.by_boxes = true;
      pair.answer.evidence = *std::move(apart);
    } else {
      pair.answer = answer_of(a, b, question_);
      look_closer(pair, a, b);
      count_answer(pair, a, b, question_, answer_.counts);
    }
    answer_.pairs.push_back(std::move(pair));
  }

  std::span<const Body> bodies_;
  const Question& question_;
  Members members_;
  std::vector<solid::WorldBox> boxes_;
  Answer answer_;
};

}  // namespace

Cost PartPair::cost() const {
  Cost sum = answer.cost;
  if (!meshes) return sum;
  const Cost& of_meshes = meshes->cost();
  sum.probes += of_meshes.probes;
  sum.iterations += of_meshes.iterations;
  sum.exact += of_meshes.exact;
  sum.proposals += of_meshes.proposals;
  return sum;
}

const solid::Mesh* mesh_of(const Part& part) {
  if (part.mesh != nullptr) return part.mesh.get();
  return part.shape.is_polyhedron() ? &solid::represent::of<solid::HullMesh>(part.shape.core()).mesh : nullptr;
}

std::string part_name(const Body& body, std::uint32_t part) {
  SUNDER_REQUIRE(part < body.parts.size());
  return body.parts.size() == 1 ? body.name : body.name + "/" + body.parts[part].name;
}

Point3 rounded_common_point(const PartPair& pair, const Part& a, const Part& b) {
  SUNDER_REQUIRE(pair.meet());
  if (pair.meshes) return PartsAsMeshes::of(a, b)->rounded_common_point(*pair.meshes);
  return solid::rounded_point_of(solid::PlacedRound(a.shape, a.pose), solid::PlacedRound(b.shape, b.pose),
                                 pair.answer.evidence);
}

Answer meeting_pairs(std::span<const Body> bodies, const Question& question) {
  return Scene(bodies, question).answer();
}

}  // namespace sunder::scene
