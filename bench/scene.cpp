// bench_scene: which bodies of a scene meet, step after step? An arm (the hulls of the links of a Panda, neighbours
// left out) in random placements and in slow motion; and swarms of bodies of 100 vertices that drift and turn slowly.
// Against FCL's dynamic AABB tree manager, and, for the arm, a loop over all pairs of boxes.
//
// Fairness:
//   - An input is a step, and all contestants are asked about the same steps in their order, in rounds. Poses of bodies
//     and transforms are prepared; moving the objects there is timed, for all.
//   - The answer is how many pairs meet; a peer is wrong about a step where it counts another number than exact
//     predicates do. FCL's GJK takes bodies for apart, or not, within 1e-6. Wrong peers count: hardly any step of a
//     swarm is right with tolerances.
//   - Sunder's follower keeps what it knows from step to step, as in `sunder scene --placements` within a chain; "cold"
//     forgets it before each step; "all at once" is meeting_pairs, which makes evidence for every pair that it looks
//     at.
//   - Sunder's answer has the certificate of every pair that meets; FCL's is a boolean.
//
// At the end warm questions about two bodies that move slowly near contact are compared with cold ones.
#include <bench/contest/program.h>
#include <bench/peers/scene_peer.h>

#include <sunder/base/random.h>
#include <sunder/io/robot/robot_bodies.h>
#include <sunder/io/robot/robot_motion.h>
#include <sunder/io/robot/urdf.h>
#include <sunder/near/box_sweep.h>
#include <sunder/scene/follower.h>
#include <sunder/solid/pair/polyhedron_polyhedron_warm.h>

#include <tests/support/shapes.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <utility>
#include <vector>

