#include "sunder_verify_circles.h"

#include "disc_arcs.h"

#include <algorithm>
#include <memory>
#include <utility>

namespace sunder_verifier {
namespace {

// In units of 2^e.
struct Discs {
  std::vector<Disc> discs;
  std::int64_t e = 0;
  std::size_t bits = 0;  // of the longest number
};

std::string text(std::size_t i) { return std::to_string(i); }

std::string kind_of(const Disc& c, const Disc& d) {
  const Integer distance = square(c.x - d.x) + square(c.y - d.y);  // squared
  const int far = distance.compare(square(c.r + d.r));
  if (far > 0) return "none";
  if (far == 0) return "touching";
  return distance > square(c.r - d.r) ? "overlapping" : "inside";
}

bool is_kind(const std::string& kind) { return kind == "touching" || kind == "overlapping" || kind == "inside"; }

bool counts(const std::string& kind, const std::string& rule) {
  return kind == "touching" ? rule == "nothing" : kind != "none";
}

struct Some {
  std::size_t i = 0, j = 0;
  std::string kind;
  Numbers point;
  std::vector<std::int64_t> groups;  // empty: none
};

PointInUnits in_integers(std::int64_t e, const Numbers& point) {
  const Number &x = point[0], &y = point[1];
  const std::int64_t low = std::min(e, std::min(x.e, y.e));
  return {shifted(x.n * y.d, x.e - low), shifted(y.n * x.d, y.e - low), shifted(x.d * y.d, e - low)};
}

// 1: the point is inside of the circle; 0: on it; -1: outside.
int place_in(const Disc& disc, const PointInUnits& p) {
  const Integer left = square(disc.r * p.unit) - square(p.x - disc.x * p.unit) - square(p.y - disc.y * p.unit);
  return left.sign();
}

void check_some(const Discs& set, const std::string& rule, const Some& some) {
  const std::size_t longest = length(some.point) + set.bits;
  take_steps(16, longest, longest);
  require(counts(some.kind, rule), "C1", some.kind + " does not count where " + rule + " is allowed");
  require(some.groups.empty() || some.groups[some.i] != some.groups[some.j], "C1",
          "circles " + text(some.i) + " and " + text(some.j) + " are of one group");
  for (const std::size_t k : {some.i, some.j}) {
    require(place_in(set.discs[k], in_integers(set.e, some.point)) >= 0, "C2", "the point is not in circle " + text(k));
  }
  const std::string found = kind_of(set.discs[some.i], set.discs[some.j]);
  require(found == some.kind, "C3", "the contact is " + found);
}

struct None {
  std::vector<std::size_t> events, below;
};

// T1.
void check_order(const std::vector<Disc>& discs, const std::vector<std::size_t>& events) {
  require_each_end_once(events, discs.size(), "circle");
  Integer before, here;
  for (std::size_t k = 0; k < events.size(); ++k) {
    const std::size_t event = events[k];
    const Disc& d = discs[event / 2];
    const bool is_last = event % 2 == 1;
    here = d.x + (is_last ? d.r : Integer(-d.r));
    if (k > 0) {
      const int step = before.compare(here);
      const bool was_last = events[k - 1] % 2 == 1;
      require(step < 0 || (step == 0 && (is_last || !was_last)), "T1", "event " + text(k) + " is out of order");
    }
    before = here;
  }
}

class Transcript {
 public:
  Transcript(const std::vector<Disc>& discs, const std::string& rule)
      : discs_(discs), rule_(rule), none_(discs.size()), above_(none_ + 1, none_), below_(none_ + 1, none_) {
    is_cut_.resize(none_ + 1);
    is_cut_[none_] = true;
  }

  void check(const None& transcript) {
    check_order(discs_, transcript.events);
    std::size_t begun = 0;
    for (const std::size_t event : transcript.events) {
      if (event % 2 == 1) {
        take_out(event / 2);
      } else {
        put_in(event / 2, transcript.below[begun++]);
      }
    }
  }

 private:
  void take_out(std::size_t s) {
    is_cut_[s] = false;
    become_neighbours(below_[s], above_[s]);
  }

