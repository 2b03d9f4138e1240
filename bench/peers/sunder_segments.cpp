#include <bench/peers/sunder_segments.h>

#include <sunder/planar/object/polygon.h>
#include <sunder/planar/object/segments.h>
#include <sunder/planar/polygons/polygon_simple.h>
#include <sunder/planar/segments/drawing_plane.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/segments/segments_any.h>

#include <algorithm>
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

struct Drawing {
  std::vector<sunder::Point2> vertices;
  std::vector<sunder::planar::DrawingEdge> edges;
};

Drawing drawing_of(const Segments& segments) {
  Drawing made;
  for (const sunder::planar::Segment& s : segments.all()) made.vertices.insert(made.vertices.end(), {s.a, s.b});
  const auto less = sunder::planar::lexicographically_less;
  std::sort(made.vertices.begin(), made.vertices.end(), less);
  made.vertices.erase(std::unique(made.vertices.begin(), made.vertices.end()), made.vertices.end());
  const auto number_of = [&](const sunder::Point2& p) {
    const auto at = std::lower_bound(made.vertices.begin(), made.vertices.end(), p, less);
    return static_cast<std::uint32_t>(at - made.vertices.begin());
  };
  for (const sunder::planar::Segment& s : segments.all()) made.edges.push_back({number_of(s.a), number_of(s.b)});
  return made;
}

std::uint64_t all(const Segments& segments, Allowed allowed) {
  return sunder::planar::segments_all(segments, {allowed}).found.size();
}
std::uint64_t count(const Segments& segments, Allowed allowed) {
  return sunder::planar::segments_count(segments, {allowed}).count;
}

}  // namespace

std::string_view name_of(Question question) {
  constexpr std::array<std::string_view, 7> names{"any, make", "any", "any, transcript", "any, drawing",
                                                  "simple",    "all", "all, count"};
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
    case Question::drawing: {
      const auto drawing = std::make_shared<const Drawing>(drawing_of(*segments));
      return [drawing]() -> std::uint64_t {
        return sunder::planar::drawing_plane(drawing->vertices, drawing->edges).meet() ? 1 : 0;
      };
    }
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
