// Scenes of meshes that are not convex, among convex bodies, balls and cylinders: which meet, of each pair alone;
// how far apart they are, of each against all triangles; the follower against meeting_pairs; and each certificate by its checker.
#include <tests/support/scale.h>
#include <tests/support/shapes.h>

#include <sunder/base/random.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/clearance_follower.h>
#include <sunder/scene/follower.h>
#include <sunder/scene/scene_claims.h>
#include <sunder/solid/mesh/mesh_distance.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/round/round_distance.h>

#include <verifier/cpp/verify.h>

#include <gtest/gtest.h>

#include <cstdint>
#include <cstdio>
#include <limits>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::tests {
namespace {

using scene::Answer;
using scene::Body;
using scene::Part;
using scene::PartPair;
using scene::Question;
using solid::ConvexPolyhedron;
using solid::Mesh;
using solid::MeshView;
using solid::Pose;
using solid::RoundBody;

// A frame of four bars around a hole: of a square of size 4, 1 high; perhaps without its upper side.
std::shared_ptr<const Mesh> frame_mesh(bool is_open) {
  std::vector<Point3> points;
  for (const double z : {0.0, 1.0}) {
    for (const double size : {2.0, 1.0}) {
      for (const auto& [x, y] : {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)}) {
        points.push_back({x * size, y * size, z});
      }
    }
  }
  std::vector<std::uint32_t> begin{0}, corners;
  const auto face = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    corners.insert(corners.end(), {a, b, c, d});
    begin.push_back(static_cast<std::uint32_t>(corners.size()));
  };
  for (std::uint32_t k = 0; k < 4; ++k) {
    const std::uint32_t n = (k + 1) % 4;
    face(k, n, 8 + n, 8 + k);            // outside
    face(4 + n, 4 + k, 12 + k, 12 + n);  // around the hole
    face(n, k, 4 + k, 4 + n);            // below
    if (!is_open) face(8 + k, 8 + n, 12 + n, 12 + k);
  }
  return std::make_shared<const Mesh>(MeshView{points, begin, corners});
}

Part mesh_part(const std::shared_ptr<const Mesh>& mesh, const Pose& pose) {
  const std::vector<Point3> points(mesh->points().begin(), mesh->points().end());
  return {"", ConvexPolyhedron(points), pose, mesh};
}

class MeshScenes {
 public:
  explicit MeshScenes(std::uint64_t seed) : random_(chosen_seed(seed)) {}

  std::vector<Body> next() {
    std::vector<Body> bodies(2 + random_.below(5));
    for (std::size_t b = 0; b < bodies.size(); ++b) {
      bodies[b].name = "b" + std::to_string(b);
      for (std::uint64_t parts = 1 + random_.below(2); parts > 0; --parts) bodies[b].parts.push_back(part());
    }
    return bodies;
  }

  // A frame, perhaps open, and a body that fits into its hole.
  std::vector<Body> plug_in_a_hole() {
    const auto quarter = [&] { return static_cast<double>(random_.between(-2, 2)) / 4; };
    const Pose there = Pose::from_matrix({0.5, 0, 0, 0, 0.5, 0, 0, 0, 0.5}, {quarter(), quarter(), quarter()});
    return {{"frame", {mesh_part(random_.below(4) == 0 ? open_ : closed_, Pose())}},
            {"plug", {Part{"", RoundBody(unit_), there}}}};
  }

  Pose anywhere() {
    const auto whole = [&] { return static_cast<double>(random_.between(-3, 3)); };
    const std::array<double, 3> shift{whole(), whole(), whole() / 2};
    if (random_.below(3) > 0) return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, shift);
    const auto u = [&] { return random_.uniform(-1, 1); };
    return Pose::from_quaternion(u(), u(), u(), 1, shift);
  }

  Random& random() { return random_; }

 private:
  Pose near() {
    const auto whole = [&] { return static_cast<double>(random_.between(-1, 1)); };
    return Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {whole(), whole(), whole() / 2});
  }

  Part part() {
    switch (random_.below(5)) {
      case 0: return mesh_part(open_, anywhere());
      case 1: return {"", RoundBody(unit_), near()};
      case 2:
        return {
            "",
            random_.below(2) == 0 ? RoundBody::ball({0, 0, 0}, 0.5) : RoundBody::cylinder({0, 0, -2}, {0, 0, 1}, 0.5),
            Pose::from_matrix({1, 0, 0, 0, 1, 0, 0, 0, 1}, {static_cast<double>(random_.between(-3, 3)),
                                                            static_cast<double>(random_.between(-3, 3)), 0.5})};
      case 3: return mesh_part(closed_, near());
      default: return mesh_part(closed_, anywhere());
    }
  }

  Random random_;
  std::shared_ptr<const Mesh> closed_ = frame_mesh(false), open_ = frame_mesh(true);
  ConvexPolyhedron unit_{cube_corners(-0.5, 0.5)};  // fits into the hole
};

