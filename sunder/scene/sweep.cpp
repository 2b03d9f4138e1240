#include <sunder/base/contract.h>
#include <sunder/near/box_tree.h>
#include <sunder/scene/members.h>
#include <sunder/scene/part_questions.h>
#include <sunder/scene/parts_as_meshes.h>
#include <sunder/scene/sweep.h>
#include <sunder/solid/mesh/mesh_mesh_claims.h>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace sunder::scene {

namespace {

class Sweep {
 public:
  Sweep(std::span<const Body> begin, std::span<const Body> end, const Question& question)
      : bodies_{begin, end}, members_(begin, question.allowed), every_pair_(question.every_pair) {
    for (std::uint32_t i = 0; i < members_.size(); ++i) {
      const Part &first = part(i, 0), &last = part(i, 1);
      for (const Part* at : {&first, &last}) require_rigid(at->shape, at->pose);
      goes_straight_.push_back(is_translation(first.pose, last.pose));
      for (std::size_t k = 0; k < 2; ++k) boxes_[k].push_back(rough_box_of(part(i, k)));
    }
  }

  SweptAnswer answer() {
    if (every_pair_) {
      for (std::uint32_t j = 0; j < members_.size(); ++j) {
        for (std::uint32_t i = 0; i < j; ++i) {
          if (members_.are_asked_about(i, j)) look_at(i, j);
        }
      }
    } else {
      look_at_near();
    }
    SweptCounts& counts = answer_.counts;
    const std::uint64_t all_the_way = members_.asked_about(goes_straight_);
    counts.by_boxes = all_the_way - counts.by_method;
    counts.at_ends_only = members_.asked_about(std::vector<bool>(members_.size(), true)) - all_the_way;
    std::sort(answer_.pairs.begin(), answer_.pairs.end(), [](const SweptPair& p, const SweptPair& q) {
      return std::array{p.body_a, p.body_b, p.part_a, p.part_b} < std::array{q.body_a, q.body_b, q.part_a, q.part_b};
    });
    Counts all;
    members_.complete(all);
    counts.pairs = all.pairs;
    counts.allowed = all.allowed;
    return std::move(answer_);
  }

 private:
  const Part& part(std::uint32_t i, std::size_t at) const { return members_.part(bodies_[at], i); }

  // Of the pairs that are asked about, all whose boxes meet at one end or on the way.
  void look_at_near() {
    std::vector<Box3> ways;
    for (std::uint32_t i = 0; i < members_.size(); ++i) ways.push_back(hull(boxes_[0][i], boxes_[1][i]));
    const std::vector<std::uint32_t> groups = members_.bodies();
    const BoxTree tree(ways, groups);
    for (const std::uint32_t i : tree.order()) {
      answer_.counts.looks += tree.for_each_meeting(ways[i], groups[i], [&](std::uint32_t j) {
        if (i < j && members_.are_asked_about(i, j)) look_at(i, j);
      });
    }
  }

  void look_at(std::uint32_t i, std::uint32_t j) {
    if (!goes_straight_[i] || !goes_straight_[j]) return look_at_ends(i, j);
    // All of a way that is straight is in the hull of both ends, and so in the box around their boxes.
    const Box3 of_a = hull(boxes_[0][i], boxes_[1][i]), of_b = hull(boxes_[0][j], boxes_[1][j]);
    if (!meet(of_a, of_b)) {
      if (every_pair_) list_apart(i, j, axis_between(of_a, of_b));
      return;
    }
    ++answer_.counts.by_method;
    const solid::RoundBody &a = part(i, 0).shape, &b = part(j, 0).shape;
    const solid::Translation way_a(part(i, 0).pose, part(i, 1).pose), way_b(part(j, 0).pose, part(j, 1).pose);
    const solid::SweepAnswer swept = round_round_sweep(a, way_a, b, way_b);
    if (swept.verdict() == Verdict::apart) {
      if (every_pair_) list_apart(i, j, direction_of(a, way_a, b, way_b, swept));
      return;
    }
    if (look_at_meshes(i, j, way_a, way_b)) return;
    SweptPair& pair = list(i, j);
    if (swept.undecided()) {
      ++answer_.counts.undecided;
      return;
    }
    ++answer_.counts.meeting;
    pair.evidence = MeetOnTheWay{
        std::make_shared<const solid::RoundFirstContact>(round_round_first_contact(a, way_a, b, way_b, swept))};
  }

