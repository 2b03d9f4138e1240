// Algorithm IHL: a plane T through the line, and the section Q of the body by T, an implicit polygon. IGL finds where Q
// is furthest to both sides of the line: beyond it, or not, and in the first case the two sides of Q that it crosses.
// Each side of Q is in a facet: these are what is proposed.
#include <sunder/solid/line/polyhedron_line.h>
#include <sunder/solid/line/polyhedron_line_answer.h>
#include <sunder/solid/line/polyhedron_ray.h>
#include <sunder/solid/line/polyhedron_segment.h>
#include <sunder/solid/represent/drums.h>
#include <sunder/solid/represent/facet_graph.h>
#include <sunder/solid/represent/of.h>
#include <sunder/solid/section/scaled_pose.h>
#include <sunder/solid/section/section_search.h>

#include <algorithm>
#include <cmath>
#include <span>

namespace sunder::solid {

namespace {

// The line is where two linear forms are zero: T's, which is as upright as can be, and one that tells sides.
template <class Real>
struct LineForms {
  LinearForm<Real> t, g;
  Point3 along;  // the line's direction, as the drums see it
};

template <class Real>
VectorOf<Real> mixed(const Real& x, const VectorOf<Real>& u, const Real& y, const VectorOf<Real>& v) {
  return {x * u.x + y * v.x, x * u.y + y * v.y, x * u.z + y * v.z};
}

template <class Real>
LineForms<Real> forms_of(const Placed& body, const DrumSearch& search, const Line& line) {
  const Drums& drums = search.drums();
  const ScaledPose m(body.pose, drums.shrink());
  const VectorOf<Real> d = m.way<Real>(line.a, line.b);
  const VectorOf<Real> away = m.way_to_image<Real>(line.a, search.vertex(drums.vertex_of(0)));
  const Point3 size = rounded(d);
  const double x = std::fabs(size.x), y = std::fabs(size.y), z = std::fabs(size.z);
  const Real to_one_of_d(scale_to_one(std::max({x, y, z})));
  // Two normals perpendicular to the line: their numbers are those of d.
  const Real none(0), dx = d.x * to_one_of_d, dy = d.y * to_one_of_d, dz = d.z * to_one_of_d;
  const VectorOf<Real> about_x{none, dz, -dy}, about_y{-dz, none, dx}, about_z{dy, -dx, none};
  // u x v is d times its greatest component.
  const bool by_x = x >= y && x >= z, by_y = !by_x && y >= z;
  const auto& u = by_x ? about_y : by_y ? about_z : about_x;
  const auto& v = by_x ? about_z : by_y ? about_x : about_y;
  const double greatest_of_d = by_x ? size.x : by_y ? size.y : size.z;
  const LinearForm<Real> of_u = m.form<Real>(u, away), of_v = m.form<Real>(v, away);
  // g: what of the two is most nearly upright as a direction of measuring; T: the mix that is perpendicular to it.
  const Point3 p = rounded(of_u.normal), q = rounded(of_v.normal), &up = drums.up();
  const double pp = dot(p, p), pq = dot(p, q), qq = dot(q, q), up_p = dot(up, p), up_q = dot(up, q);
  double of_p = up_p * qq - up_q * pq, of_q = up_q * pp - up_p * pq;
  if (!(std::fabs(of_p) + std::fabs(of_q) > 0)) of_p = 1, of_q = 0;
  const double by = 1 / std::max(std::fabs(of_p), std::fabs(of_q));
  of_p *= by, of_q *= by;
  const Point3 upright = mixed<double>(of_p, p, of_q, q);
  double t_p = dot(upright, q), t_q = -dot(upright, p);
  const double t_by = 1 / std::max(std::fabs(t_p), std::fabs(t_q));
  t_p *= t_by, t_q *= t_by;
  const auto mix = [&](double x_of_u, double x_of_v) {
    return LinearForm<Real>{mixed<Real>(Real(x_of_u), of_u.normal, Real(x_of_v), of_v.normal),
                            Real(x_of_u) * of_u.at_base + Real(x_of_v) * of_v.at_base};
  };
  LineForms<Real> forms{mix(t_p, t_q), mix(of_p, of_q), {}};
  const bool is_turned = (greatest_of_d < 0) != ((t_p * of_q - t_q * of_p < 0) != m.reflects());
  forms.along = cross(rounded(forms.t.normal), rounded(forms.g.normal));
  if (is_turned) forms.along = negated(forms.along);
  return forms;
}

template <class Real>
LinearForm<Real> negated_form(const LinearForm<Real>& form) {
  return {{-form.normal.x, -form.normal.y, -form.normal.z}, -form.at_base};
}

class LineByDrums {
 public:
  LineByDrums(const Placed& body, const Drums& drums, const Line& line, Cost& cost)
      : body_(body), drums_(drums), search_(drums, body.body.vertices(), cost), line_(line) {}