// Of two meshes, or a mesh and a convex body or one with a radius, as they are.
bool meet_as_meshes(const Part& a, const Part& b) {
  if (!a.shape.is_polyhedron() || !b.shape.is_polyhedron()) {
    const Part &of_mesh = a.mesh != nullptr ? a : b, &round = a.mesh != nullptr ? b : a;
    return mesh_round_by_scan(*of_mesh.mesh, of_mesh.pose, solid::PlacedRound(round.shape, round.pose)).meet();
  }
  const auto mesh = [](const Part& part) { return part.mesh != nullptr ? *part.mesh : mesh_of(part.shape.core()); };
  return mesh_mesh_by_scan(mesh(a), a.pose, mesh(b), b.pose).meet();
}

// How many pairs a statement about all pairs leaves out.
std::size_t left_out(const std::string& sentence) {
  const std::size_t end = std::min(sentence.find(" pair not asked about"), sentence.find(" pairs not asked about"));
  if (end == std::string::npos) return 0;
  return std::stoul(sentence.substr(sentence.rfind(' ', end - 1) + 1));
}

// The pairs that the statement about all pairs leaves out are undecided; or, where touching is allowed, it is not told of
// them whether they overlap.
void expect_accepted(const std::vector<Body>& bodies, const Answer& answer, const Question& question,
                     std::map<std::string, int>& seen) {
  std::string text;
  write_certificate(std::array{scene::Placement{"here", bodies, answer}}, question, {},
                    [&](std::string_view piece) { text += piece; });
  const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
  for (const auto& statement : result.statements) {
    ASSERT_TRUE(statement.accepted) << statement.sentence << ": " << statement.failed_check << ": " << statement.reason;
  }
  ASSERT_TRUE(result.accepted()) << result.failed_form << result.error;
  std::size_t as_meshes = 0, overlapping = 0, stated = 0;
  for (const auto& statement : result.statements) {
    stated += statement.sentence.starts_with("the solid of") || statement.sentence.starts_with("the surface of") ||
              statement.sentence.starts_with("what is inside of the solid of");
  }
  for (const PartPair& pair : answer.pairs) {
    as_meshes += pair.meshes != nullptr;
    overlapping += pair.meshes && pair.meshes->relation.inside.has_value();
    if (pair.meshes) {
      ASSERT_EQ(pair.meshes->relation.inside.has_value(), pair.relation == Relation::overlapping);
    }
  }
  ASSERT_GE(stated, as_meshes);
  ASSERT_LE(overlapping, as_meshes);

  const auto& all = result.statements.back();
  ASSERT_TRUE(all.sentence.starts_with("exactly ")) << all.sentence;
  const std::size_t left = left_out(all.sentence);
  seen["pairs joined as meshes"] += static_cast<int>(as_meshes);
  if (question.touching_allowed) {
    seen["pairs that may touch"] += static_cast<int>(answer.pairs.size());
    seen["of these left out"] += static_cast<int>(left);
  } else {
    const auto meeting = static_cast<std::size_t>(answer.counts.meeting);
    ASSERT_EQ(left, answer.counts.undecided) << all.sentence;
    ASSERT_EQ(std::stoul(all.sentence.substr(8)), meeting) << all.sentence;
    ASSERT_EQ(all.sentence.find(" mesh") == std::string::npos, as_meshes == 0) << all.sentence;
  }
}

