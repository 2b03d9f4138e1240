#include <sunder/base/contract.h>
#include <sunder/near/box_sweep.h>
#include <sunder/scene/scene.h>

#include <algorithm>
#include <tuple>

namespace sunder::scene {

namespace {

using BodyPair = std::array<std::uint32_t, 2>;

// The pairs sorted, each once and lower index first, none of a body with itself.
std::vector<BodyPair> normalized(std::vector<BodyPair> pairs) {
  for (BodyPair& pair : pairs) std::sort(pair.begin(), pair.end());
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());
  std::erase_if(pairs, [](const BodyPair& pair) { return pair[0] == pair[1]; });
  return pairs;
}

struct Member {
  std::uint32_t body, part;
};

class Scene {
 public:
  Scene(std::span<const Body> bodies, const Question& question)
      : bodies_(bodies), question_(question), allowed_(normalized(question.allowed)) {
    SUNDER_REQUIRE(std::all_of(allowed_.begin(), allowed_.end(),
                               [&](const BodyPair& pair) { return std::max(pair[0], pair[1]) < bodies.size(); }));
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      for (std::uint32_t p = 0; p < bodies[b].parts.size(); ++p) {
        const Part& part = bodies[b].parts[p];
        members_.push_back({b, p});
        boxes_.push_back(world_box(solid::Placed(part.shape, part.pose)));
      }
    }
  }

  Answer answer() {
    if (question_.every_pair) {
      for (std::uint32_t i = 0; i < members_.size(); ++i) {
        for (std::uint32_t j = i + 1; j < members_.size(); ++j) look_at(i, j);
      }
    } else {
      for (const auto& [i, j] : meeting_boxes(std::span<const WorldBox>(boxes_))) look_at(i, j);
    }
    std::sort(answer_.pairs.begin(), answer_.pairs.end(), [](const PartPair& p, const PartPair& q) {
      return std::tie(p.body_a, p.body_b, p.part_a, p.part_b) < std::tie(q.body_a, q.body_b, q.part_a, q.part_b);
    });
    count();
    return std::move(answer_);
  }

 private:
  // Requires i < j; members are in the order of the bodies.
  void look_at(std::uint32_t i, std::uint32_t j) {
    const Member a = members_[i], b = members_[j];
    if (a.body == b.body || std::binary_search(allowed_.begin(), allowed_.end(), BodyPair{a.body, b.body})) return;
    PartPair pair;
    pair.body_a = a.body;
    pair.body_b = b.body;
    pair.part_a = a.part;
    pair.part_b = b.part;
    if (const auto certificate = apart_by_boxes(boxes_[i], boxes_[j])) {
      pair.by_boxes = true;
      pair.answer.evidence = *certificate;
    } else {
      ask(pair);
    }
    answer_.pairs.push_back(std::move(pair));
  }

  void ask(PartPair& pair) {
    const Part& a = bodies_[pair.body_a].parts[pair.part_a];
    const Part& b = bodies_[pair.body_b].parts[pair.part_b];
    pair.answer = question_.method(a.shape, a.pose, b.shape, b.pose);
    ++answer_.counts.by_method;
    if (!pair.answer.meet()) return;
    ++answer_.counts.meeting;
    pair.counts = true;
    if (!question_.contacts && !question_.touching_allowed) return;
    pair.contact = solid::polyhedron_polyhedron_contact(a.shape, a.pose, b.shape, b.pose);
    if (question_.touching_allowed && pair.contact == Contact::touching) {
      pair.counts = false;
      ++answer_.counts.touching_only;
    }
  }

  void count() {
    const auto pairs_of = [](std::uint64_t n) { return n < 2 ? 0 : n * (n - 1) / 2; };
    Counts& c = answer_.counts;
    c.parts = members_.size();
    c.pairs = pairs_of(members_.size());
    for (const Body& body : bodies_) c.pairs -= pairs_of(body.parts.size());
    for (const BodyPair& pair : allowed_) {
      c.allowed += std::uint64_t{bodies_[pair[0]].parts.size()} * bodies_[pair[1]].parts.size();
    }
    c.by_boxes = c.pairs - c.allowed - c.by_method;
  }

  std::span<const Body> bodies_;
  const Question& question_;
  std::vector<BodyPair> allowed_;
  std::vector<Member> members_;
  std::vector<WorldBox> boxes_;
  Answer answer_;
};

}  // namespace

std::string part_name(const Body& body, std::uint32_t part) {
  SUNDER_REQUIRE(part < body.parts.size());
  return body.parts.size() == 1 ? body.name : body.name + "/" + body.parts[part].name;
}

Answer meeting_pairs(std::span<const Body> bodies, const Question& question) {
  return Scene(bodies, question).answer();
}

}  // namespace sunder::scene
