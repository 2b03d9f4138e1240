#include <sunder/certificate/claims.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>
#include <sunder/predicate/coordinates.h>

#include <array>
#include <vector>

namespace sunder::planar {

namespace {

using ExactVector = Vector2<Dyadic>;

// The direction of the half-plane's line, which has it on its left.
ExactVector along(const Constraint& h) { return {-h.b, h.a}; }

ExactVector along(const LeftOf& h) { return coordinates<Dyadic>(h.to) - coordinates<Dyadic>(h.from); }

// The normal, times a positive number that all three numbers of the half-plane may be multiplied by.
ExactVector normal(const Constraint& h) { return {h.a, h.b}; }

ExactVector normal(const LeftOf& h) {
  const ExactVector d = along(h);
  return {d.y, -d.x};
}

Dyadic magnitude(const Dyadic& x) { return x.sign() == Sign::negative ? -x : x; }

template <class Given>
ExactVector direction_of(const Given& given, const Objective& objective, const LinearProgramAnswer& answer) {
  if (answer.side == no_half_plane) return {objective.p, objective.q};
  const ExactVector d = along(given[answer.side]);
  return answer.backward ? -d : d;
}

// Positive, with which the normals of two opposite half-planes, or of three that turn, sum to zero.
template <class Given>
std::vector<Weight> contradiction(const Given& given, const LinearProgramAnswer& answer) {
  const ExactVector u = normal(given[answer.before]), w = normal(given[answer.after]);
  if (answer.side == no_half_plane) {
    return {{answer.before, magnitude(w.x) + magnitude(w.y)}, {answer.after, magnitude(u.x) + magnitude(u.y)}};
  }
  const ExactVector v = normal(given[answer.side]);
  return {{answer.before, cross(v, w)}, {answer.side, cross(w, u)}, {answer.after, cross(u, v)}};
}

// Positive, with which the normals at the point sum to a positive multiple of the objective.
template <class Given>
std::vector<Weight> bound(const Given& given, const Objective& objective, const LinearProgramAnswer& answer) {
  if (answer.outcome == Optimum::many) return {{answer.side, 1.0}};
  const ExactVector u = normal(given[answer.before]), w = normal(given[answer.after]);
  if (answer.side == no_half_plane) {
    const ExactVector up{objective.p, objective.q};
    return {{answer.before, cross(up, w)}, {answer.after, cross(u, up)}};
  }
  // before and after sum to a multiple of the side's normal, which may be negative: the side makes up for it.
  const ExactVector v = normal(given[answer.side]);
  const Dyadic square = dot(v, v), of_u = cross(v, w), of_w = cross(u, v);
  const Dyadic sum = of_u * dot(u, v) + of_w * dot(w, v);
  return {{answer.before, of_u * square}, {answer.side, magnitude(sum) + square}, {answer.after, of_w * square}};
}

template <class Given>
void write_ends(ClaimsWriter& file, const Given& given, const LinearProgramAnswer& answer) {
  file.begin_claim("ends");
  file.begin_list("ends");
  for (const std::uint32_t end : {answer.before, answer.after}) {
    if (end == no_half_plane) {
      file.add_null();
      continue;
    }
    const ExactPoint2 p = end == answer.before ? exact_corner(given[end], given[answer.side])
                                               : exact_corner(given[answer.side], given[end]);
    file.add_fractions_and_index(std::array{p.x, p.y}, p.denominator, end);
  }
  file.end_list();
  file.end_claim();
}

}  // namespace

template <class Given>
void write_statement(ClaimsWriter& file, const Given& given, const Objective& objective,
                     const LinearProgramAnswer& answer) {
  write_half_planes(file, given);
  file.begin_statement("linear_program");
  file.doubles("objective", std::array{objective.p, objective.q});
  file.text("verdict", name_of(answer.outcome));
  if (answer.feasible()) {
    const ExactPoint2 p = point_of(given, answer);
    file.fractions("point", std::array{p.x, p.y}, p.denominator);
  }
  file.begin_claims();
  if (answer.feasible()) file.claim("feasible");
  switch (answer.outcome) {
    case Optimum::one: file.weights_claim("bounds_only", bound(given, objective, answer)); break;
    case Optimum::many:
      file.weights_claim("bounds", bound(given, objective, answer));
      write_ends(file, given, answer);
      break;
    case Optimum::all: file.claim("no_objective"); break;
    case Optimum::unbounded: {
      const ExactVector d = direction_of(given, objective, answer);
      file.begin_claim("goes_on");
      file.numbers("direction", std::array{d.x, d.y});
      file.end_claim();
      break;
    }
    case Optimum::infeasible: file.weights_claim("contradict", contradiction(given, answer)); break;
  }
  file.end_statement();
}

template <class Given>
std::string certificate_text(const Given& given, const Objective& objective, const LinearProgramAnswer& answer,
                             const Origin& origin, const Region* region) {
  return claims_text(origin, [&](ClaimsWriter& file) {
    write_statement(file, given, objective, answer);
    if (region != nullptr) write_region_statement(file, given, *region);
  });
}

template std::string certificate_text(const Constraints&, const Objective&, const LinearProgramAnswer&, const Origin&,
                                      const Region*);
template std::string certificate_text(const HalfPlanes&, const Objective&, const LinearProgramAnswer&, const Origin&,
                                      const Region*);

}  // namespace sunder::planar
