// The certificate file of scenes (docs/claims.md, "pair", "all_pairs"): of each placement its pairs, and that these are
// all.
#pragma once

#include <sunder/certificate/claims.h>
#include <sunder/scene/clearance.h>
#include <sunder/scene/scene.h>
#include <sunder/scene/scene_said.h>

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>
#include <string>
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
// what the placements' answers about clearances were asked. said: what the file says besides; so below. Throws what the
// sink throws.
void write_certificate(std::span<const Placement> placements, const Question& question, Origin origin,
                       const TextSink& sink, const ClearanceQuestion& clearance = {}, const SaidOfScene& said = {});

// Two parts that are closer than they have to be, or of which that is undecided.
struct CloserPair {
  std::uint32_t body_a = 0, body_b = 0;  // body_a < body_b
  std::uint32_t part_a = 0, part_b = 0;
  double least = 0;
  bool is_undecided = false;
  bool is_of_meshes = false;
};

// What meets, and what is closer, in one of many placements; the spans hold until the next one is asked for.
struct MeetingPlacement {
  std::string title;
  std::span<const Body> bodies;     // where they are
  std::span<const PartPair> pairs;  // that meet or are undecided, of an answer to the question
  std::span<const CloserPair> closer{};
};

// Of so many placements of the bodies, each of which is asked for a few times, the pairs that meet, and those that are
// closer than they have to be, and nothing of others; that is told with what the origin leaves out, and so are pairs
// that are undecided. Requires a pair to state. Throws what the sink and `placement` throw. Memory: a name and a pose
// for each part of a pair.
void write_meeting_certificate(std::span<const Body> bodies, std::size_t count,
                               const std::function<MeetingPlacement(std::size_t k)>& placement,
                               const Question& question, Origin origin, const TextSink& sink,
                               const SaidOfScene& said = {});

// Of so many placements, each of which is asked for a few times: all that write_certificate states, whether or not
// pairs meet; of clearances, where they were asked about. `pairs` and `closer` of a placement need hold no more than
// those that meet, are closer or undecided: the others are asked about again, one placement after another. Throws what
// the sink and `placement` throw. Memory: a name and a pose for each part in each placement, and one answer.
void write_whole_certificate(std::span<const Body> bodies, std::size_t count,
                             const std::function<MeetingPlacement(std::size_t k)>& placement, const Question& question,
                             Origin origin, const TextSink& sink, const ClearanceQuestion* clearance = nullptr,
                             const SaidOfScene& said = {});

}  // namespace sunder::scene
