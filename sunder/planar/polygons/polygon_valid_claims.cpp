#include <sunder/planar/pair/segment_segment.h>
#include <sunder/planar/polygons/polygon_valid_claims.h>
#include <sunder/planar/polygons/polygons_claims.h>
#include <sunder/planar/segments/segments_all.h>
#include <sunder/planar/sweep/sweep_claims.h>
#include <sunder/predicate/line/crossing.h>

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <numeric>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

// A ring without a last vertex that repeats its first.
std::span<const Point2> open(const std::vector<Point2>& ring) {
  return std::span(ring).first(ring.size() - (ring.size() > 1 && ring.front() == ring.back() ? 1 : 0));
}

// The rings and edges of some parts, numbered over all of them in turn.
struct Numbered {
  explicit Numbered(std::span<const PolygonRings> parts) {
    for (std::uint32_t i = 0; i < parts.size(); ++i) {
      first_ring.push_back(static_cast<std::uint32_t>(part.size()));
      for (const std::vector<Point2>& ring : parts[i]) {
        const std::span<const Point2> vertices = open(ring);
        first_edge.push_back(static_cast<std::uint32_t>(edges.size()));
        for (std::size_t k = 0; k < vertices.size(); ++k) {
          edges.push_back(sorted({vertices[k], vertices[k + 1 < vertices.size() ? k + 1 : 0]}));
          ring_of.push_back(static_cast<std::uint32_t>(part.size()));
        }
        part.push_back(i);
        box.push_back(vertices.empty() ? Box2{} : Box2{vertices[0], vertices[0]});
        for (const Point2& p : vertices) box.back() = hull(box.back(), {p, p});
      }
    }
    first_edge.push_back(static_cast<std::uint32_t>(edges.size()));
  }

  std::uint32_t ring(const RingPlace& place) const { return first_ring[place.part] + place.ring; }
  std::uint32_t edge(const RingPlace& place) const { return first_edge[ring(place)] + place.edge; }
  std::span<const Segment> edges_of(std::uint32_t ring) const {
    return std::span(edges).subspan(first_edge[ring], first_edge[ring + 1] - first_edge[ring]);
  }

  std::vector<std::uint32_t> first_ring, first_edge;  // of each part, of each ring
  std::vector<std::uint32_t> ring_of, part;           // of each edge, of each ring
  std::vector<Box2> box;                              // of each ring
  std::vector<Segment> edges;
};

std::string_view name_in_file(PolygonRule rule) {
  switch (rule) {
    case PolygonRule::simple: return "simple";
    case PolygonRule::valid: return "valid";
    case PolygonRule::self_touch: break;
  }
  return "valid-with-self-touch";
}

// The statement about some parts, of which first_part is the first in the table.
struct Statement {
  ClaimsWriter& file;
  const Numbered& all;
  std::uint32_t first_part;
  PolygonRule rule;

  void begin(std::string_view verdict) const {
    std::vector<std::uint32_t> parts(all.first_ring.size());
    std::iota(parts.begin(), parts.end(), first_part);
    file.begin_statement("valid");
    file.indices("parts", parts);
    file.text("rule", name_in_file(rule));
    file.text("verdict", verdict);
  }
  void point(const ExactPoint2& p) const { file.fractions("point", std::array{p.x, p.y}, p.denominator); }
  void end(std::string_view claim) const {
    file.begin_claims();
    file.claim(claim);
    file.end_statement();
  }
  void end(std::string_view claim, const SweepEvents& events) const {
    write_sweep(file, claim, events);
    file.end_statement();
  }
};

// ---- Rings that do not fit at a point.

// Positive: the point, of denominator 1, is left of the edge.
Sign side(const Segment& e, const ExactPoint2& p) {
  const Dyadic ax(e.a.x), ay(e.a.y);
  return ((Dyadic(e.b.x) - ax) * (p.y - ay) - (Dyadic(e.b.y) - ay) * (p.x - ax)).sign();
}

bool is_before(const ExactPoint2& p, const Point2& q) {
  const Sign x = (p.x - Dyadic(q.x)).sign();
  return x == Sign::negative || (x == Sign::zero && (p.y - Dyadic(q.y)).sign() == Sign::negative);
}

bool is_after(const ExactPoint2& p, const Point2& q) {
  const Sign x = (p.x - Dyadic(q.x)).sign();
  return x == Sign::positive || (x == Sign::zero && (p.y - Dyadic(q.y)).sign() == Sign::positive);
}

