// The oracle: it shares nothing with polygon_valid.cpp but what is declared in the header.
//
// Coordinates are exact numbers: x' = 2 (K x + y), y' = 2 y, with K so large that different points have different x'.
// That maps the plane onto itself and keeps what turns left; no edge is vertical, and the middle of two points has
// whole coordinates where these are whole. Numbers are Dyadic, or, where all coordinates are whole and at most 2^8 in
// size, 64-bit integers: x' is below 2^20 and y' below 2^10 then, differences of both are below 2^21 and 2^11,
// numerators of heights below 2^33, and products of these with a difference below 2^54.
//
// The interior is connected iff all sides of edges that are inside are joined by these: two sides that face each other
// at a point, from one way to the next around it; and the lower side of a piece of an edge with the upper side of the
// next piece straight below its middle. (Of a part of the boundary that hangs together, by itself within a face, some
// edge has nothing of that part below its middle.)
#include <sunder/number/dyadic.h>
#include <sunder/planar/pair/segment_segment.h>
#include <sunder/planar/polygons/polygon_valid.h>

#include <algorithm>
#include <numeric>
#include <optional>
#include <tuple>

namespace sunder::planar {

namespace {

using Kind = PolygonDefectKind;

int sign_of_number(const Dyadic& x) { return static_cast<int>(x.sign()); }
int sign_of_number(std::int64_t x) { return x > 0 ? 1 : x < 0 ? -1 : 0; }

template <class Number>
struct Point {
  Number x, y;
};

Point<std::int64_t> sheared(const Point2& p, std::int64_t) {
  const auto x = static_cast<std::int64_t>(p.x), y = static_cast<std::int64_t>(p.y);
  return {2 * (1024 * x + y), 2 * y};
}
Point<Dyadic> sheared(const Point2& p, const Dyadic&) {
  const Dyadic y(p.y), k = Dyadic::power_of_two(2200), two(2.0);
  return {two * (k * Dyadic(p.x) + y), two * y};
}
std::int64_t half(std::int64_t x) { return x / 2; }
Dyadic half(const Dyadic& x) { return x * Dyadic(0.5); }

template <class Number>
class RingScan {
 public:
  using P = Point<Number>;

  RingScan(std::span<const PolygonRings> parts, PolygonRule rule) : rule_(rule) {
    for (std::uint32_t p = 0; p < parts.size(); ++p) {
      for (std::uint32_t r = 0; r < parts[p].size(); ++r) add_ring(p, r, parts[p][r]);
    }
  }

  std::vector<PolygonDefect> run() {
    look_at_edges();
    drop();
    if (look_at_points(true)) drop();
    look_at_points(false);
    cut_edges();
    look_at_holes();
    drop();
    look_at_interiors();
    look_at_parts();
    return std::move(defects_);
  }

 private:
  struct Ring {
    std::uint32_t part, number;
    std::vector<P> at;
    std::vector<Point2> given;
    std::vector<std::uint32_t> numbers;
    bool dropped = false;
    std::size_t size() const { return at.size(); }
    std::size_t next(std::size_t k) const { return (k + 1) % size(); }
  };
  struct Pass {  // of a ring through a point: from where, and to where
    Ring* ring;
    std::size_t edge;
    P from, to;
  };
  struct Piece {
    const Ring* ring;
    std::size_t edge;
    P a, b, middle;  // a to the left
  };

  void add_ring(std::uint32_t part, std::uint32_t number, std::vector<Point2> given) {
    if (given.size() > 1 && given.front() == given.back()) given.pop_back();
    const RingPlace place{part, number, 0};
    Ring ring{part, number, {}, {}, {}};
    for (std::uint32_t k = 0; k < given.size(); ++k) {
      const auto next = static_cast<std::uint32_t>((k + 1) % given.size());
      if (given[k] == given[next] && (next > 0 || !ring.at.empty())) {
        if (rule_ == PolygonRule::simple) {
          add(Kind::repeated_vertex, {part, number, k}, {part, number, next}, {given[k], given[k]});
        }
        continue;
      }
      ring.at.push_back(sheared(given[k], Number{}));
      ring.given.push_back(given[k]);
      ring.numbers.push_back(k);
    }
    if (ring.size() >= 3) return rings_.push_back(ring);
    const Point2 at = given.empty() ? Point2{} : given[0];
    add(Kind::too_few_points, place, place, {at, at});
  }

  void add(Kind kind, const RingPlace& a, const RingPlace& b, const Segment& place) {
    defects_.push_back({kind, a, b, place});
  }
  static RingPlace place_of(const Ring& r, std::size_t edge) { return {r.part, r.number, r.numbers[edge]}; }
  static Segment edge_of(const Ring& r, std::size_t k) { return sorted({r.given[k], r.given[r.next(k)]}); }
  void drop() {
    std::erase_if(rings_, [](const Ring& r) { return r.dropped; });
  }

