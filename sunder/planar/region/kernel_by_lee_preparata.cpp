// The kernel in linear time (Lee & Preparata 1979; also Preparata & Shamos 1985, section 7.2.6).
//
// Edges are taken in turn, the polygon on their left, from a reflex vertex on. What is left after some is a convex
// region K, a list of sides; of the vertex reached, v, the sides that it is not strictly inside of, those that are seen
// from v, are a part of the list, from `first_seen` to `last_seen`. The next edge h cuts K only before v on its line
// where the boundary turns right at v, and only behind v where it turns left: so only if the end of what is seen there,
// F or L in the paper, is outside of h. Then what h cuts off is found from that end in both directions. As v moves on,
// K being on the left, what is seen moves on counter-clockwise only, at both ends. The paper's points at infinity are
// the missing ends of the first and last side of an unbounded K. A search proposes: K is accepted as a region if its
// check holds, which it does for simple polygons. K that is or gets flat, and turns that go on and on (spirals; the
// paper counts turns), are left to half_planes.
#include <sunder/planar/region/angle_order.h>
#include <sunder/planar/region/kernel.h>
#include <sunder/planar/region/region_search.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

constexpr std::uint32_t none = 0xffffffffu;

class KernelSearch {
 public:
  explicit KernelSearch(Signs<PolygonSides>& signs)
      : signs_(signs),
        sides_(signs.given()),
        size_(sides_.size()),
        next_(size_, none),
        previous_(size_, none),
        moves_left_(4 * std::uint64_t{size_} + 64) {}

  // The kernel, as proposed; none where others have to find it.
  std::optional<Region> region() {
    const std::optional<std::uint32_t> start = reflex_edge();
    if (!start) return convex();
    begin_at(*start);
    for (std::uint32_t n = 2; n < size_; ++n) {
      const Step step = take(edge((*start + n - 1) % size_), edge((*start + n - 2) % size_));
      if (step == Step::beyond) return contradiction(edge((*start + n - 1) % size_));
      if (step == Step::lost) return std::nullopt;
    }
    return proposed();
  }

 private:
  enum class Step : std::uint8_t {
    taken,
    beyond,  // nothing of K, or something flat, is inside of the edge
    lost,
  };

  // The n-th edge with the polygon on the left.
  std::uint32_t edge(std::uint32_t n) const { return sides_.clockwise() ? size_ - 1 - n : n; }

  // An n for which the boundary turns right before the n-th edge.
  std::optional<std::uint32_t> reflex_edge() {
    for (std::uint32_t n = 0; n < size_; ++n) {
      if (signs_.turn(edge(n == 0 ? size_ - 1 : n - 1), edge(n)) == Sign::negative) return n;
    }
    return std::nullopt;
  }

  // All edges are sides, but for those in one line. (Where angles go around more than once the polygon is not simple.)
  std::optional<Region> convex() {
    std::vector<std::uint32_t> sides;
    std::size_t least = 0;
    int rounds = 0;
    for (std::uint32_t n = 0; n < size_; ++n) {
      const std::uint32_t k = edge(n), after = edge(n + 1 == size_ ? 0 : n + 1);
      const bool wraps = signs_.points_down(k) && !signs_.points_down(after);
      rounds += wraps ? 1 : 0;
      if (!sides.empty() && signs_.turn(sides.back(), k) == Sign::zero) {
        sides.back() = std::min(sides.back(), k);
      } else {
        sides.push_back(k);
      }
      if (wraps) least = sides.size();
    }
    if (rounds != 1) return std::nullopt;
    if (least == sides.size()) least = 0;
    // The first and the last one may be in one line.
    if (signs_.turn(sides.back(), sides.front()) == Sign::zero) {
      sides.front() = std::min(sides.front(), sides.back());
      sides.pop_back();
      if (least == sides.size()) least = 0;
    }
    std::rotate(sides.begin(), sides.begin() + static_cast<std::ptrdiff_t>(least), sides.end());
    Region region;
    region.kind = RegionKind::bounded;
    region.sides = std::move(sides);
    return region;
  }

  // The wedge at a reflex vertex, before the n-th edge, seen from that edge's end.
  void begin_at(std::uint32_t n) {
    first_ = edge(n);
    last_ = edge(n == 0 ? size_ - 1 : n - 1);
    next_[first_] = last_;
    previous_[last_] = first_;
    first_seen_ = first_;
    last_seen_ = last_;
  }

