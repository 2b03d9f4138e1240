#include <bench/peers/sunder_segments.h>

#include <sunder/planar/object/polygon.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>

#include <array>
#include <memory>
#include <vector>

namespace bench {
namespace {

using sunder::Allowed;
using sunder::planar::Segments;

std::uint64_t any(const Segments& segments, Allowed allowed, bool transcript) {
  sunder::planar::SweepEvents events;
  const sunder::planar::SegmentsAnswer answer =
      transcript ? sunder::planar::segments_any_with_transcript(segments, {allowed}, events)
                 : sunder::planar::segments_any(segments, {allowed});
  return answer.meet() ? 1 : 0;
}

std::uint64_t all(const Segments& segments, Allowed allowed) {
  return sunder::planar::segments_all(segments, {allowed}).found.size();
}
std::uint64_t count(const Segments& segments, Allowed allowed) {
  return sunder::planar::segments_count(segments, {allowed}).count;
}

}  // namespace

std::string_view name_of(Question question) {
  constexpr std::array<std::string_view, 6> names{"any, make", "any", "any, transcript", "simple", "all", "all, count"};
  return names.at(static_cast<std::size_t>(question));
}

Asked ask_sunder(const SegmentInput& input, Question question) {
  auto given = std::make_shared<std::vector<sunder::planar::Segment>>();
  for (const Line& l : input.lines) given->push_back({{l.a.x, l.a.y}, {l.b.x, l.b.y}});
  if (question == Question::make) return [given]() -> std::uint64_t { return Segments(*given).size(); };
  if (question == Question::simple) {
    std::vector<sunder::Point2> ring;
    for (const Xy& p : input.ring) ring.push_back({p.x, p.y});
    const auto polygon = std::make_shared<sunder::planar::Polygon>(std::vector<std::vector<sunder::Point2>>{ring});
    return [polygon]() -> std::uint64_t { return sunder::planar::polygon_simple(*polygon).meet() ? 0 : 1; };
  }
  const auto segments = std::make_shared<Segments>(*given);
  const Allowed allowed = input.shared_ends ? Allowed::shared_endpoint : Allowed::nothing;
  switch (question) {
    case Question::all: return [segments, allowed] { return all(*segments, allowed); };
    case Question::count: return [segments, allowed] { return count(*segments, allowed); };
    default: break;
  }
  const bool transcript = question == Question::transcript;
  return [segments, allowed, transcript] { return any(*segments, allowed, transcript); };
}

std::uint64_t truth(const SegmentInput& input, Question question) {
  switch (question) {
    case Question::make: return input.lines.size();
    case Question::simple: return input.pairs == 0 ? 1 : 0;
    case Question::all:
    case Question::count: return input.pairs;
    default: return input.pairs > 0 ? 1 : 0;
  }
}

}  // namespace bench
