#include "polygon_subject.h"

#include <sunder/base/random.h>
#include <sunder/certificate/check.h>

#include <vector>

namespace bench {
namespace {

using sunder::PairAnswer;
using sunder::Point3;
using sunder::planar::ConvexPolygon;
using sunder::planar::Pose;

constexpr PolygonMethod kMethods[] = {
    {"front door", sunder::planar::polygon_polygon},
    {"difference", sunder::planar::polygon_polygon_by_difference},
    {"halving", sunder::planar::polygon_polygon_by_halving},
    {"triangles", sunder::planar::polygon_polygon_by_triangles},
    {"gjk", sunder::planar::polygon_polygon_by_gjk},
};

std::vector<Point3> in_space(const ConvexPolygon& polygon) {
  std::vector<Point3> points;
  points.reserve(polygon.size());
  for (const sunder::Point2& p : polygon.vertices()) points.push_back({p.x, p.y, 0});
  return points;
}

class Subject final : public PolygonSubject {
 public:
  Subject(const PolygonScenario& scenario, const PolygonMethod& method, bool posed)
      : scenario_(scenario), method_(method) {
    sunder::Random random(scenario.n);
    for (std::size_t i = 0; posed && i < scenario.pairs.size(); ++i) {
      const double angle = random.uniform(-3, 3), x = random.uniform(-2, 2), y = random.uniform(-2, 2);
      poses_.push_back(Pose::from_angle(angle, {x, y}));
    }
  }

  void run(std::size_t first, std::span<std::uint8_t> answers) override {
    for (std::size_t i = 0; i < answers.size(); ++i) {
      const PairAnswer answer = ask(first + i);
      consume(answer);
      answers[i] = answer.meet() ? 1 : 0;
    }
  }

  PolygonTally tally(bool certificates) const override {
    PolygonTally sum;
    for (std::size_t i = 0; i < scenario_.pairs.size(); ++i) {
      const PairAnswer answer = ask(i);
      const bool right = answer.meet() == scenario_.pairs[i].meet && (!certificates || holds(answer.certificate(), i));
      sum += {1, answer.decided_by == sunder::DecidedBy::finishing, answer.cost.probes, answer.cost.exact, !right};
    }
    return sum;
  }

 private:
  // The compiler has to suppose that all of the answer, its certificate too, is read here.
  static void consume(const PairAnswer& answer) { asm volatile("" : : "g"(&answer) : "memory"); }

  const Pose& pose_of(std::size_t i) const { return poses_.empty() ? identity_ : poses_[i]; }
  PairAnswer ask(std::size_t i) const {
    const PolygonPair& pair = scenario_.pairs[i];
    return method_.answer(scenario_.polygons[pair.a], pose_of(i), scenario_.polygons[pair.b], pose_of(i));
  }

  bool holds(const sunder::PairCertificate& certificate, std::size_t i) const {
    const PolygonPair& pair = scenario_.pairs[i];
    const sunder::Affine3 pose = sunder::planar::in_space(pose_of(i).affine());
    const std::vector<Point3> a = in_space(scenario_.polygons[pair.a]), b = in_space(scenario_.polygons[pair.b]);
    return sunder::check_absolutely(certificate, {a, pose, false}, {b, pose, false}) == sunder::CheckResult::accepted;
  }

  const PolygonScenario& scenario_;
  const PolygonMethod& method_;
  const Pose identity_;
  std::vector<Pose> poses_;
};

}  // namespace

PolygonTally& PolygonTally::operator+=(const PolygonTally& other) {
  pairs += other.pairs;
  finishing += other.finishing;
  probes += other.probes;
  exact += other.exact;
  wrong += other.wrong;
  return *this;
}

std::span<const PolygonMethod> polygon_methods() { return kMethods; }

std::unique_ptr<PolygonSubject> make_polygon_subject(const PolygonScenario& scenario, const PolygonMethod& method,
                                                     bool posed) {
  return std::make_unique<Subject>(scenario, method, posed);
}

}  // namespace bench
