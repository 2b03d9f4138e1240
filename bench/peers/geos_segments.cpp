// GEOS: its C interface where that has the question, else its C++ classes, which it calls unstable: they want
// USE_UNSTABLE_GEOS_CPP_API to be defined, which its CMake package does.
#include <bench/peers/geos_context.h>
#include <bench/peers/segment_peer.h>

#include <geos/algorithm/Orientation.h>
#include <geos/geom/Coordinate.h>
#include <geos/geom/CoordinateSequence.h>
#include <geos/geom/Envelope.h>
#include <geos/index/strtree/TemplateSTRtree.h>
#include <geos/noding/BasicSegmentString.h>
#include <geos/noding/FastNodingValidator.h>
#include <geos/noding/MCIndexNoder.h>
#include <geos/noding/SegmentIntersector.h>

#include <algorithm>
#include <memory>
#include <stdexcept>
#include <utility>
#include <vector>

namespace bench {
namespace {

using geos::geom::Coordinate;
using geos::geom::Envelope;

Coordinate coordinate(const Xy& p) { return {p.x, p.y}; }

int turn(const Xy& p, const Xy& q, const Xy& r) {
  return geos::algorithm::Orientation::index(coordinate(p), coordinate(q), coordinate(r));
}

// Requires boxes that meet. Orientation::index is right but in rare cases; four of them decide.
bool meet(const Line& s, const Line& t) {
  const int ta = turn(s.a, s.b, t.a), tb = turn(s.a, s.b, t.b);
  if (ta * tb > 0) return false;
  const int sa = turn(t.a, t.b, s.a), sb = turn(t.a, t.b, s.b);
  return sa * sb <= 0;
}

bool counts(const SegmentInput& input, std::uint32_t i, std::uint32_t j) {
  const Line &s = input.lines[i], &t = input.lines[j];
  return pair_counts(s, t, input.shared_ends, turn, [&] { return meet(s, t); });
}

// --- The C interface: questions of a geometry ------------------------------------------------------------------------

GEOSGeometry* checked(GEOSGeometry* geometry) {
  if (geometry == nullptr) throw std::runtime_error("GEOS made no geometry");
  return geometry;
}

GEOSCoordSequence* sequence(const std::vector<Xy>& points) {
  GEOSCoordSequence* made = GEOSCoordSeq_create_r(context(), static_cast<unsigned>(points.size()), 2);
  for (unsigned i = 0; i < points.size(); ++i) GEOSCoordSeq_setXY_r(context(), made, i, points[i].x, points[i].y);
  return made;
}

std::shared_ptr<GEOSGeometry> owned(GEOSGeometry* geometry) {
  return {checked(geometry), [](GEOSGeometry* g) { GEOSGeom_destroy_r(context(), g); }};
}

std::uint64_t yes(char answer) {  // 0: no, 1: yes, 2: an exception
  if (answer != 0 && answer != 1) throw std::runtime_error("GEOS gave no answer");
  return answer == 1 ? 1 : 0;
}

Asked lines_simple(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::any) return {};
  std::vector<GEOSGeometry*> parts;
  for (const Line& l : input.lines)
    parts.push_back(checked(GEOSGeom_createLineString_r(context(), sequence({l.a, l.b}))));
  const auto lines = owned(
      GEOSGeom_createCollection_r(context(), GEOS_MULTILINESTRING, parts.data(), static_cast<unsigned>(parts.size())));
  return [lines] { return 1 - yes(GEOSisSimple_r(context(), lines.get())); };
}

std::shared_ptr<GEOSGeometry> polygon(const SegmentInput& input) {
  std::vector<Xy> closed = input.ring;
  closed.push_back(closed.front());
  return owned(
      GEOSGeom_createPolygon_r(context(), GEOSGeom_createLinearRing_r(context(), sequence(closed)), nullptr, 0));
}

Asked polygon_valid(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::simple || input.ring.empty()) return {};
  return [shape = polygon(input)] { return yes(GEOSisValid_r(context(), shape.get())); };
}

Asked polygon_simple(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::simple || input.ring.empty()) return {};
  return [shape = polygon(input)] { return yes(GEOSisSimple_r(context(), shape.get())); };
}

