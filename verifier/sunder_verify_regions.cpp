#include "sunder_verify_regions.h"

#include "sunder_verify_programs.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sunder_verifier {
namespace {

// What a verdict wants of its sides.
struct Shape {
  const char* verdict;
  std::size_t least, most;  // sides
  bool is_round;            // the last side turns to the first
  bool has_corners;
};

constexpr std::size_t any = no_index;
constexpr std::array<Shape, 10> shapes{{{"empty", 2, 3, true, false},
                                        {"point", 3, 4, true, true},
                                        {"segment", 4, 4, true, true},
                                        {"ray", 3, 3, false, true},
                                        {"line", 2, 2, false, false},
                                        {"strip", 2, 2, false, false},
                                        {"half-plane", 1, 1, false, false},
                                        {"unbounded", 2, any, false, true},
                                        {"bounded", 3, any, true, true},
                                        {"plane", 0, 0, false, false}}};

bool is_in_lower_half(const HalfPlane& h) { return h.b < 0 || (h.b == 0 && h.a < 0); }

class RegionChecker {
 public:
  RegionChecker(const Shape& shape, const std::vector<std::size_t>& sides, const std::vector<HalfPlane>& given)
      : shape_(shape), verdict_(shape.verdict), given_(given), sides_(sides), size_(sides.size()) {}

  void check(const std::vector<std::size_t>& cones) const {
    check_normals();
    check_lines();
    for (std::size_t i = 0; i < cones.size(); ++i) check_other(i, cones[i]);
  }

 private:
  const HalfPlane& side(std::size_t k) const { return given_[sides_[k % size_]]; }

  // Negative: side k has a part of the boundary, from the corner before it to the one after.
  int end(std::size_t k) const { return excess(side(k + 1), corner(side(k + size_ - 1), side(k))); }

  // S1: the sides turn as they do for such a region.
  void check_normals() const {
    require(shape_.least <= size_ && (shape_.most == any || size_ <= shape_.most), "S1",
            std::to_string(size_) + " sides are not those of this verdict");
    if (size_ < 2) return;
    if (shape_.most == 2 || (verdict_ == "empty" && size_ == 2)) {
      require(are_opposite(side(0), side(1)), "S1", "the two sides are not opposite");
      return;
    }
    for (std::size_t k = 0; k + (shape_.is_round ? 0 : 1) < size_; ++k) {
      require(turn(side(k), side(k + 1)) > 0, "S1",
              "side " + std::to_string(k) + " does not turn to the next by less than half a turn");
    }
    if (shape_.is_round) {
      require(rounds() == 1, "S1", "the sides do not go round once");
      return;
    }
    bool is_within = turn(side(0), side(size_ - 1)) >= 0;
    for (std::size_t k = 1; k + 1 < size_; ++k) is_within = is_within && turn(side(0), side(k)) > 0;
    require(is_within, "S1", "the sides turn by more than half a turn");
    require(verdict_ != "ray" || are_opposite(side(0), side(2)), "S1", "the ends of a ray are not opposite");
  }

  int rounds() const {
    int count = 0;
    for (std::size_t k = 0; k < size_; ++k) count += is_in_lower_half(side(k)) && !is_in_lower_half(side(k + 1));
    return count;
  }

  // S2: the sides' lines lie as they do for such a region. Requires S1.
  void check_lines() const {
    if (verdict_ == "empty") {
      require(size_ == 2 ? width(side(0), side(1)) < 0 : end(1) > 0, "S2", "the half-planes have a common point");
    } else if (verdict_ == "line" || verdict_ == "ray") {
      require(width(side(0), side(size_ - 1)) == 0, "S2", "the first and last side are not on one line");
    } else if (verdict_ == "strip") {
      require(width(side(0), side(1)) > 0, "S2", "the strip has no inside");
    } else if (verdict_ == "unbounded") {
      check_ends(1, size_ - 1, false);
    } else if (verdict_ == "bounded" || verdict_ == "point") {
      check_ends(0, size_, verdict_ == "point");
    } else if (verdict_ == "segment") {
      const std::size_t k = is_on_one_line(0) ? 0 : 1;
      require(is_on_one_line(k), "S2", "no two sides are on one line and opposite");
      require(end(k) < 0, "S2", "the segment has no length");
    }
  }

