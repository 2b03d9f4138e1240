// Sets of circles: circles_any and the lists of contacts against their scans, under every rule, with groups; and a
// checker of transcripts, which knows the rules T1 to T4 of circles_any.h and nothing else of the library.
#include <tests/support/scale.h>

#include <sunder/base/random.h>
#include <sunder/planar/set/circles_all.h>
#include <sunder/planar/set/circles_any.h>

#include <gtest/gtest.h>
#include <boost/multiprecision/cpp_int.hpp>

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

using planar::Allowed;
using planar::Circle;
using planar::Circles;
using planar::CirclesAnswer;
using planar::CirclesContact;
using planar::CirclesOptions;
using planar::DiscContact;

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
  std::vector<Circle> next() {
    family_ = static_cast<Family>(turn_++ % family_count);
    if (family_ == Family::crowd && random_.below(16) != 0) family_ = Family::sparse;
    std::vector<Circle> set = of_family();
    for (std::size_t k = set.size(); k > 1; --k) std::swap(set[k - 1], set[random_.below(k)]);
    if (!set.empty() && random_.below(40) == 0) set.push_back(set[random_.below(set.size())]);
    return set;
  }

 private:
  double integer(std::int64_t low, std::int64_t high) { return static_cast<double>(random_.between(low, high)); }
  Circle on_integers(std::int64_t side, std::int64_t radius) {
    const double x = integer(0, side), y = integer(0, side);
    return {{x, y}, integer(0, radius)};
  }
  Circle in_square(double x, double y, double size, double radius) {
    const double u = random_.unit(), v = random_.unit();
    return {{x + size * u, y + size * v}, radius * random_.unit()};
  }

  std::vector<Circle> of_family() {
    std::vector<Circle> set;
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
          set.push_back(how == 0 ? Circle{{at - r, y}, r} : how == 1 ? Circle{{at + r, y}, r} : Circle{{y, at}, r});
        }
        break;
      }
      case Family::any_scale: {
        const double unit = std::ldexp(1, static_cast<int>(random_.between(-1074, 1015)));
        if (random_.below(2) == 0) {
          repeat(random_.between(2, 4), [&] {
            const Circle c = on_integers(8, 3);
            return Circle{{unit * c.center.x, unit * c.center.y}, unit * c.radius};
          });
        } else {
          const auto any = [&](double x) { return std::ldexp(x, static_cast<int>(random_.between(-1074, 1022))); };
          repeat(random_.between(2, 3), [&] {
            const double x = any(random_.uniform(-2, 2)), y = any(random_.uniform(-2, 2));
            return Circle{{x, y}, random_.below(3) == 0 ? 0 : any(random_.unit())};
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

  void pack(std::vector<Circle>& set) {
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

  void touch(std::vector<Circle>& set, std::int64_t count) {
    set.push_back(in_square(0, 0, 1, 0.3));
    for (std::int64_t k = 1; k < count; ++k) {
      Circle c = in_square(0, 0, 3, 0);
      const Circle& other = set[random_.below(set.size())];
      const double apart = std::hypot(c.center.x - other.center.x, c.center.y - other.center.y);
      c.radius = std::fabs(apart - other.radius);
      for (std::int64_t bits = random_.between(-2, 2); bits != 0; bits += bits < 0 ? 1 : -1) {
        c.radius = std::nextafter(c.radius, bits < 0 ? 0 : 9);
      }
      const auto meets_others = [&] {
        return std::any_of(set.begin(), set.end(), [&](const Circle& d) {
          return &d != &other && planar::circle_circle(c, d) != DiscContact::none;
        });
      };
      if (random_.below(8) == 0 || !meets_others()) set.push_back(c);
    }
  }

  void nest(std::vector<Circle>& set, std::int64_t count) {
    for (std::int64_t k = 0; k < count; ++k) {
      const Circle around{{20.0 * static_cast<double>(k), integer(-2, 2)}, integer(1, 9)};
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

// --- The checker of transcripts
// ----------------------------------------------------------------------------------------

using Integer = boost::multiprecision::cpp_int;

// x 2^1074: a whole number for each double.
Integer whole(double x) {
  int exponent = 0;
  const double fraction = std::frexp(x, &exponent);
  const Integer mantissa = static_cast<std::int64_t>(std::ldexp(fraction, 53));
  const int shift = exponent - 53 + 1074;
  if (shift >= 0) return mantissa << shift;
  return mantissa / (Integer(1) << -shift);  // without a rest
}

struct WholeDisc {
  Integer x, y, r;
  explicit WholeDisc(const Circle& c) : x(whole(c.center.x)), y(whole(c.center.y)), r(whole(c.radius)) {}
  Integer end(bool is_last) const { return is_last ? Integer(x + r) : Integer(x - r); }
};

struct Transcript {
  std::vector<std::uint32_t> events, below;
};

constexpr std::uint32_t no_disc = 0xffffffffu;

// Is it a proof that no contact counts?
bool accepts(const std::vector<Circle>& set, bool touching_allowed, const Transcript& transcript) {
  std::vector<WholeDisc> discs;
  for (const Circle& c : set) discs.emplace_back(c);
  // T1
  if (transcript.events.size() != 2 * set.size() || transcript.below.size() != set.size()) return false;
  std::vector<int> seen(2 * set.size(), 0);
  for (std::size_t k = 0; k < transcript.events.size(); ++k) {
    const std::uint32_t e = transcript.events[k];
    if (e >= seen.size() || seen[e]++ != 0) return false;
    if (k == 0) continue;
    const std::uint32_t before = transcript.events[k - 1];
    const Integer at = discs[e / 2].end(e % 2 == 1), was = discs[before / 2].end(before % 2 == 1);
    if (at < was || (at == was && e % 2 < before % 2)) return false;
  }
  // T2 to T4
  const auto apart = [&](std::uint32_t i, std::uint32_t j) {
    const WholeDisc &c = discs[i], &d = discs[j];
    const Integer x = c.x - d.x, y = c.y - d.y, reach = c.r + d.r;
    const Integer gap = x * x + y * y - reach * reach;
    return gap > 0 || (touching_allowed && gap == 0);
  };
  std::vector<std::uint32_t> line;
  std::size_t begun = 0;
  for (const std::uint32_t e : transcript.events) {
    const std::uint32_t i = e / 2;
    if (e % 2 == 0) {
      const std::uint32_t below = transcript.below[begun++];
      std::size_t at = 0;
      if (below != no_disc) {
        at = static_cast<std::size_t>(std::find(line.begin(), line.end(), below) - line.begin()) + 1;
        if (at > line.size() || discs[below].y > discs[i].y || !apart(below, i)) return false;
      }
      if (at < line.size() && (discs[i].y > discs[line[at]].y || !apart(i, line[at]))) return false;
      line.insert(line.begin() + static_cast<std::ptrdiff_t>(at), i);
    } else {
      const auto at = std::find(line.begin(), line.end(), i);
      if (at == line.end()) return false;
      const auto after = line.erase(at);
      if (after != line.begin() && after != line.end() && !apart(*std::prev(after), *after)) return false;
    }
  }
  return true;
}

// The transcript of a sweep that tests nothing: in order by T1 to T3, ties as chance will have it.
Transcript untested(const std::vector<Circle>& set, Random& random) {
  std::vector<WholeDisc> discs;
  for (const Circle& c : set) discs.emplace_back(c);
  Transcript transcript;
  std::vector<std::uint64_t> chance;
  for (std::uint32_t e = 0; e < 2 * set.size(); ++e) {
    transcript.events.push_back(e);
    chance.push_back(random.next());
  }
  std::sort(transcript.events.begin(), transcript.events.end(), [&](std::uint32_t e, std::uint32_t f) {
    const Integer at = discs[e / 2].end(e % 2 == 1), other = discs[f / 2].end(f % 2 == 1);
    if (at != other) return at < other;
    return e % 2 != f % 2 ? e % 2 < f % 2 : chance[e] < chance[f];
  });
  std::vector<std::uint32_t> line;
  for (const std::uint32_t e : transcript.events) {
    const std::uint32_t i = e / 2;
    if (e % 2 == 1) {
      line.erase(std::find(line.begin(), line.end(), i));
      continue;
    }
    const bool over_equals = random.below(2) == 0;
    const auto at = std::find_if(line.begin(), line.end(), [&](std::uint32_t j) {
      return over_equals ? discs[j].y > discs[i].y : discs[j].y >= discs[i].y;
    });
    transcript.below.push_back(at == line.begin() ? no_disc : *std::prev(at));
    line.insert(at, i);
  }
  return transcript;
}

// --- Tests
// -------------------------------------------------------------------------------------------------------------

void expect_truth(const CirclesAnswer& answer, const CirclesAnswer& scan, const Circles& circles,
                  const CirclesOptions& options) {
  ASSERT_EQ(answer.meet(), scan.meet());
  if (!answer.meet()) return;
  ASSERT_LT(answer.i, answer.j);
  ASSERT_LT(answer.j, circles.size());
  ASSERT_EQ(planar::circle_circle(circles[answer.i], circles[answer.j]), answer.kind);
  ASSERT_TRUE(planar::counts(answer.kind, options.allowed));
  ASSERT_FALSE(planar::may_meet(options.groups, answer.i, answer.j));
  ASSERT_TRUE(answer.transcript.events.empty());
}

struct Rates {
  int cases = 0;
  std::array<int, 3> meets{};
};

TEST(CirclesDifferential, AnyAgreesWithTheScan) {
  const int count = scaled_count(20000);
  CircleSets sets(chosen_seed(20261128));
  std::map<Family, Rates> rates;
  std::map<DiscContact, int> kinds;
  for (int i = 0; i < count; ++i) {
    const std::vector<Circle> set = sets.next();
    const Circles circles(set);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < set.size(); ++k) groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
    Rates& rate = rates[sets.family()];
    ++rate.cases;
    for (std::size_t r = 0; r < rules.size(); ++r) {
      for (const bool grouped : {false, true}) {
        CirclesOptions options{rules[r], false, {}, nullptr};
        if (grouped) options.groups = groups;
        const CirclesAnswer scan = planar::circles_any_by_scan(circles, options);
        if (!grouped) {
          rate.meets[r] += scan.meet();
          ++kinds[scan.kind];
        }
        for (const bool transcript : {false, true}) {
          options.transcript = transcript;
          for (const auto method :
               {&planar::circles_any_by_sweep, &planar::circles_any_by_grid, &planar::circles_any}) {
            const CirclesAnswer answer = method(circles, options);
            ASSERT_NO_FATAL_FAILURE(expect_truth(answer, scan, circles, options))
                << i << " " << family_names[static_cast<std::size_t>(sets.family())] << " rule " << r;
            const bool proved = transcript && !grouped && !answer.meet();
            ASSERT_EQ(answer.transcript.events.size(), proved ? 2 * set.size() : 0);
          }
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
TEST(CirclesDifferential, ListsAgreeWithTheScan) {
  const int count = scaled_count(10000);
  CircleSets sets(chosen_seed(20261129));
  std::uint64_t contacts = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Circle> set = sets.next();
    const Circles circles(set);
    std::vector<std::uint32_t> groups;
    for (std::size_t k = 0; k < set.size(); ++k) groups.push_back(static_cast<std::uint32_t>(sets.random().below(3)));
    CirclesOptions options{rules[static_cast<std::size_t>(i % 3)], false, {}, nullptr};
    if (i % 2 == 0) options.groups = groups;
    const auto listed = [&](planar::CirclesContactMethod* method) {
      std::vector<CirclesContact> list;
      method(circles, options, [&](const CirclesContact& contact) {
        list.push_back(contact);
        return true;
      });
      std::sort(list.begin(), list.end());
      return list;
    };
    const std::vector<CirclesContact> truth = listed(&planar::visit_circle_contacts_by_scan);
    ASSERT_TRUE(listed(&planar::visit_circle_contacts_by_sweep) == truth) << i;
    ASSERT_TRUE(listed(&planar::visit_circle_contacts_by_grid) == truth) << i;
    ASSERT_TRUE(listed(&planar::visit_circle_contacts) == truth) << i;
    ASSERT_EQ(planar::circles_count(circles, options).count, truth.size());
    ASSERT_EQ(planar::circles_all(circles, options).contacts.size(), truth.size());
    contacts += truth.size();
  }
  EXPECT_GT(contacts, static_cast<std::uint64_t>(count >= 5000 ? count / 2 : 0));
}

// T1 to T4 are enough, and the sweep keeps to them: the checker accepts what the sweep writes, and a transcript that is
// in order but untested if and only if nothing counts.
TEST(CirclesDifferential, TranscriptsProveThatNothingCounts) {
  const int count = scaled_count(8000);
  CircleSets sets(chosen_seed(20261130));
  int accepted = 0, refused = 0, mutations = 0, mutations_refused = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Circle> set = sets.next();
    if (set.size() > 100) continue;
    const Allowed allowed = rules[static_cast<std::size_t>(i % 3)];
    const bool touching_allowed = allowed != Allowed::nothing;
    const Circles circles(set);
    const bool none = !planar::circles_any_by_scan(circles, {allowed, false, {}, nullptr}).meet();
    ASSERT_EQ(accepts(set, touching_allowed, untested(set, sets.random())), none) << i;
    (none ? accepted : refused) += 1;
    if (!none || set.empty()) continue;
    const CirclesAnswer answer = planar::circles_any(circles, {allowed, true, {}, nullptr});
    const Transcript written{answer.transcript.events, answer.transcript.below};
    ASSERT_TRUE(accepts(set, touching_allowed, written)) << i;
    Transcript changed = written;
    const std::size_t at = sets.random().below(set.size());
    switch (sets.random().below(4)) {
      case 0: std::swap(changed.events[at], changed.events[at + set.size()]); break;
      case 1: changed.events[at] = changed.events[at + 1]; break;
      case 2: changed.events.pop_back(); break;
      default: changed.below[at] = changed.below[at] == no_disc ? changed.events[2 * at] / 2 : no_disc; break;
    }
    ++mutations;
    mutations_refused += !accepts(set, touching_allowed, changed);
  }
  std::printf("accepted %d, refused %d; of %d mutations refused %d\n", accepted, refused, mutations, mutations_refused);
  if (count < 2000) return;
  EXPECT_GT(accepted, count / 5);
  EXPECT_GT(refused, count / 5);
  EXPECT_GT(mutations_refused, mutations * 3 / 4);
}

// Reflected, turned, scaled by a power of two, order changed: the same verdict and count.
TEST(CirclesDifferential, SymmetriesKeepTheVerdict) {
  const int count = scaled_count(4000);
  CircleSets sets(chosen_seed(12));
  int meets = 0;
  for (int i = 0; i < count; ++i) {
    const std::vector<Circle> set = sets.next();
    const CirclesOptions options{rules[static_cast<std::size_t>(i % 3)], true, {}, nullptr};
    const auto contacts = [&](auto&& changed) {
      std::vector<Circle> circles;
      for (const Circle& c : set) circles.push_back(changed(c));
      const std::uint64_t found = planar::circles_count(Circles(circles), options).count;
      EXPECT_EQ(planar::circles_any(Circles(circles), options).meet(), found > 0) << i;
      return found;
    };
    const std::uint64_t truth = contacts([](const Circle& c) { return c; });
    meets += truth > 0;
    ASSERT_EQ(contacts([](const Circle& c) { return Circle{{-c.center.x, c.center.y}, c.radius}; }), truth) << i;
    ASSERT_EQ(contacts([](const Circle& c) { return Circle{{c.center.x, -c.center.y}, c.radius}; }), truth) << i;
    ASSERT_EQ(contacts([](const Circle& c) { return Circle{{c.center.y, c.center.x}, c.radius}; }), truth) << i;
    if (sets.family() != Family::any_scale) {
      ASSERT_EQ(contacts([](const Circle& c) {
                  return Circle{{0x1p-900 * c.center.x, 0x1p-900 * c.center.y}, 0x1p-900 * c.radius};
                }),
                truth)
          << i;
    }
    const std::vector<Circle> reversed(set.rbegin(), set.rend());
    ASSERT_EQ(planar::circles_count(Circles(reversed), options).count, truth) << i;
  }
  if (count < 1000) return;
  EXPECT_GT(meets, count / 5);
  EXPECT_LT(meets, count - count / 5);
}

}  // namespace
}  // namespace sunder::tests
