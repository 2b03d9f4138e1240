#include "sunder_verify_programs.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

struct Program {
  HalfPlanes given;
  HalfPlane up;                    // a positive multiple of the objective; c is zero
  Place point;                     // all but infeasible
  HalfPlane direction;             // unbounded; c is zero
  std::vector<std::size_t> named;  // one: at the point; infeasible: without a common point
  std::size_t side = no_index, before = no_index, after = no_index;  // many
};

std::string text(std::size_t i) { return std::to_string(i); }

Place place_of(const Numbers& point) {
  const Common scaled = common(point);
  const std::int64_t up = std::max<std::int64_t>(scaled.e, 0), down = std::max<std::int64_t>(-scaled.e, 0);
  return {shifted(scaled.integers[0], up), shifted(scaled.integers[1], up), shifted(scaled.d, down)};
}

HalfPlane direction_of(const Numbers& numbers) {
  const Common scaled = common(numbers);
  return {scaled.integers[0], scaled.integers[1], 0};
}

// Of a look at all half-planes with a point or a direction.
void take_steps_of(const Program& program, const Integers& vector) {
  std::size_t longest = 0;
  for (const HalfPlane& h : *program.given) longest = std::max({longest, bits(h.a), bits(h.b), bits(h.c)});
  take_steps(2 * program.given->size(), bits(vector), longest);
}

void check_in_all(const Program& program, const Place& point, const char* check, const std::string& what) {
  const std::vector<HalfPlane>& given = *program.given;
  take_steps_of(program, {point.x, point.y, point.w});
  for (std::size_t i = 0; i < given.size(); ++i) {
    require(excess(given[i], point) <= 0, check, what + " is outside of half-plane " + text(i));
  }
}

void check_on_line(const Program& program, std::size_t k) {
  require(excess((*program.given)[k], program.point) == 0, "L2",
          "the point is not on the line of half-plane " + text(k));
}

bool faces_as(const HalfPlane& h, const HalfPlane& up) { return turn(h, up) == 0 && facing(h, up) > 0; }

void check_one(const Program& program) {
  check_in_all(program, program.point, "L1", "the point");
  for (const std::size_t k : program.named) check_on_line(program, k);
  const HalfPlane &first = (*program.given)[program.named.front()], &last = (*program.given)[program.named.back()];
  bool ways = false;
  if (program.named.size() == 2) {
    ways = turn(first, program.up) > 0 && turn(program.up, last) > 0 && turn(first, last) > 0;
  } else {
    const HalfPlane& side = (*program.given)[program.named[1]];
    ways = faces_as(side, program.up) && turn(first, side) > 0 && turn(side, last) > 0;
  }
  require(ways, "L3", "the half-planes at the point do not face as the objective needs");
}

// The end of the side before which, or after which, half-plane `end` has no part of it.
void check_end(const Program& program, std::size_t end, bool is_after) {
  const HalfPlane& side = (*program.given)[program.side];
  const auto turns_on = [&](const HalfPlane& h) { return is_after ? turn(side, h) > 0 : turn(h, side) > 0; };
  if (end == no_index) {
    take_steps_of(program, {side.a, side.b, side.c});
    for (std::size_t i = 0; i < program.given->size(); ++i) {
      require(!turns_on((*program.given)[i]), "L4", "half-plane " + text(i) + " ends the side");
    }
    return;
  }
  const HalfPlane& h = (*program.given)[end];
  require(turns_on(h), "L4", "half-plane " + text(end) + " does not end the side there");
  check_in_all(program, is_after ? corner(side, h) : corner(h, side), "L4", "the side's end");
}

void check_many(const Program& program) {
  check_in_all(program, program.point, "L1", "the point");
  check_on_line(program, program.side);
  const HalfPlane& side = (*program.given)[program.side];
  require(faces_as(side, program.up), "L3", "the side does not face as the objective");
  check_end(program, program.before, false);
  check_end(program, program.after, true);
  if (program.before == no_index || program.after == no_index) return;
  require(excess((*program.given)[program.after], corner((*program.given)[program.before], side)) < 0, "L4",
          "the side's ends are one point");
}

void check_all(const Program& program) {
  check_in_all(program, program.point, "L1", "the point");
  require(program.up.a == 0 && program.up.b == 0, "L3", "there is an objective");
}

void check_unbounded(const Program& program) {
  check_in_all(program, program.point, "L1", "the point");
  take_steps_of(program, {program.direction.a, program.direction.b});
  require(facing(program.up, program.direction) > 0, "L3", "the direction does not lead further along the objective");
  for (std::size_t i = 0; i < program.given->size(); ++i) {
    require(facing((*program.given)[i], program.direction) <= 0, "L4", "the direction leaves half-plane " + text(i));
  }
}

std::size_t name_member(const json& item, const char* key, std::size_t size, const std::string& where) {
  return is_minus_one(member(item, key, where)) ? no_index : index_member(item, key, size, where);
}

Statement read_program(const HalfPlanes& given, const json& item, const std::string& where) {
  const std::string verdict = string_member(item, "verdict", where);
  const bool is_one = verdict == "one", is_many = verdict == "many", is_all = verdict == "all";
  const bool is_unbounded = verdict == "unbounded", is_infeasible = verdict == "infeasible";
  if (!is_one && !is_many && !is_all && !is_unbounded && !is_infeasible) {
    refuse_form(where + ".verdict is no outcome");
  }
  const auto two = [&](const char* key, Number (*read)(const json&, const std::string&)) {
    return read_numbers(member(item, key, where), 2, read, where + "." + key);
  };
  const std::size_t size = given->size();
  Program program;
  program.given = given;
  program.up = direction_of(two("objective", read_double));
  if (is_infeasible) {
    program.named = index_list(item, "sides", size, no_index, where);
  } else {
    program.point = place_of(two("point", read_number));
  }
  if (is_one) {
    program.named = index_list(item, "tight", size, no_index, where);
    if (program.named.size() != 2 && program.named.size() != 3) refuse_form(where + ".tight is not a list of 2 or 3");
  }
  if (is_many) {
    program.side = index_member(item, "side", size, where);
    program.before = name_member(item, "before", size, where);
    program.after = name_member(item, "after", size, where);
  }
  if (is_unbounded) program.direction = direction_of(two("direction", read_number));
  return make_statement("half-planes", "linear program", verdict, [=] {
    if (is_infeasible) {
      check_contradict(*program.given, program.named);
    } else if (is_one) {
      check_one(program);
    } else if (is_many) {
      check_many(program);
    } else if (is_all) {
      check_all(program);
    } else {
      check_unbounded(program);
    }
  });
}

}  // namespace

void add_program_question(const HalfPlanes& given, Questions& questions) {
  questions["linear_program"] = [given](const json& item, const std::string& where) {
    return read_program(given, item, where);
  };
}

}  // namespace sunder_verifier
