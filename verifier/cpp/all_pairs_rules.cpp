// The rules that what is said of many bodies has been proved pair by pair: docs/claims.md, "each_pair" and
// "each_clearance".
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <array>
#include <initializer_list>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>

namespace sunder_verifier {
namespace {

IndexPair in_order(std::size_t i, std::size_t j) { return {std::min(i, j), std::max(i, j)}; }

// Looks at each two members of different groups, but for some: holds(i, j, is_listed), i < j.
template <class Holds>
void look_at_each(const char* rule, const Indices& members, const Groups& groups, const StatedContacts& except,
                  const StatedContacts& listed, std::uint32_t looks, const Holds& holds) {
  std::map<std::int64_t, std::vector<std::size_t>> of_group;
  for (std::size_t i = 0; i < members.size(); ++i) {
    of_group[groups.empty() ? static_cast<std::int64_t>(i) : groups[i]].push_back(i);
  }
  std::set<IndexPair> besides, left;
  for (const StatedContact& pair : except) besides.emplace(pair.i, pair.j);
  for (const StatedContact& contact : listed) left.emplace(contact.i, contact.j);
  const auto look_at = [&](std::size_t i, std::size_t j) {
    take_steps(looks, 1, 1);
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
  // of_hulls: the verdict that carries over to meshes from bodies, which hold them.
  KnownOfMembers(const char* rule, const Indices& members, const MeshMembers& as_meshes, const Proved& proved,
                 const std::array<std::string, 3>& questions, std::string_view of_hulls, const Number& least = {})
      : members_(members), as_meshes_(as_meshes), of_hulls_(of_hulls), least_(least) {
    for (std::size_t q = 0; q < 3; ++q) verdicts_[q] = proved.of(questions[q]);
    const ProvedVerdicts* const around = proved.of("around");
    for (std::size_t k = 0; k < as_meshes.size(); ++k) {
      const MeshMember& mesh = as_meshes[k];
      require(!mesh.is_mesh ||
                  (around != nullptr && around->contains({mesh.mesh_base, mesh.body_base, Number().n, Number().e})),
              rule, "that member " + std::to_string(k) + " holds its mesh is not proved before");
      are_some_ = are_some_ || mesh.is_mesh;
    }
  }

  std::uint32_t looks() const { return are_some_ ? 12 : 4; }

  bool is_one_of(std::size_t i, std::size_t j, std::initializer_list<std::string_view> words) const {
    const std::size_t a = members_[i], b = members_[j];
    const bool is_any = are_some_ && (as_meshes_[i].is_mesh || as_meshes_[j].is_mesh);
    if (const bool carries_over = std::find(words.begin(), words.end(), of_hulls_) != words.end();
        !is_any || carries_over) {
      const std::initializer_list<std::string_view> alone{of_hulls_};
      if (has(0, a, b, is_any ? alone : words) || has(0, b, a, is_any ? alone : words)) return true;
    }
    if (!is_any) return false;
    const MeshMember &p = as_meshes_[i], &q = as_meshes_[j];
    if (p.is_mesh && q.is_mesh) return has(1, p.mesh, q.mesh, words) || has(1, q.mesh, p.mesh, words);
    return p.is_mesh ? has(2, p.mesh, b, words) : has(2, q.mesh, a, words);
  }

 private:
  bool has(std::size_t question, std::size_t a, std::size_t b, std::initializer_list<std::string_view> words) const {
    if (verdicts_[question] == nullptr) return false;
    const auto found = verdicts_[question]->find({a, b, least_.n, least_.e});
    if (found == verdicts_[question]->end()) return false;
    return std::any_of(found->second.begin(), found->second.end(), [&](const std::string& verdict) {
      return std::find(words.begin(), words.end(), verdict) != words.end();
    });
  }

  const Indices& members_;
  const MeshMembers& as_meshes_;
  std::array<const ProvedVerdicts*, 3> verdicts_{};
  std::string_view of_hulls_;
  Number least_;
  bool are_some_ = false;
};

void check_each_pair(const Indices& members, const Groups& groups, const StatedContacts& except,
                     const AllowedContacts& allowed, const MeshMembers& as_meshes, const Proved& proved,
                     const StatedContacts& contacts) {
  const char* const rule = "each_pair";
  const KnownOfMembers known(rule, members, as_meshes, proved, {"pair", "meshes", "mesh_body"}, "apart");
  const bool may_touch = allowed.shared_endpoint;
  look_at_each(rule, members, groups, except, contacts, known.looks(),
               [&](std::size_t i, std::size_t j, bool is_listed) {
                 if (is_listed && may_touch) return known.is_one_of(i, j, {"overlapping"});
                 if (is_listed) {
                   return known.is_one_of(
                       i, j, {"meet", "touching", "overlapping", "a_within", "b_within", "a_inside_b", "b_inside_a"});
                 }
                 return may_touch ? known.is_one_of(i, j, {"apart", "touching"}) : known.is_one_of(i, j, {"apart"});
               });
}

void check_each_clearance(const Indices& members, const Groups& groups, const StatedContacts& except,
                          const Number& least, const MeshMembers& as_meshes, const Proved& proved,
                          const StatedContacts& nearer) {
  const char* const rule = "each_clearance";
  const KnownOfMembers known(rule, members, as_meshes, proved, {"clearance", "mesh_clearance", "mesh_body_clearance"},
                             "kept", least);
  look_at_each(rule, members, groups, except, nearer, known.looks(), [&](std::size_t i, std::size_t j, bool is_listed) {
    return is_listed ? known.is_one_of(i, j, {"broken", "a_within", "b_within"}) : known.is_one_of(i, j, {"kept"});
  });
}

}  // namespace

const ClaimRows claims_of_all_pairs{
    {"each_pair", "", rule<check_each_pair>},
    {"each_clearance", "", rule<check_each_clearance>},
};

}  // namespace sunder_verifier
