#include "sunder_verify_segments.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

struct Point {
  Integer x, y;
};

bool operator==(const Point& p, const Point& q) { return p.x == q.x && p.y == q.y; }
bool operator<(const Point& p, const Point& q) { return p.x < q.x || (p.x == q.x && p.y < q.y); }

struct Segment {
  Point first, last;
};

// The segments in units of 2^e.
struct Set {
  std::vector<Segment> segments;
  std::int64_t e = 0;
};

constexpr std::array<const char*, 4> kinds{"shared-endpoint", "touch", "crossing", "overlap"};  // and "none"

enum class Allowed { nothing, shared_endpoint, touch };

bool is_allowed(const std::string& kind, Allowed allowed) {
  if (kind == "none") return true;
  if (kind == kinds[0]) return allowed != Allowed::nothing;
  return kind == kinds[1] && allowed == Allowed::touch;
}

void require(bool condition, const char* check, const std::string& reason) {
  if (!condition) throw Refused{check, reason};
}

// 1: p, q, r turn left; -1: right; 0: on one line.
int turn(const Point& p, const Point& q, const Point& r) {
  const Integer cross = (q.x - p.x) * (r.y - p.y) - (q.y - p.y) * (r.x - p.x);
  return cross.sign();
}

bool is_end(const Point& p, const Segment& s) { return p == s.first || p == s.last; }

