#include "sunder_verify_convex.h"

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace sunder_verifier {
namespace {

struct Vector {
  Integer x, y;
};

bool operator==(const Vector& u, const Vector& v) { return u.x == v.x && u.y == v.y; }
bool operator<(const Vector& u, const Vector& v) { return u.x < v.x || (u.x == v.x && u.y < v.y); }

Integer cross(const Vector& u, const Vector& v) { return u.x * v.y - u.y * v.x; }
Integer dot(const Vector& u, const Vector& v) { return u.x * v.x + u.y * v.y; }

using Vertices = std::vector<Vector>;  // a polygon: their convex hull

// In units of 2^e.
struct Polygons {
  std::vector<Vertices> polygons;
  std::int64_t e = 0;
  std::size_t bits = 0;  // of the longest coordinate
};

std::string text(std::size_t i) { return std::to_string(i); }

// The point x / w, y / w; w > 0.
struct Place {
  Integer x, y, w;
};

Place place_of(const Numbers& point, std::int64_t e) {
  const Common scaled = common(point);
  const std::int64_t up = std::max<std::int64_t>(scaled.e - e, 0), down = std::max<std::int64_t>(e - scaled.e, 0);
  return {shifted(scaled.integers[0], up), shifted(scaled.integers[1], up), shifted(scaled.d, down)};
}

bool is_left(const Vector& u) { return u.x < 0 || (u.x == 0 && u.y < 0); }

// Where two polygons with a common point only touch, a line through it parts them: then all ways from the point into a,
// and the opposites of those into b, are on one side of the line, or on it, and not all are on it.
std::string contact_at(const Vertices& a, const Vertices& b, const Place& point) {
  std::vector<Vector> ways;
  for (const Vector& v : a) ways.push_back({v.x * point.w - point.x, v.y * point.w - point.y});
  for (const Vector& v : b) ways.push_back({point.x - v.x * point.w, point.y - v.y * point.w});
  std::erase_if(ways, [](const Vector& u) { return u.x == 0 && u.y == 0; });
  if (ways.empty()) return "overlapping";
  std::sort(ways.begin(), ways.end(), [](const Vector& u, const Vector& v) {  // by angle
    if (is_left(u) != is_left(v)) return is_left(v);
    return cross(u, v) > 0;
  });
  const bool on_one_line =
      std::all_of(ways.begin(), ways.end(), [&](const Vector& u) { return cross(ways.front(), u) == 0; });
  if (on_one_line) return dot(ways.front(), ways.back()) < 0 ? "overlapping" : "touching";
  for (std::size_t k = 0; k < ways.size(); ++k) {  // a gap of half a turn or more?
    const Vector &u = ways[k], &v = ways[k + 1 == ways.size() ? 0 : k + 1];
    const Integer side = cross(u, v);
    if (side < 0 || (side == 0 && dot(u, v) < 0)) return "touching";
  }
  return "overlapping";
}

struct Weights {
  std::vector<std::size_t> vertices;
  Numbers values;
};

struct Some {
  std::array<std::size_t, 2> of{};
  std::string contact;
  Numbers point;
  std::array<Weights, 2> weights;
  std::vector<std::int64_t> groups;  // empty: none
};

void check_weights(const Vertices& vertices, const Weights& weights, const Place& place, const std::string& polygon) {
  const Common scaled = common_weights(weights.values);
  Integer total;
  Vector sum;
  for (std::size_t k = 0; k < weights.vertices.size(); ++k) {
    const Integer& w = scaled.integers[k];
    require(w >= 0, "C2", "a weight of polygon " + polygon + " is negative");
    total += w;
    sum.x += w * vertices[weights.vertices[k]].x;
    sum.y += w * vertices[weights.vertices[k]].y;
  }
  const std::int64_t up = std::max<std::int64_t>(scaled.e, 0), down = std::max<std::int64_t>(-scaled.e, 0);
  require(shifted(total, up) == shifted(scaled.d, down), "C2",
          "the weights of polygon " + polygon + " do not sum to 1");
  require(sum.x * place.w == place.x * total && sum.y * place.w == place.y * total, "C2",
          "the weighted sum of polygon " + polygon + " is not the point");
}

void check_some(const Polygons& set, const std::string& rule, const Some& some) {
  require(some.contact == "overlapping" || rule != "touch", "C1", "touching does not count where it is allowed");
  const std::size_t i = some.of[0], j = some.of[1];
  require(some.groups.empty() || some.groups[i] != some.groups[j], "C1",
          "polygons " + text(i) + " and " + text(j) + " are of one group");
  const Place place = place_of(some.point, set.e);
  for (std::size_t k = 0; k < 2; ++k) {
    check_weights(set.polygons[some.of[k]], some.weights[k], place, text(some.of[k]));
  }
  const std::size_t longest = length(some.point) + set.bits;
  take_steps(8 * (set.polygons[i].size() + set.polygons[j].size()), longest, longest);
  const std::string found = contact_at(set.polygons[i], set.polygons[j], place);
  require(found == some.contact, "C3", "the contact is " + found);
}

struct None {
  std::vector<std::size_t> events, below;
  std::vector<Vector> directions;
};

class Transcript {
 public:
  Transcript(const Polygons& set, const None& none)
      : polygons_(set.polygons),
        bits_(set.bits),
        given_(none),
        none_(polygons_.size()),
        above_(none_ + 1, none_),
        below_(none_ + 1, none_) {
    is_cut_.resize(none_ + 1);
    is_cut_[none_] = true;
  }

  void check() {
    check_order();
    std::size_t begun = 0;
    for (const std::size_t event : given_.events) {
      if (event % 2 == 1) {
        is_cut_[event / 2] = false;
        become_neighbours(below_[event / 2], above_[event / 2], false);
      } else {
        put_in(event / 2, given_.below[begun++]);
      }
    }
    require(used_ == given_.directions.size(), "T4", "there are more directions than neighbours");
  }

 private:
  // T1.
  void check_order() const {
    const std::vector<std::size_t>& events = given_.events;
    require_each_end_once(events, polygons_.size(), "polygon");
    std::vector<const Vector*> ends;
    for (const Vertices& vertices : polygons_) {
      const auto [least, greatest] = std::minmax_element(vertices.begin(), vertices.end());
      ends.push_back(&*least);
      ends.push_back(&*greatest);
    }
    for (std::size_t k = 1; k < events.size(); ++k) {
      const Vector &before = *ends[events[k - 1]], &here = *ends[events[k]];
      const bool is_point = events[k] % 2 == 1 && events[k - 1] == events[k] - 1;  // it may come and go at once
      require(before < here || (is_point && before == here), "T1",
              "event " + text(k) + " is out of order, or shares its point");
    }
  }

  void put_in(std::size_t s, std::size_t named) {
    const std::size_t lower = named == no_index ? none_ : named;
    require(is_cut_[lower], "T2", "polygon " + text(s) + " begins above " + text(lower) + ", which is not cut then");
    const std::size_t upper = above_[lower];
    is_cut_[s] = true;
    become_neighbours(lower, s, true);
    become_neighbours(s, upper, true);
  }

  void become_neighbours(std::size_t lower, std::size_t upper, bool is_new) {
    above_[lower] = upper;
    below_[upper] = lower;
    if (lower == none_ || upper == none_) return;
    const std::string pair = text(lower) + " and " + text(upper);
    require(used_ < given_.directions.size(), "T4", "there are fewer directions than neighbours");
    const Vector& d = given_.directions[used_++];
    require(!is_new || d.y > 0, "T3", "the direction between polygons " + pair + " does not point up");
    const auto less = [&](const Vector& u, const Vector& v) { return dot(d, u) < dot(d, v); };
    const Vertices &l = polygons_[lower], &u = polygons_[upper];
    take_steps(l.size() + u.size(), std::max(bits(d.x), bits(d.y)), bits_);
    require(less(*std::max_element(l.begin(), l.end(), less), *std::min_element(u.begin(), u.end(), less)), "T4",
            "the direction does not part polygons " + pair + ", which become neighbours");
  }

  const std::vector<Vertices>& polygons_;
  const std::size_t bits_;
  const None& given_;
  const std::size_t none_;                  // stands below and above all: the list is a ring
  std::vector<std::size_t> above_, below_;  // in the list
  std::vector<bool> is_cut_;                // is the polygon in the list?
  std::size_t used_ = 0;                    // of the directions
};

Polygons read_polygons(const json& top) {
  Numbers flat;
  std::vector<std::size_t> sizes;
  for (const json& polygon : list_member(top, "convex_polygons", "the file")) {
    const std::string where = "convex_polygons[" + text(sizes.size()) + "]";
    if (!polygon.is_array() || polygon.empty()) refuse_form(where + " is not a list of vertices");
    for (const json& vertex : polygon) {
      for (Number& number : read_numbers(vertex, 2, read_double, where + " vertex")) flat.push_back(std::move(number));
    }
    sizes.push_back(polygon.size());
  }
  Common scaled = common(flat);
  Polygons set;
  set.e = scaled.e;
  set.bits = bits(scaled.integers);
  std::size_t next = 0;
  for (const std::size_t size : sizes) {
    Vertices& vertices = set.polygons.emplace_back();
    for (std::size_t k = 0; k < size; ++k, next += 2) {
      vertices.push_back({std::move(scaled.integers[next]), std::move(scaled.integers[next + 1])});
    }
  }
  return set;
}

Weights read_weights(const json& item, const char* key, std::size_t size, const std::string& parent) {
  const std::string where = parent + "." + key;
  const json& list = list_member(item, key, parent);
  if (list.size() > most_weights) refuse_form(where + " has more than " + text(most_weights) + " entries");
  Weights weights;
  for (const json& entry : list) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(where + " has an entry that is not a list of 2");
    const std::size_t vertex = read_index(entry[0], size, where + " vertex");
    if (std::count(weights.vertices.begin(), weights.vertices.end(), vertex) > 0) {
      refuse_form(where + " has vertex " + text(vertex) + " twice");
    }
    weights.vertices.push_back(vertex);
    weights.values.push_back(read_number(entry[1], where));
  }
  return weights;
}

Some read_some(const json& item, const Polygons& set, const std::string& where) {
  const std::size_t size = set.polygons.size();
  Some some;
  some.of = {index_member(item, "i", size, where), index_member(item, "j", size, where)};
  if (some.of[0] == some.of[1]) refuse_form(where + " names one polygon twice");
  some.contact = string_member(item, "contact", where);
  if (some.contact != "touching" && some.contact != "overlapping") {
    refuse_form(where + ".contact is neither touching nor overlapping");
  }
  some.point = read_numbers(member(item, "point", where), 2, read_number, where + ".point");
  some.weights[0] = read_weights(item, "weights_i", set.polygons[some.of[0]].size(), where);
  some.weights[1] = read_weights(item, "weights_j", set.polygons[some.of[1]].size(), where);
  return some;
}

None read_none(const json& item, std::size_t size, const std::string& where) {
  None none;
  none.events = index_list(item, "events", 2 * size, no_index, where);
  none.below = index_or_none_list(item, "below", size, size, where);
  for (const json& entry : list_member(item, "directions", where)) {
    const Integers d = common(read_numbers(entry, 2, read_number, where + ".directions entry")).integers;
    none.directions.push_back({d[0], d[1]});
  }
  return none;
}

Statement read_any(const std::shared_ptr<const Polygons>& set, const json& item, const std::string& where) {
  const std::size_t size = set->polygons.size();
  const std::string rule = read_rule(item, where), verdict = string_member(item, "verdict", where);
  if (verdict != "some" && verdict != "none") refuse_form(where + ".verdict is neither none nor some");
  const bool has_groups = item.contains("groups");
  std::vector<std::int64_t> groups;
  if (has_groups) groups = read_groups(item, size, where);
  if (verdict == "some") {
    Some some = read_some(item, *set, where);
    some.groups = std::move(groups);
    return make_statement("convex polygons", rule + " allowed", verdict, [=] { check_some(*set, rule, some); });
  }
  if (has_groups || rule == "touch") {
    refuse_form(where + " has groups or allows touching, for which there is no transcript");
  }
  const None none = read_none(item, size, where);
  return make_statement("convex polygons", rule + " allowed", verdict, [=] { Transcript(*set, none).check(); });
}

}  // namespace

void add_convex_questions(const json& top, Questions& questions) {
  if (!top.contains("convex_polygons")) return;
  const auto set = std::make_shared<const Polygons>(read_polygons(top));
  questions["convex_polygons_any"] = [set](const json& item, const std::string& where) {
    return read_any(set, item, where);
  };
}

}  // namespace sunder_verifier