TEST(SceneMeshesDifferential, PairsAreAsOfMeshesAlone) {
  MeshScenes scenes(4021);
  const int times = scaled_count(80);
  std::map<std::string, int> seen;
  for (int i = 0; i < times; ++i) {
    const std::vector<Body> bodies = scenes.next();
    Question question;
    question.every_pair = true;
    question.contacts = i % 2 == 0;
    question.touching_allowed = i % 4 == 0;
    const Answer answer = meeting_pairs(bodies, question);
    for (const PartPair& pair : answer.pairs) {
      const Part &a = bodies[pair.body_a].parts[pair.part_a], &b = bodies[pair.body_b].parts[pair.part_b];
      if (a.mesh == nullptr && b.mesh == nullptr) {
        ASSERT_EQ(pair.meshes, nullptr);
        continue;
      }
      ASSERT_EQ(pair.meet(), meet_as_meshes(a, b)) << i;
      if (pair.answer.meet() && !(a.shape.is_polyhedron() && b.shape.is_polyhedron())) {
        ++seen[pair.meet() ? "a ball meets a mesh" : "a ball meets a hull alone"];
      }
      if (!pair.answer.meet()) {
        ++seen["apart by hulls"];
        continue;
      }
      ASSERT_NE(pair.meshes, nullptr);
      ++seen[pair.meet() ? "meet" : "apart as meshes"];
      if (pair.meet()) (void)rounded_common_point(pair, a, b);
    }
    const bool has_open = answer.counts.surfaces_alone > 0;
    seen["surfaces alone"] += has_open;
    if (i % 3 > 0) continue;
    ASSERT_NO_FATAL_FAILURE(expect_accepted(bodies, answer, question, seen));
  }
  for (const auto& [what, n] : seen) std::printf("%-20s %d\n", what.c_str(), n);
  for (const char* what : {"a ball meets a mesh", "a ball meets a hull alone", "apart by hulls", "meet",
                           "apart as meshes", "surfaces alone", "pairs joined as meshes"}) {
    EXPECT_GE(seen[what], times / 80) << what;
  }
  EXPECT_LE(2 * seen["of these left out"], seen["pairs that may touch"]);
}

// How far apart two parts are, as clearances say it.
Interval distance_as_meshes(const Part& a, const Part& b) {
  if (a.mesh == nullptr && b.mesh == nullptr) return distance_of(round_distance(a.shape, a.pose, b.shape, b.pose));
  if (!a.shape.is_polyhedron() || !b.shape.is_polyhedron()) {
    const Part &of_mesh = a.mesh != nullptr ? a : b, &round = a.mesh != nullptr ? b : a;
    const solid::PlacedRound placed(round.shape, round.pose);
    return mesh_round_distance_by_scan(*of_mesh.mesh, of_mesh.pose, placed,
                                       mesh_round_by_scan(*of_mesh.mesh, of_mesh.pose, placed))
        .distance;
  }
  const auto mesh = [](const Part& part) { return part.mesh != nullptr ? *part.mesh : mesh_of(part.shape.core()); };
  const Mesh of_a = mesh(a), of_b = mesh(b);
  return distance_of(mesh_distance_by_scan(of_a, a.pose, of_b, b.pose));
}

// Pairs of parts of which one is curved.
std::size_t curved_pairs(const std::vector<Body>& bodies) {
  std::size_t parts = 0, curved = 0;
  for (const Body& body : bodies) {
    parts += body.parts.size();
    for (const Part& part : body.parts) curved += part.shape.is_curved();
  }
  return parts * curved;
}

