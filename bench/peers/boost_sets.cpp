// Boost.Geometry, header only, in doubles.
#include <bench/peers/set_peer.h>

#include <boost/geometry/algorithms/comparable_distance.hpp>
#include <boost/geometry/algorithms/intersects.hpp>
#include <boost/geometry/algorithms/is_valid.hpp>
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/geometries/ring.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include <memory>
#include <utility>
#include <vector>

namespace bench {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;

using Point = bg::model::d2::point_xy<double>;
using Box = bg::model::box<Point>;
using Polygon = bg::model::polygon<Point, false, true>;  // counter-clockwise, its first vertex repeated
using Entry = std::pair<Box, std::uint32_t>;

Polygon polygon(const Ring& ring) {
  Polygon made;
  for (const Xy& p : ring) made.outer().push_back({p.x, p.y});
  made.outer().push_back(made.outer().front());
  return made;
}

struct RoundDisc {
  Point center;
  double radius;
};

bool meet(const RoundDisc& a, const RoundDisc& b) {
  const double reach = a.radius + b.radius;
  return bg::comparable_distance(a.center, b.center) <= reach * reach;
}
bool meet(const Polygon& a, const Polygon& b) { return bg::intersects(a, b); }

template <class Object>
Asked by_tree(const SetInput& input, SetQuestion question, std::vector<Object> objects) {
  struct Prepared {
    std::vector<Object> objects;
    std::vector<Entry> entries;
  };
  auto prepared = std::make_shared<Prepared>(Prepared{std::move(objects), {}});
  for (const Frame& frame : frames_of(input)) {
    prepared->entries.emplace_back(Box({frame.low.x, frame.low.y}, {frame.high.x, frame.high.y}),
                                   static_cast<std::uint32_t>(prepared->entries.size()));
  }
  return [prepared, question]() -> std::uint64_t {
    const bgi::rtree<Entry, bgi::quadratic<16>> tree(prepared->entries.begin(), prepared->entries.end());
    PairSink sink(question);
    std::uint32_t i = 0;
    const auto decide = [&](const Entry& found) {
      const std::uint32_t j = found.second;
      if (j > i && meet(prepared->objects[i], prepared->objects[j]) && !sink.take(i, j)) throw Found{};
    };
    try {
      for (; i < prepared->entries.size(); ++i) {
        tree.query(bgi::intersects(prepared->entries[i].first), boost::make_function_output_iterator(decide));
      }
    } catch (const Found&) {
    }
    return sink.count();
  };
}

Asked discs_by_tree(const SetInput& input, SetQuestion question) {
  if (input.discs.empty()) return {};
  std::vector<RoundDisc> discs;
  for (const Disc& d : input.discs) discs.push_back({{d.center.x, d.center.y}, d.radius});
  return by_tree(input, question, std::move(discs));
}

Asked polygons_by_tree(const SetInput& input, SetQuestion question) {
  if (input.rings.empty()) return {};
  std::vector<Polygon> polygons;
  for (const Ring& ring : input.rings) polygons.push_back(polygon(ring));
  return by_tree(input, question, std::move(polygons));
}

Asked all_valid(const SetInput& input, SetQuestion question) {
  if (input.rings.empty() || question != SetQuestion::any) return {};
  bg::model::multi_polygon<Polygon> polygons;
  for (const Ring& ring : input.rings) polygons.push_back(polygon(ring));
  return [polygons = std::move(polygons)]() -> std::uint64_t { return bg::is_valid(polygons) ? 0 : 1; };
}

}  // namespace

std::vector<SetWay> boost_set_ways() {
  return {{"boost", "rtree, comparable_distance", discs_by_tree},
          {"boost", "rtree, intersects", polygons_by_tree},
          {"boost", "is_valid of all", all_valid}};
}

}  // namespace bench