namespace bench {
namespace {

using sunder::Point3;
using sunder::Random;
using sunder::solid::ConvexPolyhedron;
using sunder::solid::Pose;
using Scenario = std::shared_ptr<const SceneScenario>;

// What an issue demands: at most a fifth of FCL's time.
const Steps kByFcl{{0, 5}};

std::vector<sunder::scene::Body> bodies_of(const SceneScenario& scenario) {
  std::vector<sunder::scene::Body> bodies;
  for (std::size_t i = 0; i < scenario.shapes.size(); ++i) {
    bodies.push_back({"", {{"", scenario.shapes[i], scenario.steps.front()[i]}}});
  }
  return bodies;
}

sunder::scene::Question question_of(const SceneScenario& scenario) {
  sunder::scene::Question question;
  question.allowed = scenario.allowed;
  return question;
}

Run follow(const Scenario& scenario, bool is_cold) {
  const auto follower = std::make_shared<sunder::scene::Follower>(bodies_of(*scenario), question_of(*scenario));
  return each([=](std::size_t k) {
    if (is_cold) follower->forget();
    const std::vector<Pose>& poses = scenario->steps[k];
    for (std::uint32_t i = 0; i < poses.size(); ++i) follower->place(i, poses[i]);
    return follower->ask().counts.meeting;
  });
}

Run all_at_once(const Scenario& scenario) {
  return each([bodies = bodies_of(*scenario), question = question_of(*scenario), scenario](std::size_t k) mutable {
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].parts[0].pose = scenario->steps[k][i];
    return sunder::scene::meeting_pairs(bodies, question).counts.meeting;
  });
}

Contest contest_of(const Scenario& scenario, bool has_loop) {
  Contest made;
  const Run truth = all_at_once(scenario);
  std::uint64_t pairs = 0, meeting = 0;
  for (std::size_t k = 0; k < scenario->steps.size(); ++k) {
    made.truths.push_back(truth(k, 1));
    meeting += made.truths.back();
  }
  for (std::size_t k = 0; k < scenario->steps.size(); k += 8) {
    auto bodies = bodies_of(*scenario);
    for (std::size_t i = 0; i < bodies.size(); ++i) bodies[i].parts[0].pose = scenario->steps[k][i];
    pairs += sunder::scene::meeting_pairs(bodies, question_of(*scenario)).counts.by_method;
  }
  const double steps = static_cast<double>(scenario->steps.size());
  std::printf("%zu bodies, %.0f steps: %.0f pairs of boxes meet in a step, %.1f pairs of bodies\n",
              scenario->shapes.size(), steps, static_cast<double>(pairs) / std::ceil(steps / 8),
              static_cast<double>(meeting) / steps);
  made.wrong_peers_count = true;
  made.subjects = {{"sunder", "follower", [=] { return Ready{follow(scenario, false)}; }},
                   {"sunder", "cold", [=] { return Ready{follow(scenario, true)}; }},
                   {"sunder", "all at once", [=] { return Ready{all_at_once(scenario)}; }}};
  for (const SceneWay& way : fcl_scene_ways()) {
    if (way.method == "loop" && !has_loop) continue;
    made.peers.push_back(
        {std::string(way.library), std::string(way.method), [=] { return Ready{way.make(*scenario)}; }});
  }
  return made;
}

// The first convex part of each link.
Scenario arm(bool is_slow, std::size_t steps, std::uint64_t seed) {
  auto made = std::make_shared<SceneScenario>();
  const std::string file = SUNDER_BENCH_ARM;
  const sunder::io::Robot robot = sunder::io::read_urdf(file);
  sunder::io::LeftOutList left_out(true);
  const sunder::io::RobotBodies bodies = sunder::io::read_robot_bodies(robot, file, false, left_out);
  made->allowed = sunder::io::adjacent_bodies(robot, bodies);
  for (const auto& body : bodies.bodies) made->shapes.push_back(body.parts.front().body.hull);
  const std::vector<std::string> joints = sunder::io::movable_joints(robot);
  const sunder::io::RobotMotion motion(robot, joints);
  Random random(seed);
  std::vector<double> values(joints.size()), phase(joints.size());
  for (double& p : phase) p = random.uniform(0, 6);
  std::vector<sunder::Affine3> links(robot.links.size());
  for (std::size_t k = 0; k < steps; ++k) {
    for (std::size_t j = 0; j < joints.size(); ++j) {
      const auto& joint = motion.joint_of(j);
      const double part =
          is_slow ? 0.5 + 0.5 * std::sin(phase[j] + 0.002 * static_cast<double>(k * (j + 1))) : random.uniform(0, 1);
      values[j] = joint.lower + part * (joint.upper - joint.lower);
    }
    motion.place(values, links);
    made->steps.emplace_back();
    for (const auto& body : bodies.bodies) {
      const sunder::Affine3& link = links[body.link];
      made->steps.back().push_back(compose(Pose::from_matrix(link.linear, link.translation), body.parts.front().pose));
    }
  }
  return made;
}

// n bodies of 100 vertices and radius 1 at a density of about six boxes that each box meets; they drift by up to a
// hundredth of the radius a step, and turn.
Scenario swarm(std::size_t n, std::size_t steps, std::uint64_t seed) {
  auto made = std::make_shared<SceneScenario>();
  Random random(seed);
  std::vector<ConvexPolyhedron> pool;
  for (int k = 0; k < 100; ++k) pool.emplace_back(sunder::tests::points_on_sphere(100, random));
  const double side = std::cbrt(static_cast<double>(n) * 60 / 6);
  std::vector<Point3> at, velocity, axis;
  for (std::size_t i = 0; i < n; ++i) {
    made->shapes.push_back(pool[i % pool.size()]);
    const auto u = [&](double by) { return by * random.uniform(-1, 1); };
    at.push_back({u(side / 2), u(side / 2), u(side / 2)});
    velocity.push_back({u(0.01), u(0.01), u(0.01)});
    axis.push_back({u(0.01), u(0.01), u(0.01)});
  }
  for (std::size_t k = 0; k < steps; ++k) {
    const double t = static_cast<double>(k);
    made->steps.emplace_back();
    for (std::size_t i = 0; i < n; ++i) {
      const Point3 &p = at[i], &v = velocity[i], &w = axis[i];
      made->steps.back().push_back(
          Pose::from_quaternion(1, t * w.x, t * w.y, t * w.z, {p.x + t * v.x, p.y + t * v.y, p.z + t * v.z}));
    }
  }
  return made;
}

std::vector<Plan> plans(const Options& options) {
  const std::size_t placements = options.quick ? 500 : 4000, steps = options.quick ? 8 : 40;
  std::vector<Plan> list;
  for (const bool is_slow : {false, true}) {
    list.push_back(
        {is_slow ? "slow" : "random", "arm", Demand{"fcl", kByFcl}, {10}, [=](std::size_t, std::uint64_t seed) {
           return contest_of(arm(is_slow, placements, seed), true);
         }});
  }
  list.push_back({"drifting", "swarm", Demand{"fcl", kByFcl}, {1000, 10000}, [=](std::size_t n, std::uint64_t seed) {
                    return contest_of(swarm(n, steps, seed), false);
                  }});
  return list;
}

// --- A warm start ----------------------------------------------------------------------------------------------------

constexpr double kMostOfCold = 0.5;

// Pairs of bodies of 100 vertices that pass each other slowly, and turn: near contact all the way.
struct SlowPairs {
  struct Step {
    std::size_t pair;
    Pose pose_b;
  };
  std::vector<ConvexPolyhedron> a, b;
  std::vector<Step> steps;