  // As meshes, if they are to be asked about so. Returns whether they are.
  bool look_at_meshes(std::uint32_t i, std::uint32_t j, const solid::Translation& way_a,
                      const solid::Translation& way_b) {
    const auto begin = PartsAsMeshes::of(part(i, 0), part(j, 0)), end = PartsAsMeshes::of(part(i, 1), part(j, 1));
    if (!begin || !end || !begin->are_two()) return false;
    const solid::Mesh &a = *mesh_of(part(i, 0)), &b = *mesh_of(part(j, 0));
    solid::MeshMotion motion = mesh_motion(a, way_a, b, way_b);
    if (motion.meet()) {
      ++answer_.counts.meeting;
      const solid::SweepContact* const contact = contact_on_the_way(motion);
      const Point3 point = contact != nullptr
                               ? nearest(contact->point.at)
                               : rounded_point_of(a, way_a.begin(), b, way_b.begin(), evidence_at_start(motion));
      list(i, j).evidence = MeshesMeetOnTheWay{std::make_shared<const solid::MeshMotion>(std::move(motion)), point};
      return true;
    }
    if (!begin->are_closed()) ++answer_.counts.surfaces_alone;
    if (every_pair_) list(i, j).evidence = MeshesApartOnTheWay{};
    return true;
  }

  void look_at_ends(std::uint32_t i, std::uint32_t j) {
    bool is_undecided = false;
    for (std::size_t at = 0; at < 2; ++at) {
      if (!meet(boxes_[at][i], boxes_[at][j])) continue;
      PartPair found = members_.pair(i, j);
      const Part &a = part(i, at), &b = part(j, at);
      found.answer = answer_of(a, b, {});
      look_closer(found, a, b);
      is_undecided = is_undecided || found.undecided();
      if (!found.meet()) continue;
      ++answer_.counts.meeting;
      list(i, j).evidence = MeetAtAnEnd{static_cast<double>(at), std::make_shared<const PartPair>(std::move(found))};
      return;
    }
    if (!is_undecided) return;
    ++answer_.counts.undecided;
    list(i, j).evidence = UndecidedPair{.all_the_way = false};
  }

  SweptPair& list(std::uint32_t i, std::uint32_t j) {
    const PartPair named = members_.pair(i, j);
    SweptPair& pair = answer_.pairs.emplace_back();
    pair.body_a = named.body_a, pair.body_b = named.body_b;
    pair.part_a = named.part_a, pair.part_b = named.part_b;
    return pair;
  }

  void list_apart(std::uint32_t i, std::uint32_t j, std::array<Dyadic, 3> direction) {
    list(i, j).evidence = ApartOnTheWay{std::make_shared<const std::array<Dyadic, 3>>(std::move(direction))};
  }

  // From A to B. Requires boxes that are apart.
  static std::array<Dyadic, 3> axis_between(const Box3& a, const Box3& b) {
    std::array<Dyadic, 3> axis{Dyadic(0.0), Dyadic(0.0), Dyadic(0.0)};
    for (std::size_t k = 0; k < 3; ++k) {
      if (a.high[k] < b.low[k] || b.high[k] < a.low[k]) {
        axis[k] = Dyadic(a.high[k] < b.low[k] ? 1.0 : -1.0);
        break;
      }
    }
    return axis;
  }

  std::array<std::span<const Body>, 2> bodies_;
  Members members_;
  bool every_pair_;
  std::vector<bool> goes_straight_;
  std::array<std::vector<Box3>, 2> boxes_;  // of each part at both ends
  SweptAnswer answer_;
};

}  // namespace

bool SweptPair::is_of_meshes() const {
  if (const auto* end = std::get_if<MeetAtAnEnd>(&evidence)) return end->pair->meshes != nullptr;
  return std::holds_alternative<MeshesMeetOnTheWay>(evidence) || std::holds_alternative<MeshesApartOnTheWay>(evidence);
}

bool SweptPair::all_the_way() const {
  if (const auto* open = std::get_if<UndecidedPair>(&evidence)) return open->all_the_way;
  return !std::holds_alternative<MeetAtAnEnd>(evidence);
}

Interval SweptPair::time() const {
  SUNDER_REQUIRE(meet());
  if (const auto* end = std::get_if<MeetAtAnEnd>(&evidence)) return {end->time, end->time};
  if (const auto* meshes = std::get_if<MeshesMeetOnTheWay>(&evidence)) {
    return first_time_of(*meshes->motion).enclosure();
  }
  return std::get<MeetOnTheWay>(evidence).first->time;
}

SweptAnswer meeting_on_the_way(std::span<const Body> begin, std::span<const Body> end, const Question& question) {
  SUNDER_REQUIRE(begin.size() == end.size());
  return Sweep(begin, end, question).answer();
}

}  // namespace sunder::scene
