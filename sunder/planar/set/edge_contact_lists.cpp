#include <sunder/planar/set/edge_contact_lists.h>
#include <sunder/planar/set/near_pairs.h>

#include <algorithm>
#include <optional>
#include <vector>

namespace sunder::planar {

namespace {

constexpr std::size_t few = 24;  // of so many, all pairs are tested faster than a grid is made

class Taker {
 public:
  Taker(const PolygonEdges& edges, const WantedContacts& wanted, PolygonMeetings& meetings)
      : edges_(edges), wanted_(wanted), meetings_(meetings) {}

  bool wants(std::uint32_t e, std::uint32_t f) const {
    const std::uint32_t p = edges_.polygon_of(e), q = edges_.polygon_of(f);
    if (p == q) return wanted_.own && !meetings_.follow(e, f);
    return !may_meet(wanted_.groups, p, q);
  }

  bool of_pair(std::uint32_t e, std::uint32_t f) {
    if (!wants(e, f)) return true;
    ++meetings_.cost.probes;
    const ContactKind kind = segment_segment(edges_.edges()[e], edges_.edges()[f]);
    return kind == ContactKind::none || meetings_.take(e, f, kind);
  }

  bool of_contact(std::uint32_t e, std::uint32_t f, ContactKind kind) {
    return !wants(e, f) || meetings_.take(e, f, kind);
  }

 private:
  const PolygonEdges& edges_;
  const WantedContacts& wanted_;
  PolygonMeetings& meetings_;
};

// By a method for sets of segments, which need not know about polygons.
template <class NumberOf>
bool take_by(ContactMethod* method, const Segments& segments, const NumberOf& number_of, const WantedContacts& wanted,
             Taker& taker, PolygonMeetings& meetings) {
  bool all = true;
  const ContactVisitor visit = [&](const SegmentsContact& c) {
    const std::uint32_t e = number_of(c.i), f = number_of(c.j);
    return all = taker.of_contact(std::min(e, f), std::max(e, f), c.kind);
  };
  meetings.cost.probes += method(segments, {Allowed::nothing, false, {}, wanted.progress}, visit).probes;
  return all;
}

template <class NumberOf>
std::optional<bool> take_by_grid_alone(const Segments& segments, const NumberOf& number_of, std::size_t most,
                                       const WantedContacts& wanted, Taker& taker) {
  const std::optional<SegmentGrid> grid = SegmentGrid::over(segments.all());
  if (!grid || crowded(*grid, most) > 0) return std::nullopt;
  const auto of_pair = [&](std::uint32_t i, std::uint32_t j) {
    const std::uint32_t e = number_of(i), f = number_of(j);
    return taker.of_pair(std::min(e, f), std::max(e, f));
  };
  return for_each_near_pair<crowd_for_all>(segments.all(), *grid, of_pair, wanted.progress);
}

template <class NumberOf>
bool take_by_grid(const Segments& segments, const NumberOf& number_of, const WantedContacts& wanted, Taker& taker,
                  PolygonMeetings& meetings) {
  const std::optional<bool> taken = take_by_grid_alone(segments, number_of, crowd_for_all, wanted, taker);
  return taken ? *taken : take_by(visit_contacts, segments, number_of, wanted, taker, meetings);
}

constexpr auto same = [](std::uint32_t e) { return e; };

}  // namespace

std::optional<bool> take_contacts_by_grid_alone(const PolygonEdges& edges, const WantedContacts& wanted,
                                                PolygonMeetings& meetings) {
  Taker taker(edges, wanted, meetings);
  return take_by_grid_alone(edges.edges(), same, crowd_for_any, wanted, taker);
}

bool take_contacts_by_grid(const PolygonEdges& edges, const WantedContacts& wanted, PolygonMeetings& meetings) {
  Taker taker(edges, wanted, meetings);
  return take_by_grid(edges.edges(), same, wanted, taker, meetings);
}

bool take_contacts_by_sweep(const PolygonEdges& edges, const WantedContacts& wanted, PolygonMeetings& meetings) {
  Taker taker(edges, wanted, meetings);
  return take_by(visit_contacts_by_bentley_ottmann, edges.edges(), same, wanted, taker, meetings);
}

bool take_contacts_of(std::span<const std::uint32_t> some, const PolygonEdges& edges, const WantedContacts& wanted,
                      PolygonMeetings& meetings) {
  Taker taker(edges, wanted, meetings);
  if (some.size() <= few) {
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
  return take_by_grid(Segments(chosen), [&](std::uint32_t k) { return some[k]; }, wanted, taker, meetings);
}

}  // namespace sunder::planar
