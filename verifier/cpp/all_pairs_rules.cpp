// The rules that what is said of many bodies has been proved pair by pair: docs/claims.md, "each_pair" and
// "each_clearance".
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <set>
#include <string>
#include <utility>

namespace sunder_verifier {
namespace {

IndexPair in_order(std::size_t i, std::size_t j) { return {std::min(i, j), std::max(i, j)}; }

// Looks at each two members of different groups, but for some: holds(i, j, is_listed), i < j.
template <class Holds>
void look_at_each(const char* rule, const Indices& members, const Groups& groups, const StatedContacts& except,
                  const StatedContacts& listed, const Holds& holds) {
  std::map<std::int64_t, std::vector<std::size_t>> of_group;
  for (std::size_t i = 0; i < members.size(); ++i) {
    of_group[groups.empty() ? static_cast<std::int64_t>(i) : groups[i]].push_back(i);
  }
  std::set<IndexPair> besides, left;
  for (const StatedContact& pair : except) besides.emplace(pair.i, pair.j);
  for (const StatedContact& contact : listed) left.emplace(contact.i, contact.j);
  const auto look_at = [&](std::size_t i, std::size_t j) {
    take_steps(4, 1, 1);
    const IndexPair pair = in_order(i, j);
    if (besides.contains(pair)) return;
    require(holds(pair.first, pair.second, left.erase(pair) > 0), rule,
            "of " + std::to_string(pair.first) + " and " + std::to_string(pair.second) + " this is not proved before");
  };
  for (auto first = of_group.begin(); first != of_group.end(); ++first) {
    for (auto second = std::next(first); second != of_group.end(); ++second) {
      for (const std::size_t i : first->second) {
        for (const std::size_t j : second->second) look_at(i, j);
      }
    }
  }
  require(left.empty(), rule, "a pair is listed that is not asked about");
}

// What statements before say of two members: of two bodies; of two meshes; of a mesh and a body.
class KnownOfMembers {
 public:
  // of_hulls: the verdict that carries over to meshes from bodies around them.
  KnownOfMembers(const Indices& members, const MeshMembers& as_meshes, const Proved& proved,
                 const std::array<std::string, 3>& questions, std::string of_hulls, const Number& least = {})
      : members_(members),
        as_meshes_(as_meshes),
        proved_(proved),
        questions_(questions),
        of_hulls_(std::move(of_hulls)),
        least_(least) {}

  bool is(std::size_t i, std::size_t j, const std::string& verdict) const {
    const std::size_t a = members_[i], b = members_[j];
    const MeshMember p = as_mesh(i), q = as_mesh(j);
    if ((!p.is_mesh && !q.is_mesh) || (verdict == of_hulls_ && is_around(p) && is_around(q))) {
      if (either_way(questions_[0], a, b, verdict)) return true;
    }
    if (p.is_mesh && q.is_mesh) return either_way(questions_[1], p.mesh, q.mesh, verdict);
    if (p.is_mesh) return proved_.holds(questions_[2], p.mesh, b, verdict, least_);
    return q.is_mesh && proved_.holds(questions_[2], q.mesh, a, verdict, least_);
  }
  bool is_one_of(std::size_t i, std::size_t j, std::initializer_list<const char*> verdicts) const {
    return std::any_of(verdicts.begin(), verdicts.end(), [&](const char* verdict) { return is(i, j, verdict); });
  }

 private:
  MeshMember as_mesh(std::size_t k) const { return as_meshes_.empty() ? MeshMember() : as_meshes_[k]; }
  bool is_around(const MeshMember& of) const {
    return !of.is_mesh || proved_.holds("around", of.mesh_base, of.body_base, "around");
  }
  bool either_way(const std::string& question, std::size_t a, std::size_t b, const std::string& verdict) const {
    return proved_.holds(question, a, b, verdict, least_) || proved_.holds(question, b, a, verdict, least_);
  }

  const Indices& members_;
  const MeshMembers& as_meshes_;
  const Proved& proved_;
  std::array<std::string, 3> questions_;
  std::string of_hulls_;
  Number least_;
};

void check_each_pair(const Indices& members, const Groups& groups, const StatedContacts& except,
                     const AllowedContacts& allowed, const MeshMembers& as_meshes, const Proved& proved,
                     const StatedContacts& contacts) {
  const KnownOfMembers known(members, as_meshes, proved, {"pair", "meshes", "mesh_body"}, "apart");
  const bool may_touch = allowed.shared_endpoint;
  look_at_each("each_pair", members, groups, except, contacts, [&](std::size_t i, std::size_t j, bool is_listed) {
    if (!is_listed) return known.is(i, j, "apart") || (may_touch && known.is(i, j, "touching"));
    return known.is(i, j, "overlapping") ||
           (!may_touch &&
            known.is_one_of(i, j, {"touching", "meet", "a_within", "b_within", "a_inside_b", "b_inside_a"}));
  });
}

void check_each_clearance(const Indices& members, const Groups& groups, const StatedContacts& except,
                          const Number& least, const MeshMembers& as_meshes, const Proved& proved,
                          const StatedContacts& nearer) {
  const KnownOfMembers known(members, as_meshes, proved, {"clearance", "mesh_clearance", "mesh_body_clearance"}, "kept",
                             least);
  look_at_each("each_clearance", members, groups, except, nearer, [&](std::size_t i, std::size_t j, bool is_listed) {
    return is_listed ? known.is_one_of(i, j, {"broken", "a_within", "b_within"}) : known.is(i, j, "kept");
  });
}

}  // namespace

const ClaimRows claims_of_all_pairs{
    {"each_pair", "", rule<check_each_pair>},
    {"each_clearance", "", rule<check_each_clearance>},
};

}  // namespace sunder_verifier
