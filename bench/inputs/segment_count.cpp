#include <bench/inputs/segment_count.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace bench {
namespace {

__extension__ using Wide = __int128;

Wide whole(double v) {
  const double scaled = std::ldexp(v, 40);
  if (!(std::fabs(scaled) < 0x1p60) || scaled != std::nearbyint(scaled)) {
    throw std::logic_error("a coordinate is not a multiple of 2^-40");
  }
  return static_cast<std::int64_t>(scaled);
}

bool before(const Xy& p, const Xy& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

// Requires p collinear with the line.
bool within(const Line& s, const Xy& p) {
  return !before(p, std::min(s.a, s.b, before)) && !before(std::max(s.a, s.b, before), p);
}

}  // namespace

int exact_turn(const Xy& p, const Xy& q, const Xy& r) {
  const Wide turn =
      (whole(q.x) - whole(p.x)) * (whole(r.y) - whole(p.y)) - (whole(q.y) - whole(p.y)) * (whole(r.x) - whole(p.x));
  return turn > 0 ? 1 : turn < 0 ? -1 : 0;
}

bool exact_contact(const Line& s, const Line& t, bool shared_ends) {
  if (std::max(s.a.x, s.b.x) < std::min(t.a.x, t.b.x) || std::max(t.a.x, t.b.x) < std::min(s.a.x, s.b.x) ||
      std::max(s.a.y, s.b.y) < std::min(t.a.y, t.b.y) || std::max(t.a.y, t.b.y) < std::min(s.a.y, s.b.y)) {
    return false;
  }
  const int ta = exact_turn(s.a, s.b, t.a), tb = exact_turn(s.a, s.b, t.b);
  const int sa = exact_turn(t.a, t.b, s.a), sb = exact_turn(t.a, t.b, s.b);
  if (ta * tb < 0 && sa * sb < 0) return true;
  // What is left: an end of one lies on the other, or there is no contact.
  const bool end_on_other = (ta == 0 && within(s, t.a)) || (tb == 0 && within(s, t.b)) || (sa == 0 && within(t, s.a)) ||
                            (sb == 0 && within(t, s.b));
  if (!end_on_other) return false;
  if (!shared_ends) return true;
  if (ta == 0 && tb == 0 && sa == 0 && sb == 0) {  // collinear: one point only, and then it is an end of both?
    const Xy from = std::max(std::min(s.a, s.b, before), std::min(t.a, t.b, before), before);
    const Xy to = std::min(std::max(s.a, s.b, before), std::max(t.a, t.b, before), before);
    const auto is_end = [&](const Line& l) { return l.a == from || l.b == from; };
    return !(from == to && is_end(s) && is_end(t));
  }
  return !(s.a == t.a || s.a == t.b || s.b == t.a || s.b == t.b);
}

std::uint64_t count_by_grid(std::span<const Line> lines, bool shared_ends) {
  if (lines.empty()) return 0;
  Xy low = lines[0].a, high = low;
  double lengths = 0;
  for (const Line& l : lines) {
    for (const Xy& p : {l.a, l.b}) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    lengths += std::hypot(l.b.x - l.a.x, l.b.y - l.a.y);
  }
  const double count = static_cast<double>(lines.size()), mean = lengths / count;
  const double side = std::max(std::sqrt((high.x - low.x + mean) * (high.y - low.y + mean) / count), mean / 2);
  const auto cell = [side](double v, double from) { return static_cast<std::size_t>((v - from) / side); };
  const std::size_t columns = cell(high.x, low.x) + 1, rows = cell(high.y, low.y) + 1;
  struct Box {
    std::size_t x0, y0, x1, y1;
  };
  std::vector<Box> boxes;
  std::vector<std::size_t> begin(columns * rows + 1);
  for (const Line& l : lines) {
    const auto [x0, x1] = std::minmax(l.a.x, l.b.x);
    const auto [y0, y1] = std::minmax(l.a.y, l.b.y);
    const Box b{cell(x0, low.x), cell(y0, low.y), cell(x1, low.x), cell(y1, low.y)};
    boxes.push_back(b);
    for (std::size_t y = b.y0; y <= b.y1; ++y) {
      for (std::size_t x = b.x0; x <= b.x1; ++x) ++begin[y * columns + x + 1];
    }
  }
  std::partial_sum(begin.begin(), begin.end(), begin.begin());
  std::vector<std::uint32_t> members(begin.back());
  std::vector<std::size_t> next(begin.begin(), begin.end() - 1);
  for (std::uint32_t i = 0; i < boxes.size(); ++i) {
    const Box& b = boxes[i];
    for (std::size_t y = b.y0; y <= b.y1; ++y) {
      for (std::size_t x = b.x0; x <= b.x1; ++x) members[next[y * columns + x]++] = i;
    }
  }
  std::uint64_t pairs = 0;
  for (std::size_t y = 0; y < rows; ++y) {
    for (std::size_t x = 0; x < columns; ++x) {
      const std::size_t from = begin[y * columns + x], to = begin[y * columns + x + 1];
      for (std::size_t i = from; i < to; ++i) {
        for (std::size_t j = i + 1; j < to; ++j) {
          const Box &s = boxes[members[i]], &t = boxes[members[j]];
          if (std::max(s.x0, t.x0) != x || std::max(s.y0, t.y0) != y) continue;  // each pair in one cell only
          pairs += exact_contact(lines[members[i]], lines[members[j]], shared_ends);
        }
      }
    }
  }
  return pairs;
}

std::uint64_t count_by_angle(std::span<const Line> lines, bool shared_ends) {
  constexpr double pi = 3.141592653589793, margin = 1e-9;  // far more than atan2 is wrong
  struct View {
    double from, to;
    std::uint32_t line;
  };
  std::vector<View> views;
  for (std::uint32_t i = 0; i < lines.size(); ++i) {
    double from = std::atan2(lines[i].a.y, lines[i].a.x), to = std::atan2(lines[i].b.y, lines[i].b.x);
    if (from > to) std::swap(from, to);
    if (to - from > pi) {
      from += 2 * pi;
      std::swap(from, to);
    }
    from -= margin, to += margin;
    if (from < -pi) from += 2 * pi, to += 2 * pi;  // so that what is below seen again begins at pi or later
    views.push_back({from, to, i});
  }
  double widest = 0;
  for (const View& v : views) widest = std::max(widest, v.to - v.from);
  if (widest > 1) throw std::logic_error("count_by_angle: a segment is seen under a wide angle");
  const std::size_t count = views.size();
  for (std::size_t i = 0; i < count; ++i) {  // those that begin a turn are seen again at its end
    if (views[i].from < -pi + 2 * widest) {
      views.push_back({views[i].from + 2 * pi, views[i].to + 2 * pi, views[i].line});
    }
  }
  std::sort(views.begin(), views.end(), [](const View& v, const View& w) { return v.from < w.from; });
  std::uint64_t pairs = 0;
  for (std::size_t i = 0; i < views.size(); ++i) {
    if (views[i].from >= pi) break;  // seen before
    for (std::size_t j = i + 1; j < views.size() && views[j].from <= views[i].to; ++j) {
      pairs += exact_contact(lines[views[i].line], lines[views[j].line], shared_ends);
    }
  }
  return pairs;
}

}  // namespace bench