TEST(SceneMeshesDifferential, ClearancesAreAsOfMeshesAlone) {
  MeshScenes scenes(4023);
  const int times = scaled_count(50);
  int of_meshes = 0, kept_as_meshes = 0, alone = 0;
  for (int i = 0; i < times; ++i) {
    std::vector<Body> bodies = scenes.next();
    if (i % 2 == 1) bodies = scenes.plug_in_a_hole();
    scene::ClearanceQuestion question;
    question.least = i % 3 == 0 ? 0.25 : i % 3 == 1 ? 0.5 : 1.5;
    if (i % 4 == 0) question.margins.push_back({0, 1, 0.75});
    const scene::ClearanceAnswer answer = closer_pairs(bodies, question);
    scene::ClearanceFollower follower(bodies, question);
    const scene::ClearanceAnswer again = follower.ask(bodies);
    ASSERT_EQ(answer.closer.size(), again.closer.size());
    ASSERT_EQ(answer.surfaces_alone, again.surfaces_alone);
    std::size_t closer = 0;
    Interval least{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    for (std::uint32_t b = 0; b < bodies.size(); ++b) {
      for (std::uint32_t c = b + 1; c < bodies.size(); ++c) {
        for (const Part& p : bodies[b].parts) {
          for (const Part& q : bodies[c].parts) {
            const Interval distance = distance_as_meshes(p, q);
            if (distance.low < least.low) least = distance;
            const double margin = i % 4 == 0 && b == 0 && c == 1 ? 0.75 : question.least;
            const bool is_closer = distance.low < margin;  // margins are doubles: where both ends are it, it is kept
            kept_as_meshes += !is_closer && (p.mesh || q.mesh) &&
                              distance_of(round_distance(p.shape, p.pose, q.shape, q.pose)).low < margin;
            if (!is_closer) continue;
            ASSERT_LT(closer, answer.closer.size()) << i;
            const scene::CloserParts& found = answer.closer[closer];
            ASSERT_EQ(std::tie(found.body_a, found.body_b), std::tie(b, c));
            if (p.shape.is_curved() || q.shape.is_curved()) {
              ASSERT_TRUE(found.distance.low <= distance.high && distance.low <= found.distance.high);
            } else {
              ASSERT_EQ(found.distance.low, distance.low);
              ASSERT_EQ(found.distance.high, distance.high);
            }
            ASSERT_EQ(again.closer[closer].distance.low, found.distance.low);
            ASSERT_EQ(is_of_meshes(found, bodies), p.mesh || q.mesh);
            of_meshes += is_of_meshes(found, bodies);
            ++closer;
          }
        }
      }
    }
    ASSERT_EQ(closer, answer.closer.size()) << i;
    alone += answer.surfaces_alone > 0;
    const auto nearest = nearest_parts(bodies);
    ASSERT_TRUE(nearest->distance.low <= least.high && least.low <= nearest->distance.high) << i;
    if (i % 2 > 0) continue;
    std::string text;
    Question of_all;
    of_all.every_pair = true;
    const Answer met = meeting_pairs(bodies, of_all);
    write_certificate(
        std::array{scene::Placement{"here", bodies, met, &answer, &*nearest}}, of_all, {},
        [&](std::string_view piece) { text += piece; }, question);
    const auto result = sunder_verifier::verify_text(text, "certificate", sunder_verifier::Limit::none);
    ASSERT_TRUE(result.accepted()) << result.failed_form << result.error << text.substr(0, 2000);
    for (const auto& statement : result.statements) {
      if (statement.question != "clearances" || i % 4 == 0) continue;
      // The nearest pair's distance may be undecided where it is curved; that of meshes never leaves a pair out.
      ASSERT_LE(left_out(statement.sentence), answer.undecided.size() + curved_pairs(bodies)) << statement.sentence;
    }
    ASSERT_EQ(text.find("in a statement of their own"), std::string::npos);
  }
  std::printf("closer as meshes %d, far enough though hulls are not %d, surfaces alone %d\n", of_meshes, kept_as_meshes,
              alone);
  EXPECT_GE(of_meshes, times / 10);
  EXPECT_GE(kept_as_meshes, times / 25);
  EXPECT_GE(alone, times / 50);
}

TEST(SceneMeshesDifferential, TheFollowerAgrees) {
  MeshScenes scenes(4022);
  const int times = scaled_count(60);
  std::uint64_t meeting = 0, alone = 0;
  for (int i = 0; i < times; ++i) {
    std::vector<Body> bodies = scenes.next();
    scene::Follower follower(bodies);
    for (int step = 0; step < 10; ++step) {
      const Answer expected = meeting_pairs(bodies);
      const Answer& answer = follower.ask();
      std::size_t next = 0;
      for (const PartPair& pair : expected.pairs) {
        if (pair.verdict() == Verdict::apart) continue;
        ASSERT_LT(next, answer.pairs.size());
        const PartPair& found = answer.pairs[next++];
        ASSERT_EQ(std::tie(found.body_a, found.part_a, found.body_b, found.part_b),
                  std::tie(pair.body_a, pair.part_a, pair.body_b, pair.part_b));
        ASSERT_EQ(found.meshes != nullptr, pair.meshes != nullptr);
      }
      ASSERT_EQ(next, answer.pairs.size());
      ASSERT_EQ(answer.counts.meeting, expected.counts.meeting);
      ASSERT_EQ(answer.counts.surfaces_alone, expected.counts.surfaces_alone);
      meeting += answer.counts.meeting;
      alone += answer.counts.surfaces_alone;
      std::uint32_t number = 0;
      for (Body& body : bodies) {
        for (Part& part : body.parts) {
          if (part.shape.is_polyhedron() && scenes.random().below(2) == 0) {
            part.pose = scenes.anywhere();
            follower.place(number, part.pose);
          }
          ++number;
        }
      }
    }
  }
  EXPECT_GE(meeting, static_cast<std::uint64_t>(times / 30));
  EXPECT_GE(alone, static_cast<std::uint64_t>(times / 60));
}

}  // namespace
}  // namespace sunder::tests