  explicit SlowPairs(std::size_t pairs) {
    Random random(7);
    for (std::size_t k = 0; k < pairs; ++k) {
      a.emplace_back(sunder::tests::points_on_sphere(100, random));
      b.emplace_back(sunder::tests::points_on_sphere(100, random));
      const Point3 from = sunder::tests::on_sphere(random), way = sunder::tests::on_sphere(random);
      for (int step = -100; step < 100; ++step) {
        const double t = 0.003 * step, turn = 0.001 * step;
        steps.push_back({k, Pose::from_quaternion(
                                1, turn * way.y, turn * way.z, turn * way.x,
                                {1.98 * from.x + t * way.x, 1.98 * from.y + t * way.y, 1.98 * from.z + t * way.z})});
      }
    }
  }

  // Seconds a question; meeting: how many meet.
  double time(bool is_warm, std::uint64_t& meeting) const {
    std::vector<sunder::solid::WarmStart> last(a.size());
    meeting = 0;
    const double start = thread_seconds();
    for (const Step& step : steps) {
      const ConvexPolyhedron &p = a[step.pair], &q = b[step.pair];
      const sunder::PairAnswer answer =
          is_warm ? sunder::solid::polyhedron_polyhedron_warm(p, Pose(), q, step.pose_b, last[step.pair])
                  : sunder::solid::polyhedron_polyhedron(p, Pose(), q, step.pose_b);
      meeting += answer.meet();
    }
    return (thread_seconds() - start) / static_cast<double>(steps.size());
  }
};

void conclude(const std::vector<Row>&, std::vector<std::string>& failures) {
  const SlowPairs pairs(100);
  std::vector<double> cold, part;
  std::uint64_t meet_cold = 0, meet_warm = 0;
  for (int round = 0; round < 11; ++round) {
    cold.push_back(pairs.time(false, meet_cold));
    part.push_back(pairs.time(true, meet_warm) / cold.back());
  }
  std::sort(cold.begin(), cold.end());
  std::sort(part.begin(), part.end());
  char text[160];
  std::snprintf(text, sizeof text, "a warm question about slow bodies near contact takes %.2f of a cold one", part[5]);
  std::printf("%s (allowed: %.2f), which takes %.0f ns; %.0f %% of them meet\n", text, kMostOfCold, 1e9 * cold[5],
              100 * static_cast<double>(meet_cold) / static_cast<double>(pairs.steps.size()));
  if (part[5] > kMostOfCold) failures.emplace_back(text);
  if (meet_cold != meet_warm) failures.emplace_back("warm answers differ from cold ones");
}

}  // namespace
}  // namespace bench

int main(int argc, char** argv) {
  bench::Program program;
  program.name = "bench_scene";
  program.note = "N: bodies. A call is a step of the scene. Wrong: of all steps.";
  program.libraries = {"fcl", "fcl-loop"};
  program.questions = {"arm", "swarm"};
  program.plans = bench::plans;
  program.tells_subjects = true;
  program.conclude = bench::conclude;
  return bench::run(program, argc, argv);
}
