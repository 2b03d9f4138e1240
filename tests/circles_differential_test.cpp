// Sets of circles: discs_any and the lists of contacts against their scans, under every rule, with groups; and what
// proves them, against the checker.
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/set/discs_all.h>
#include <sunder/planar/set/discs_any.h>
#include <sunder/planar/set/discs_any_json.h>
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

constexpr std::array<Allowed, 3> rules{Allowed::nothing, Allowed::shared_endpoint, Allowed::touch};

// --- Sets: small and nasty -------------------------------------------------------------------------------------------

enum class Family : int {
  grid,       // integer centres and radii in a small square: every contact is common
  sparse,     // small discs in the unit square, few of which meet
  packed,     // touching discs in rows, with points and small ones between, now and then one too large
  last_bit,   // each touches one before it, or misses it by a few bits
  nested,     // about few centres: equal ones, rings, touching from inside
  upright,    // with equal first or last abscissas, or heights
  any_scale,  // 1e-300 to 1e300, mixed; or integers at such a scale
  points,     // radius zero, on integers, with few discs
  crowd,      // more, many of them in one place
};
constexpr int family_count = 9;
constexpr std::array<const char*, family_count> family_names{"grid",    "sparse",    "packed", "last_bit", "nested",
                                                             "upright", "any_scale", "points", "crowd"};

class CircleSets {
 public:
  explicit CircleSets(std::uint64_t seed) : random_(seed) {}
  Random& random() { return random_; }

  Family family() const { return family_; }
  std::vector<Disc> next() {
    family_ = static_cast<Family>(turn_++ % family_count);
    if (family_ == Family::crowd && random_.below(16) != 0) family_ = Family::sparse;
    std::vector<Disc> set = of_family();
    for (std::size_t k = set.size(); k > 1; --k) std::swap(set[k - 1], set[random_.below(k)]);
    if (!set.empty() && random_.below(40) == 0) set.push_back(set[random_.below(set.size())]);
    return set;
  }

 private:
  double integer(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }
  Disc on_integers(std::int64_t side, std::int64_t radius) {
    const double x = integer(0, side), y = integer(0, side);
    return {{x, y}, integer(0, radius)};
  }
  Disc in_square(double x, double y, double size, double radius) {
    const double u = random_.unit(), v = random_.unit();
    return {{x + size * u, y + size * v}, radius * random_.unit()};
  }

  std::vector<Disc> of_family() {
    std::vector<Disc> set;
    const std::int64_t count = random_.between(2, 14);
    const auto repeat = [&](std::int64_t times, const auto& make) {
      for (std::int64_t k = 0; k < times; ++k) set.push_back(make());
    };
    switch (family_) {
      case Family::grid: {
        const std::int64_t side = random_.between(3, 30);
        repeat(std::min<std::int64_t>(count, 8), [&] { return on_integers(side, 3); });
        break;
      }
      case Family::sparse: repeat(2 * count, [&] { return in_square(0, 0, 1, 0.05); }); break;
      case Family::packed: pack(set); break;
      case Family::last_bit: touch(set, random_.between(2, 7)); break;
      case Family::nested: nest(set, random_.between(2, 4)); break;
      case Family::upright: {
        const double at = integer(-3, 3), step = integer(2, 6), how = integer(0, 2);
        for (std::int64_t k = 0; k < count / 2 + 1; ++k) {
          const double r = integer(0, 2), y = step * static_cast<double>(k) + integer(0, 1);
          set.push_back(how == 0 ? Disc{{at - r, y}, r} : how == 1 ? Disc{{at + r, y}, r} : Disc{{y, at}, r});
        }
        break;
      }
      case Family::any_scale: {
        const double unit = std::ldexp(1, static_cast<int>(random_.between(-1074, 1015)));
        if (random_.below(2) == 0) {
          repeat(random_.between(2, 4), [&] {
            const Disc c = on_integers(8, 3);
            return Disc{{unit * c.center.x, unit * c.center.y}, unit * c.radius};
          });
        } else {
          const auto any = [&](double x) { return std::ldexp(x, static_cast<int>(random_.between(-1074, 1022))); };
          repeat(random_.between(2, 3), [&] {
            const double x = any(random_.uniform(-2, 2)), y = any(random_.uniform(-2, 2));
            return Disc{{x, y}, random_.below(3) == 0 ? 0 : any(random_.unit())};
          });
        }
        break;
      }
      case Family::points: {
        repeat(random_.between(2, 9), [&] { return on_integers(9, 0); });
        if (random_.below(2) == 0) set.push_back(on_integers(9, 2));
        break;
      }
      case Family::crowd: {
        repeat(200, [&] { return in_square(0, 0, 1, 0.0015); });
        const double x = random_.unit(), y = random_.unit();
        repeat(75, [&] { return in_square(x, y, 0.01, 0.00004); });
        break;
      }
    }
    return set;
  }