std::string kind_of(const Segment& s, const Segment& t) {
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

// Is s, just after it begins, above t, which has begun? A segment of length zero is above those that it lies on.
bool is_above(const Segment& s, const Segment& t) {
  const int begins = turn(t.first, t.last, s.first);
  if (begins != 0) return begins > 0;
  return s.first == s.last || turn(t.first, t.last, s.last) > 0;
}

struct Some {
  std::size_t i = 0, j = 0;
  std::string kind;
  Numbers point;
};

void check_some(const Set& set, Allowed allowed, const Some& some) {
  require(!is_allowed(some.kind, allowed), "C1", some.kind + " does not count");
  const Number &x = some.point[0], &y = some.point[1];
  const std::int64_t low = std::min(set.e, std::min(x.e, y.e));
  const Integer unit = shifted(x.d * y.d, set.e - low);  // one unit of the coordinates
  for (const std::size_t k : {some.i, some.j}) {
    const Segment& s = set.segments[k];
    const Integer px = shifted(x.n * y.d, x.e - low) - s.first.x * unit;
    const Integer py = shifted(y.n * x.d, y.e - low) - s.first.y * unit;
    const Integer dx = s.last.x - s.first.x, dy = s.last.y - s.first.y;
    const Integer along = px * dx + py * dy;
    const bool is_point = dx == 0 && dy == 0;
    const bool on_line = is_point ? px == 0 && py == 0 : px * dy == py * dx;
    require(on_line && along >= 0 && along <= (dx * dx + dy * dy) * unit, "C2",
            "the point is not on segment " + std::to_string(k));
  }
  const std::string found = kind_of(set.segments[some.i], set.segments[some.j]);
  require(found == some.kind, "C3", "the contact is " + found);
}

struct None {
  std::vector<std::size_t> events;
  std::vector<std::int64_t> below;
};

// The order of events at one point: ends, then points, one after the other, then beginnings.
std::pair<int, std::size_t> rank(const Segment& s, std::size_t event) {
  if (s.first == s.last) return {1, event};
  return {event % 2 == 1 ? 0 : 2, 0};
}

void check_order(const Set& set, Allowed allowed, const std::vector<std::size_t>& events) {
  std::vector<bool> seen(2 * set.segments.size());
  for (const std::size_t event : events) {
    require(!seen[event], "T1", "event " + std::to_string(event) + " is there twice");
    seen[event] = true;
  }
  require(events.size() == seen.size(), "T1", "the events are not each end of each segment once");
  const auto place = [&](std::size_t event) -> const Point& {
    const Segment& s = set.segments[event / 2];
    return event % 2 == 1 ? s.last : s.first;
  };
  for (std::size_t k = 1; k < events.size(); ++k) {
    const std::size_t before = events[k - 1], here = events[k];
    const Point &p = place(before), &q = place(here);
    const bool same = p == q;
    const bool in_order = same ? rank(set.segments[before / 2], before) <= rank(set.segments[here / 2], here) : p < q;
    require(in_order, "T1", "event " + std::to_string(k) + " is out of order");
    require(allowed != Allowed::nothing || !same || before / 2 == here / 2, "T1",
            "event " + std::to_string(k) + " shares its point with another segment");
  }
}

void check_none(const Set& set, Allowed allowed, const None& none) {
  check_order(set, allowed, none.events);
  const std::size_t size = set.segments.size();
  const auto neighbours = [&](std::size_t lower, std::size_t upper) {
    if (lower == size || upper == size) return;
    const std::string kind = kind_of(set.segments[lower], set.segments[upper]);
    require(
        is_allowed(kind, allowed), "T4",
        "segments " + std::to_string(lower) + " and " + std::to_string(upper) + " become neighbours and meet: " + kind);
  };
  // A ring: `size` stands below and above all.
  std::vector<std::size_t> above(size + 1, size), below(size + 1, size);
  std::vector<bool> is_cut(size + 1);
  is_cut[size] = true;
  std::size_t begun = 0;
  for (const std::size_t event : none.events) {
    const std::size_t s = event / 2;
    if (event % 2 == 1) {
      require(is_cut[s], "T2", "segment " + std::to_string(s) + " ends before it begins");
      is_cut[s] = false;
      above[below[s]] = above[s];
      below[above[s]] = below[s];
      neighbours(below[s], above[s]);
      continue;
    }
    const std::int64_t named = none.below[begun++];
    const std::size_t lower = named < 0 ? size : static_cast<std::size_t>(named);
    require(is_cut[lower], "T2",
            "segment " + std::to_string(s) + " begins above " + std::to_string(named) + ", which is not cut then");
    const std::size_t upper = above[lower];
    require(lower == size || is_above(set.segments[s], set.segments[lower]), "T3",
            "segment " + std::to_string(s) + " does not begin above " + std::to_string(lower));
    require(upper == size || !is_above(set.segments[s], set.segments[upper]), "T3",
            "segment " + std::to_string(s) + " does not begin below " + std::to_string(upper));
    is_cut[s] = true;
    above[s] = upper;
    below[s] = lower;
    above[lower] = below[upper] = s;
    neighbours(lower, s);
    neighbours(s, upper);
  }
}

Set read_set(const json& top) {
  Numbers flat;
  std::size_t count = 0;
  for (const json& item : list_member(top, "segments", "the file")) {
    for (Number& number : read_numbers(item, 4, read_double, "segments[" + std::to_string(count) + "]")) {
      flat.push_back(std::move(number));
    }
    ++count;
  }
  const Common scaled = common(flat);
  Set set;
  set.e = scaled.e;
  for (std::size_t k = 0; k < flat.size(); k += 4) {
    const Integer* x = &scaled.integers[k];
    set.segments.push_back({{x[0], x[1]}, {x[2], x[3]}});
    const Segment& s = set.segments.back();
    if (s.last < s.first) {
      refuse_form("segments[" + std::to_string(k / 4) + "] does not begin with its lexicographically first end");
    }
  }
  return set;
}

struct Statement {
  Allowed allowed = Allowed::nothing;
  PairResult result;
  Some some;
  None none;
};

Statement read_statement(const json& item, std::size_t size, const std::string& where) {
  Statement statement;
  if (string_member(item, "question", where) != "segments_any") refuse_form(where + ".question is not segments_any");
  const std::string allowed = string_member(item, "allowed", where);
  if (allowed == "shared-endpoint") {
    statement.allowed = Allowed::shared_endpoint;
  } else if (allowed == "touch") {
    statement.allowed = Allowed::touch;
  } else if (allowed != "nothing") {
    refuse_form(where + ".allowed is none of nothing, shared-endpoint, touch");
  }
  statement.result.name_a = "segments";
  statement.result.name_b = allowed + " allowed";
  statement.result.verdict = string_member(item, "verdict", where);
  if (statement.result.verdict == "some") {
    Some& some = statement.some;
    some.i = index_member(item, "i", size, where);
    some.j = index_member(item, "j", size, where);
    if (some.i == some.j) refuse_form(where + " names one segment twice");
    some.kind = string_member(item, "kind", where);
    if (std::find(kinds.begin(), kinds.end(), some.kind) == kinds.end()) {
      refuse_form(where + ".kind is no kind of contact");
    }
    some.point = read_numbers(list_member(item, "point", where), 2, read_number, where + ".point");
  } else if (statement.result.verdict == "none") {
    for (const json& event : list_member(item, "events", where)) {
      statement.none.events.push_back(read_index(event, 2 * size, where + " event"));
    }
    const json& below = list_member(item, "below", where);
    if (below.size() != size) refuse_form(where + ".below is not a list of " + std::to_string(size));
    for (const json& entry : below) {
      const bool none = entry.is_number_integer() && !entry.is_number_unsigned() && entry.get<std::int64_t>() == -1;
      statement.none.below.push_back(
          none ? -1 : static_cast<std::int64_t>(read_index(entry, size, where + ".below entry that is not -1")));
    }
  } else {
    refuse_form(where + ".verdict is neither none nor some");
  }
  return statement;
}

}  // namespace

std::vector<PairResult> verify_set(const json& top) {
  const json& version = member(top, "sunder_set_certificate", "the file");
  if (!version.is_number_integer() || version.get<std::int64_t>() != 1) {
    refuse_form("sunder_set_certificate is not 1");
  }
  const Set set = read_set(top);
  std::vector<Statement> statements;
  for (const json& item : list_member(top, "statements", "the file")) {
    statements.push_back(
        read_statement(item, set.segments.size(), "statements[" + std::to_string(statements.size()) + "]"));
  }
  std::vector<PairResult> results;
  for (Statement& statement : statements) {
    PairResult& result = statement.result;
    try {
      if (result.verdict == "some") {
        check_some(set, statement.allowed, statement.some);
      } else {
        check_none(set, statement.allowed, statement.none);
      }
      result.accepted = true;
    } catch (const Refused& refused) {
      result.failed_check = refused.check;
      result.reason = refused.reason;
    }
    results.push_back(std::move(result));
  }
  return results;
}

}  // namespace sunder_verifier
