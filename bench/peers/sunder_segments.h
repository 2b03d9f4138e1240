// The library under test, asked as its peers are.
#pragma once

#include <bench/inputs/segment_scenarios.h>
#include <bench/peers/segment_peer.h>

#include <cstdint>
#include <string_view>

namespace bench {

// make: the Segments themselves. transcript: any, with its evidence. drawing: drawing_plane, of segments that share
// ends, whose vertices are prepared. The others are those of SegmentQuestion.
enum class Question : std::uint8_t { make, any, transcript, drawing, simple, all, count };

std::string_view name_of(Question);

// Sunder's front doors. Segments and polygons are prepared; the input need not outlive the call.
// Empty where Sunder does not answer the question yet.
Asked ask_sunder(const SegmentInput& input, Question question);

// What ask_sunder's call has to give.
std::uint64_t truth(const SegmentInput& input, Question question);

}  // namespace bench