  // Where an end of a side lies to h: positive: outside; zero: on its line. An end that is missing is far away.
  Sign start_side(std::uint32_t side, std::uint32_t h) {
    if (previous_[side] != none) return signs_.corner_side(previous_[side], side, h);
    const Sign turn = signs_.turn(side, h);
    return turn != Sign::zero ? -turn : parallel_side(side, h);
  }
  Sign end_side(std::uint32_t side, std::uint32_t h) {
    if (next_[side] != none) return signs_.corner_side(side, next_[side], h);
    const Sign turn = signs_.turn(side, h);
    return turn != Sign::zero ? turn : parallel_side(side, h);
  }
  Sign parallel_side(std::uint32_t side, std::uint32_t h) {
    return signs_.facing(side, h) == Sign::positive ? -signs_.tighter(side, h) : -signs_.gap(side, h);
  }

  bool is_seen(std::uint32_t side, const Point2& v) {
    const LeftOf half = sides_[side];
    return signs_.counted(orient_2d(half.from, half.to, v)) != Sign::positive;
  }

  // False where a simple polygon would have come to an end long since.
  bool may_move() { return moves_left_ > 0 && moves_left_-- > 0; }

  Step take(std::uint32_t h, std::uint32_t before) {
    const Sign turn = signs_.turn(before, h);
    Step step = Step::taken;
    if (turn == Sign::negative && start_side(first_seen_, h) == Sign::positive) {
      step = cut_before(h);
      first_seen_ = step == Step::taken ? h : first_seen_;
    } else if (turn == Sign::positive && end_side(last_seen_, h) == Sign::positive) {
      step = cut_behind(h);
      last_seen_ = step == Step::taken ? h : last_seen_;
    }
    if (step != Step::taken) return step;
    return look_from(sides_[h].to) ? Step::taken : Step::lost;
  }

  // The side that keeps its start, from p clockwise on; and that keeps its end, from q counter-clockwise on. None:
  // beyond an end of K. `last`: where to stop, none being left of the list.
  struct Kept {
    Step step = Step::taken;
    std::uint32_t side = none;
  };
  Kept keeps_start(std::uint32_t p, std::uint32_t h, std::uint32_t last) {
    for (; p != none; p = previous_[p]) {
      if (!may_move()) return {Step::lost, none};
      if (start_side(p, h) == Sign::negative) break;
      if (p == last) return {Step::beyond, none};
    }
    return {Step::taken, p};
  }
  Kept keeps_end(std::uint32_t q, std::uint32_t h, std::uint32_t last) {
    for (; q != none; q = next_[q]) {
      if (!may_move()) return {Step::lost, none};
      if (end_side(q, h) == Sign::negative) break;
      if (q == last) return {Step::beyond, none};
    }
    return {Step::taken, q};
  }

  // h cuts off the start of the first side seen, and what is clockwise of it.
  Step cut_before(std::uint32_t h) {
    const Kept q = keeps_end(first_seen_, h, last_seen_);
    if (q.step != Step::taken) return q.step;
    Kept p = keeps_start(previous_[first_seen_], h, none);
    if (p.side == none && last_ == none) return Step::lost;
    const bool around = p.step == Step::taken && p.side == none && end_side(last_, h) != Sign::negative;
    if (around) p = keeps_start(last_, h, none);
    return p.step == Step::taken ? join(p.side, h, q.side, around) : p.step;
  }

  // h cuts off the end of the last side seen, and what is counter-clockwise of it.
  Step cut_behind(std::uint32_t h) {
    const Kept p = keeps_start(last_seen_, h, first_seen_);
    if (p.step != Step::taken) return p.step;
    Kept q = keeps_end(next_[last_seen_], h, none);
    if (q.side == none && first_ == none) return Step::lost;
    const bool around = q.step == Step::taken && q.side == none && start_side(first_, h) != Sign::negative;
    if (around) q = keeps_end(first_, h, none);
    return q.step == Step::taken ? join(p.side, h, q.side, around) : q.step;
  }

  // Puts h between p and q. `around`: what is cut off goes beyond infinity, so K is bounded from now on.
  Step join(std::uint32_t p, std::uint32_t h, std::uint32_t q, bool around) {
    if (p == none && q == none) return Step::lost;
    if (around && (p == none || q == none)) return Step::lost;
    previous_[h] = p;
    next_[h] = q;
    if (p != none) next_[p] = h;
    if (q != none) previous_[q] = h;
    if (p == none) first_ = h;
    if (q == none) last_ = h;
    if (around) first_ = last_ = none;
    return Step::taken;
  }

