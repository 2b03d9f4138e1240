#include <sunder/near/near_pairs.h>
#include <sunder/planar/polygons/edge_contact_lists.h>
#include <sunder/planar/segments/segment_boxes.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace sunder::planar {

namespace {

constexpr std::size_t few_edges = 24;  // of so many, all pairs are tested faster than a grid is made

class Taker {
 public:
  Taker(const PolygonEdges& edges, const WantedContacts& wanted, PolygonMeetings& meetings)
      : edges_(edges), wanted_(wanted), meetings_(meetings) {}

  bool wants(std::uint32_t e, std::uint32_t f) const {
    const std::uint32_t p = edges_.polygon_of(e), q = edges_.polygon_of(f);
    if (p == q) return wanted_.own && !meetings_.follow(e, f);
    return !may_meet(wanted_.groups, p, q);
  }

  void count_pairs(const BoxGrid& grid) {
    for (std::uint32_t c = 0; c < grid.cell_count(); ++c) {
      const std::uint64_t size = grid.cell(c).size();
      meetings_.cost.probes += size * size / 2;
    }
  }

  bool of_pair(std::uint32_t e, std::uint32_t f) {
    if (!wants(e, f)) return true;
    ++meetings_.cost.probes;
    const ContactKind kind = segment_segment(edges_.edges()[e], edges_.edges()[f]);
    return kind == ContactKind::none || meetings_.take(e, f, kind);
  }

 private:
  const PolygonEdges& edges_;
  const WantedContacts& wanted_;
  PolygonMeetings& meetings_;
};

template <class NumberOf>
std::optional<bool> take_by_grid(const Segments& segments, const NumberOf& number_of, const WantedContacts& wanted,
                                 Taker& taker) {
  const std::optional<BoxGrid> grid = grid_over(segments);
  if (!grid || crowded(*grid, crowd_for_any) > 0) return std::nullopt;
  taker.count_pairs(*grid);
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t e = number_of(i), f = number_of(j);
    return taker.of_pair(std::min(e, f), std::max(e, f));
  };
  return for_each_near_pair<crowd_for_any>(segments.all(), *grid, of_pair, wanted.progress);
}

}  // namespace

std::optional<bool> take_contacts_by_grid(const PolygonEdges& edges, const WantedContacts& wanted,
                                          PolygonMeetings& meetings) {
  Taker taker(edges, wanted, meetings);
  return take_by_grid(edges.edges(), [](std::uint32_t e) { return e; }, wanted, taker);
}

std::optional<bool> take_contacts_of(std::span<const std::uint32_t> some, const PolygonEdges& edges,
                                     const WantedContacts& wanted, PolygonMeetings& meetings) {
  Taker taker(edges, wanted, meetings);
  if (some.size() <= few_edges) {
    for (std::size_t k = 0; k < some.size(); ++k) {
      for (std::size_t l = k + 1; l < some.size(); ++l) {
        if (!taker.of_pair(std::min(some[k], some[l]), std::max(some[k], some[l]))) return false;
      }
    }
    return true;
  }
  std::vector<Segment> chosen;
  chosen.reserve(some.size());
  for (const std::uint32_t e : some) chosen.push_back(edges.edges()[e]);
  return take_by_grid(Segments(std::move(chosen)), [&](std::uint32_t k) { return some[k]; }, wanted, taker);
}

}  // namespace sunder::planar
