// Boost.Geometry, header only, in doubles.
#include <bench/peers/segment_peer.h>

#include <boost/geometry/algorithms/envelope.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/algorithms/is_simple.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/linestring.hpp>
#include <boost/geometry/geometries/multi_linestring.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/geometries/segment.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>

#include <memory>
#include <type_traits>
#include <utility>
#include <vector>

namespace bench {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Point = bg::model::d2::point_xy<double>;
using Segment = bg::model::segment<Point>;
using Box = bg::model::box<Point>;
using LineString = bg::model::linestring<Point>;
using MultiLine = bg::model::multi_linestring<LineString>;
using Polygon = bg::model::polygon<Point, false, true>;  // counter-clockwise, its first vertex repeated

Point point(const Xy& p) { return {p.x, p.y}; }

MultiLine multi_line(const SegmentInput& input) {
  MultiLine lines;
  lines.reserve(input.lines.size());
  for (const Line& l : input.lines) lines.push_back(LineString{point(l.a), point(l.b)});
  return lines;
}

Asked lines_simple(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::any) return {};
  return [lines = multi_line(input)]() -> std::uint64_t { return bg::is_simple(lines) ? 0 : 1; };
}

Asked lines_intersect(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::any || input.shared_ends) return {};
  return [lines = multi_line(input)]() -> std::uint64_t { return bg::intersects(lines) ? 1 : 0; };
}

// Indexed: Box or Segment.
template <class Indexed>
Asked by_tree(const SegmentInput& input, SegmentQuestion question) {
  if (question == SegmentQuestion::simple) return {};
  using Entry = std::pair<Indexed, std::uint32_t>;
  struct Prepared {
    const SegmentInput& input;
    std::vector<Segment> segments;
    std::vector<Entry> entries;
  };
  auto prepared = std::make_shared<Prepared>(Prepared{input, {}, {}});
  for (std::uint32_t i = 0; i < input.lines.size(); ++i) {
    prepared->segments.emplace_back(point(input.lines[i].a), point(input.lines[i].b));
    if constexpr (std::is_same_v<Indexed, Box>) {
      prepared->entries.emplace_back(bg::return_envelope<Box>(prepared->segments.back()), i);
    } else {
      prepared->entries.emplace_back(prepared->segments.back(), i);
    }
  }
  return [prepared, question]() -> std::uint64_t {
    const bgi::rtree<Entry, bgi::quadratic<16>> tree(prepared->entries.begin(), prepared->entries.end());
    PairSink sink(question);
    const auto turn = [](const Xy& p, const Xy& q, const Xy& r) {
      return bg::strategy::side::side_by_triangle<>::apply(point(p), point(q), point(r));
    };
    const std::vector<Line>& lines = prepared->input.lines;
    for (const Entry& entry : prepared->entries) {
      const std::uint32_t i = entry.second;
      for (auto found = tree.qbegin(bgi::intersects(entry.first)); found != tree.qend(); ++found) {
        const std::uint32_t j = found->second;
        if (j <= i) continue;
        const auto meet = [&] {  // a tree of segments has decided that
          return std::is_same_v<Indexed, Segment> || bg::intersects(prepared->segments[i], prepared->segments[j]);
        };
        if (pair_counts(lines[i], lines[j], prepared->input.shared_ends, turn, meet) && !sink.take(i, j)) return 1;
      }
    }
    return sink.count();
  };
}

Asked polygon_valid(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::simple || input.ring.empty()) return {};
  Polygon polygon;
  for (const Xy& p : input.ring) polygon.outer().push_back(point(p));
  polygon.outer().push_back(polygon.outer().front());
  return [polygon = std::move(polygon)]() -> std::uint64_t { return bg::is_valid(polygon) ? 1 : 0; };
}

Asked boundary_simple(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::simple || input.ring.empty()) return {};
  LineString line;
  for (const Xy& p : input.ring) line.push_back(point(p));
  line.push_back(line.front());
  return [line = std::move(line)]() -> std::uint64_t { return bg::is_simple(line) ? 1 : 0; };
}

}  // namespace

std::vector<SegmentWay> boost_segment_ways() {
  return {{"boost", "is_simple of lines", lines_simple},   {"boost", "intersects of lines", lines_intersect},
          {"boost", "rtree of boxes", by_tree<Box>},       {"boost", "rtree of segments", by_tree<Segment>},
          {"boost", "is_valid of polygon", polygon_valid}, {"boost", "is_simple of boundary", boundary_simple}};
}

}  // namespace bench
