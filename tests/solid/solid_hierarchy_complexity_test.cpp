// Counted probes on every family of hard bodies: of polyhedron_polyhedron_by_hierarchy a constant times log2^2 n, n the
// larger body, of polyhedron_polyhedron_by_polar, _by_bounded and of the front door a constant times log2 n + log2 m,
// and the rounds of _by_polar. What it rests on, BL15 Lemma 4.2; and the walk that scans all neighbours, which the
// lemma alone does not save.
#include <tests/support/near_contact.h>
#include <tests/support/scale.h>
#include <tests/support/shapes.h>
#include <tests/support/solid_shapes.h>

#include <sunder/base/random.h>
#include <sunder/predicate/point/along.h>
#include <sunder/solid/descent/polar_round.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/represent/hierarchy.h>
#include <sunder/solid/represent/hierarchy_walk.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/search/support.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::tests {
namespace {

using solid::ConvexPolyhedron;
using solid::Hierarchy;
using solid::Pose;

using Method = PairAnswer (*)(const ConvexPolyhedron&, const Pose&, const ConvexPolyhedron&, const Pose&);

// For bodies of 8 vertices or more; a bound is less than 1.5 times the greatest ratio up to n of about 1,000.
struct Bounded {
  std::string_view name;
  Method method;
  double bound, bound_tilted;  // of bodies hardly turned, to the last bit, another one
  double (*of)(double log2_n, double log2_m);
  int finished;         // at most one in so many; needles, mostly
  int finished_tilted;  // of bodies hardly turned
};
double square_of_larger(double x, double y) { return std::max(x, y) * std::max(x, y); }
double sum_of_logs(double x, double y) { return x + y; }
PairAnswer distance(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b) {
  const solid::PolyhedronDistance found = polyhedron_polyhedron_distance(a, pose_a, b, pose_b);
  if (const auto* common = std::get_if<CommonVertices>(&found.evidence)) {
    return {*common, found.decided_by, found.cost};
  }
  return {{}, found.decided_by, found.cost};  // that they are apart; what parts them is not looked at
}
const std::array<Bounded, 5> bounded{
    {{"hierarchy", solid::polyhedron_polyhedron_by_hierarchy, 68, 68, square_of_larger, 1000, 1000},
     {"polar", solid::polyhedron_polyhedron_by_polar, 80, 80, sum_of_logs, 100, 10},
     {"front", solid::polyhedron_polyhedron, 250, 520, sum_of_logs, 1000, 1000},
     {"distance", distance, 390, 720, sum_of_logs, 50, 20},
     {"bounded", solid::polyhedron_polyhedron_by_bounded, 220, 220, sum_of_logs, 100, 10}}};

class BoundedRatios {
 public:
  explicit BoundedRatios(const Bounded& of) : of_(of) {}

