#include <bench/peers/body_peer.h>
#include <bench/peers/sunder_bodies.h>
#include <bench/peers/sunder_pairs.h>

#include <sunder/solid/pair/polyhedron_polyhedron.h>
#include <sunder/solid/pair/polyhedron_polyhedron_distance.h>

#include <array>
#include <memory>
#include <vector>

namespace bench {
namespace {

using sunder::solid::ConvexPolyhedron;
using sunder::solid::Pose;

struct Pair {
  const ConvexPolyhedron* a;
  const ConvexPolyhedron* b;
  Pose pose_a, pose_b;
};

struct Bodies {
  explicit Bodies(const Scenario& scenario) {
    bodies.reserve(scenario.pool.size());  // pairs point into it
    for (const Body& body : scenario.pool) {
      std::vector<sunder::Point3> points;
      for (const Vec& p : body.points) points.push_back({p[0], p[1], p[2]});
      bodies.emplace_back(points);
    }
    for (const Query& query : scenario.queries) {
      pairs.push_back({&bodies[query.a], &bodies[query.b],
                       Pose::from_matrix(query.pose_a.linear, query.pose_a.translation),
                       Pose::from_matrix(query.pose_b.linear, query.pose_b.translation)});
    }
  }
  sunder::PairAnswer answer(std::size_t k) const {
    const Pair& q = pairs[k];
    return sunder::intersect(*q.a, q.pose_a, *q.b, q.pose_b);
  }

  sunder::PairAnswer answer_by(std::size_t k, PairBy by) const {
    constexpr std::array methods{
        sunder::solid::polyhedron_polyhedron_by_hierarchy, sunder::solid::polyhedron_polyhedron_by_bounded,
        sunder::solid::polyhedron_polyhedron_by_polar, sunder::solid::polyhedron_polyhedron_by_drums,
        sunder::solid::polyhedron_polyhedron_by_scan};
    const Pair& q = pairs[k];
    return methods.at(static_cast<std::size_t>(by))(*q.a, q.pose_a, *q.b, q.pose_b);
  }

  sunder::solid::PolyhedronDistance distance(std::size_t k) const {
    const Pair& q = pairs[k];
    return polyhedron_polyhedron_distance(*q.a, q.pose_a, *q.b, q.pose_b);
  }

  std::vector<ConvexPolyhedron> bodies;
  std::vector<Pair> pairs;
};

}  // namespace

Ready prepare_sunder(const Scenario& scenario) {
  const auto given = std::make_shared<const Bodies>(scenario);
  return {run_pairs([given](std::size_t k) { return given->answer(k); }), [given] {
            Tally sum;
            for (std::size_t k = 0; k < given->pairs.size(); ++k) sum += tally_of(given->answer(k), false);
            return sum;
          }};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): a std::function frees what it holds

Ready prepare_sunder_by(const Scenario& scenario, PairBy by) {
  const auto given = std::make_shared<const Bodies>(scenario);
  return {run_pairs([given, by](std::size_t k) { return given->answer_by(k, by); }), [given, by] {
            Tally sum;
            for (std::size_t k = 0; k < given->pairs.size(); ++k) sum += tally_of(given->answer_by(k, by), false);
            return sum;
          }};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): likewise

Ready prepare_sunder_distance(const Scenario& scenario, DistanceAs as) {
  const auto given = std::make_shared<const Bodies>(scenario);
  const auto ask = [given, as](std::size_t k) {
    const sunder::solid::PolyhedronDistance answer = given->distance(k);
    consume(answer);
    if (as == DistanceAs::features) return answer.meet();
    return distance_of(answer).high == 0;
  };
  return {each(ask), [given] {
            Tally sum;
            for (std::size_t k = 0; k < given->pairs.size(); ++k) sum += tally_of(given->distance(k), false);
            return sum;
          }};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): likewise

std::vector<std::array<std::uint32_t, 3>> triangles_by_sunder(const std::vector<Vec>& points) {
  std::vector<sunder::Point3> of_hull;
  for (const Vec& p : points) of_hull.push_back({p[0], p[1], p[2]});
  const ConvexPolyhedron body(of_hull);
  std::vector<std::array<std::uint32_t, 3>> triangles;
  for (std::uint32_t f = 0; f < body.facet_count(); ++f) {
    const auto facet = body.facet(f);
    for (std::size_t k = 1; k + 1 < facet.size(); ++k) {
      triangles.push_back({body.source()[facet[0]], body.source()[facet[k]], body.source()[facet[k + 1]]});
    }
  }
  return triangles;
}

}  // namespace bench