enum class Place { outside, on, inside };

Place place_in(std::span<const Segment> ring, const ExactPoint2& p) {
  bool inside = false;
  for (const Segment& e : ring) {
    if (is_before(p, e.a) || is_after(p, e.b)) continue;
    const Sign at = side(e, p);
    if (at == Sign::zero) return Place::on;
    inside ^= at == Sign::positive && is_before(p, e.b);
  }
  return inside ? Place::inside : Place::outside;
}

// May these rings, sorted, have a common point inside? In each part its first, and one other; one without another.
bool fits(const Numbered& all, const std::vector<std::uint32_t>& rings) {
  std::size_t filled = 0;
  for (std::size_t k = 0; k < rings.size();) {
    const std::uint32_t part = all.part[rings[k]];
    const std::size_t first = k;
    while (k < rings.size() && all.part[rings[k]] == part) ++k;
    if (k - first > 2 || rings[first] != all.first_ring[part]) return false;
    if (k - first == 1) ++filled;
  }
  return filled <= 1;
}

// Is this point of an edge on no other ring, and does what is on one side of it not fit?
bool is_misplaced(const Numbered& all, std::uint32_t edge, const ExactPoint2& p) {
  const std::uint32_t ring = all.ring_of[edge];
  std::vector<std::uint32_t> others, with;
  for (std::uint32_t r = 0; r < all.part.size(); ++r) {
    if (!meet(all.box[r], box_of(all.edges[edge]))) continue;  // the point is outside
    const Place place = r == ring ? Place::outside : place_in(all.edges_of(r), p);
    if (place == Place::on) return false;
    if (place == Place::inside) others.push_back(r);
    if (place == Place::inside || r == ring) with.push_back(r);
  }
  return !fits(all, others) || !fits(all, with);
}

ExactPoint2 between(const Point2& p, const Point2& q, const Dyadic& part) {
  return {Dyadic(p.x) + (Dyadic(q.x) - Dyadic(p.x)) * part, Dyadic(p.y) + (Dyadic(q.y) - Dyadic(p.y)) * part, 1.0};
}

// On an edge, from its middle to near its ends.
std::optional<ExactPoint2> misplaced_on(const Numbered& all, std::uint32_t edge) {
  const Segment& e = all.edges[edge];
  for (int k = 1; k < 4000; k += k < 64 ? 1 : k) {
    const Dyadic part = Dyadic::power_of_two(-k);
    for (const auto& [p, q] : {std::pair(e.a, e.b), std::pair(e.b, e.a)}) {
      ExactPoint2 point = between(p, q, part);
      if (is_misplaced(all, edge, point)) return point;
    }
  }
  return std::nullopt;
}

bool write_misplaced(const Statement& out, const std::vector<std::uint32_t>& edges) {
  for (const std::uint32_t edge : edges) {
    const std::optional<ExactPoint2> point = misplaced_on(out.all, edge);
    if (!point) continue;
    out.begin("misplaced");
    out.file.index("ring", out.all.ring_of[edge]);
    out.point(*point);
    out.end("misplaced");
    return true;
  }
  return false;
}

// The edges of a ring that hold a point.
std::vector<std::uint32_t> edges_at(const Numbered& all, std::uint32_t ring, const Point2& p) {
  std::vector<std::uint32_t> result;
  for (std::uint32_t e = all.first_edge[ring]; e < all.first_edge[ring + 1]; ++e) {
    const Segment& s = all.edges[e];
    if (s.a != s.b && segment_segment({p, p}, s) != ContactKind::none) result.push_back(e);
  }
  return result;
}

// ---- Rings that close a circle.

// Rings and points, each the neighbour of the next, the last of the first.
struct Disc {
  std::vector<std::uint32_t> rings;
  std::vector<Point2> points;
};

// A forest of rings, below `rings`, and of points that some touch in.
class Touches {
 public:
  explicit Touches(std::uint32_t rings) : rings_(rings), joined_(rings) {}

