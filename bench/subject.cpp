#include "subject.h"

#include <sunder/solid/pair/polyhedron_polyhedron.h>

#include <vector>

namespace bench {
namespace {

using sunder::Point3;
using sunder::solid::ConvexPolyhedron;
using sunder::solid::PairAnswer;
using sunder::solid::Pose;

struct Prepared {
  const ConvexPolyhedron* a;
  const ConvexPolyhedron* b;
  Pose pose_a, pose_b;
};

class SunderSubject : public Subject {
 public:
  explicit SunderSubject(const Scenario& scenario) {
    bodies_.reserve(scenario.pool.size());  // queries point into it
    for (const Body& body : scenario.pool) {
      std::vector<Point3> points;
      for (const Vec& p : body.points) points.push_back({p[0], p[1], p[2]});
      bodies_.emplace_back(points);
    }
    for (const Query& query : scenario.queries) {
      queries_.push_back({&bodies_[query.a], &bodies_[query.b],
                          Pose::from_matrix(query.pose_a.linear, query.pose_a.translation),
                          Pose::from_matrix(query.pose_b.linear, query.pose_b.translation)});
    }
  }

  std::string_view library() const override { return "sunder"; }
  std::string_view method() const override { return "front door"; }

  void run(std::span<std::uint8_t> meets) override {
    for (std::size_t i = 0; i < queries_.size(); ++i) {
      const Prepared& q = queries_[i];
      const PairAnswer answer = sunder::intersect(*q.a, q.pose_a, *q.b, q.pose_b);
      consume(answer);
      meets[i] = answer.meet();
    }
  }

  Tally tally() const override {
    Tally sum;
    for (const Prepared& q : queries_) {
      const PairAnswer answer = sunder::intersect(*q.a, q.pose_a, *q.b, q.pose_b);
      switch (answer.decided_by) {
        case sunder::DecidedBy::filter: ++sum.filter; break;
        case sunder::DecidedBy::evidence: ++sum.evidence; break;
        case sunder::DecidedBy::finishing: ++sum.finishing; break;
        case sunder::DecidedBy::scan: break;  // the front door does not
      }
      sum.probes += answer.cost.probes;
      sum.iterations += answer.cost.iterations;
      sum.exact += answer.cost.exact;
    }
    return sum;
  }

 private:
  // The compiler has to suppose that all of the answer, its certificate too, is read here.
  static void consume(const PairAnswer& answer) { asm volatile("" : : "g"(&answer) : "memory"); }

  std::vector<ConvexPolyhedron> bodies_;
  std::vector<Prepared> queries_;
};

}  // namespace

std::unique_ptr<Subject> make_sunder(const Scenario& scenario) { return std::make_unique<SunderSubject>(scenario); }

}  // namespace bench