  void pack(std::vector<Disc>& set) {
    const std::int64_t side = random_.between(2, 4), odd = random_.between(0, 1);
    for (std::int64_t k = 0; k < side * side; ++k) {
      const double x = 2 * static_cast<double>(k % side), y = 2 * static_cast<double>(k / side);
      const std::uint64_t what = random_.below(6);
      if (what == 0) continue;
      if (what == 1) set.push_back({{x + 1, y}, 0});          // between two
      if (what == 2) set.push_back({{x + 1, y + 1}, 0.375});  // in the gap
      set.push_back({{x, y}, what == 3 ? 0.5 : 1});
    }
    if (odd != 0 && !set.empty()) set[random_.below(set.size())].radius += random_.below(2) == 0 ? 0x1p-40 : 0.5;
  }

  void touch(std::vector<Disc>& set, std::int64_t count) {
    set.push_back(in_square(0, 0, 1, 0.3));
    for (std::int64_t k = 1; k < count; ++k) {
      Disc c = in_square(0, 0, 3, 0);
      const Disc& other = set[random_.below(set.size())];
      const double apart = std::hypot(c.center.x - other.center.x, c.center.y - other.center.y);
      c.radius = std::fabs(apart - other.radius);
      for (std::int64_t bits = random_.between(-2, 2); bits != 0; bits += bits < 0 ? 1 : -1) {
        c.radius = std::nextafter(c.radius, bits < 0 ? 0 : 9);
      }
      const auto meets_others = [&] {
        return std::any_of(set.begin(), set.end(),
                           [&](const Disc& d) { return &d != &other && planar::disc_disc(c, d) != DiscContact::none; });
      };
      if (random_.below(8) == 0 || !meets_others()) set.push_back(c);
    }
  }

  void nest(std::vector<Disc>& set, std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
      const Disc around{{20.0 * static_cast<double>(k), integer(-2, 2)}, integer(1, 9)};
      set.push_back(around);
      if (random_.below(3) != 0) continue;
      const double r = integer(0, 4), along = random_.below(2) == 0 ? around.radius - r : integer(-3, 3);
      set.push_back({{around.center.x + along, around.center.y}, r});
    }
  }

  Random random_;
  int turn_ = 0;
  Family family_ = Family::grid;
};

// --- Tests
// -------------------------------------------------------------------------------------------------------------

void expect_truth(const DiscsAnswer& answer, const DiscsAnswer& scan, const Discs& circles, const SetOptions& options) {
  ASSERT_EQ(answer.meet(), scan.meet());
  if (!answer.meet()) return;
  ASSERT_LT(answer.found->i, answer.found->j);
  ASSERT_LT(answer.found->j, circles.size());
  ASSERT_EQ(planar::disc_disc(circles[answer.found->i], circles[answer.found->j]), answer.found->kind);
  ASSERT_TRUE(planar::counts(answer.found->kind, options.allowed));
  ASSERT_FALSE(may_meet(options.groups, answer.found->i, answer.found->j));
}

bool is_accepted(const std::string& text) { return sunder_verifier::verify_text(text, "proof").accepted(); }

struct Rates {
  int cases = 0;
  std::array<int, 3> meets{};
};