  void put_in(std::size_t s, std::size_t named) {
    const std::size_t lower = named == no_index ? none_ : named;
    require(is_cut_[lower], "T2", "circle " + text(s) + " begins above " + text(lower) + ", which is not cut then");
    const std::size_t upper = above_[lower];
    require(lower == none_ || discs_[lower].y <= discs_[s].y, "T3",
            "circle " + text(s) + " is not above " + text(lower));
    require(upper == none_ || discs_[s].y <= discs_[upper].y, "T3",
            "circle " + text(s) + " is not below " + text(upper));
    is_cut_[s] = true;
    become_neighbours(lower, s);
    become_neighbours(s, upper);
  }

  void become_neighbours(std::size_t lower, std::size_t upper) {
    above_[lower] = upper;
    below_[upper] = lower;
    if (lower == none_ || upper == none_) return;
    const std::string kind = kind_of(discs_[lower], discs_[upper]);
    require(!counts(kind, rule_), "T4",
            "circles " + text(lower) + " and " + text(upper) + " become neighbours and meet: " + kind);
  }

  const std::vector<Disc>& discs_;
  const std::string rule_;
  const std::size_t none_;                  // stands below and above all: the list is a ring
  std::vector<std::size_t> above_, below_;  // in the list
  std::vector<bool> is_cut_;                // is the disc in the list?
};

// What proves the kind of the common part of all discs.
struct CommonPart {
  std::string verdict;
  Numbers point;                   // region
  std::vector<std::size_t> arcs;   // what bounds it; empty: not stated
  std::vector<std::size_t> named;  // empty and point
  Integers weights;                // of these, times something positive
};

// The discs' means with the weights, times their sum: of the power of a disc at p, |p - c|^2 - r^2, the mean is
// |p - mean c|^2 + mean (|c|^2 - r^2) - |mean c|^2.
struct Mean {
  Integer total, x, y, power;  // the sum of the weights; of x, y; of |c|^2 - r^2
};

Mean mean_of(const std::vector<Disc>& discs, const CommonPart& part) {
  Mean mean;
  for (std::size_t k = 0; k < part.named.size(); ++k) {
    const Disc& d = discs[part.named[k]];
    const Integer& w = part.weights[k];
    mean.total += w;
    mean.x += w * d.x;
    mean.y += w * d.y;
    mean.power += w * (square(d.x) + square(d.y) - square(d.r));
  }
  return mean;
}

void check_common(const Discs& set, const CommonPart& part) {
  if (part.verdict == "plane") return;
  if (part.verdict == "region") {
    const std::size_t longest = length(part.point) + set.bits;
    take_steps(4 * set.discs.size(), longest, longest);
    take_steps(10 * set.discs.size() * part.arcs.size(), 4 * set.bits, 4 * set.bits);
    const PointInUnits point = in_integers(set.e, part.point);
    for (std::size_t k = 0; k < set.discs.size(); ++k) {
      require(place_in(set.discs[k], point) > 0, "D3", "the point is not inside of circle " + text(k));
    }
    if (!part.arcs.empty()) check_arcs(set.discs, part.arcs, point);
    return;
  }
  const bool are_positive =
      std::none_of(part.weights.begin(), part.weights.end(), [](const Integer& w) { return w < 0; });
  const Mean mean = mean_of(set.discs, part);
  require(are_positive && mean.total > 0, "D1", "the weights are not at least 0, and not all 0");
  const Integer least = mean.total * mean.power - square(mean.x) - square(mean.y);
  if (part.verdict == "empty") {
    require(least > 0, "D2", "the named circles may have a common point");
    return;
  }
  require(least == 0, "D2", "the named circles have no single common point, or these weights do not show it");
  const std::size_t longest = bits(Integers{mean.x, mean.y, mean.total});
  take_steps(4 * set.discs.size(), longest, longest);
  for (std::size_t k = 0; k < set.discs.size(); ++k) {
    const Disc& d = set.discs[k];
    require(square(mean.x - d.x * mean.total) + square(mean.y - d.y * mean.total) <= square(d.r * mean.total), "D3",
            "the point is not in circle " + text(k));
  }
}

Discs read_discs(const json& top) {
  Numbers flat;
  std::size_t count = 0;
  for (const json& item : list_member(top, "circles", "the file")) {
    for (Number& number : read_numbers(item, 3, read_double, "circles[" + text(count) + "]")) {
      flat.push_back(std::move(number));
    }
    ++count;
  }
  const Common scaled = common(flat);
  Discs set;
  set.e = scaled.e;
  set.bits = bits(scaled.integers);
  for (std::size_t k = 0; k < flat.size(); k += 3) {
    set.discs.push_back({scaled.integers[k], scaled.integers[k + 1], scaled.integers[k + 2]});
    if (set.discs.back().r < 0) refuse_form("circles[" + text(k / 3) + "] has a negative radius");
  }
  return set;
}

Some read_some(const json& item, std::size_t size, const std::string& where) {
  Some some;
  some.i = index_member(item, "i", size, where);
  some.j = index_member(item, "j", size, where);
  if (some.i == some.j) refuse_form(where + " names one circle twice");
  some.kind = string_member(item, "kind", where);
  if (!is_kind(some.kind)) refuse_form(where + ".kind is no kind of contact");
  some.point = read_numbers(list_member(item, "point", where), 2, read_number, where + ".point");
  return some;
}

Statement read_any(const std::shared_ptr<const Discs>& set, const json& item, const std::string& where) {
  const std::size_t size = set->discs.size();
  const std::string rule = read_rule(item, where), verdict = string_member(item, "verdict", where);
  if (verdict != "some" && verdict != "none") refuse_form(where + ".verdict is neither none nor some");
  const bool has_groups = item.contains("groups");
  std::vector<std::int64_t> groups;
  if (has_groups) groups = read_groups(item, size, where);
  if (verdict == "some") {
    Some some = read_some(item, size, where);
    some.groups = std::move(groups);
    return make_statement("circles", rule + " allowed", verdict, [=] { check_some(*set, rule, some); });
  }
  if (has_groups) refuse_form(where + " has groups, for which there is no transcript");
  None none;
  none.events = index_list(item, "events", 2 * size, no_index, where);
  none.below = index_or_none_list(item, "below", size, size, where);
  return make_statement("circles", rule + " allowed", verdict, [=] { Transcript(set->discs, rule).check(none); });
}

Statement read_common(const std::shared_ptr<const Discs>& set, const json& item, const std::string& where) {
  constexpr std::size_t most = 16;  // named; 3 are always enough
  CommonPart part;
  part.verdict = string_member(item, "verdict", where);
  if (part.verdict == "region") {
    if (set->discs.empty()) refuse_form(where + ".verdict is region, but there are no circles");
    part.point = read_numbers(member(item, "point", where), 2, read_number, where + ".point");
    if (item.contains("arcs")) {
      part.arcs = index_list(item, "arcs", set->discs.size(), no_index, where);
      if (part.arcs.empty()) refuse_form(where + ".arcs is empty");
      if (part.arcs.size() > 2 * set->discs.size()) refuse_form(where + ".arcs has more than two arcs a circle");
    }
  } else if (part.verdict == "plane") {
    if (!set->discs.empty()) refuse_form(where + ".verdict is plane, but there are circles");
  } else if (part.verdict == "empty" || part.verdict == "point") {
    part.named = index_list(item, "discs", set->discs.size(), no_index, where);
    if (part.named.size() > most) refuse_form(where + ".discs has more than " + text(most) + " entries");
    part.weights =
        common_weights(read_numbers(member(item, "weights", where), part.named.size(), read_number, where + ".weights"))
            .integers;
  } else {
    refuse_form(where + ".verdict is no kind of common part");
  }
  return make_statement("circles", "common part", part.verdict, [=] { check_common(*set, part); });
}

}  // namespace

void add_circle_questions(const json& top, Questions& questions) {
  if (!top.contains("circles")) return;
  const auto set = std::make_shared<const Discs>(read_discs(top));
  questions["circles_any"] = [set](const json& item, const std::string& where) { return read_any(set, item, where); };
  questions["circles"] = [set](const json& item, const std::string& where) { return read_common(set, item, where); };
}

}  // namespace sunder_verifier
