// bench_round: do two primitives meet? Balls, capsules, boxes, cylinders, cones and ellipsoids, each with each, against
// FCL's own primitives.
//
// Fairness:
//   - All contestants answer the same pairs in one run, in rounds, and take turns in going first. The time of a
//     contestant is the median over its rounds of its mean per pair, in processor time of its thread.
//   - Bodies, shapes and poses are prepared outside of the loop. What is asked is yes or no; Sunder's answer has its
//     evidence, checked exactly.
//   - FCL is asked by fcl::collide with both of its solvers; the faster one counts, right or wrong, and its wrong
//     answers are told: the truth is Sunder's answer, which tests prove against fractions. What Sunder leaves undecided
//     is not asked.
//   - random: about half of the pairs meet. near: moved along a line to where they touch, then by 1e-12 of their size
//     to either side.
#include <bench/contest/program.h>
#include <bench/peers/round_peer.h>

#include <sunder/base/random.h>
#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>
#include <sunder/solid/round/round_clearance.h>
#include <sunder/solid/round/round_round.h>

#include <tests/support/round_pairs.h>
#include <tests/support/shapes.h>

#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

using namespace sunder;
using solid::Pose;
using solid::RoundBody;

constexpr const char* kNames[kRoundShapeKinds] = {"ball", "capsule", "box", "cylinder", "cone", "ellipsoid"};

RoundBody body_of(const RoundPrimitive& p) {
  const auto& [x, y, z] = p.half;
  switch (p.kind) {
    case RoundShapeKind::ball: return RoundBody::ball({}, x);
    case RoundShapeKind::capsule: return RoundBody::capsule({0, 0, -y}, {0, 0, y}, x);
    case RoundShapeKind::box: {
      std::vector<Point3> corners = tests::cube_corners(-1, 1);
      for (Point3& c : corners) c = {c.x * x, c.y * y, c.z * z};
      return RoundBody::rounded(solid::ConvexPolyhedron(corners), 0);
    }
    case RoundShapeKind::cylinder: return RoundBody::cylinder({0, 0, -y}, {0, 0, y}, x);
    case RoundShapeKind::cone: return RoundBody::cone({0, 0, -y}, {0, 0, y}, x);
    case RoundShapeKind::ellipsoid: break;
  }
  return RoundBody::ellipsoid({}, {x, y, z});
}
Pose pose_of(const RoundPrimitive& p) { return Pose::from_matrix(p.linear, p.translation); }
void place(RoundPrimitive& p, const Pose& pose) {
  p.linear = pose.affine().linear;
  p.translation = pose.affine().translation;
}

struct Prepared {
  std::vector<RoundQuestion> questions;
  std::vector<RoundBody> bodies;  // two each
  std::vector<Pose> poses;
};

RoundPrimitive some(RoundShapeKind kind, double distance, Random& random) {
  const auto part = [&] { return random.uniform(-1, 1); };
  RoundPrimitive p{kind, {random.log_uniform(0.3, 1), random.log_uniform(0.3, 1), random.log_uniform(0.3, 1)}, {}, {}};
  place(p, Pose::from_quaternion(part(), part(), part(), part(),
                                 {distance * part(), distance * part(), distance * part()}));
  return p;
}

Prepared prepare(RoundShapeKind a, RoundShapeKind b, bool near, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  Prepared made;
  while (made.questions.size() < n) {
    RoundQuestion q{some(a, near ? 0.1 : 0.9, random), some(b, near ? 0.1 : 0.9, random)};
    const RoundBody body_a = body_of(q.a), body_b = body_of(q.b);
    if (near) {
      const Point3 u = tests::on_sphere(random), way{8 * u.x, 8 * u.y, 8 * u.z};
      const double t = tests::last_meeting(body_a, pose_of(q.a), body_b, pose_of(q.b), way);
      place(q.b, tests::moved(pose_of(q.b), way, t + (random.below(2) == 0 ? 1e-12 : -1e-12) / 8));
    }
    if (round_round(body_a, pose_of(q.a), body_b, pose_of(q.b)).undecided()) continue;
    made.questions.push_back(q);
    for (const RoundPrimitive* p : {&q.a, &q.b}) {
      made.bodies.push_back(body_of(*p));
      made.poses.push_back(pose_of(*p));
    }
  }
  return made;
}

Contest contest(RoundShapeKind a, RoundShapeKind b, bool near, std::size_t n, std::uint64_t seed) {
  const auto given = std::make_shared<const Prepared>(prepare(a, b, near, n, seed));
  const auto ask = [given](std::size_t k) {
    return round_round(given->bodies[2 * k], given->poses[2 * k], given->bodies[2 * k + 1], given->poses[2 * k + 1]);
  };
  Contest made;
  made.wrong_peers_count = true;
  for (std::size_t k = 0; k < n; ++k) made.truths.push_back(ask(k).meet() ? 1 : 0);
  made.subjects.push_back(
      {"sunder", "round_round", [=] { return Ready{each([=](std::size_t k) { return ask(k).meet(); }), {}}; }});
  for (const RoundWay& way : fcl_round_ways()) {
    made.peers.push_back({way.library, way.method, [=] { return Ready{way.run(given->questions), {}}; }});
  }
  return made;
}

// ---- Closer than a distance? Against whether they meet.

constexpr std::size_t kCloserVertices = 100;
constexpr double kCloserThan = 0.1, kCloserMost = 2, kCloserMostNear = 2.5;

struct CloserPair {
  RoundBody a, b;
  Pose pose_a, meet_b, closer_b;  // where B is, asked whether they meet, and whether they are closer
};

