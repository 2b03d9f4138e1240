#include "sunder_verify_polygons.h"

#include "segment_set.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace sunder_verifier {
namespace {

std::string text(std::size_t i) { return std::to_string(i); }

enum class Allowed { nothing, shared_endpoint, touch };

// The edges of all polygons in turn, in units of 2^e. Their groups are the polygons.
struct Polygons {
  SegmentSet edges;
  std::vector<std::size_t> first_edge{0};  // of each polygon; the last entry is the number of edges

  std::size_t size() const { return first_edge.size() - 1; }
};

enum class Where { outside, inside, on_edge, at_vertex };  // at_vertex: on no edge but at its ends

// The point is x / w, y / w; w > 0.
Where place_in(const Polygons& set, std::size_t polygon, const Point& point, const Integer& w, std::size_t longest) {
  bool is_inside = false, on_edge = false, at_vertex = false;
  for (std::size_t k = set.first_edge[polygon]; k < set.first_edge[polygon + 1]; ++k) {
    const Segment& edge = set.edges.segments[k];
    const Point a{edge.first.x * w, edge.first.y * w}, b{edge.last.x * w, edge.last.y * w};
    if (point == a || point == b) {
      at_vertex = true;
    } else if (a < point && point < b) {
      take_steps(1, longest, longest);
      const int side = turn(a, b, point);
      if (side == 0) on_edge = true;
      if (side > 0) is_inside = !is_inside;  // the edge is below the point
    }
  }
  if (on_edge) return Where::on_edge;
  if (at_vertex) return Where::at_vertex;
  return is_inside ? Where::inside : Where::outside;
}

struct Some {
  std::array<std::size_t, 2> of{};
  Numbers point;
  std::vector<std::int64_t> groups;  // empty: none
};

void check_some(const Polygons& set, Allowed allowed, const Some& some) {
  const auto [i, j] = some.of;
  require(some.groups.empty() || some.groups[i] != some.groups[j], "C1",
          "polygons " + text(i) + " and " + text(j) + " are of one group");
  const auto edges_of = [&](std::size_t k) { return set.first_edge[k + 1] - set.first_edge[k]; };
  take_steps(4 * (edges_of(i) + edges_of(j)), length(some.point), set.edges.bits);
  const Common scaled = common(some.point);
  const std::int64_t above = scaled.e - set.edges.e;  // of the unit of the edges
  Point point{scaled.integers[0], scaled.integers[1]};
  Integer w = scaled.d;
  if (above > 0) point = {shifted(point.x, above), shifted(point.y, above)};
  if (above < 0) w = shifted(w, -above);
  std::array<Where, 2> where{};
  for (std::size_t k = 0; k < 2; ++k) {
    where[k] = place_in(set, some.of[k], point, w, length(some.point) + set.edges.bits);
    require(where[k] != Where::outside, "C2", "the point is not in polygon " + text(some.of[k]));
  }
  const auto are_both = [&](Where here) { return where[0] == here && where[1] == here; };
  if (allowed == Allowed::shared_endpoint) {
    require(!are_both(Where::at_vertex), "C3", "the point is only a vertex of both");
  }
  if (allowed == Allowed::touch) require(are_both(Where::inside), "C3", "the point is not inside of both");
}

struct None {
  std::vector<std::size_t> events, below;  // below: or no_index
};

class Transcript {
 public:
  Transcript(const Polygons& set, Allowed allowed, const None& none)
      : set_(set.edges),
        allowed_(allowed),
        given_(none),
        none_(set_.segments.size()),
        above_(none_ + 1, none_),
        below_(above_),
        sides_(none_ + 1, Side::unknown) {
    is_cut_.resize(none_ + 1);
    is_cut_[none_] = true;
    sides_[none_] = Side::upper;  // for what is just above
  }

  void check() {
    check_order();
    Holders holders(set_);
    std::size_t begun = 0;
    for (std::size_t k = 0; k < given_.events.size(); ++k) {
      const std::size_t event = given_.events[k], s = event / 2;
      const auto [lower, upper] = event % 2 == 1 ? take_out(s) : put_in(s, given_.below[begun++]);
      if (allowed_ != Allowed::touch) holders.look(event, lower, upper);
      changed_.insert(changed_.end(), {s, lower, upper});
      const bool more_here = k + 1 < given_.events.size() && set_.end_of(given_.events[k + 1]) == set_.end_of(event);
      if (!more_here) check_pairs();
    }
  }

