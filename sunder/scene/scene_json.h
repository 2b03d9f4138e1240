// The certificate file of scenes (docs/claims.md, "pair", "all_pairs"): of each placement its pairs, and that these are
// all.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/scene.h>

#include <span>
#include <string_view>

namespace sunder::scene {

// One placement of the bodies, and its answer.
struct Placement {
  std::string_view title;
  std::span<const Body> bodies;
  const Answer& answer;
  const ClearanceAnswer* clearance = nullptr;  // none: it is not stated
  const PartDistance* nearest = nullptr;       // likewise
};

// One placement at least, all of the same bodies; their answers to the question, which asked for every pair. That
// bodies are allowed to meet is told with what the origin leaves out; so is each pair that is undecided. clearance:
// what the placements' answers about clearances were asked. Throws what the sink throws.
void write_certificate(std::span<const Placement> placements, const Question& question, Origin origin,
                       const TextSink& sink, const ClearanceQuestion& clearance = {});

}  // namespace sunder::scene
