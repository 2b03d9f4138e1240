// GEOS: its C interface for polygons, and of its C++ classes the tree, which its C interface has without templates.
#include <bench/peers/geos_context.h>
#include <bench/peers/set_peer.h>

#include <geos/geom/Envelope.h>
#include <geos/index/strtree/TemplateSTRtree.h>

#include <memory>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

using geos::geom::Envelope;

Geometry polygon(const Ring& ring) {
  const auto size = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* points = GEOSCoordSeq_create_r(context(), size + 1, 2);
  for (unsigned i = 0; i <= size; ++i) {
    GEOSCoordSeq_setXY_r(context(), points, i, ring[i % size].x, ring[i % size].y);
  }
  Geometry made(GEOSGeom_createPolygon_r(context(), GEOSGeom_createLinearRing_r(context(), points), nullptr, 0));
  if (made == nullptr) throw std::runtime_error("GEOS made no geometry");
  return made;
}

bool yes(char answer) {  // 0: no, 1: yes, 2: an exception
  if (answer != 0 && answer != 1) throw std::runtime_error("GEOS gave no answer");
  return answer == 1;
}

std::vector<Envelope> envelopes(const SetInput& input) {
  std::vector<Envelope> boxes;
  for (const Frame& f : frames_of(input)) boxes.emplace_back(f.low.x, f.high.x, f.low.y, f.high.y);
  return boxes;
}

// meet(i, j) decides; before each i its box is asked for.
template <class Meet>
std::uint64_t ask_tree(const std::vector<Envelope>& boxes, SetQuestion question, const Meet& meet) {
  geos::index::strtree::TemplateSTRtree<std::uint32_t> tree(10, boxes.size());
  for (std::uint32_t i = 0; i < boxes.size(); ++i) tree.insert(boxes[i], i);
  PairSink sink(question);
  bool enough = false;
  for (std::uint32_t i = 0; i < boxes.size() && !enough; ++i) {
    tree.query(boxes[i], [&](const std::uint32_t& j) {  // false: ends this query
      if (j > i && meet(i, j)) enough = !sink.take(i, j);
      return !enough;
    });
  }
  return sink.count();
}

Asked discs_by_tree(const SetInput& input, SetQuestion question) {
  if (input.discs.empty()) return {};
  return [&input, boxes = envelopes(input), question] {
    return ask_tree(boxes, question, [&](std::uint32_t i, std::uint32_t j) {
      const Disc &a = input.discs[i], &b = input.discs[j];
      const double dx = a.center.x - b.center.x, dy = a.center.y - b.center.y, reach = a.radius + b.radius;
      return dx * dx + dy * dy <= reach * reach;
    });
  };
}

struct Shapes {
  std::vector<Geometry> polygons;
  std::vector<Envelope> boxes;
};

std::shared_ptr<Shapes> shapes_of(const SetInput& input) {
  auto shapes = std::make_shared<Shapes>(Shapes{{}, envelopes(input)});
  for (const Ring& ring : input.rings) shapes->polygons.push_back(polygon(ring));
  return shapes;
}

Asked polygons_by_tree(const SetInput& input, SetQuestion question) {
  if (input.rings.empty()) return {};
  return [shapes = shapes_of(input), question] {
    return ask_tree(shapes->boxes, question, [&](std::uint32_t i, std::uint32_t j) {
      return yes(GEOSIntersects_r(context(), shapes->polygons[i].get(), shapes->polygons[j].get()));
    });
  };
}

Asked prepared_by_tree(const SetInput& input, SetQuestion question) {
  if (input.rings.empty()) return {};
  return [shapes = shapes_of(input), question] {
    Prepared prepared;
    std::uint32_t of = 0;
    return ask_tree(shapes->boxes, question, [&](std::uint32_t i, std::uint32_t j) {
      if (prepared == nullptr || of != i) prepared.reset(GEOSPrepare_r(context(), shapes->polygons[of = i].get()));
      return yes(GEOSPreparedIntersects_r(context(), prepared.get(), shapes->polygons[j].get()));
    });
  };
}

Asked all_valid(const SetInput& input, SetQuestion question) {
  if (input.rings.empty() || question != SetQuestion::any) return {};
  std::vector<GEOSGeometry*> parts;
  for (const Ring& ring : input.rings) parts.push_back(polygon(ring).release());
  const std::shared_ptr<GEOSGeometry> all(
      GEOSGeom_createCollection_r(context(), GEOS_MULTIPOLYGON, parts.data(), static_cast<unsigned>(parts.size())),
      Destroy());
  return [all]() -> std::uint64_t { return yes(GEOSisValid_r(context(), all.get())) ? 0 : 1; };
}

}  // namespace

std::vector<SetWay> geos_set_ways() {
  return {{"geos", "STRtree", discs_by_tree},
          {"geos", "STRtree, intersects", polygons_by_tree},
          {"geos", "STRtree, prepared intersects", prepared_by_tree},
          {"geos", "isValid of all", all_valid}};
}

}  // namespace bench
