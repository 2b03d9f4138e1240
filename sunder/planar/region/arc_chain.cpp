#include <sunder/base/interruption.h>
#include <sunder/planar/region/arc_chain.h>
#include <sunder/planar/region/merge_in_pairs.h>

#include <algorithm>
#include <utility>

namespace sunder::planar {

namespace {

void push(std::vector<ArcPiece>& out, std::size_t start, std::uint32_t disc, const Bearing& begin) {
  const bool is_first = out.size() == start;
  if (!is_first && out.back().disc == disc) return;
  out.push_back({is_first ? no_disc : out.back().disc, disc, begin});
}

// Widens the box to an arc of the circle about `center`, from one point to another; both are in it already.
void include_arc(Enclosure2& box, const Disc& circle, const Enclosure2& begin, const Enclosure2& end) {
  const Interval x = circle.center.x, y = circle.center.y, radius = circle.radius;
  const Interval from_x = begin.x - x, from_y = begin.y - y, to_x = end.x - x, to_y = end.y - y;
  // Does it reach the circle's rightmost point? An arc of less than a half turn does not unless it begins below and
  // ends above; and likewise for the others.
  const bool any = sign(from_x * to_y - from_y * to_x) != Guess::positive;
  if (any || (from_y.low <= 0 && to_y.high >= 0)) box.x.high = std::max(box.x.high, (x + radius).high);
  if (any || (from_y.high >= 0 && to_y.low <= 0)) box.x.low = std::min(box.x.low, (x - radius).low);
  if (any || (from_x.high >= 0 && to_x.low <= 0)) box.y.high = std::max(box.y.high, (y + radius).high);
  if (any || (from_x.low <= 0 && to_x.high >= 0)) box.y.low = std::min(box.y.low, (y - radius).low);
}

}  // namespace

std::vector<std::uint32_t> discs_around(std::span<const ArcPiece> chain) {
  std::vector<std::uint32_t> discs;
  for (const ArcPiece& piece : chain) discs.push_back(piece.disc);
  if (discs.size() > 1 && discs.front() == discs.back()) discs.pop_back();
  return discs;
}

Enclosure2 ArcChains::box(std::span<const ArcPiece> chain) const {
  const std::vector<std::uint32_t> discs = discs_around(chain);
  const Disc& first = circles_[discs[0]];
  if (discs.size() == 1) {
    const Interval x = first.center.x, y = first.center.y, radius = first.radius;
    return {{(x - radius).low, (x + radius).high}, {(y - radius).low, (y + radius).high}};
  }
  std::vector<Enclosure2> corners;  // corner m is where arc m ends
  for (std::size_t m = 0; m < discs.size(); ++m) {
    const std::uint32_t next = discs[m + 1 == discs.size() ? 0 : m + 1];
    corners.push_back(enclosure(DiscCrossing{circles_[discs[m]], circles_[next]}));
  }
  Enclosure2 box = corners.front();
  for (std::size_t m = 0; m < discs.size(); ++m) {
    box = hull(box, corners[m]);
    include_arc(box, circles_[discs[m]], corners[m == 0 ? discs.size() - 1 : m - 1], corners[m]);
  }
  return box;
}

ArcChains::Direction ArcChains::toward(std::uint32_t from, std::uint32_t to) {
  Direction out{from, to, {}};
  out.bearing = bearing(crossing(out), from_, &tally_);
  return out;
}

Sign ArcChains::compare(const Direction& a, const Direction& b) {
  if (b.from == no_disc && a.from == no_disc) return Sign::zero;
  if (b.from == no_disc) return is_bearing_zero(crossing(a), a.bearing, from_, &tally_) ? Sign::zero : Sign::positive;
  if (a.from == no_disc) return -compare(b, a);
  return compare_bearings(crossing(a), a.bearing, crossing(b), b.bearing, from_, &tally_);
}

// Pushes what is least of the circles of a and b from `begin` to where piece `end` begins, or once round where there is
// none.
void ArcChains::compare_in_sector(std::uint32_t a, std::uint32_t b, const Direction& begin, const ArcPiece* end,
                                  std::vector<ArcPiece>& out) {
  ++probes_;
  const std::size_t start = start_;
  const Disc disc_a = circles_[a], disc_b = circles_[b];
  if (a == b || !circles_cross(disc_a, disc_b, &tally_)) {  // one holds the other
    const bool a_less = disc_a.radius < disc_b.radius || (disc_a.radius == disc_b.radius && a < b);
    return push(out, start, a_less ? a : b, begin.bearing);
  }
  const Direction to_a = toward(b, a), to_b = toward(a, b);  // a is less from to_a on, b from to_b on
  const bool after_a = compare(begin, to_a) != Sign::negative, after_b = compare(begin, to_b) != Sign::negative;
  const bool a_first = compare(to_a, to_b) == Sign::negative;
  const bool a_less = a_first ? after_a && !after_b : after_a || !after_b;
  push(out, start, a_less ? a : b, begin.bearing);
  const auto is_before_end = [&](const Direction& d) {
    return end == nullptr || compare(d, {end->from, end->disc, end->begin}) == Sign::negative;
  };
  const auto change = [&](std::uint32_t disc, const Direction& d, bool passed) {
    if (!passed && is_before_end(d)) push(out, start, disc, d.bearing);
  };
  if (a_first) change(a, to_a, after_a);
  change(b, to_b, after_b);
  if (!a_first) change(a, to_a, after_a);
}

void ArcChains::merge(std::span<const ArcPiece> p, std::span<const ArcPiece> q, std::vector<ArcPiece>& out) {
  start_ = out.size();
  Direction begin{no_disc, no_disc, {0, 0}};
  std::size_t i = 0, k = 0;
  for (;;) {
    may_be_interrupted(10);
    const ArcPiece* next_p = i + 1 < p.size() ? &p[i + 1] : nullptr;
    const ArcPiece* next_q = k + 1 < q.size() ? &q[k + 1] : nullptr;
    const Sign order = next_p == nullptr && next_q == nullptr ? Sign::zero
                       : next_q == nullptr                    ? Sign::negative
                       : next_p == nullptr                    ? Sign::positive
                                                              : compare({next_p->from, next_p->disc, next_p->begin},
                                                                        {next_q->from, next_q->disc, next_q->begin});
    const ArcPiece* end = order == Sign::positive ? next_q : next_p;
    compare_in_sector(p[i].disc, q[k].disc, begin, end, out);
    if (end == nullptr) return;
    begin = {end->from, end->disc, end->begin};
    if (order != Sign::positive) ++i;
    if (order != Sign::negative) ++k;
  }
}

std::vector<ArcPiece> ArcChains::divide(std::span<const std::uint32_t> discs) {
  std::vector<ArcPiece> chains;
  std::vector<std::size_t> ends;
  for (const std::uint32_t disc : discs) {
    chains.push_back({no_disc, disc, {0, 0}});
    ends.push_back(chains.size());
  }
  return merged_in_pairs(std::move(chains), std::move(ends),
                         [this](const auto& p, const auto& q, auto& out) { merge(p, q, out); });
}

}  // namespace sunder::planar
