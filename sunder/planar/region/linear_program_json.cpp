#include <sunder/planar/region/linear_program_json.h>
#include <sunder/planar/region/regions_json.h>
#include <sunder/planar/set/tables_json.h>

#include <array>
#include <vector>

namespace sunder::planar {

namespace {

struct ExactVector {
  Dyadic x, y;
};

// The direction of the half-plane's line, which has it on its left.
ExactVector along(const Constraint& h) { return {-h.b, h.a}; }

ExactVector along(const LeftOf& h) { return {Dyadic(h.to.x) - Dyadic(h.from.x), Dyadic(h.to.y) - Dyadic(h.from.y)}; }

// The named half-planes, in the order of their angles.
std::vector<std::uint32_t> named(const LinearProgramAnswer& answer) {
  std::vector<std::uint32_t> result;
  for (const std::uint32_t k : {answer.before, answer.side, answer.after}) {
    if (k != no_half_plane) result.push_back(k);
  }
  return result;
}

template <class Given>
ExactVector direction_of(const Given& given, const Objective& objective, const LinearProgramAnswer& answer) {
  if (answer.side == no_half_plane) return {objective.p, objective.q};
  const ExactVector d = along(given[answer.side]);
  return answer.backward ? ExactVector{-d.x, -d.y} : d;
}

void append_edge(std::string& text, const LinearProgramAnswer& answer) {
  const auto number = [](std::uint32_t k) { return k == no_half_plane ? "-1" : std::to_string(k); };
  text += ",\n   \"side\": " + number(answer.side) + ", \"before\": " + number(answer.before) +
          ", \"after\": " + number(answer.after);
}

}  // namespace

template <class Given>
std::string certificate_text(const Given& given, const Objective& objective, const LinearProgramAnswer& answer) {
  std::string text = json_file_begin;
  append_half_planes(text, given);
  text += ",\n \"statements\": [\n  {\"question\": \"linear_program\", \"objective\": ";
  append_doubles(text, std::array{objective.p, objective.q});
  text += ", \"verdict\": \"" + std::string(name_of(answer.outcome)) + '"';
  if (answer.feasible()) {
    text += ",\n   \"point\": ";
    append_point(text, point_of(given, answer));
  } else {
    text += ",\n   \"sides\": ";
    append_indices(text, named(answer));
  }
  if (answer.outcome == Optimum::one) {
    text += ",\n   \"tight\": ";
    append_indices(text, named(answer));
  } else if (answer.outcome == Optimum::many) {
    append_edge(text, answer);
  } else if (answer.outcome == Optimum::unbounded) {
    const ExactVector d = direction_of(given, objective, answer);
    text += ",\n   \"direction\": [\"" + d.x.hexadecimal() + "\", \"" + d.y.hexadecimal() + "\"]";
  }
  return text + "}]}\n";
}

template std::string certificate_text(const Constraints&, const Objective&, const LinearProgramAnswer&);
template std::string certificate_text(const HalfPlanes&, const Objective&, const LinearProgramAnswer&);

}  // namespace sunder::planar