 private:
  using Around = std::pair<std::size_t, std::size_t>;
  enum class Side : unsigned char { unknown, lower, upper };  // of an edge in its pair

  bool is_point(std::size_t event) const { return set_.segments[event / 2].first == set_.segments[event / 2].last; }

  // T1.
  void check_order() const {
    const std::vector<std::size_t>& events = given_.events;
    require_each_end_once(events, none_, "edge");
    const auto rank = [&](std::size_t event) {  // at one point
      if (is_point(event)) return std::pair<int, std::size_t>{1, event};
      return std::pair<int, std::size_t>{event % 2 == 1 ? 0 : 2, 0};
    };
    for (std::size_t k = 1; k < events.size(); ++k) {
      const Point &before = set_.end_of(events[k - 1]), &here = set_.end_of(events[k]);
      const bool is_shared = before == here;
      require(before < here || (is_shared && rank(events[k - 1]) <= rank(events[k])), "T1",
              "event " + text(k) + " is out of order");
      require(!is_shared || allowed_ != Allowed::nothing || set_.is_one_group(events[k - 1] / 2, events[k] / 2), "T1",
              "event " + text(k) + " shares its point with another polygon");
    }
  }

  Around put_in(std::size_t s, std::size_t named) {
    const std::size_t lower = named == no_index ? none_ : named;
    require(is_cut_[lower], "T2", "edge " + text(s) + " begins above " + text(lower) + ", which is not cut then");
    const std::size_t upper = above_[lower];
    require(lower == none_ || side_of(s, lower) >= 0, "T3", "edge " + text(s) + " does not begin above " + text(lower));
    require(upper == none_ || side_of(s, upper) <= 0, "T3", "edge " + text(s) + " does not begin below " + text(upper));
    is_cut_[s] = true;
    become_neighbours(lower, s);
    become_neighbours(s, upper);
    return {lower, upper};
  }

  Around take_out(std::size_t s) {
    require(is_cut_[s], "T2", "edge " + text(s) + " ends before it begins");
    is_cut_[s] = false;
    const Around around{below_[s], above_[s]};
    become_neighbours(around.first, around.second);
    return around;
  }

  // 1: s, just after it begins, is above t, which has begun; -1: below; 0: on its line.
  int side_of(std::size_t s, std::size_t t) const {
    const Segment &edge = set_.segments[s], &other = set_.segments[t];
    const int begins = turn(other.first, other.last, edge.first);
    return begins != 0 ? begins : turn(other.first, other.last, edge.last);
  }

  void become_neighbours(std::size_t lower, std::size_t upper) {
    above_[lower] = upper;
    below_[upper] = lower;
    if (lower == none_ || upper == none_) return;
    const std::string kind = kind_of(set_.segments[lower], set_.segments[upper]);
    require(kind == "none" || (kind != "crossing" && (set_.is_one_group(lower, upper) || may_meet(kind))), "T4",
            "edges " + text(lower) + " and " + text(upper) + " become neighbours and meet: " + kind);
  }

  // May edges of different polygons, which do not cross, meet so?
  bool may_meet(const std::string& kind) const {
    return allowed_ == Allowed::touch || (allowed_ == Allowed::shared_endpoint && kind == "shared-endpoint");
  }

  // T5, around the edges that are new in the list, or have new neighbours.
  void check_pairs() {
    std::erase_if(changed_, [&](std::size_t s) { return !is_cut_[s]; });
    for (std::size_t s : changed_) {
      std::vector<std::size_t> row;
      for (; sides_[s] == Side::unknown; s = below_[s]) row.push_back(s);
      for (; !row.empty(); row.pop_back()) {
        sides_[row.back()] = sides_[below_[row.back()]] == Side::upper ? Side::lower : Side::upper;
      }
    }
    for (const std::size_t s : changed_) {
      require_in_pairs(below_[s], s);
      require_in_pairs(s, above_[s]);
    }
    changed_.clear();
  }

  void require_in_pairs(std::size_t lower, std::size_t upper) const {
    const bool is_pair = lower != none_ && sides_[lower] == Side::lower;
    const bool is_right = is_pair ? upper != none_ && sides_[upper] == Side::upper && set_.is_one_group(lower, upper)
                                  : upper == none_ || sides_[upper] == Side::lower;
    const auto name = [&](std::size_t s) { return s == none_ ? "-1" : text(s); };
    require(is_right, "T5",
            "edges " + name(lower) + " and " + name(upper) + " are not as in pairs of one polygon each");
  }