  void add(std::string_view what, const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b,
           const Pose& pose_b, bool is_tilted = false) {
    // Two flat bodies: another method takes them.
    const bool is_by_polar =
        of_.method == solid::polyhedron_polyhedron_by_polar || of_.method == solid::polyhedron_polyhedron_by_bounded;
    if (is_by_polar && a.dimension() < 3 && b.dimension() < 3) return;
    // Bounded hierarchies of large hubs take seconds to make: for longer runs.
    const bool is_large = std::max(a.vertices().size(), b.vertices().size()) > 20000;
    if (of_.method == solid::polyhedron_polyhedron_by_bounded && is_large && scaled_count(10) < 20) return;
    const PairAnswer answer = of_.method(a, pose_a, b, pose_b);
    const double n = static_cast<double>(a.vertices().size()), m = static_cast<double>(b.vertices().size());
    ++(is_tilted ? tilted_ : answer.meet() ? meet_ : apart_);
    if (answer.decided_by == DecidedBy::finishing) {  // some exact pivots more
      ++(is_tilted ? finished_tilted_ : finished_);
      return;
    }
    const double ratio = static_cast<double>(answer.cost.probes) / of_.of(std::log2(n), std::log2(m));
    greatest_of_row_ = std::max(greatest_of_row_, ratio);
    EXPECT_LE(ratio, is_tilted ? of_.bound_tilted : of_.bound)
        << of_.name << " " << what << ", n = " << n << ", m = " << m;
    Greatest& greatest = is_tilted ? greatest_tilted_ : greatest_;
    if (std::max(n, m) <= 1100) greatest.at_a_thousand = std::max(greatest.at_a_thousand, ratio);
    if (ratio <= greatest.of_all) return;
    greatest.of_all = ratio;
    std::printf("%-9.*s %-30.*s n %6.0f m %6.0f  probes %6.0f  steps %4u  ratio %.1f\n",
                static_cast<int>(of_.name.size()), of_.name.data(), static_cast<int>(what.size()), what.data(), n, m,
                static_cast<double>(answer.cost.probes), static_cast<unsigned>(answer.cost.iterations), ratio);
  }
  // The greatest since it was last asked for.
  double take_greatest_of_row() { return std::exchange(greatest_of_row_, 0); }
  void expect_no_growth(bool is_of_many) const {
    std::printf("%.*s: greatest %.2f, at n = 1,000 %.2f; %d apart, %d meet, %d finished; %d tilted, %d finished, ",
                static_cast<int>(of_.name.size()), of_.name.data(), greatest_.of_all, greatest_.at_a_thousand, apart_,
                meet_, finished_, tilted_, finished_tilted_);
    std::printf("greatest %.2f, at n = 1,000 %.2f\n", greatest_tilted_.of_all, greatest_tilted_.at_a_thousand);
    if (is_of_many) {
      EXPECT_LE(of_.bound, 1.5 * std::max(greatest_.at_a_thousand, greatest_tilted_.at_a_thousand)) << of_.name;
      EXPECT_LE(of_.bound_tilted, 1.5 * std::max(greatest_.at_a_thousand, greatest_tilted_.at_a_thousand)) << of_.name;
    }
    EXPECT_LE(finished_, (apart_ + meet_) / of_.finished) << of_.name;
    EXPECT_LE(finished_tilted_, tilted_ / of_.finished_tilted) << of_.name;
    EXPECT_GT(apart_, meet_ / 4);
    EXPECT_GT(meet_, apart_ / 4);
  }

 private:
  const Bounded& of_;
  struct Greatest {
    double of_all = 0, at_a_thousand = 0;
  };
  Greatest greatest_, greatest_tilted_;
  double greatest_of_row_ = 0;
  int meet_ = 0, apart_ = 0, finished_ = 0, tilted_ = 0, finished_tilted_ = 0;
};

// The rounds of the walk between two spaces: never more than there are levels of both hierarchies.
class Rounds {
 public:
  void add(const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b, const Pose& pose_b) {
    const solid::PolarRun run = polyhedron_polyhedron_polar_run(a, pose_a, b, pose_b);
    if (run.rounds.empty()) return;
    ASSERT_LE(run.rounds.size() - 1, run.levels_p - 1 + run.levels_q - 1);
    most_ = std::max(most_, run.rounds.size() - 1);
    for (std::size_t k = 1; k < run.rounds.size(); ++k) {
      const auto &before = run.rounds[k - 1], &here = run.rounds[k];
      // Each goes down in the space where it is, and in no other.
      const bool in_primal = here.space == solid::PolarRound::Space::primal;
      ASSERT_EQ(in_primal, before.is_apart);
      ASSERT_GT(in_primal ? here.level_p : here.level_q, in_primal ? before.level_p : before.level_q);
      ASSERT_EQ(in_primal ? here.level_q : here.level_p, in_primal ? before.level_q : before.level_p);
      changes_ += here.is_apart != before.is_apart;
    }
    ++runs_;
  }
  void print() const { std::printf("rounds: at most %zu, %d changes of space in %d runs\n", most_, changes_, runs_); }
  int changes() const { return changes_; }

 private:
  std::size_t most_ = 0;
  int changes_ = 0, runs_ = 0;
};

struct Measured {
  std::vector<BoundedRatios> ratios{bounded.begin(), bounded.end()};
  Rounds rounds;