// random: the same pairs, of which about half meet. near: moved along a line to where they touch, or are so far apart,
// and by 1e-6 to 1e-3 of their size, 1, to either side.
std::vector<CloserPair> closer_pairs(bool near, std::size_t n, std::uint64_t seed) {
  Random random(seed);
  std::vector<RoundBody> pool;
  while (pool.size() < 32) {
    std::vector<Point3> points;
    while (points.size() < kCloserVertices) points.push_back(tests::on_sphere(random));
    pool.emplace_back(solid::ConvexPolyhedron(points));
  }
  const auto pose = [&](const Point3& at) {
    const auto part = [&] { return random.uniform(-1, 1); };
    return Pose::from_quaternion(part(), part(), part(), part(), {at.x, at.y, at.z});
  };
  std::vector<CloserPair> pairs;
  while (pairs.size() < n) {
    const RoundBody &a = pool[random.below(32)], &b = pool[random.below(32)];
    const Point3 u = tests::on_sphere(random);
    const Pose pose_a = pose({});
    const double far = random.uniform(1.7, 2.3);
    Pose meet_b = pose(near ? Point3{} : Point3{far * u.x, far * u.y, far * u.z}), closer_b = meet_b;
    if (near) {
      const Point3 way{8 * u.x, 8 * u.y, 8 * u.z};
      const double by = (random.below(2) == 0 ? 1 : -1) * random.log_uniform(1e-6, 1e-3) / 8;
      const RoundBody larger = RoundBody::rounded(a.core(), kCloserThan);
      closer_b = tests::moved(meet_b, way, tests::last_meeting(larger, pose_a, b, meet_b, way) + by);
      meet_b = tests::moved(meet_b, way, tests::last_meeting(a, pose_a, b, meet_b, way) + by);
    }
    pairs.push_back({a, b, pose_a, meet_b, closer_b});
  }
  return pairs;
}

Contest closer_contest(bool near, std::size_t n, std::uint64_t seed) {
  const auto pairs = std::make_shared<const std::vector<CloserPair>>(closer_pairs(near, n, seed));
  Contest made;
  for (const CloserPair& p : *pairs) {
    const auto distance = solid::polyhedron_polyhedron_distance(p.a.core(), p.pose_a, p.b.core(), p.closer_b);
    made.truths.push_back(compare_distance(distance, kCloserThan) == Sign::negative ? 1 : 0);
  }
  made.yardstick = [pairs] {
    const double start = thread_seconds();
    std::size_t meet = 0;
    for (const CloserPair& p : *pairs) {
      meet += polyhedron_polyhedron(p.a.core(), p.pose_a, p.b.core(), p.meet_b).meet() ? 1 : 0;
    }
    const double elapsed = thread_seconds() - start;
    return (elapsed + (meet > pairs->size() ? 1 : 0)) / static_cast<double>(pairs->size());
  };
  made.subjects.push_back({"sunder", "clearance_verdict", [pairs] {
                             return Ready{each([pairs](std::size_t k) {
                                            const CloserPair& p = (*pairs)[k];
                                            return solid::clearance_verdict(solid::PlacedRound(p.a, p.pose_a),
                                                                            solid::PlacedRound(p.b, p.closer_b),
                                                                            kCloserThan) == Verdict::meet;
                                          }),
                                          {}};
                           }});
  return made;
}

// What is demanded of FCL's time over Sunder's.
constexpr double kAtLeastAsFast = 1;

std::vector<Plan> plans(const Options&) {
  std::vector<Plan> list;
  for (const bool near : {false, true}) {
    Demand demand;
    demand.most_sorts = {{0, near ? kCloserMostNear : kCloserMost}};
    list.push_back(
        {near ? "closer, near" : "closer, random", "closer", demand, {500}, [=](std::size_t n, std::uint64_t seed) {
           return closer_contest(near, n, seed);
         }});
  }
  for (const bool near : {false, true}) {
    for (std::size_t i = 0; i < kRoundShapeKinds; ++i) {
      for (std::size_t j = i; j < kRoundShapeKinds; ++j) {
        if (i == 2 && j == 2) continue;  // box and box: bench_pair
        const auto a = static_cast<RoundShapeKind>(i), b = static_cast<RoundShapeKind>(j);
        Demand demand;
        demand.peers = {{0, kAtLeastAsFast}};
        list.push_back({std::string(kNames[i]) + ", " + kNames[j],
                        near ? "near" : "random",
                        demand,
                        {500},
                        [=](std::size_t n, std::uint64_t seed) { return contest(a, b, near, n, seed); }});
      }
    }
  }
  return list;
}

// Who was faster, and wrong how often.
void conclude(const std::vector<Row>& rows, std::vector<std::string>&) {
  int faster = 0, measured = 0;
  for (const Row& row : rows) {
    for (const Result& peer : row.peers) {
      if (peer.state != Result::State::measured) continue;
      ++measured;
      if (row.ratio(peer) >= 1) ++faster;
    }
  }
  std::printf("At least as fast as FCL in %d of %d rows.\n", faster, measured);
  for (const Row& row : rows) {
    for (const Result& look : row.looks) {
      if (look.wrong == 0) continue;
      std::printf("Wrong: %zu of %zu, %s, %s: %s, %s\n", look.wrong, look.asked, row.input.c_str(),
                  row.question.c_str(), look.library.c_str(), look.method.c_str());
    }
  }
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_round";
  program.note =
      "N: pairs. Wrong: of these. closer: than a tenth of their size, polyhedra of 100 vertices; its \"sorts\" are "
      "times "
      "of \"do they meet?\".";
  program.libraries = {"fcl"};
  program.questions = {"random", "near", "closer"};
  program.plans = bench::plans;
  program.conclude = bench::conclude;
  return bench::run(program, argc, argv);
}
