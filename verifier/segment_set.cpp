#include "segment_set.h"

#include "statement.h"

namespace sunder_verifier {

int turn(const Point& p, const Point& q, const Point& r) {
  const Integer cross = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return cross.sign();
}

std::string kind_of(const Segment& s, const Segment& t) {
  const auto& kinds = contact_kinds;
  const int first_of_t = turn(s.first, s.last, t.first), last_of_t = turn(s.first, s.last, t.last);
  const int first_of_s = turn(t.first, t.last, s.first), last_of_s = turn(t.first, t.last, s.last);
  if (first_of_t == 0 && last_of_t == 0 && first_of_s == 0 && last_of_s == 0) {
    const Point& first = s.first < t.first ? t.first : s.first;
    const Point& last = s.last < t.last ? s.last : t.last;
    if (last < first) return "none";
    if (first < last) return kinds[3];
    return is_end(first, s) && is_end(first, t) ? kinds[0] : kinds[1];
  }
  if (first_of_t * last_of_t > 0 || first_of_s * last_of_s > 0) return "none";
  if (first_of_t * last_of_t < 0 && first_of_s * last_of_s < 0) return kinds[2];
  return is_end(s.first, t) || is_end(s.last, t) ? kinds[0] : kinds[1];
}

void Holders::look(std::size_t event, std::size_t lower, std::size_t upper) {
  const std::size_t s = event / 2, none = set_.segments.size();
  const Point& p = set_.end_of(event);
  if (!any_ || set_.end_of(first_) != p) {
    any_ = true;
    first_ = event;
    are_mixed_ = has_holder_ = false;
  }
  are_mixed_ = are_mixed_ || !set_.is_one_group(first_ / 2, s);
  for (const std::size_t n : {lower, upper}) {
    if (n == none || is_end(p, set_.segments[n])) continue;
    if (turn(set_.segments[n].first, set_.segments[n].last, p) != 0) continue;
    has_holder_ = true;
    holder_ = n;
  }
  require(!has_holder_ || (!are_mixed_ && set_.is_one_group(holder_, s)), "T6",
          "a segment with an end where segment " + std::to_string(s) +
              " has one is not of the group of one that holds that point");
}

}  // namespace sunder_verifier