// --- The C++ classes: nodings ----------------------------------------------------------------------------------------

// Lines of two points each, which know their number.
struct Strings {
  const SegmentInput& input;
  std::vector<std::unique_ptr<geos::geom::CoordinateSequence>> points;
  std::vector<std::unique_ptr<geos::noding::BasicSegmentString>> strings;
  std::vector<geos::noding::SegmentString*> list;

  explicit Strings(const SegmentInput& given) : input(given) {
    for (const Line& l : input.lines) {
      // What the C interface hands out is this class; how to construct one changes with the version.
      points.emplace_back(reinterpret_cast<geos::geom::CoordinateSequence*>(sequence({l.a, l.b})));
      strings.push_back(std::make_unique<geos::noding::BasicSegmentString>(points.back().get(), &l));
      list.push_back(strings.back().get());
    }
  }
  std::uint32_t number(const geos::noding::SegmentString* string) const {
    return static_cast<std::uint32_t>(static_cast<const Line*>(string->getData()) - input.lines.data());
  }
};

Asked by_validator(const SegmentInput& input, SegmentQuestion question) {
  if (question != SegmentQuestion::any) return {};
  return [prepared = std::make_shared<Strings>(input)]() -> std::uint64_t {
    return geos::noding::FastNodingValidator(prepared->list).isValid() ? 0 : 1;
  };
}

class Decider : public geos::noding::SegmentIntersector {
 public:
  Decider(const Strings& prepared, SegmentQuestion question) : prepared_(prepared), sink_(question) {}
  void processIntersections(geos::noding::SegmentString* s, std::size_t, geos::noding::SegmentString* t,
                            std::size_t) override {
    if (s == t) return;
    const std::uint32_t i = prepared_.number(s), j = prepared_.number(t);
    if (counts(prepared_.input, i, j)) done_ = !sink_.take(std::min(i, j), std::max(i, j));
  }
  bool isDone() const override { return done_; }
  std::uint64_t count() const { return sink_.count(); }

 private:
  const Strings& prepared_;
  PairSink sink_;
  bool done_ = false;
};

Asked by_noder(const SegmentInput& input, SegmentQuestion question) {
  if (question == SegmentQuestion::simple) return {};
  return [prepared = std::make_shared<Strings>(input), question]() -> std::uint64_t {
    Decider decider(*prepared, question);
    geos::noding::MCIndexNoder noder(&decider);
    noder.computeNodes(&prepared->list);
    return question == SegmentQuestion::any ? std::min<std::uint64_t>(decider.count(), 1) : decider.count();
  };
}

// --- The tree --------------------------------------------------------------------------------------------------------

Asked by_tree(const SegmentInput& input, SegmentQuestion question) {
  if (question == SegmentQuestion::simple) return {};
  struct Prepared {
    const SegmentInput& input;
    std::vector<Envelope> boxes;
  };
  auto prepared = std::make_shared<Prepared>(Prepared{input, {}});
  for (const Line& l : input.lines) prepared->boxes.emplace_back(l.a.x, l.b.x, l.a.y, l.b.y);
  return [prepared, question]() -> std::uint64_t {
    const std::vector<Envelope>& boxes = prepared->boxes;
    geos::index::strtree::TemplateSTRtree<std::uint32_t> tree(10, boxes.size());
    for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.insert(boxes[i], i);
    PairSink sink(question);
    bool enough = false;
    for (std::uint32_t i = 0; i < boxes.size() && !enough; ++i) {
      tree.query(boxes[i], [&](const std::uint32_t& j) {  // false: ends this query
        if (j > i && counts(prepared->input, i, j)) enough = !sink.take(i, j);
        return !enough;
      });
    }
    return sink.count();
  };
}

}  // namespace

std::vector<SegmentWay> geos_segment_ways() {
  return {{"geos", "isSimple of lines", lines_simple},
          {"geos", "FastNodingValidator", by_validator},
          {"geos", "MCIndexNoder", by_noder},
          {"geos", "STRtree", by_tree},
          {"geos", "isValid of polygon", polygon_valid},
          {"geos", "isSimple of polygon", polygon_simple}};
}

}  // namespace bench