  static int side(const P& a, const P& b, const P& p) {
    return sign_of_number((b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x));
  }
  static int compare(const Number& x, const Number& y) { return sign_of_number(x - y); }
  static bool equal(const P& p, const P& q) { return compare(p.x, q.x) == 0; }  // different ones differ in x'
  static bool is_inside_edge(const P& p, const P& a, const P& b) {
    return side(a, b, p) == 0 && compare(a.x, p.x) * compare(p.x, b.x) > 0;
  }

  void look_at_edges() {
    for (std::size_t r = 0; r < rings_.size(); ++r) {
      for (std::size_t s = r; s < rings_.size(); ++s) {
        for (std::size_t e = 0; e < rings_[r].size(); ++e) {
          for (std::size_t f = r == s ? e + 1 : 0; f < rings_[s].size(); ++f) look_at_two(rings_[r], e, rings_[s], f);
        }
      }
    }
  }

  void look_at_two(Ring& r, std::size_t e, Ring& s, std::size_t f) {
    const P &a = r.at[e], &b = r.at[r.next(e)], &c = s.at[f], &d = s.at[s.next(f)];
    const int of_c = side(a, b, c), of_d = side(a, b, d);
    if (of_c == 0 && of_d == 0) {
      const auto less = [](const P& p, const P& q) { return compare(p.x, q.x) < 0; };
      if (!less(std::max(std::min(a, b, less), std::min(c, d, less), less),
                std::min(std::max(a, b, less), std::max(c, d, less), less))) {
        return;
      }
      const Segment t = edge_of(r, e), u = edge_of(s, f);
      add(Kind::overlap, place_of(r, e), place_of(s, f),
          {std::max(t.a, u.a, lexicographically_less), std::min(t.b, u.b, lexicographically_less)});
    } else if (of_c * of_d < 0 && side(c, d, a) * side(c, d, b) < 0) {
      const Point2 at = common_point_rounded(edge_of(r, e), edge_of(s, f));
      add(Kind::crossing, place_of(r, e), place_of(s, f), {at, at});
    } else {
      return;
    }
    s.dropped = true;
  }

  // All passes through a vertex.
  std::vector<Pass> passes_at(const P& p) {
    std::vector<Pass> passes;
    for (Ring& ring : rings_) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const P &a = ring.at[k], &b = ring.at[ring.next(k)];
        if (equal(a, p)) passes.push_back({&ring, k, ring.at[(k + ring.size() - 1) % ring.size()], b});
        if (is_inside_edge(p, a, b)) passes.push_back({&ring, k, a, b});
      }
    }
    return passes;
  }

  // Is q strictly between the ways from p to a and to b, counter-clockwise? It is on neither.
  static bool is_between(const P& p, const P& a, const P& b, const P& q) {
    const int turn = side(p, a, b);
    if (turn < 0) return !is_between(p, b, a, q);
    return side(p, a, q) > 0 && (turn == 0 || side(p, q, b) > 0);
  }
  static bool cross(const P& p, const Pass& v, const Pass& w) {
    return is_between(p, v.from, v.to, w.from) != is_between(p, v.from, v.to, w.to);
  }