  template <class Real, class Holds>
  bool propose(const Holds& holds) const {
    const LineForms<Real> forms = forms_of<Real>(body_, search_, line_);
    SectionSearch<Real> section(search_, forms.t);
    // IHP: is there a vertex on the other side of T?
    const std::uint32_t first = drums_.vertex_of(0);
    const bool starts_above = section.value_at(forms.t, first) > Real(0);
    const auto is_beyond = [&](std::uint32_t v) {
      const Real value = section.value_at(forms.t, v);
      return starts_above ? !(value > Real(0)) : !(value < Real(0));
    };
    const std::uint32_t beyond =
        search_.furthest_vertex<Real>(starts_above ? negated(forms.t.normal) : forms.t.normal, is_beyond);
    if (!is_beyond(beyond)) {
      const Point3 normal = rounded(forms.t.normal);
      return beside(beyond, starts_above ? negated(normal) : normal, forms.along, holds);
    }
    section.find_corners(beyond);
    const Point3 g = rounded(forms.g.normal);
    const auto high = section.furthest(g), low = section.furthest(negated(g));
    const auto apart_at = [&](const auto& place) {
      return holds(
          sorted(LineProposal::Claim::apart, section.facet_before(place), section.facet_after(place), forms.along));
    };
    if (section.value(forms.g, high) < Real(0)) return apart_at(high);
    if (section.value(forms.g, low) > Real(0)) return apart_at(low);
    return holds(sorted(LineProposal::Claim::through, section.crossed(forms.g, low, high),
                        section.crossed(negated_form(forms.g), high, low), forms.along));
  }

 private:
  // By facets through which the line comes from outside, and those through which it does not.
  LineProposal sorted(LineProposal::Claim claim, std::uint32_t f, std::uint32_t g, const Point3& along) const {
    const bool f_enters = dot(drums_.normal(f), along) < dot(drums_.normal(g), along);
    return {claim, f_enters ? f : g, f_enters ? g : f};
  }

  // Vertex v is nearest to T, along T's normal: so the normals of the facets at v go round it. Seen along the line, two
  // edges at v are the body's outline; the line is beyond one of them, or both.
  template <class Holds>
  bool beside(std::uint32_t v, const Point3& normal, const Point3& along, const Holds& holds) const {
    const FacetGraph& graph = represent::of<FacetGraph>(body_.body);
    const std::span<const std::uint32_t> around = body_.body.neighbours(v);
    const auto n = static_cast<std::uint32_t>(around.size());
    const auto facet = [&](std::uint32_t k) { return graph.edge(v, around[k % n])->facet; };
    const Point3 across = cross(normal, along);
    for (const Point3& outward : {across, negated(across)}) {
      const std::uint32_t k = first_past(n, normal, outward, [&](std::uint32_t i) { return drums_.normal(facet(i)); });
      if (holds(sorted(LineProposal::Claim::apart, facet(k + n - 1), facet(k), along))) return true;
    }
    return false;
  }

  const Placed& body_;
  const Drums& drums_;
  DrumSearch search_;
  const Line& line_;
};

PolyhedronCut cut_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b,
                           OwnEnds ends) {
  return cut_by(body, pose, a, b, ends, [](const Placed& placed, const Line& line, const auto& holds, Cost& cost) {
    const LineByDrums method(placed, represent::of<Drums>(placed.body), line, cost);
    return method.propose<double>(holds) || method.propose<DoubleDouble>(holds);
  });
}

}  // namespace

PolyhedronCut polyhedron_line_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  return cut_by_drums(body, pose, line.a, line.b, {});
}

PolyhedronCut polyhedron_ray_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Ray& ray) {
  return cut_by_drums(body, pose, ray.a, ray.b, {.a = true, .b = false});
}

PolyhedronCut polyhedron_segment_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Segment& segment) {
  return cut_by_drums(body, pose, segment.a, segment.b, {.a = true, .b = true});
}

}  // namespace sunder::solid