  bool is_on_one_line(std::size_t k) const {
    return are_opposite(side(k), side(k + 2)) && width(side(k), side(k + 2)) == 0;
  }

  void check_ends(std::size_t from, std::size_t to, bool is_point) const {
    for (std::size_t k = from; k < to; ++k) {
      require(is_point ? end(k) == 0 : end(k) < 0, "S2",
              "side " + std::to_string(k) + (is_point ? " does not hold the point" : " has no part of the boundary"));
    }
  }

  // S3, S4: half-plane i holds the region. Requires S1 and S2.
  void check_other(std::size_t i, std::size_t p) const {
    const HalfPlane &h = given_[i], &from = side(p);
    const auto refusal = [i](const char* what) { return "half-plane " + std::to_string(i) + what; };
    if (shape_.has_corners) {
      const HalfPlane& to = side(p + 1);
      require(turn(from, h) >= 0 && turn(h, to) >= 0, "S3", refusal(" does not face as between its sides"));
      require(excess(h, corner(from, to)) <= 0, "S4", refusal(" does not hold its corner"));
    } else {
      require(turn(from, h) == 0 && facing(from, h) > 0, "S3", refusal(" does not face as its side"));
      require(holds(h, from), "S4", refusal(" does not hold its side"));
    }
  }

  const Shape& shape_;
  const std::string verdict_;
  const std::vector<HalfPlane>& given_;
  const std::vector<std::size_t>& sides_;
  const std::size_t size_;
};

// A list of `least` vertices or more.
std::vector<Numbers> read_vertices(const json& item, std::size_t least, const std::string& where) {
  if (!item.is_array() || item.size() < least) {
    refuse_form(where + " is not a list of " + std::to_string(least) + " vertices or more");
  }
  std::vector<Numbers> vertices;
  for (const json& vertex : item) vertices.push_back(read_numbers(vertex, 2, read_double, where + " vertex"));
  return vertices;
}

HalfPlane left_of_edge(const Numbers& p, const Numbers& q, const std::string& where) {
  return left_of({p[0], p[1], q[0], q[1]}, where);
}

// Of each edge of a ring the half-plane of the side where its inside is.
HalfPlanes sides_of_ring(const json& item, const std::string& where) {
  const std::vector<Numbers> vertices = read_vertices(item, 3, where);
  Numbers flat;
  for (const Numbers& vertex : vertices) flat.insert(flat.end(), vertex.begin(), vertex.end());
  const Integers scaled = common(flat).integers;
  const std::size_t size = vertices.size();
  const auto next = [size](std::size_t k) { return k + 1 == size ? 0 : k + 1; };
  Integer area;
  for (std::size_t k = 0; k < size; ++k) {
    area += scaled[2 * k] * scaled[2 * next(k) + 1] - scaled[2 * k + 1] * scaled[2 * next(k)];
  }
  if (area == 0) refuse_form(where + " has no area");
  std::vector<HalfPlane> sides;
  for (std::size_t k = 0; k < size; ++k) {
    const Numbers &p = vertices[k], &q = vertices[next(k)];
    sides.push_back(area > 0 ? left_of_edge(p, q, where) : left_of_edge(q, p, where));
  }
  return std::make_shared<const std::vector<HalfPlane>>(std::move(sides));
}

void add_kernel_question(const json& top, Questions& questions) {
  std::vector<HalfPlanes> rings;
  for (const json& item : list_member(top, "rings", "the file")) {
    rings.push_back(sides_of_ring(item, "rings[" + std::to_string(rings.size()) + "]"));
  }
  questions["kernel"] = [rings](const json& item, const std::string& where) {
    return read_region(item, rings[index_member(item, "ring", rings.size(), where)], "rings", "kernel", where);
  };
}

// x or y of this number at most, or at least.
HalfPlane beside(std::size_t axis, const Number& limit, bool at_most) {
  Number one;
  one.n = at_most ? 1 : -1;
  Number signed_limit = limit;
  if (!at_most) signed_limit.n = -limit.n;
  const Integers scaled = common({one, signed_limit}).integers;
  const Integer zero;
  return {axis == 0 ? scaled[0] : zero, axis == 0 ? zero : scaled[0], scaled[1]};
}

// Appends the half-planes whose common part is a convex polygon, a segment or a point.
void append_sides_of_convex(const json& item, const std::string& where, std::vector<HalfPlane>& sides) {
  const std::vector<Numbers> vertices = read_vertices(item, 1, where);
  const std::size_t size = vertices.size(), first = sides.size();
  if (size == 1) {
    for (const bool at_most : {true, false}) {
      for (const std::size_t axis : {0u, 1u}) sides.push_back(beside(axis, vertices[0][axis], at_most));
    }
    return;
  }
  for (std::size_t k = 0; k < size; ++k) {
    sides.push_back(left_of_edge(vertices[k], vertices[k + 1 == size ? 0 : k + 1], where));
  }
  if (size == 2) {
    const Integers x = common({vertices[0][0], vertices[1][0]}).integers;
    const Integers y = common({vertices[0][1], vertices[1][1]}).integers;
    const std::size_t axis = x[0] != x[1] ? 0 : 1, greater = axis == 0 ? x[1] > x[0] : y[1] > y[0];
    sides.push_back(beside(axis, vertices[greater][axis], true));
    sides.push_back(beside(axis, vertices[1 - greater][axis], false));
    return;
  }
  int rounds = 0;
  for (std::size_t k = 0; k < size; ++k) {
    const HalfPlane &h = sides[first + k], &next = sides[first + (k + 1 == size ? 0 : k + 1)];
    if (turn(h, next) <= 0) refuse_form(where + " is not strictly convex and counter-clockwise");
    rounds += is_in_lower_half(h) && !is_in_lower_half(next);
  }
  if (rounds != 1) refuse_form(where + " is not strictly convex and counter-clockwise");
}

// Looks at the polygons where it is asked for: other questions do not mind in which order vertices are.
void add_convex_question(const json& top, Questions& questions) {
  questions["convex_polygons"] = [&top, known = HalfPlanes()](const json& item, const std::string& where) mutable {
    if (!known) {
      std::vector<HalfPlane> given;
      std::size_t number = 0;
      for (const json& polygon : list_member(top, "convex_polygons", "the file")) {
        append_sides_of_convex(polygon, "convex_polygons[" + std::to_string(number++) + "]", given);
      }
      known = std::make_shared<const std::vector<HalfPlane>>(std::move(given));
    }
    return read_region(item, known, "convex polygons", "common part", where);
  };
}

}  // namespace

