// The rules about valid polygons, and about what is wrong with others: docs/claims.md, "Valid polygons".
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sets.h>
#include <verifier/cpp/sweep.h>

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <string>
#include <unordered_set>
#include <utility>

namespace sunder_verifier {
namespace {

// Of a label, whose rings stand by parts, the shell of a part first: may they have a common point inside, which is so
// if of each part there is its shell, and one hole, and one shell without; and the parts of which there is the shell
// alone.
struct Filling {
  bool fits = true;
  Set alone;
};

Filling filling(const PartTable& parts, const Set& label) {
  Filling result;
  for (std::size_t k = 0; k < label.size();) {
    const std::size_t part = parts.part[label[k]], begin = k;
    while (k < label.size() && parts.part[label[k]] == part) ++k;
    const bool has_shell = label[begin] == parts.shell[part];
    result.fits = result.fits && k - begin <= 2 && has_shell;
    if (k - begin == 1 && has_shell) result.alone.push_back(part);
  }
  result.fits = result.fits && result.alone.size() <= 1;
  return result;
}

// Of the edges around a point, one that passes twice: does each way of a ring through it have, on either side, all of
// another one, or nothing?
bool is_nested(const PartTable& parts, const std::vector<std::size_t>& ways) {
  std::vector<std::size_t> begun;
  for (const std::size_t s : ways) {
    const auto& [before, after] = parts.beside[s];
    const bool ends = !begun.empty() && (begun.back() == s || begun.back() == before || begun.back() == after);
    if (ends) {
      begun.pop_back();
    } else {
      begun.push_back(s);
    }
  }
  return begun.empty();
}

// Goes through a sweep of all edges, with the rings that cover what is just above each edge of the list, and counts in
// how many pieces the inside of each part is.
class Regions {
 public:
  Regions(const SweepEvents& events, const PartTable& parts)
      : sweep(events, parts.polygons.edges, parts.ring_of),
        pieces(parts.polygons.rings.size()),
        parts_(parts),
        face_(parts.polygons.edges.size()),
        joined_{0} {}

  LabelledSweep sweep;
  std::vector<std::size_t> pieces;

  bool next() {
    if (!sweep.next()) return false;
    const std::vector<std::size_t>& going = sweep.going;
    const std::size_t lower = sweep.below == no_index ? 0 : face_[sweep.below];
    const std::size_t upper = sweep.here.empty() ? lower : face_[sweep.here.back()];
    for (std::size_t k = 0; k + 1 < going.size(); ++k) {
      face_[going[k]] = joined_.size();
      joined_.push_back(joined_.size());
      for (const std::size_t part : filling(parts_, sweep.labels[k + 1]).alone) ++pieces[part];
    }
    if (going.empty()) {
      join(lower, upper);
    } else {
      face_[going.back()] = upper;
    }
    return true;
  }

 private:
  // What is below and what is above the point are one: just right of it nothing is between.
  void join(std::size_t lower, std::size_t upper) {
    const std::size_t a = leader(lower), b = leader(upper);
    if (a == b) return;
    joined_[b] = a;
    for (const std::size_t part : filling(parts_, sweep.labels[0]).alone) --pieces[part];
  }

  std::size_t leader(std::size_t k) {
    while (joined_[k] != k) k = joined_[k] = joined_[joined_[k]];
    return k;
  }

  const PartTable& parts_;
  std::vector<std::size_t> face_;    // of what is just above each edge in the list
  std::vector<std::size_t> joined_;  // of each face one that it is one with, or itself
};

// Requires that no two edges that go on have one direction.
void require_no_lines(const Segments& edges, const std::vector<std::size_t>& going, const char* rule) {
  for (std::size_t k = 1; k < going.size(); ++k) {
    require(turn(edges[going[k - 1]], edges[going[k]]) != 0, rule, "edges go on along one line");
  }
}

// Where a point is seen from a ring.
struct AtRing {
  SweepPoint place;
  std::vector<std::size_t> edges;  // of some length, that hold the point
};

// Requires, by a rule, that an edge of some length holds the point.
AtRing at_ring(const char* rule, const PartTable& parts, std::size_t ring, const Numbers& point) {
  AtRing at{place_in_units(point, parts.polygons.edges.exponent), {}};
  for (const std::size_t k : edges_near(parts.polygons, parts.rings[ring], point, at.place)) {
    const PlanarSegment& edge = parts.polygons.edges[k];
    if (!is_point(edge) && is_on(edge, at.place)) at.edges.push_back(k);
  }
  require(!at.edges.empty(), rule, "the point is not on ring " + std::to_string(ring));
  return at;
}

// Is the first point of two lexicographically before the other?
struct IsBefore {
  bool operator()(const SweepPoint& p, const SweepPoint& q) const { return is_before(p, q); }
};

// A way from a point along an edge.
struct WayAlong {
  Integer x, y;
  std::size_t edge;