  void add(std::string_view what, const ConvexPolyhedron& a, const Pose& pose_a, const ConvexPolyhedron& b,
           const Pose& pose_b) {
    for (BoundedRatios& r : ratios) r.add(what, a, pose_a, b, pose_b);
    rounds.add(a, pose_a, b, pose_b);
  }
  // What docs/images/plot_solid_probes.py reads: the greatest ratios of a family and size.
  void print_row(std::string_view family, std::size_t n) {
    std::printf("| %-12.*s | %6zu |", static_cast<int>(family.size()), family.data(), n);
    for (BoundedRatios& r : ratios) std::printf(" %5.1f |", r.take_greatest_of_row());
    std::printf("\n");
  }
};

Pose turned(Random& random, const Point3& to) {
  std::array<double, 4> q;
  for (double& x : q) x = random.uniform(-1, 1);
  return Pose::from_quaternion(q[0], q[1], q[2], q[3], {to.x, to.y, to.z});
}

// Bisection for the distance of contact along a direction, then a gap or an overlap of log-uniform size. Needles keep
// to the axes, and move along the one in which they are 1 wide.
void add_near_contact(Measured& ratios, std::string_view what, const ConvexPolyhedron& a, const ConvexPolyhedron& b,
                      bool are_needles, Random& random) {
  const Pose here = are_needles ? Pose() : turned(random, {});
  const Pose there = are_needles ? shift(0, 1, 0) : turned(random, on_sphere(random));
  const auto at = [&](double distance) {
    const auto& t = there.affine().translation;
    return Pose::from_matrix(there.affine().linear, {t[0] * distance, t[1] * distance, t[2] * distance});
  };
  double meeting = 0, parted = 8;
  for (int i = 0; i < 54 && meeting < parted; ++i) {
    const double middle = (meeting + parted) / 2;
    (polyhedron_polyhedron(a, here, b, at(middle)).meet() ? meeting : parted) = middle;
  }
  const double gap = random.log_uniform(0x1p-53, 0.1);
  ratios.add(what, a, here, b, at(parted + gap));
  ratios.add(what, a, here, b, at(meeting - gap));
}

// A body and its mirror image in one of its vertices, which is all that they have in common.
void add_touching(Measured& ratios, std::string_view what, const ConvexPolyhedron& a, Random& random) {
  const Point3 v = a.vertices()[random.below(a.vertices().size())];
  const Pose mirror = Pose::from_matrix({-1, 0, 0, 0, -1, 0, 0, 0, -1}, {2 * v.x, 2 * v.y, 2 * v.z});
  ratios.add(what, a, Pose(), a, mirror);
}

// A body and itself, hardly turned, to the last bit.
void add_tilted(Measured& ratios, std::string_view what, const ConvexPolyhedron& a, bool are_needles, Random& random) {
  for (const PlacedPair& at : places_of(Placement::tilted, a, a, are_needles, random)) {
    for (BoundedRatios& r : ratios.ratios) r.add(what, a, at.a, a, at.b, true);
  }
}

TEST(SolidHierarchyComplexity, ProbesGrowAsTheSquareOrTheSumOfLogarithms) {
  const int greatest_power = scaled_count(17, 12) >= 17 ? 17 : 12;
  const int small_times = std::min(scaled_count(400, 40), 400);         // the bound is made of the greatest of these
  const int large_times = std::min(scaled_count(10, 10), small_times);  // as many at a scale of 40
  Random random(chosen_seed(97)), random_tilts(chosen_seed(197));
  Measured ratios;
  for (int power = 7; power <= greatest_power; ++power) {
    const std::size_t n = std::size_t{1} << power;
    std::vector<ConvexPolyhedron> others;
    for (const std::size_t m : {std::size_t{8}, std::size_t{100}, n}) {
      others.emplace_back(solid_shapes::sphere(m, random));
    }
    const int times = power < 11 ? small_times : large_times;
    for (const SolidShape& shape : all_solid_shapes()) {
      const ConvexPolyhedron body(shape.make(n, random));
      const bool is_needle = shape.name == "needle";
      for (int i = 0; i < times; ++i) {
        add_near_contact(ratios, shape.name, body, body, is_needle, random);
        add_touching(ratios, std::string(shape.name) + " touching", body, random);
        if (i % 2 == 0) add_tilted(ratios, std::string(shape.name) + " tilted", body, is_needle, random_tilts);
        if (is_needle) continue;
        const ConvexPolyhedron& other = others[random.below(others.size())];
        add_near_contact(ratios, std::string(shape.name) + ", sphere", body, other, false, random);
      }
      ratios.print_row(shape.name, n);
    }
  }
  for (const BoundedRatios& r : ratios.ratios) r.expect_no_growth(small_times == 400);
  ratios.rounds.print();
  EXPECT_GT(ratios.rounds.changes(), 1000);
}

// Ranks of the first m that are strictly further along a direction than rank v.
std::vector<std::uint32_t> beyond(const Hierarchy& h, Along& along, std::uint32_t v, std::uint32_t m) {
  std::vector<std::uint32_t> found;
  for (std::uint32_t w = 0; w < m; ++w) {
    if (along.compare(h.nodes[v].at, h.nodes[w].at) == Sign::positive) found.push_back(w);
  }
  return found;
}

// Directions that tie, too: axes, and small whole numbers.
Point3 tying_direction(Random& random, int i) {
  if (i % 2 == 0) return on_sphere(random);
  const auto part = [&] { return static_cast<double>(random.between(-2, 2)); };
  return {part(), part(), part()};
}

// A plane that supports P_{i+1} at v has at most one vertex of P_i strictly beyond: a neighbour of v in P_i.
TEST(SolidHierarchyComplexity, Lemma42AtMostOneVertexIsBeyondAndANeighbour) {
  Random random(chosen_seed(101));
  int none_beyond = 0, one_beyond = 0;
  for (const SolidShape& shape : all_solid_shapes()) {
    if (shape.name == "flat") continue;
    SCOPED_TRACE(shape.name);
    for (const std::size_t n : {20u, 200u, 1000u}) {
      const ConvexPolyhedron body(shape.make(n, random));
      if (body.vertices().size() < 5) continue;
      const Hierarchy& h = solid::represent::of<Hierarchy>(body);
      const int times = scaled_count(40);
      for (int i = 0; i < times; ++i) {
        const Affine3 identity;
        const WorldDirection direction(tying_direction(random, i));
        Along along(direction, identity, false);
        std::uint32_t v = 0;  // extreme in the level before; of those that tie any
        for (std::uint32_t w = 1; w < h.level_end.front(); ++w) {
          if (along.compare(h.nodes[v].at, h.nodes[w].at) == Sign::positive) v = w;
        }
        for (std::size_t level = 1; level < h.level_end.size(); ++level) {
          const std::vector<std::uint32_t> found = beyond(h, along, v, h.level_end[level]);
          ASSERT_LE(found.size(), 1u);
          ++(found.empty() ? none_beyond : one_beyond);
          if (found.empty()) continue;
          // It is new, so its neighbours are those that it comes with.
          ASSERT_GE(found[0], h.level_end[level - 1]);
          bool is_neighbour = false;
          for (const Hierarchy::Triangle t : h.nodes[found[0]].star()) is_neighbour |= t.a == v;
          ASSERT_TRUE(is_neighbour);
          v = found[0];
        }
      }
    }
  }
  EXPECT_GT(none_beyond, one_beyond / 10);
  EXPECT_GT(one_beyond, none_beyond / 10);
}

// From level to level a walk finds what a run to that level finds, and looks at no more in all.
TEST(SolidHierarchyComplexity, AWalkFromLevelToLevelCostsOneRun) {
  Random random(chosen_seed(103));
  for (const SolidShape& shape : all_solid_shapes()) {
    SCOPED_TRACE(shape.name);
    const ConvexPolyhedron body(shape.make(500, random));
    const Hierarchy& h = solid::represent::of<Hierarchy>(body);
    solid::CompareAlong<double> compare(body);
    const solid::TurnBy<solid::CompareAlong<double>> turn{compare};
    std::uint64_t in_pieces = 0, whole = 0;
    solid::HierarchyWalk walk(h, compare, turn, in_pieces);
    for (int i = 0; i < 50; ++i) {
      compare.turn_to(on_sphere(random));
      in_pieces = whole = 0;
      walk.start();
      for (const std::uint32_t end : h.level_end) {
        whole = 0;
        ASSERT_EQ(walk.go_on(end), solid::HierarchyWalk(h, compare, turn, whole).run(end));
        ASSERT_EQ(in_pieces, whole);
      }
    }
  }
}

// What the walk of Dobkin and Kirkpatrick 1990 looks at: on each level all neighbours of the vertex that is extreme on
// the level above. One of them at most is further (Lemma 4.2), but nothing bounds how many there are.
std::uint64_t probes_of_naive_walk(const Hierarchy& h, const Point3& d) {
  const Affine3 identity;
  const WorldDirection direction(d);
  Along along(direction, identity, false);
  std::uint64_t probes = h.level_end.front();
  std::uint32_t v = 0;
  for (std::uint32_t w = 1; w < h.level_end.front(); ++w) {
    if (along.compare(h.nodes[v].at, h.nodes[w].at) == Sign::positive) v = w;
  }
  for (const std::uint32_t m : std::span(h.level_end).subspan(1)) {
    // The triangles of the level at v; each neighbour is a corner before v of one.
    std::uint32_t further = v;
    const auto look_at = [&](std::uint32_t w) {
      ++probes;
      if (along.compare(h.nodes[further].at, h.nodes[w].at) == Sign::positive) further = w;
    };
    for (std::uint32_t w = 0; w < m; ++w) {
      for (const Hierarchy::Triangle t : h.nodes[w].star()) {
        if (t.beyond < m) continue;
        if (w == v) look_at(t.a);
        if (t.a == v) look_at(t.b);
        if (t.b == v) look_at(w);
      }
    }
    v = further;
  }
  return probes;
}

// The oversight that BL15 section 4 names: on stacked bodies the degree of one vertex doubles from level to level.
TEST(SolidHierarchyComplexity, ScanningAllNeighboursIsLinearOnStackedBodies) {
  const Point3 to_the_hub{0.01, 0.02, 1};
  for (const std::size_t n : {256u, 4096u, 65536u}) {
    const ConvexPolyhedron body(solid_shapes::stacked(n));
    const auto naive = static_cast<double>(probes_of_naive_walk(solid::represent::of<Hierarchy>(body), to_the_hub));
    // Hub over hub, near and touching.
    const double logs = std::log2(n) * std::log2(n);
    std::uint64_t ours = 0;
    for (const double height : {2.0, 2 + 0x1p-40, 2.5}) {
      const Pose upside_down = Pose::from_matrix({1, 0, 0, 0, -1, 0, 0, 0, -1}, {0, 0, height});
      const PairAnswer answer = polyhedron_polyhedron_by_hierarchy(body, Pose(), body, upside_down);
      EXPECT_EQ(answer.meet(), height == 2);
      ours = std::max<std::uint64_t>(ours, answer.cost.probes);
    }
    std::printf("n = %6zu: naive walk %6.0f probes, by_hierarchy %4.0f\n", n, naive, static_cast<double>(ours));
    EXPECT_GE(naive, static_cast<double>(n));
    EXPECT_LE(static_cast<double>(ours), bounded[0].bound * logs);
  }
}

// The hull of (t, t^2, 0), t = 2^(-400 k / n), and two points more, against its reflection through a vertex, in which
// they touch: doubles see nothing of it, and each step of the simplex method from the whole bodies halves a distance.
TEST(SolidHierarchyComplexity, SignsOfFinishingGrowAsALogarithm) {
  const int greatest_power = scaled_count(16, 12) >= 16 ? 16 : 12;
  int finished = 0;
  std::uint64_t last = 400;
  for (int power = 8; power <= greatest_power; power += 2) {
    const std::size_t n = std::size_t{1} << power;
    std::vector<Point3> points;
    const double by = std::exp2(-400 / static_cast<double>(n));
    for (double t = 1; points.size() + 2 < n; t *= by) points.push_back({t, t * t, 0});
    points.insert(points.end(), {{0.5, 0.6, 1}, {-1, 1, 0}});
    const solid::ConvexPolyhedron body(points);
    std::uint64_t greatest = 0;
    for (const std::size_t eighth : {2U, 4U, 6U}) {
      const Point3& at = points[n * eighth / 8];
      const solid::Pose reflected = solid::Pose::from_matrix({-1, 0, 0, 0, -1, 0, 0, 0, -1}, {2 * at.x, 2 * at.y, 0});
      const PairAnswer answer = solid::polyhedron_polyhedron(body, solid::Pose(), body, reflected);
      EXPECT_TRUE(answer.meet()) << n << " " << eighth;
      finished += answer.decided_by == DecidedBy::finishing;
      greatest = std::max<std::uint64_t>(greatest, answer.cost.exact);
    }
    EXPECT_LE(greatest, std::min(200.0 * power, 10000.0)) << n;
    EXPECT_LE(greatest, last + 2 * 330) << n;  // each doubling adds 206 to 319: N is four times the last one
    last = greatest;
    std::printf("finishing: N %7zu signs %6llu\n", n, static_cast<unsigned long long>(greatest));  // NOLINT
  }
  EXPECT_GE(finished, 2 * (greatest_power / 2 - 3));
}

}  // namespace
}  // namespace sunder::tests