  // Once to look for crossings, then to look for touches.
  bool look_at_points(bool for_crossings) {
    const std::size_t before = defects_.size();
    for (const Ring& ring : rings_) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const P& p = ring.at[k];
        const std::vector<Pass> passes = passes_at(p);
        const auto first = std::find_if(passes.begin(), passes.end(),
                                        [&](const Pass& pass) { return equal(pass.ring->at[pass.edge], p); });
        if (first->ring != &ring || first->edge != k) continue;  // each point once
        for (std::size_t i = 0; i < passes.size(); ++i) {
          for (std::size_t j = i + 1; j < passes.size(); ++j) {
            look_at_passes(for_crossings, p, ring.given[k], passes[i], passes[j]);
          }
        }
      }
    }
    return defects_.size() > before;
  }

  void look_at_passes(bool for_crossings, const P& p, const Point2& at, const Pass& v, const Pass& w) {
    const RingPlace a = place_of(*v.ring, v.edge), b = place_of(*w.ring, w.edge);
    if (for_crossings) {
      if (!cross(p, v, w)) return;
      add(Kind::crossing, a, b, {at, at});
      w.ring->dropped = true;
    } else if (v.ring == w.ring) {
      if (rule_ != PolygonRule::self_touch) add(Kind::self_touch, a, b, {at, at});
    } else if (rule_ == PolygonRule::simple && v.ring->part == w.ring->part) {
      add(Kind::rings_touch, a, b, {at, at});
    }
  }

  void cut_edges() {
    for (const Ring& ring : rings_) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        std::vector<P> at{ring.at[k], ring.at[ring.next(k)]};
        for (const Ring& other : rings_) {
          for (const P& p : other.at) {
            if (is_inside_edge(p, at[0], at[1])) at.push_back(p);
          }
        }
        std::sort(at.begin(), at.end(), [](const P& p, const P& q) { return compare(p.x, q.x) < 0; });
        for (std::size_t i = 1; i < at.size(); ++i) {
          if (equal(at[i - 1], at[i])) continue;
          const P middle{half(at[i - 1].x + at[i].x), half(at[i - 1].y + at[i].y)};
          pieces_.push_back({&ring, k, at[i - 1], at[i], middle});
        }
      }
    }
  }

  static bool spans(const P& a, const P& b, const P& p) {  // half-open, a to the left
    return compare(a.x, p.x) <= 0 && compare(p.x, b.x) < 0;
  }
  // Is it above an odd number of the edges of the ring? It is on none of them.
  static bool encloses(const Ring& ring, const P& p) {
    bool odd = false;
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const P &a = ring.at[k], &b = ring.at[ring.next(k)];
      if (spans(a, b, p)) odd ^= side(a, b, p) > 0;
      if (spans(b, a, p)) odd ^= side(b, a, p) > 0;
    }
    return odd;
  }

  const Ring* shell_of(std::uint32_t part) const {
    for (const Ring& ring : rings_) {
      if (ring.part == part && ring.number == 0) return &ring;
    }
    return nullptr;
  }

  // Of a ring, a piece whose middle is where `is_there` says.
  template <class IsThere>
  const Piece* some_piece(const Ring& ring, IsThere&& is_there) const {
    for (const Piece& piece : pieces_) {
      if (piece.ring == &ring && is_there(piece.middle)) return &piece;
    }
    return nullptr;
  }

  void name(Kind kind, const Piece& piece, std::uint32_t part, std::uint32_t ring) {
    const Point2& at = piece.ring->given[piece.edge];
    add(kind, place_of(*piece.ring, piece.edge), {part, ring, 0}, {at, at});
  }

  void look_at_holes() {
    for (Ring& hole : rings_) {
      const Ring* shell = shell_of(hole.part);
      if (hole.number == 0 || !shell) continue;
      const Piece* outside = some_piece(hole, [&](const P& p) { return !encloses(*shell, p); });
      if (!outside) continue;
      name(Kind::hole_outside, *outside, hole.part, 0);
      hole.dropped = true;
    }
    for (Ring& hole : rings_) {
      for (const Ring& other : rings_) {
        if (hole.number == 0 || hole.dropped || other.dropped || &hole == &other) continue;
        if (other.number == 0 || other.part != hole.part) continue;
        const Piece* inside = some_piece(hole, [&](const P& p) { return encloses(other, p); });
        if (!inside) continue;
        name(Kind::nested_holes, *inside, other.part, other.number);
        hole.dropped = true;
      }
    }
    pieces_.clear();
  }

  // The piece straight below a point, and how many are there.
  struct Below {
    std::optional<std::size_t> next;
    std::size_t count = 0;
  };
  Below below(const P& p, std::size_t but) const {
    Below found;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const Piece& piece = pieces_[k];
      if (k == but || !spans(piece.a, piece.b, p) || side(piece.a, piece.b, p) <= 0) continue;
      ++found.count;
      if (!found.next || is_higher(piece, pieces_[*found.next], p)) found.next = k;
    }
    return found;
  }
  static bool is_higher(const Piece& s, const Piece& t, const P& p) {
    const auto height = [&](const Piece& u) {  // times u.b.x - u.a.x
      return u.a.y * (u.b.x - u.a.x) + (p.x - u.a.x) * (u.b.y - u.a.y);
    };
    return compare(height(s) * (t.b.x - t.a.x), height(t) * (s.b.x - s.a.x)) > 0;
  }

  void look_at_interiors() {
    const std::vector<Ring> all = rings_;
    std::uint32_t parts = 0;
    for (const Ring& ring : all) parts = std::max(parts, ring.part + 1);
    for (std::uint32_t part = 0; part < parts; ++part) {
      rings_ = all;
      std::erase_if(rings_, [&](const Ring& r) { return r.part != part; });
      pieces_.clear();
      cut_edges();
      if (!pieces_.empty() && !is_connected(part)) {
        const Segment at{rings_[0].given[0], rings_[0].given[0]};
        add(Kind::disconnected, place_of(rings_[0], 0), place_of(rings_[0], 0), at);
      }
    }
    rings_ = all;
    pieces_.clear();
    cut_edges();
  }

  // 2 k is the lower side of piece k, 2 k + 1 its upper side, and the last one is at infinity.
  bool is_connected(std::uint32_t part) {
    const std::size_t infinity = 2 * pieces_.size();
    joined_.resize(infinity + 1);
    std::iota(joined_.begin(), joined_.end(), std::size_t{0});
    std::vector<bool> inside(infinity + 1);
    const bool is_at_infinity = shell_of(part) == nullptr;
    inside[infinity] = is_at_infinity;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      const Below found = below(pieces_[k].middle, k);
      join(2 * k, found.next ? 2 * *found.next + 1 : infinity);
      inside[2 * k] = (found.count % 2 == 1) != is_at_infinity;
      inside[2 * k + 1] = !inside[2 * k];
      for (const P& p : {pieces_[k].a, pieces_[k].b}) join_around(p);
    }
    std::optional<std::size_t> first;
    for (std::size_t k = 0; k <= infinity; ++k) {
      if (!inside[k]) continue;
      if (first && group_of(k) != *first) return false;
      first = group_of(k);
    }
    return true;
  }

  std::size_t group_of(std::size_t k) const {
    while (joined_[k] != k) k = joined_[k];
    return k;
  }
  void join(std::size_t k, std::size_t l) { joined_[group_of(k)] = group_of(l); }

  void join_around(const P& p) {
    struct Way {
      std::size_t piece;
      bool right;
      P to;
    };
    std::vector<Way> ways;
    for (std::size_t k = 0; k < pieces_.size(); ++k) {
      if (equal(pieces_[k].a, p)) ways.push_back({k, true, pieces_[k].b});
      if (equal(pieces_[k].b, p)) ways.push_back({k, false, pieces_[k].a});
    }
    std::sort(ways.begin(), ways.end(),
              [&](const Way& v, const Way& w) { return v.right != w.right ? v.right : side(p, v.to, w.to) > 0; });
    for (std::size_t k = 0; k < ways.size(); ++k) {
      const Way &v = ways[k], &w = ways[(k + 1) % ways.size()];
      join(2 * v.piece + (v.right ? 1 : 0), 2 * w.piece + (w.right ? 0 : 1));
    }
  }

  void look_at_parts() {
    std::uint32_t parts = 0;
    for (const Ring& ring : rings_) parts = std::max(parts, ring.part + 1);
    for (const Ring& shell : rings_) {
      for (std::uint32_t part = 0; part < parts && shell.number == 0; ++part) {
        if (part == shell.part || !shell_of(part)) continue;
        const Piece* inside = some_piece(shell, [&](const P& p) {
          bool odd = false;
          for (const Ring& ring : rings_) odd ^= ring.part == part && encloses(ring, p);
          return odd;
        });
        if (inside) name(Kind::nested_parts, *inside, part, 0);
      }
    }
  }

  const PolygonRule rule_;
  std::vector<Ring> rings_;
  std::vector<Piece> pieces_;
  std::vector<std::size_t> joined_;
  std::vector<PolygonDefect> defects_;
};

