#include <verifier/cpp/products.h>
#include <verifier/cpp/sweep.h>

#include <utility>

namespace sunder_verifier {
namespace {

Integer turn(const Integer& ux, const Integer& uy, const Integer& vx, const Integer& vy) { return ux * vy - uy * vx; }

// Of their lines, which are not parallel.
SweepPoint crossing(const PlanarSegment& s, const PlanarSegment& t) {
  const Integer ux = s.last.x - s.first.x, uy = s.last.y - s.first.y;
  const Integer vx = t.last.x - t.first.x, vy = t.last.y - t.first.y;
  SweepPoint p;
  p.w = turn(ux, uy, vx, vy);
  Integer along = turn(t.first.x - s.first.x, t.first.y - s.first.y, vx, vy);
  if (p.w < 0) {
    p.w = -p.w;
    along = -along;
  }
  p.x = s.first.x * p.w + ux * along;
  p.y = s.first.y * p.w + uy * along;
  return p;
}

}  // namespace

bool is_before(const SweepPoint& p, const SweepPoint& q) {
  const int x = compare_products(p.x, q.w, q.x, p.w);
  return x != 0 ? x < 0 : compare_products(p.y, q.w, q.y, p.w) < 0;
}

int side(const PlanarSegment& s, const SweepPoint& p) {
  const bool is_whole = p.w == 1;
  const Integer x = is_whole ? Integer(p.x - s.first.x) : p.x - s.first.x * p.w;
  const Integer y = is_whole ? Integer(p.y - s.first.y) : p.y - s.first.y * p.w;
  return compare_products(s.last.x - s.first.x, y, s.last.y - s.first.y, x);
}

int turn(const PlanarSegment& s, const PlanarSegment& t) {
  return compare_products(s.last.x - s.first.x, t.last.y - t.first.y, s.last.y - s.first.y, t.last.x - t.first.x);
}

bool is_point(const PlanarSegment& s) { return s.first == s.last; }

SweepPoint place_of(const PlanarPoint& p) { return {p.x, p.y, 1}; }

SweepPoint place_in_units(Numbers point, std::int64_t exponent) {
  for (Number& value : point) value.e -= exponent;
  Integers given = projective(point);
  return {std::move(given[0]), std::move(given[1]), std::move(given[2])};
}

bool is_on(const PlanarSegment& s, const SweepPoint& p) {
  return side(s, p) == 0 && !is_before(p, place_of(s.first)) && !is_before(place_of(s.last), p);
}

bool ends_at(const PlanarSegment& s, const SweepPoint& p) { return p.is(s.first) || p.is(s.last); }

Sweep::Sweep(const SweepEvents& events, const Segments& segments)
    : events_(events),
      segments_(segments),
      above_(segments_.size() + 1, kOut),
      has_begun_(segments_.size()),
      stays_(segments_.size()) {
  above_[segments_.size()] = segments_.size();  // the end of the ring, which stands below and above all
}

bool Sweep::next() {
  if (k_ == events_.at.size()) {
    require(above_[segments_.size()] == segments_.size() && begun_ == segments_.size(), "sweep",
            "not all segments begin and end");
    return false;
  }
  row = events_.row.data() + events_.begin[k_];
  row_end = events_.row.data() + events_.begin[k_ + 1];
  come_to_point();
  const std::size_t none = segments_.size();
  const std::size_t lower = events_.below[k_] < 0 ? none : static_cast<std::size_t>(events_.below[k_]);
  put_in(lower, take_out_from(lower));
  below = lower == none ? no_index : lower;
  require_event(stay_ == 0, " loses a segment that goes on");
  ++k_;
  return true;
}

void Sweep::come_to_point() {
  SweepPoint p;
  if (events_.at[k_] >= 0) {
    const auto end = static_cast<std::size_t>(events_.at[k_]);
    const PlanarPoint& q = end % 2 == 1 ? segments_[end / 2].last : segments_[end / 2].first;
    p.x = q.x;
    p.y = q.y;
  } else {
    require_event(row_end - row > 1 && turn(segments_[*row], segments_[row_end[-1]]) != 0,
                  " has no point: its first and last segment do not cross");
    const std::size_t longest = 3 * segments_.bits;
    take_steps(static_cast<std::uint64_t>(row_end - row) + 4, longest, longest);
    p = crossing(segments_[*row], segments_[row_end[-1]]);
  }
  require_event(k_ == 0 || is_before(point, p), " is not after the one before it");
  point = std::move(p);
}

// Takes out what holds the point, from the lower one up. The one above that.
std::size_t Sweep::take_out_from(std::size_t lower) {
  const std::size_t none = segments_.size();
  require_event(above_[lower] != kOut, " is above a segment that is not in the list");
  require_event(lower == none || side(segments_[lower], point) > 0, " is not above segment ", lower);
  here.clear();
  stay_ = 0;
  std::size_t s = above_[lower];
  int place = 0;
  while (s != none && (place = side(segments_[s], point)) == 0) {
    here.push_back(s);
    stays_[s] = !point.is(segments_[s].last);
    if (stays_[s]) ++stay_;
    s = std::exchange(above_[s], kOut);
  }
  require_event(s == none || place < 0, " is not below segment ", s);
  return s;
}

// Puts in what goes on, sorted by direction.
void Sweep::put_in(std::size_t lower, std::size_t upper) {
  bool is_first = true;
  for (const std::size_t* s = row; s != row_end; ++s) {
    if (stays_[*s]) {
      stays_[*s] = false;
      --stay_;
    } else {
      require_event(!has_begun_[*s] && point.is(segments_[*s].first), ": segment ", *s,
                    " is not in the list there, or does not begin there");
      has_begun_[*s] = true;
      ++begun_;
    }
    require_event(is_first || turn(segments_[lower], segments_[*s]) >= 0, ": segment ", *s, " does not go on above ",
                  lower);
    if (is_point(segments_[*s])) continue;
    above_[lower] = *s;
    lower = *s;
    is_first = false;
  }
  above_[lower] = upper;
}

bool LabelledSweep::next() {
  if (!Sweep::next()) return false;
  going.clear();
  labels = {below == no_index ? Set() : above_[below]};
  take_steps(2 * labels[0].size(), 1, 1);
  for (const std::size_t s : here) above_[s] = {};
  for (const std::size_t* s = row; s != row_end; ++s) {
    if (is_point(edges_[*s])) continue;
    going.push_back(*s);
    above_[*s] = toggled(labels.back(), owner_[*s]);
    labels.push_back(above_[*s]);
    take_steps(2 * labels.back().size(), 1, 1);
  }
  return true;
}

}  // namespace sunder_verifier
