// The certificate file of what meets on the way between successive placements (docs/claims.md, "motion").
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/scene/scene_said.h>
#include <sunder/scene/sweep.h>

#include <cstddef>
#include <functional>
#include <span>

namespace sunder::scene {

// From one placement to the next; the spans hold until the next one is asked for.
struct SweptStep {
  std::span<const Body> begin, end;
  std::span<const SweptPair> pairs;  // of an answer to the question
};

// Of so many steps, which begin and end at the placements `count` and one more: what is stated of the pairs. Those that
// meet: by a motion, or, where they were asked at their ends only, by the pair at that end. With every_pair: that all
// others are apart, but for those at their ends only. What was decided of meshes is stated of these (`mesh_motion`). Each
// step is asked for four times. allowed: pairs of bodies, as the question says; they are told with what the origin leaves
// out, and so is all that no statement is about. Requires a pair that is stated. Throws what the sink and `step` throw.
// Memory: a name and a pose for each part of a pair.
void write_motion_certificate(std::span<const Body> bodies, std::size_t count,
                              const std::function<SweptStep(std::size_t k)>& step, const Question& question,
                              Origin origin, const TextSink& sink, const SaidOfScene& said = {});

}  // namespace sunder::scene