  // The way between a ring and a point that were joined before; else joins them.
  std::optional<Disc> join(std::uint32_t ring, const Point2& p) {
    const auto [found, is_new] = number_.try_emplace({p.x, p.y}, static_cast<std::uint32_t>(joined_.size()));
    const std::uint32_t point = found->second;
    if (is_new) {
      joined_.emplace_back();
      points_.push_back(p);
    }
    const std::vector<std::uint32_t>& known = joined_[ring];
    if (std::find(known.begin(), known.end(), point) != known.end()) return std::nullopt;
    std::optional<Disc> circle = way(ring, point);
    joined_[ring].push_back(point);
    joined_[point].push_back(ring);
    return circle;
  }

 private:
  std::optional<Disc> way(std::uint32_t ring, std::uint32_t point) const {
    std::vector<std::uint32_t> from(joined_.size(), none), next{point};
    from[point] = point;
    for (std::size_t k = 0; k < next.size() && from[ring] == none; ++k) {
      for (const std::uint32_t other : joined_[next[k]]) {
        if (from[other] != none) continue;
        from[other] = next[k];
        next.push_back(other);
      }
    }
    if (from[ring] == none) return std::nullopt;
    Disc circle;
    for (std::uint32_t at = ring;; at = from[at]) {
      if (at < rings_) {
        circle.rings.push_back(at);
      } else {
        circle.points.push_back(points_[at - rings_]);
      }
      if (at == point) return circle;
    }
  }

  static constexpr std::uint32_t none = no_segment;
  std::uint32_t rings_;
  std::vector<std::vector<std::uint32_t>> joined_;  // of each ring, then of each point
  std::map<std::pair<double, double>, std::uint32_t> number_;
  std::vector<Point2> points_;
};

// Of one part; of crossings nothing is looked at.
std::optional<Disc> circle_in(const Numbered& all, std::uint32_t part) {
  std::vector<Segment> edges;
  std::vector<std::uint32_t> ring_of;
  for (std::size_t e = 0; e < all.edges.size(); ++e) {
    if (all.part[all.ring_of[e]] != part) continue;
    edges.push_back(all.edges[e]);
    ring_of.push_back(all.ring_of[e]);
  }
  Touches touches(static_cast<std::uint32_t>(all.part.size()));
  std::optional<Disc> circle;
  SetOptions options;
  options.groups = ring_of;
  const Segments segments(edges);
  segments_visit(segments, options, [&](const SegmentsContact& c) {
    if (c.kind == ContactKind::crossing) return true;
    const Segment &s = segments[c.i], &t = segments[c.j];
    const auto holds = [](const Segment& e, const Point2& p) {
      return segment_segment({p, p}, e) != ContactKind::none;
    };
    const Point2& p = holds(t, s.a) ? s.a : holds(t, s.b) ? s.b : holds(s, t.a) ? t.a : t.b;
    circle = touches.join(ring_of[c.i], p);
    if (!circle) circle = touches.join(ring_of[c.j], p);
    return !circle;
  });
  return circle;
}

bool write_circle(const Statement& out, std::uint32_t part) {
  const std::optional<Disc> circle = circle_in(out.all, part);
  if (!circle) return false;
  out.begin("circle");
  out.file.indices("rings", circle->rings);
  out.file.begin_list("points");
  for (const Point2& p : circle->points) out.file.add_numbers(std::array{p.x, p.y});
  out.file.end_list();
  out.end("circle");
  return true;
}

// ---- Parts that fall apart.

// Goes through a sweep of all edges, with the rings around what is just above each, and the face that this is of.
class Faces {
 public:
  explicit Faces(const Numbered& all)
      : all_(all),
        outside_(static_cast<std::uint32_t>(all.edges.size())),
        next_(all.edges.size() + 1, none),
        goes_on_at_(all.edges.size() + 1, none),
        face_(all.edges.size() + 1),
        rings_(all.edges.size() + 1),
        joined_{0},
        pieces_(all.first_ring.size()) {}

  // Is the inside of a part in two pieces or more? Of edges with a piece in common nothing is said.
  bool fall_apart(const SweepEvents& events) {
    for (std::uint32_t k = 0; k < events.size(); ++k) {
      if (has_line(events.goes_on(k))) return false;
      pass(events, k);
    }
    return std::any_of(pieces_.begin(), pieces_.end(), [](std::size_t n) { return n > 1; });
  }

