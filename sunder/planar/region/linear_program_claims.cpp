#include <sunder/certificate/claims.h>
#include <sunder/planar/region/linear_program_claims.h>
#include <sunder/planar/region/regions_claims.h>
#include <sunder/predicate/coordinates.h>

#include <array>
#include <variant>
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
ExactVector direction_of(const Given& given, const Objective& objective, const NoBound& far) {
  if (far.side == no_half_plane) return {objective.p, objective.q};
  const ExactVector d = along(given[far.side]);
  return far.backward ? -d : d;
}

// Positive, with which the normals of two opposite half-planes, or of three that turn, sum to zero.
template <class Given>
std::vector<Weight> contradiction(const Given& given, const NoPoint& no_point) {
  const ExactVector u = normal(given[no_point.before]), w = normal(given[no_point.after]);
  if (no_point.side == no_half_plane) {
    return {{no_point.before, magnitude(w.x) + magnitude(w.y)}, {no_point.after, magnitude(u.x) + magnitude(u.y)}};
  }
  const ExactVector v = normal(given[no_point.side]);
  return {{no_point.before, cross(v, w)}, {no_point.side, cross(w, u)}, {no_point.after, cross(u, v)}};
}

// Positive, with which the normals at the point sum to a positive multiple of the objective.
template <class Given>
std::vector<Weight> bound(const Given& given, const Objective& objective, const OneOptimum& one) {
  const ExactVector u = normal(given[one.before]), w = normal(given[one.after]);
  if (one.side == no_half_plane) {
    const ExactVector up{objective.p, objective.q};
    return {{one.before, cross(up, w)}, {one.after, cross(u, up)}};
  }
  // before and after sum to a multiple of the side's normal, which may be negative: the side makes up for it.
  const ExactVector v = normal(given[one.side]);
  const Dyadic square = dot(v, v), of_u = cross(v, w), of_w = cross(u, v);
  const Dyadic sum = of_u * dot(u, v) + of_w * dot(w, v);
  return {{one.before, of_u * square}, {one.side, magnitude(sum) + square}, {one.after, of_w * square}};
}

template <class Given>
void write_ends(ClaimsWriter& file, const Given& given, const ManyOptima& many) {
  file.begin_claim("ends");
  file.begin_list("ends");
  for (const std::uint32_t end : {many.before, many.after}) {
    if (end == no_half_plane) {
      file.add_null();
      continue;
    }
    const ExactPoint2 p =
        end == many.before ? exact_corner(given[end], given[many.side]) : exact_corner(given[many.side], given[end]);
    file.add_fractions_and_index(std::array{p.x, p.y}, p.denominator, end);
  }
  file.end_list();
  file.end_claim();
}

template <class Given>
void write_claims(ClaimsWriter& file, const Given& given, const Objective& objective, const OneOptimum& one) {
  file.weights_claim("bounds_only", bound(given, objective, one));
}
template <class Given>
void write_claims(ClaimsWriter& file, const Given& given, const Objective&, const ManyOptima& many) {
  file.weights_claim("bounds", std::array{Weight{many.side, 1.0}});
  write_ends(file, given, many);
}
template <class Given>
void write_claims(ClaimsWriter& file, const Given&, const Objective&, const AnyPoint&) {
  file.claim("no_objective");
}
template <class Given>
void write_claims(ClaimsWriter& file, const Given& given, const Objective& objective, const NoBound& far) {
  const ExactVector d = direction_of(given, objective, far);
  file.begin_claim("goes_on");
  file.numbers("direction", std::array{d.x, d.y});
  file.end_claim();
}
template <class Given>
void write_claims(ClaimsWriter& file, const Given& given, const Objective&, const NoPoint& no_point) {
  file.weights_claim("contradict", contradiction(given, no_point));
}

}  // namespace

template <class Given>
void write_statement(ClaimsWriter& file, const Given& given, const Objective& objective,
                     const LinearProgramAnswer& answer) {
  write_half_planes(file, given);
  file.begin_statement("linear_program");
  file.doubles("objective", std::array{objective.p, objective.q});
  file.text("verdict", name_of(answer.verdict()));
  if (is_feasible(answer)) {
    const ExactPoint2 p = point_of(given, answer);
    file.fractions("point", std::array{p.x, p.y}, p.denominator);
  }
  file.begin_claims();
  if (is_feasible(answer)) file.claim("feasible");
  std::visit([&](const auto& held) { write_claims(file, given, objective, held); }, answer.evidence);
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
