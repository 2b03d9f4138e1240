// Sets of circles: discs_any and the lists of contacts against their scans, under every rule, with groups; and what
// proves them, against the checker.
#include <tests/support/allowed_rules.h>
#include <tests/support/disc_sets.h>
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/discs/discs_all.h>
#include <sunder/planar/discs/discs_any.h>
#include <sunder/planar/discs/discs_any_claims.h>
#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iterator>
#include <map>
#include <string>
#include <vector>

namespace sunder::tests {
namespace {

using planar::DiscContact;
using planar::Discs;
using planar::DiscsAnswer;
using planar::DiscsContact;

// --- Tests
// -------------------------------------------------------------------------------------------------------------

void expect_true_discs(const DiscsAnswer& answer, const DiscsAnswer& scan, const Discs& circles,
                       const SetOptions& options) {
  ASSERT_EQ(answer.meet(), scan.meet());
  if (!answer.meet()) return;
  ASSERT_LT(answer.found->i, answer.found->j);
  ASSERT_LT(answer.found->j, circles.size());
  ASSERT_EQ(planar::disc_disc(circles[answer.found->i], circles[answer.found->j]), answer.found->kind);
  ASSERT_TRUE(planar::counts(answer.found->kind, options.allowed));
  ASSERT_FALSE(may_meet(options.groups, answer.found->i, answer.found->j));
}

bool is_accepted(const std::string& text) { return sunder_verifier::verify_text(text, "proof").accepted(); }

struct DiscRates {
  int cases = 0;
  std::array<int, 3> meets{};
};

TEST(DiscsDifferential, AnyAgreesWithTheScan) {
  const int count = scaled_count(20000);
  DiscSets sets(chosen_seed(20261128));
  std::map<DiscFamily, DiscRates> rates;
  std::map<DiscContact, int> kinds;
  for (int i = 0; i < count; ++i) {
    const std::vector<Disc> set = sets.next();
    const Discs circles(set);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < set.size(); ++k) groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
    DiscRates& rate = rates[sets.family()];
    ++rate.cases;
    for (std::size_t r = 0; r < allowed_rules.size(); ++r) {
      for (const bool grouped : {false, true}) {
        SetOptions options{allowed_rules[r], {}, nullptr};
        if (grouped) options.groups = groups;
        const DiscsAnswer scan = planar::discs_any_by_scan(circles, options);
        if (!grouped) {
          rate.meets[r] += scan.meet();
          ++kinds[scan.found.value_or(planar::DiscsContact{}).kind];
        }
        for (const auto method : {&planar::discs_any_by_sweep, &planar::discs_any_by_grid, &planar::discs_any}) {
          const DiscsAnswer answer = method(circles, options);
          ASSERT_NO_FATAL_FAILURE(expect_true_discs(answer, scan, circles, options))
              << i << " " << disc_family_names[static_cast<std::size_t>(sets.family())] << " rule " << r;
        }
        if (i % 8 == 0) {  // proved
          ASSERT_TRUE(is_accepted(planar::certificate_text(circles, allowed_rules[r], scan, options.groups))) << i;
        }
      }
    }
  }
  std::printf("%-10s %8s %10s %12s\n", "family", "cases", "some meet", "touches not");
  for (const auto& [family, rate] : rates) {
    std::printf("%-10s %8d %10d %12d\n", disc_family_names[static_cast<std::size_t>(family)], rate.cases, rate.meets[0],
                rate.meets[2]);
    if (count < 5000) continue;  // too few for the rates below
    for (const std::size_t r : {std::size_t{0}, std::size_t{2}}) {
      EXPECT_GT(rate.meets[r], rate.cases / 50) << disc_family_names[static_cast<std::size_t>(family)] << " " << r;
      EXPECT_LT(rate.meets[r], rate.cases - rate.cases / 50)
          << disc_family_names[static_cast<std::size_t>(family)] << " " << r;
    }
  }
  if (count < 5000) return;
  for (const DiscContact kind :
       {DiscContact::none, DiscContact::touching, DiscContact::overlapping, DiscContact::inside}) {
    EXPECT_GT(kinds[kind], count / 50) << planar::name_of(kind);
  }
}

// The same pairs and kinds, each once.
TEST(DiscsDifferential, ListsAgreeWithTheScan) {
  const int count = scaled_count(10000);
  DiscSets sets(chosen_seed(20261129));
  std::uint64_t contacts = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Disc> set = sets.next();
    const Discs circles(set);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < set.size(); ++k) groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
    SetOptions options{allowed_rules[static_cast<std::size_t>(i % 3)], {}, nullptr};
    if (i % 2 == 0) options.groups = groups;
    const auto listed = [&](planar::DiscsMethod* method) {
      std::vector<DiscsContact> list;
      method(circles, options, [&](const DiscsContact& contact) {
        list.push_back(contact);
        return true;
      });
      std::sort(list.begin(), list.end());
      return list;
    };
    const std::vector<DiscsContact> truth = listed(&planar::discs_all_by_scan);
    ASSERT_TRUE(listed(&planar::discs_all_by_sweep) == truth) << i;
    ASSERT_TRUE(listed(&planar::discs_all_by_grid) == truth) << i;
    ASSERT_TRUE(listed(&planar::discs_visit) == truth) << i;
    ASSERT_EQ(planar::discs_count(circles, options).count, truth.size());
    ASSERT_EQ(planar::discs_all(circles, options).found.size(), truth.size());
    contacts += truth.size();
    if (i % 4 > 1 || set.empty()) continue;
    const SetOptions& o = options;  // proved: the list, and its length; and nothing else
    planar::DiscsAllAnswer all{truth, {}};
    std::reverse(all.found.begin(), all.found.end());
    ASSERT_TRUE(is_accepted(planar::certificate_text(circles, o.allowed, all, o.groups))) << i;
    ASSERT_TRUE(is_accepted(certificate_text(circles, o.allowed, CountAnswer<>{truth.size(), {}}, o.groups)));
    ASSERT_FALSE(is_accepted(certificate_text(circles, o.allowed, CountAnswer<>{truth.size() + 1, {}}, o.groups)));
    if (truth.empty()) continue;
    all.found.erase(all.found.begin() + static_cast<std::ptrdiff_t>(sets.random().below(truth.size())));
    ASSERT_FALSE(is_accepted(planar::certificate_text(circles, o.allowed, all, o.groups))) << i;
  }
  EXPECT_GT(contacts, static_cast<std::uint64_t>(count >= 5000 ? count / 2 : 0));
}