TEST(DiscsDifferential, AnyAgreesWithTheScan) {
  const int count = scaled_count(20000);
  CircleSets sets(chosen_seed(20261128));
  std::map<Family, Rates> rates;
  std::map<DiscContact, int> kinds;
  for (int i = 0; i < count; ++i) {
    const std::vector<Disc> set = sets.next();
    const Discs circles(set);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < set.size(); ++k) groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
    Rates& rate = rates[sets.family()];
    ++rate.cases;
    for (std::size_t r = 0; r < rules.size(); ++r) {
      for (const bool grouped : {false, true}) {
        SetOptions options{rules[r], {}, nullptr};
        if (grouped) options.groups = groups;
        const DiscsAnswer scan = planar::discs_any_by_scan(circles, options);
        if (!grouped) {
          rate.meets[r] += scan.meet();
          ++kinds[scan.found.value_or(planar::DiscsContact{}).kind];
        }
        for (const auto method : {&planar::discs_any_by_sweep, &planar::discs_any_by_grid, &planar::discs_any}) {
          const DiscsAnswer answer = method(circles, options);
          ASSERT_NO_FATAL_FAILURE(expect_truth(answer, scan, circles, options))
              << i << " " << family_names[static_cast<std::size_t>(sets.family())] << " rule " << r;
        }
        if (i % 8 == 0) {  // proved
          ASSERT_TRUE(is_accepted(planar::certificate_text(circles, rules[r], scan, options.groups))) << i;
        }
      }
    }
  }
  std::printf("%-10s %8s %10s %12s\n", "family", "cases", "some meet", "touches not");
  for (const auto& [family, rate] : rates) {
    std::printf("%-10s %8d %10d %12d\n", family_names[static_cast<std::size_t>(family)], rate.cases, rate.meets[0],
                rate.meets[2]);
    if (count < 5000) continue;  // too few for the rates below
    for (const std::size_t r : {std::size_t{0}, std::size_t{2}}) {
      EXPECT_GT(rate.meets[r], rate.cases / 50) << family_names[static_cast<std::size_t>(family)] << " " << r;
      EXPECT_LT(rate.meets[r], rate.cases - rate.cases / 50)
          << family_names[static_cast<std::size_t>(family)] << " " << r;
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
  CircleSets sets(chosen_seed(20261129));
  std::uint64_t contacts = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Disc> set = sets.next();
    const Discs circles(set);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < set.size(); ++k) groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
    SetOptions options{rules[static_cast<std::size_t>(i % 3)], {}, nullptr};
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
    ASSERT_EQ(planar::discs_all(circles, options).contacts.size(), truth.size());
    contacts += truth.size();
    if (i % 4 > 1) continue;
    const SetOptions& o = options;  // proved: the list, and its length; and nothing else
    planar::DiscsAllAnswer all{truth, {}};
    std::reverse(all.contacts.begin(), all.contacts.end());
    ASSERT_TRUE(is_accepted(planar::certificate_text(circles, o.allowed, all, o.groups))) << i;
    ASSERT_TRUE(is_accepted(certificate_text(circles, o.allowed, CountAnswer{truth.size(), {}}, o.groups)));
    ASSERT_FALSE(is_accepted(certificate_text(circles, o.allowed, CountAnswer{truth.size() + 1, {}}, o.groups)));
    if (truth.empty()) continue;
    all.contacts.erase(all.contacts.begin() + static_cast<std::ptrdiff_t>(sets.random().below(truth.size())));
    ASSERT_FALSE(is_accepted(planar::certificate_text(circles, o.allowed, all, o.groups))) << i;
  }
  EXPECT_GT(contacts, static_cast<std::uint64_t>(count >= 5000 ? count / 2 : 0));
}

// Reflected, turned, scaled by a power of two, order changed: the same verdict and count.
TEST(DiscsDifferential, SymmetriesKeepTheVerdict) {
  const int count = scaled_count(4000);
  CircleSets sets(chosen_seed(12));
  int meets = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Disc> set = sets.next();
    const SetOptions options{rules[static_cast<std::size_t>(i % 3)], {}, nullptr};
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
    if (sets.family() != Family::any_scale) {
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
