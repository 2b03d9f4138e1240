// The other libraries of bench_polygons behind one interface.
//
// Every library prepares polygons of its own outside of the timed loop, and indexes where it offers any. It is asked
// for a boolean only. Of each library the fastest way that is right counts.
#pragma once

#include <cstdint>
#include <exception>
#include <memory>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

#include "../polygon_scenarios.h"

namespace bench {

inline constexpr std::uint8_t kNoAnswer = 2;  // it threw

class PolygonPeer {
 public:
  virtual ~PolygonPeer() = default;

  // Answers the pairs from `first` on: answers[i] = 1 (they meet) or 0, or kNoAnswer.
  // Requires first + answers.size() pairs.
  virtual void run(std::size_t first, std::span<std::uint8_t> answers) = 0;
};

// ask(pair) answers one pair, as bool.
template <class Ask>
std::unique_ptr<PolygonPeer> polygon_peer(const PolygonScenario& scenario, Ask ask) {
  class Way final : public PolygonPeer {
   public:
    Way(const std::vector<PolygonPair>& pairs, Ask&& ask) : pairs_(pairs), ask_(std::move(ask)) {}
    void run(std::size_t first, std::span<std::uint8_t> answers) override {
      for (std::size_t i = 0; i < answers.size(); ++i) {
        try {
          answers[i] = ask_(pairs_[first + i]) ? 1 : 0;
        } catch (const std::exception&) {
          answers[i] = kNoAnswer;
        }
      }
    }

   private:
    const std::vector<PolygonPair>& pairs_;
    Ask ask_;
  };
  return std::make_unique<Way>(scenario.pairs, std::move(ask));
}

struct PolygonWay {
  std::string_view library, method;
  std::unique_ptr<PolygonPeer> (*make)(const PolygonScenario&);  // the scenario outlives the peer
};

// Boost.Geometry (plain doubles): intersects, of rings and of polygons.
std::vector<PolygonWay> boost_polygon_ways();

// GEOS, through its C interface: GEOSIntersects, and GEOSPreparedIntersects with the first polygon prepared, its index
// built before the loop.
std::vector<PolygonWay> geos_polygon_ways();

// CGAL:
//   do_intersect of Polygon_2. It asks whether interiors meet, so that polygons that touch do not. It constructs
//   points:
//     with exact ones, since with rounded ones it crashes on polygons that touch.
//   box_intersection_d of the boxes of the edges (prepared), each pair of edges then decided exactly, to the first that
//     meet; where none do, whether a vertex of one is in the other.
std::vector<PolygonWay> cgal_polygon_ways();

}  // namespace bench