  const SegmentSet& set_;
  const Allowed allowed_;
  const None& given_;
  const std::size_t none_;                  // stands below and above all: the list is a ring
  std::vector<std::size_t> above_, below_;  // in the list
  std::vector<bool> is_cut_;                // is the edge in the list?
  std::vector<Side> sides_;
  std::vector<std::size_t> changed_;  // edges of the list, at the point now
};

// The number of vertices of each ring; their coordinates are appended.
std::vector<std::size_t> read_rings(const json& rings, const std::string& where, Numbers& flat) {
  if (!rings.is_array() || rings.empty()) refuse_form(where + " is not a list of rings");
  std::vector<std::size_t> sizes;
  for (const json& ring : rings) {
    if (!ring.is_array() || ring.size() < 3) refuse_form(where + " has a ring of fewer than three vertices");
    sizes.push_back(ring.size());
    for (const json& vertex : ring) {
      for (Number& number : read_numbers(vertex, 2, read_double, where + " vertex")) flat.push_back(std::move(number));
    }
  }
  return sizes;
}

void add_ring(const std::vector<Point>& ring, std::size_t polygon, SegmentSet& edges) {
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Point &p = ring[k], &q = ring[k + 1 == ring.size() ? 0 : k + 1];
    edges.segments.push_back(q < p ? Segment{q, p} : Segment{p, q});
    edges.groups.push_back(static_cast<std::int64_t>(polygon));
  }
}

Polygons read_polygons(const json& top) {
  Numbers flat;
  std::vector<std::vector<std::size_t>> sizes;
  for (const json& rings : list_member(top, "polygons", "the file")) {
    sizes.push_back(read_rings(rings, "polygons[" + text(sizes.size()) + "]", flat));
  }
  Common scaled = common(flat);
  Polygons set;
  set.edges.e = scaled.e;
  set.edges.bits = bits(scaled.integers);
  set.edges.has_groups = true;
  std::size_t next = 0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    for (const std::size_t size : sizes[i]) {
      std::vector<Point> ring;
      for (std::size_t k = 0; k < size; ++k, next += 2) {
        ring.push_back({std::move(scaled.integers[next]), std::move(scaled.integers[next + 1])});
      }
      const bool is_point = std::all_of(ring.begin(), ring.end(), [&](const Point& p) { return p == ring.front(); });
      if (is_point) refuse_form("polygons[" + text(i) + "] has a ring that is one point");
      add_ring(ring, i, set.edges);
    }
    set.first_edge.push_back(set.edges.segments.size());
  }
  return set;
}

Statement read_any(const std::shared_ptr<const Polygons>& set, const json& item, const std::string& where) {
  const std::string rule = read_rule(item, where), verdict = string_member(item, "verdict", where);
  if (verdict != "some" && verdict != "none") refuse_form(where + ".verdict is neither none nor some");
  const Allowed allowed = rule == "touch"     ? Allowed::touch
                          : rule == "nothing" ? Allowed::nothing
                                              : Allowed::shared_endpoint;
  const bool has_groups = item.contains("groups");
  std::vector<std::int64_t> groups;
  if (has_groups) groups = read_groups(item, set->size(), where);
  if (verdict == "some") {
    Some some;
    some.of = {index_member(item, "i", set->size(), where), index_member(item, "j", set->size(), where)};
    if (some.of[0] == some.of[1]) refuse_form(where + " names one polygon twice");
    some.point = read_numbers(member(item, "point", where), 2, read_number, where + ".point");
    some.groups = std::move(groups);
    return make_statement("polygons", rule + " allowed", verdict, [=] { check_some(*set, allowed, some); });
  }
  if (has_groups) refuse_form(where + " has groups, for which there is no transcript");
  const std::size_t count = set->edges.segments.size();
  None none;
  none.events = index_list(item, "events", 2 * count, no_index, where);
  none.below = index_or_none_list(item, "below", count, count, where);
  return make_statement("polygons", rule + " allowed", verdict, [=] { Transcript(*set, allowed, none).check(); });
}

}  // namespace

void add_polygon_questions(const json& top, Questions& questions) {
  if (!top.contains("polygons")) return;
  const auto set = std::make_shared<const Polygons>(read_polygons(top));
  questions["polygons_any"] = [set](const json& item, const std::string& where) { return read_any(set, item, where); };
}

}  // namespace sunder_verifier
