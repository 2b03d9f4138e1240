#include <sunder/solid/round/round_round_warm.h>

namespace sunder::solid {

RoundAnswer round_round_by(PolyhedronMethod method, const RoundBody& a, const Pose& pose_a, const RoundBody& b,
                           const Pose& pose_b) {
  if (!a.is_polyhedron() || !b.is_polyhedron()) return round_round(a, pose_a, b, pose_b);
  return round_answer(method(a.core(), pose_a, b.core(), pose_b));
}

RoundAnswer round_round_warm(const RoundBody& a, const Pose& pose_a, const RoundBody& b, const Pose& pose_b,
                             WarmStart& last) {
  if (!a.is_polyhedron() || !b.is_polyhedron()) return round_round(a, pose_a, b, pose_b);
  return round_answer(polyhedron_polyhedron_warm(a.core(), pose_a, b.core(), pose_b, last));
}

}  // namespace sunder::solid
