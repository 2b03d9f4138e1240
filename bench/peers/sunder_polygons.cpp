#include <bench/peers/sunder_pairs.h>
#include <bench/peers/sunder_polygons.h>

#include <sunder/base/random.h>
#include <sunder/certificate/check.h>

#include <memory>
#include <utility>
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

class Subject {
 public:
  Subject(std::shared_ptr<const PolygonScenario> scenario, const PolygonMethod& method, bool posed)
      : scenario_(std::move(scenario)), method_(method) {
    sunder::Random random(scenario_->n);
    for (std::size_t i = 0; posed && i < size(); ++i) {
      const double angle = random.uniform(-3, 3), x = random.uniform(-2, 2), y = random.uniform(-2, 2);
      poses_.push_back(Pose::from_angle(angle, {x, y}));
    }
  }

  std::size_t size() const { return scenario_->pairs.size(); }
  const Pose& pose_of(std::size_t i) const { return poses_.empty() ? identity_ : poses_[i]; }
  PairAnswer answer(std::size_t i) const {
    const PolygonPair& pair = scenario_->pairs[i];
    return method_.answer(scenario_->polygons[pair.a], pose_of(i), scenario_->polygons[pair.b], pose_of(i));
  }

  Tally tally(bool certificates) const {
    Tally sum;
    for (std::size_t i = 0; i < size(); ++i) {
      const PairAnswer of_i = answer(i);
      const bool right = of_i.meet() == scenario_->pairs[i].meet && (!certificates || holds(of_i.evidence, i));
      sum += tally_of(of_i, !right);
    }
    return sum;
  }

 private:
  bool holds(const sunder::PairCertificate& certificate, std::size_t i) const {
    const PolygonPair& pair = scenario_->pairs[i];
    const sunder::Affine3 pose = sunder::planar::in_space(pose_of(i).affine());
    const std::vector<Point3> a = in_space(scenario_->polygons[pair.a]), b = in_space(scenario_->polygons[pair.b]);
    return sunder::check_absolutely(certificate, {a, pose, false}, {b, pose, false}) == sunder::CheckResult::accepted;
  }

  const std::shared_ptr<const PolygonScenario> scenario_;
  const PolygonMethod& method_;
  const Pose identity_;
  std::vector<Pose> poses_;
};

}  // namespace

std::span<const PolygonMethod> polygon_methods() { return kMethods; }

Ready prepare_sunder(std::shared_ptr<const PolygonScenario> scenario, const PolygonMethod& method, bool posed,
                     bool certificates) {
  const auto subject = std::make_shared<const Subject>(std::move(scenario), method, posed);
  return {run_pairs([subject](std::size_t k) { return subject->answer(k); }),
          [=] { return subject->tally(certificates); }};
}  // NOLINT(clang-analyzer-cplusplus.NewDeleteLeaks): a std::function frees what it holds

}  // namespace bench