 private:
  void pass(const SweepEvents& events, std::uint32_t k) {
    const std::uint32_t below = events.below[k] == no_segment ? outside_ : events.below[k];
    for (const std::uint32_t s : events.goes_on(k)) goes_on_at_[s] = k;
    std::uint32_t upper = next_[below], upper_face = face_[below], last = below;
    for (; upper != none && (goes_on_at_[upper] == k || ends(events.at[k], upper)); upper = next_[upper]) {
      upper_face = face_[upper];
    }
    for (const std::uint32_t s : events.goes_on(k)) {
      if (all_.edges[s].a == all_.edges[s].b) continue;
      if (last != below) add_face(last);
      next_[last] = s;
      const std::uint32_t ring = all_.ring_of[s];
      rings_[s].clear();
      std::set_symmetric_difference(rings_[last].begin(), rings_[last].end(), &ring, &ring + 1,
                                    std::back_inserter(rings_[s]));
      last = s;
    }
    next_[last] = upper;
    if (last == below) {
      join(last, upper_face);
    } else {
      face_[last] = upper_face;
    }
  }

  // Do two of these, which begin or go on in one point, from the lowest up, have one direction?
  bool has_line(std::span<const std::uint32_t> row) const {
    const Segment* last = nullptr;
    for (const std::uint32_t s : row) {
      const Segment& e = all_.edges[s];
      if (e.a == e.b) continue;
      if (last != nullptr && segment_segment(*last, e) == ContactKind::overlap) return true;
      last = &e;
    }
    return false;
  }

  bool ends(std::uint32_t at, std::uint32_t s) const {
    if (at == at_crossing) return false;
    const Segment& e = all_.edges[at / 2];
    return all_.edges[s].b == (at % 2 == 0 ? e.a : e.b);
  }

  // The part that this is inside of, and in none of its holes; of parts that overlap, any.
  std::optional<std::uint32_t> part_around(const std::vector<std::uint32_t>& rings) const {
    for (std::size_t k = 0; k < rings.size(); ++k) {
      const std::uint32_t part = all_.part[rings[k]];
      const bool has_hole = k + 1 < rings.size() && all_.part[rings[k + 1]] == part;
      if (rings[k] == all_.first_ring[part] && !has_hole) return part;
    }
    return std::nullopt;
  }

  void add_face(std::uint32_t above) {
    face_[above] = static_cast<std::uint32_t>(joined_.size());
    joined_.push_back(face_[above]);
    if (const auto part = part_around(rings_[above])) ++pieces_[*part];
  }

  void join(std::uint32_t above, std::uint32_t face) {
    const std::uint32_t a = leader(face_[above]), b = leader(face);
    if (a == b) return;
    joined_[b] = a;
    if (const auto part = part_around(rings_[above])) --pieces_[*part];
  }

  std::uint32_t leader(std::uint32_t k) {
    while (joined_[k] != k) k = joined_[k] = joined_[joined_[k]];
    return k;
  }

  static constexpr std::uint32_t none = no_segment;
  const Numbered& all_;
  const std::uint32_t outside_;  // stands below all edges
  std::vector<std::uint32_t> next_, goes_on_at_, face_;
  std::vector<std::vector<std::uint32_t>> rings_;
  std::vector<std::uint32_t> joined_;  // of each face one that it is one with, or itself
  std::vector<std::size_t> pieces_;
};

bool write_falls_apart(const Statement& out) {
  const auto events = sweep_events(Segments(out.all.edges), std::numeric_limits<std::size_t>::max());
  if (!Faces(out.all).fall_apart(*events)) return false;
  out.begin("falls_apart");
  out.end("falls_apart", *events);
  return true;
}

// ---- Others.

bool write_edges_meet(const Statement& out, std::uint32_t i, std::uint32_t j) {
  const Segment &s = out.all.edges[i], &t = out.all.edges[j];
  const ContactKind kind = segment_segment(s, t);
  out.begin("edges_meet");
  out.file.index("i", i);
  out.file.index("j", j);
  out.file.text("kind", name_of(kind));
  out.point(kind == ContactKind::overlap ? exactly(common_part(s, t).a) : common_point(s, t));
  out.end("contact");
  return true;
}

bool write_at_ring(const Statement& out, std::string_view verdict, std::uint32_t ring,
                   std::optional<std::uint32_t> other, const std::optional<Point2>& point) {
  out.begin(verdict);
  out.file.index("ring", ring);
  if (other) out.file.index("other", *other);
  if (point) out.point(exactly(*point));
  out.end(verdict);
  return true;
}

}  // namespace