  // Moves what is seen on to what is seen from v.
  bool look_from(const Point2& v) {
    while (!is_seen(first_seen_, v)) {
      const std::uint32_t next = next_[first_seen_];
      if (next == none || !may_move()) return false;
      if (first_seen_ == last_seen_) last_seen_ = next;
      first_seen_ = next;
    }
    for (;;) {
      const std::uint32_t next = next_[last_seen_];
      if (next == none || next == first_seen_ || !is_seen(next, v)) return true;
      if (!may_move()) return false;
      last_seen_ = next;
    }
  }

  // The list of K, from an end or from the x axis on.
  std::vector<std::uint32_t> list() {
    std::uint32_t from = first_;
    std::vector<std::uint32_t> all;
    if (from == none) {
      from = first_seen_;
      for (std::uint32_t n = 0; n < size_; ++n) {
        if (previous_[from] == none || next_[from] == none) return {};  // not of a simple polygon
        if (signs_.points_down(previous_[from]) && !signs_.points_down(from)) break;
        from = next_[from];
      }
    }
    for (std::uint32_t side = from; side != none && all.size() < size_;) {
      all.push_back(side);
      side = next_[side];
      if (side == from) break;
    }
    return all;
  }

  // h leaves nothing of K: so a corner of K is outside of h, and furthest inward. None where K gets flat.
  std::optional<Region> contradiction(std::uint32_t h) {
    Region region;
    region.kind = RegionKind::empty;
    const std::vector<std::uint32_t> sides = list();
    for (const std::uint32_t side : sides) {
      const std::uint32_t next = next_[side];
      const Sign turn = signs_.turn(h, side);
      if (turn == Sign::zero && signs_.facing(h, side) == Sign::negative && signs_.gap(h, side) == Sign::negative) {
        region.sides = {h, side};
        return region;
      }
      if (turn != Sign::positive || next == none || signs_.turn(next, h) != Sign::positive) continue;
      if (signs_.turn(side, next) != Sign::positive || signs_.corner_side(side, next, h) != Sign::positive) continue;
      region.sides = {h, side, next};
      return region;
    }
    return std::nullopt;
  }

  Region proposed() {
    Region region;
    region.kind = first_ == none ? RegionKind::bounded : RegionKind::unbounded;
    region.sides = list();
    return region;
  }

  Signs<PolygonSides>& signs_;
  const PolygonSides& sides_;
  std::uint32_t size_;
  std::vector<std::uint32_t> next_, previous_;  // of the list; none at its ends
  std::uint32_t first_ = none, last_ = none;    // ends of an unbounded K
  std::uint32_t first_seen_ = none, last_seen_ = none;
  std::uint64_t moves_left_;
};

// Is it the region of all? Adds its evidence; each side gets the lowest number of those that are equal.
bool accept(Signs<PolygonSides>& signs, Region& region) {
  if (region.sides.size() < (region.kind == RegionKind::bounded ? 3u : 2u)) return false;
  const PolygonSides& given = signs.given();
  const SideTable table(given, region.sides);
  region.cones.resize(given.size());
  for (std::uint32_t k = 0; k < given.size(); ++k) {
    const std::optional<std::uint32_t> cone = cone_in(signs, region, table, k);
    const std::uint32_t p = cone ? *cone : cone_of(signs, region, k);
    const std::uint32_t next = p + 1 == region.sides.size() ? 0 : p + 1;
    region.cones[k] = p;
    for (const std::uint32_t side : {p, next}) {
      std::uint32_t& number = region.sides[side];
      if (k < number && signs.same_direction(number, k) && signs.tighter(number, k) == Sign::zero) number = k;
    }
  }
  signs.count(3 * (std::uint64_t{given.size()} + region.sides.size()));  // of the check
  return check(given, region);
}

}  // namespace

Region kernel_by_lee_preparata(const PolygonSides& sides, const RegionOptions& options) {
  Signs<PolygonSides> signs(sides);
  std::optional<Region> region = KernelSearch(signs).region();
  const bool accepted = region && (region->empty() || accept(signs, *region));
  Region answer = accepted ? std::move(*region) : half_plane_intersection(sides, options);
  if (!options.evidence) answer.cones.clear();
  signs.add_to(answer.cost);
  answer.cost.iterations = accepted ? 0 : 1;
  return answer;
}

}  // namespace sunder::planar