  bool is_upper() const { return y.sign() > 0 || (y.sign() == 0 && x.sign() > 0); }  // by less than half a turn
};

// By bearing; of two alike, by edge.
bool is_before(const WayAlong& p, const WayAlong& q) {
  if (p.is_upper() != q.is_upper()) return p.is_upper();
  const Integer turn = p.x * q.y - p.y * q.x;
  return turn > 0 || (turn == 0 && p.edge < q.edge);
}

void check_valid(const SweepEvents& events, const PartTable& parts, ValidRule rule) {
  Regions regions(events, parts);
  const LabelledSweep& sweep = regions.sweep;
  std::vector<bool> seen(parts.rings.size());
  while (regions.next()) {
    const bool has_points = sweep.going.size() < static_cast<std::size_t>(sweep.row_end - sweep.row);
    require(rule != ValidRule::simple || !has_points, "valid", "a vertex is repeated");
    std::vector<std::size_t> ways = sweep.going;  // around the point
    ways.insert(ways.end(), sweep.here.rbegin(), sweep.here.rend());
    Indices rings;
    for (const std::size_t s : ways) rings.push_back(parts.ring_of[s]);
    std::sort(rings.begin(), rings.end());
    const Set at = as_set(rings);
    bool is_twice = rings.size() == 2 * at.size();
    for (std::size_t k = 0; is_twice && k < at.size(); ++k) is_twice = rings[2 * k] == rings[2 * k + 1];
    require(is_twice || rule == ValidRule::with_self_touch, "valid", "a ring comes twice to a point");
    require_no_lines(parts.polygons.edges, sweep.going, "valid");
    require(rule != ValidRule::with_self_touch || is_nested(parts, ways), "valid", "a ring crosses itself");
    for (auto label = sweep.labels.begin() + 1; label != sweep.labels.end(); ++label) {
      require(filling(parts, *label).fits, "valid", "a ring is misplaced");
    }
    for (std::size_t k = 0; k < at.size(); ++k) {
      seen[at[k]] = true;
      const bool is_second = k > 0 && parts.part[at[k]] == parts.part[at[k - 1]];
      require(rule != ValidRule::simple || !is_second, "valid", "two rings of a part touch");
    }
  }
  const bool all_seen = std::find(seen.begin(), seen.end(), false) == seen.end();
  const bool all_filled =
      std::none_of(parts.polygons.rings.begin(), parts.polygons.rings.end(), [](const auto& p) { return p.empty(); });
  require(all_seen && all_filled, "valid", "a ring is one point, or a part has none");
  const bool all_whole =
      std::all_of(regions.pieces.begin(), regions.pieces.end(), [](std::size_t n) { return n == 1; });
  require(all_whole, "valid", "a part falls apart");
}

void check_falls_apart(const SweepEvents& events, const PartTable& parts) {
  Regions regions(events, parts);
  while (regions.next()) require_no_lines(parts.polygons.edges, regions.sweep.going, "falls_apart");
  const bool apart = std::any_of(regions.pieces.begin(), regions.pieces.end(), [](std::size_t n) { return n > 1; });
  require(apart, "falls_apart", "no part falls apart");
}

void check_too_few_points(const PartTable& parts, std::size_t ring) {
  const EdgeRange& edges = parts.rings[ring];
  take_steps(2 * (edges.end - edges.begin), parts.polygons.edges.bits, 1);
  std::set<SweepPoint, IsBefore> ends;
  for (std::size_t k = edges.begin; k < edges.end; ++k) {
    ends.insert(place_of(parts.polygons.edges[k].first));
    ends.insert(place_of(parts.polygons.edges[k].last));
  }
  require(ends.size() < 3, "too_few_points", "ring " + std::to_string(ring) + " has three different vertices");
}

void check_comes_twice(const PartTable& parts, ValidRule rule, std::size_t ring, const Numbers& point) {
  require(rule != ValidRule::with_self_touch, "comes_twice", "a ring may touch itself");
  const AtRing at = at_ring("comes_twice", parts, ring, point);
  std::size_t ends = 0;
  for (const std::size_t s : at.edges) ends += ends_at(parts.polygons.edges[s], at.place) ? std::size_t{1} : 2;
  require(ends > 2, "comes_twice", "the ring comes there once");
}

void check_crosses(const PartTable& parts, std::size_t ring, const Numbers& point) {
  const AtRing at = at_ring("crosses", parts, ring, point);
  std::vector<WayAlong> ways;
  for (const std::size_t s : at.edges) {
    for (const PlanarPoint* end : {&parts.polygons.edges[s].first, &parts.polygons.edges[s].last}) {
      if (at.place.is(*end)) continue;
      ways.push_back({end->x * at.place.w - at.place.x, end->y * at.place.w - at.place.y, s});
    }
  }
  const std::size_t size = length(point) + parts.polygons.edges.bits;
  take_steps(32 * ways.size(), size, size);
  std::sort(ways.begin(), ways.end(), [](const WayAlong& p, const WayAlong& q) { return is_before(p, q); });
  std::vector<std::size_t> around;
  for (const WayAlong& way : ways) around.push_back(way.edge);
  require(!is_nested(parts, around), "crosses", "the ring does not cross itself there");
}

void check_misplaced(const PartTable& parts, std::size_t ring, const Numbers& point) {
  const SweepPoint place = at_ring("misplaced", parts, ring, point).place;
  const auto is_hole = [&](std::size_t r) { return r != parts.shell[parts.part[r]]; };
  Set label;
  std::unordered_set<std::size_t> parts_of_holes;  // the part of the ring, if it is one, and of those in the label
  if (is_hole(ring)) parts_of_holes.insert(parts.part[ring]);
  for (std::size_t r = 0; r < parts.rings.size(); ++r) {
    if (r == ring) continue;
    const std::vector<std::size_t> near = edges_near(parts.polygons, parts.rings[r], point, place);
    for (const std::size_t k : near) {
      require(!is_on(parts.polygons.edges[k], place), "misplaced",
              "the point is on ring " + std::to_string(r) + ", too");
    }
    if (!is_above_odd(parts.polygons, near, place)) continue;
    if (is_hole(r) && !parts_of_holes.insert(parts.part[r]).second) return;  // two holes of one part
    label.push_back(r);
  }
  require(!filling(parts, label).fits || !filling(parts, toggled(label, ring)).fits, "misplaced", "rings fit there");
}

void check_circle(const PartTable& parts, const Indices& rings, const Points& points) {
  for (const std::size_t r : rings) {
    require(parts.part[r] == parts.part[rings[0]], "circle", "the rings are of different parts");
  }
  std::set<SweepPoint, IsBefore> places;
  for (std::size_t k = 0; k < rings.size(); ++k) {
    take_steps(32, length(points[k]), length(points[k]));
    at_ring("circle", parts, rings[k], points[k]);
    places.insert(at_ring("circle", parts, rings[k + 1 < rings.size() ? k + 1 : 0], points[k]).place);
  }
  require(places.size() == rings.size(), "circle", "a point is listed twice");
}

void check_repeated(const PartTable& parts, ValidRule rule, std::size_t edge) {
  require(rule == ValidRule::simple, "repeated", "vertices may be repeated");
  require(is_point(parts.polygons.edges[edge]), "repeated", "the edge is of some length");
}

void check_rings_touch(const PartTable& parts, ValidRule rule, std::size_t ring, std::size_t other,
                       const Numbers& point) {
  require(rule == ValidRule::simple && ring != other && parts.part[ring] == parts.part[other], "rings_touch",
          "these may touch");
  at_ring("rings_touch", parts, ring, point);
  at_ring("rings_touch", parts, other, point);
}

}  // namespace

const ClaimRows claims_of_valid_polygons{
    {"valid", "events: sweep of subject", rule<check_valid>},
    {"falls_apart", "events: sweep of subject", rule<check_falls_apart>},
    {"too_few_points", "", rule<check_too_few_points>},
    {"comes_twice", "", rule<check_comes_twice>},
    {"crosses", "", rule<check_crosses>},
    {"misplaced", "", rule<check_misplaced>},
    {"circle", "", rule<check_circle>},
    {"repeated", "", rule<check_repeated>},
    {"rings_touch", "", rule<check_rings_touch>},
};

}  // namespace sunder_verifier