void write_parts(ClaimsWriter& file, std::span<const PolygonRings> parts) {
  for (const PolygonRings& part : parts) {
    file.begin_list();
    for (const std::vector<Point2>& ring : part) write_ring(file, open(ring));
    file.end_list();
  }
}

// What is common to the statements about the parts of one multipolygon, and which of them stand in the file: a ring
// that touches itself in a point many times has many defects, and one statement tells of all.
struct ValidClaims::Data {
  Numbered all;
  Statement out;
  std::set<std::tuple<std::string_view, std::uint32_t, std::uint32_t, double, double>> stated;  // verdict, rings, point
  std::map<std::uint32_t, bool> circles;  // of parts that were asked about: was one found?
  std::optional<bool> falls_apart;

  Data(ClaimsWriter& file, std::span<const PolygonRings> parts, std::uint32_t first_part, PolygonRule rule)
      : all(parts), out{file, all, first_part, rule} {}

  bool write_at_ring(std::string_view verdict, std::uint32_t ring, std::optional<std::uint32_t> other,
                     const std::optional<Point2>& point) {
    const Point2 p = point.value_or(Point2{});
    const bool is_new = stated.insert({verdict, ring, other.value_or(no_segment), p.x, p.y}).second;
    return !is_new || planar::write_at_ring(out, verdict, ring, other, point);
  }
  bool write_circle(std::uint32_t part) {
    const auto [found, is_new] = circles.try_emplace(part);
    if (is_new) found->second = planar::write_circle(out, part);
    return found->second;
  }
  bool write_falls_apart() {
    if (!falls_apart) falls_apart = planar::write_falls_apart(out);
    return *falls_apart;
  }
};

ValidClaims::ValidClaims(ClaimsWriter& file, std::span<const PolygonRings> parts, std::uint32_t first_part,
                         PolygonRule rule)
    : data_(std::make_unique<Data>(file, parts, first_part, rule)) {}
ValidClaims::~ValidClaims() = default;

void ValidClaims::write_valid() {
  const auto events = sweep_events(Segments(data_->all.edges), std::numeric_limits<std::size_t>::max());
  data_->out.begin("valid");
  data_->out.end("valid", *events);
}

bool ValidClaims::write_defect(const PolygonDefect& defect) {
  const Numbered& all = data_->all;
  const Statement& out = data_->out;
  const PolygonRule rule = out.rule;
  const std::uint32_t a = all.ring(defect.a), b = all.ring(defect.b);
  const Point2& at = defect.place.a;
  const auto comes_twice = [&] { return data_->write_at_ring("comes_twice", a, std::nullopt, at); };
  switch (defect.kind) {
    case PolygonDefectKind::too_few_points:
      return data_->write_at_ring("too_few_points", a, std::nullopt, std::nullopt);
    case PolygonDefectKind::crossing: {
      const std::uint32_t i = all.edge(defect.a), j = all.edge(defect.b);
      if (segment_segment(all.edges[i], all.edges[j]) == ContactKind::crossing) return write_edges_meet(out, i, j);
      if (a == b && rule != PolygonRule::self_touch) return comes_twice();
      if (a == b) return data_->write_at_ring("crosses", a, std::nullopt, at);
      std::vector<std::uint32_t> edges = edges_at(all, a, at), more = edges_at(all, b, at);
      edges.insert(edges.end(), more.begin(), more.end());
      return write_misplaced(out, edges);
    }
    case PolygonDefectKind::overlap: return write_edges_meet(out, all.edge(defect.a), all.edge(defect.b));
    case PolygonDefectKind::repeated_vertex:
      out.begin("repeated");
      out.file.index("edge", all.edge(defect.a));
      out.end("repeated");
      return true;
    case PolygonDefectKind::self_touch: return comes_twice();
    case PolygonDefectKind::rings_touch: return data_->write_at_ring("rings_touch", a, b, at);
    case PolygonDefectKind::hole_outside:
    case PolygonDefectKind::nested_holes:
    case PolygonDefectKind::nested_parts: return write_misplaced(out, {all.edge(defect.a)});
    case PolygonDefectKind::disconnected:
      if (data_->write_circle(defect.a.part)) return true;
      return a != b || rule == PolygonRule::self_touch ? data_->write_falls_apart() : comes_twice();
  }
  return false;
}

}  // namespace sunder::planar