bool are_small_and_whole(const PolygonRings& rings) {
  const auto fits = [](double x) { return x >= -256 && x <= 256 && static_cast<double>(static_cast<int>(x)) == x; };
  return std::all_of(rings.begin(), rings.end(), [&](const std::vector<Point2>& ring) {
    return std::all_of(ring.begin(), ring.end(), [&](const Point2& p) { return fits(p.x) && fits(p.y); });
  });
}

}  // namespace

PolygonDefects polygon_defects_by_scan(std::span<const PolygonRings> parts, const ValidOptions& options) {
  const bool small = std::all_of(parts.begin(), parts.end(), are_small_and_whole);
  PolygonDefects answer;
  answer.found =
      small ? RingScan<std::int64_t>(parts, options.rule).run() : RingScan<Dyadic>(parts, options.rule).run();
  std::sort(answer.found.begin(), answer.found.end(), [](const PolygonDefect& c, const PolygonDefect& d) {
    const auto& [p, q] = c.place;
    const auto& [r, s] = d.place;
    return std::tie(c.kind, c.a, c.b, p.x, p.y, q.x, q.y) < std::tie(d.kind, d.a, d.b, r.x, r.y, s.x, s.y);
  });
  if (answer.found.size() > options.most) answer.found.resize(options.most);
  return answer;
}

}  // namespace sunder::planar