Statement read_region(const json& item, const HalfPlanes& given, const std::string& about, const std::string& rule,
                      const std::string& where) {
  const std::string verdict = string_member(item, "verdict", where);
  const auto* shape = std::find_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return verdict == s.verdict; });
  if (shape == shapes.end()) refuse_form(where + ".verdict is no kind of region");
  std::vector<std::size_t> sides = index_list(item, "sides", given->size(), no_index, where), cones;
  if (verdict != "empty") {
    // A corner is between two sides: of those that do not go round, none is after the last one.
    const bool is_open = shape->has_corners && !shape->is_round;
    const std::size_t count = sides.size() - (is_open && !sides.empty() ? 1 : 0);
    cones = index_list(item, "cones", count, given->size(), where);
  }
  return make_statement(about, rule, verdict, [=] { RegionChecker(*shape, sides, *given).check(cones); });
}

void check_contradict(const std::vector<HalfPlane>& given, const std::vector<std::size_t>& sides) {
  RegionChecker(shapes[0], sides, given).check({});
}

void add_region_questions(const json& top, Questions& questions) {
  if (top.contains("rings")) add_kernel_question(top, questions);
  if (top.contains("convex_polygons")) add_convex_question(top, questions);
  if (!top.contains("half_planes")) return;
  std::vector<HalfPlane> table;
  for (const json& item : list_member(top, "half_planes", "the file")) {
    table.push_back(read_half_plane(item, "half_planes[" + std::to_string(table.size()) + "]"));
  }
  const auto given = std::make_shared<const std::vector<HalfPlane>>(std::move(table));
  questions["half_planes"] = [given](const json& item, const std::string& where) {
    return read_region(item, given, "half-planes", "common part", where);
  };
  add_program_question(given, questions);
}

}  // namespace sunder_verifier
