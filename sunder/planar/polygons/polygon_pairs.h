// Two polygons of a set at a time: only edges near both are looked at. For use by polygons_any and polygons_all.
#pragma once

#include <sunder/planar/polygons/polygons_any.h>

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>

namespace sunder::planar {

class PolygonPairs {
 public:
  // Gives up when it has looked at more than `most` boxes and edges.
  PolygonPairs(std::span<const Polygon> polygons, std::uint64_t most) : polygons_(polygons), most_(most) {}

  // How do the polygons i < j meet? Requires that their boxes do. Nothing where it gives up. Where
  // the first edges found to meet do not cross, or cross in a vertex of both, the cost is that of polygons_contact.
  std::optional<PolygonsContact> contact(std::uint32_t i, std::uint32_t j);

  void allow(std::uint64_t more) { most_ += more; }
  bool gave_up() const { return cost.probes > most_; }

  Cost cost{};  // probes: boxes and edges looked at

 private:
  struct Edges;
  // A run of edges of a polygon, or edges where the level is 0.
  struct Run {
    const Polygon& polygon;
    std::uint32_t level, number;
  };
  bool compare(const Polygon& a, const Polygon& b);
  bool compare_runs(const Run& r, const Run& s);
  bool add_near(const Edges& of_r, const Run& r, const Run& s);
  bool compare_near(const Polygon& a, const Polygon& b);
  bool is_inside(const Polygon& polygon, const Point2& p);
  bool is_odd_below(const Run& r, const Point2& p);
  std::optional<std::uint32_t> vertex_inside(const Polygon& inner, const Polygon& outer);

  std::span<const Polygon> polygons_;
  std::uint64_t most_;
  PolygonsContact found_;  // of the two that are compared

  // Runs of their edges whose boxes meet wait here until there are some: each has few edges that are near the other
  // one's, and where their number ends cannot be predicted.
  struct Near {
    std::uint32_t first_of_a, first_of_b;
  };
  static constexpr std::uint32_t most_near = 4;
  std::array<Near, most_near> near_{};
  std::uint32_t near_count_ = 0;
  std::uint64_t near_bits_ = 0;         // bit 16 n + 4 e + f: of near_[n], do the boxes meet?
  std::uint32_t wait_for_ = most_near;  // 1 where edges are expected to meet: the last two's did
};

// Calls found(contact) for each pair of polygons of different groups that meet, once, until it returns false. Returns
// whether it never did; nothing where that takes more than 64 looks at boxes and edges for each edge and 16 for each
// pair that counts: then some pairs may have been given. Where `end` is given, of pairs i < j only those whose i is
// below it, which may fall meanwhile.
std::optional<bool> for_each_meeting_pair(std::span<const Polygon> polygons, const SetOptions& options, Cost& cost,
                                          const std::function<bool(const PolygonsContact&)>& found,
                                          const std::uint32_t* end = nullptr);

}  // namespace sunder::planar