// Reflected, turned, scaled by a power of two, order changed: the same verdict and count.
TEST(DiscsDifferential, SymmetriesKeepTheVerdict) {
  const int count = scaled_count(4000);
  DiscSets sets(chosen_seed(12));
  int meets = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Disc> set = sets.next();
    const SetOptions options{allowed_rules[static_cast<std::size_t>(i % 3)], {}, nullptr};
    const auto contacts = [&](auto&& changed) {
      std::vector<Disc> circles;
      for (const Disc& c : set) circles.push_back(changed(c));
      const std::uint64_t found = planar::discs_count(Discs(circles), options).count;
      EXPECT_EQ(planar::discs_any(Discs(circles), options).meet(), found > 0) << i;
      return found;
    };
    const std::uint64_t truth = contacts([](const Disc& c) { return c; });
    meets += truth > 0;
    ASSERT_EQ(contacts([](const Disc& c) { return Disc{{-c.center.x, c.center.y}, c.radius}; }), truth) << i;
    ASSERT_EQ(contacts([](const Disc& c) { return Disc{{c.center.x, -c.center.y}, c.radius}; }), truth) << i;
    ASSERT_EQ(contacts([](const Disc& c) { return Disc{{c.center.y, c.center.x}, c.radius}; }), truth) << i;
    if (sets.family() != DiscFamily::any_scale) {
      ASSERT_EQ(contacts([](const Disc& c) {
                  return Disc{{0x1p-900 * c.center.x, 0x1p-900 * c.center.y}, 0x1p-900 * c.radius};
                }),
                truth)
          << i;
    }
    const std::vector<Disc> reversed(set.rbegin(), set.rend());
    ASSERT_EQ(planar::discs_count(Discs(reversed), options).count, truth) << i;
  }
  if (count < 1000) return;
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count - count / 5);
}

}  // namespace
}  // namespace sunder::tests
