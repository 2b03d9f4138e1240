// Numbers are as seen from the origin. A vertex of the polar is y = n / h, h > 0; a point x / w has w > 0. So y.x <= 1,
// "y is in rho_0(x)", is the sign of h w - n.x.
#include <sunder/base/contract.h>
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/represent/polar_lemmas.h>

#include <algorithm>
#include <numeric>

namespace sunder::solid {

namespace {

using Arrow = Vector3<Dyadic>;

struct LemmaTally {
  PolarLemma lemma;
  void expect(bool is_so) {
    ++lemma.checked;
    lemma.holds = lemma.holds && is_so;
  }
};

class PolarShow {
 public:
  PolarShow(const ConvexPolyhedron& body, const PolarAbout& polar, std::uint64_t most)
      : body_(body), polar_(polar), most_(std::max<std::uint64_t>(most, 1)) {
    const Point3& o = polar.origin;
    for (const Point3& v : body.vertices()) {
      points_.push_back({Dyadic(v.x) - Dyadic(o.x), Dyadic(v.y) - Dyadic(o.y), Dyadic(v.z) - Dyadic(o.z)});
    }
    for (const PolarVertex& y : polar.vertices) normals_.push_back({y.n[0], y.n[1], y.n[2]});
  }

  PolarLemma lemma_31() const {
    LemmaTally tally{{"Lemma 3.1",
                      "vertices, and points twice as far from the origin, are on, within or beyond a "
                      "facet's plane as its polar is about theirs"}};
    each_pair(tally, 2, [&](std::uint32_t v, std::uint32_t f) {
      const auto facet = body_.facet(f);
      const auto at = [&](std::size_t k) -> const Point3& { return body_.vertices()[facet[k]]; };
      const Sign beyond = orient_3d(at(0), at(1), at(2), body_.vertices()[v]);
      tally.expect(side(f, points_[v]) == -beyond);
      const Arrow twice = sum(points_[v], points_[v]);
      const Arrow &a = points_[facet[0]], &b = points_[facet[1]], &c = points_[facet[2]];
      tally.expect(side(f, twice) == -dot(cross(b - a, c - a), twice - a).sign());
    });
    return tally.lemma;
  }

  PolarLemma lemma_32() const {
    LemmaTally tally{{"Lemma 3.2",
                      "the planes of the polar's facets have the body's vertices as polars: the polar of "
                      "the polar is the body"}};
    each(tally, points_.size(), 1, [&](std::uint32_t v) {
      const std::uint32_t* cycle = &polar_.facet_vertices[polar_.facet_begin[v]];
      const std::uint32_t size = polar_.facet_begin[v + 1] - polar_.facet_begin[v];
      const Arrow &n0 = normals_[cycle[0]], &n1 = normals_[cycle[1]], &n2 = normals_[cycle[2]];
      const Dyadic determinant = dot(n0, cross(n1, n2));  // x.y_k = 1 for k = 0, 1, 2, by Cramer's rule
      const Arrow x = sum(sum(times(h(cycle[0]), cross(n1, n2)), times(h(cycle[1]), cross(n2, n0))),
                          times(h(cycle[2]), cross(n0, n1)));
      tally.expect(determinant.sign() != Sign::zero && is_zero(x - times(determinant, points_[v])));
      for (std::uint32_t k = 3; k < size; ++k) tally.expect(side(cycle[k], points_[v]) == Sign::zero);
    });
    return tally.lemma;
  }

  PolarLemma lemma_33() const {
    LemmaTally tally{{"Lemma 3.3",
                      "vertices of the polar, and points half and twice as far from the origin, are in "
                      "the polar, by its facets, where the body is within the point's half-space, by its "
                      "vertex that is furthest"}};
    each(tally, normals_.size(), 3 * points_.size(), [&](std::uint32_t f) {
      const Dyadic furthest = dot(normals_[f], points_[furthest_along(normals_[f])]);
      for (const double factor : {0.5, 1.0, 2.0}) {
        const Arrow n = times(Dyadic(factor), normals_[f]);
        const bool is_in_polar = std::none_of(points_.begin(), points_.end(), [&](const Arrow& v) {
          ++tally.lemma.checked;
          return (h(f) - dot(n, v)).sign() == Sign::negative;
        });
        tally.expect(is_in_polar == ((h(f) - Dyadic(factor) * furthest).sign() != Sign::negative));
        tally.expect(is_in_polar == (factor <= 1));
      }
    });
    return tally.lemma;
  }

  PolarLemma lemma_34() const {
    LemmaTally tally{{"Lemma 3.4",
                      "the polar is within the half-spaces of vertices and of middles of edges, which are "
                      "points of the body"}};
    each_pair(tally, 2, [&](std::uint32_t v, std::uint32_t f) {
      tally.expect(side(f, points_[v]) != Sign::negative);
      const Arrow edge = sum(points_[v], points_[body_.neighbours(v)[0]]);
      tally.expect(side(f, edge, 2) != Sign::negative);
    });
    return tally.lemma;
  }

  PolarLemma lemma_35() const {
    LemmaTally tally{{"Lemma 3.5",
                      "planes that are tangent to the polar at a vertex have polars on the boundary of the "
                      "body: means of its facets' vertices"}};
    each(tally, normals_.size(), normals_.size(), [&](std::uint32_t f) {
      const auto facet = body_.facet(f);
      const Arrow d = sum_of(f);  // the plane of all y with d.y = d.y_f; its polar is d / (d.y_f)
      const Dyadic along = dot(normals_[f], d);
      for (std::uint32_t g = 0; g < normals_.size(); ++g) {  // tangent: d.y_g <= d.y_f
        tally.expect((along * h(g) - dot(normals_[g], d) * h(f)).sign() != Sign::negative);
      }
      tally.expect(along == Dyadic(static_cast<double>(facet.size())) * h(f));  // so the polar is the mean
    });
    return tally.lemma;
  }

  PolarLemma lemma_36() const {
    LemmaTally tally{{"Lemma 3.6",
                      "the polar is within that of the means of the body's facets, whose hull is within "
                      "the body, and not within that of the body twice as large, which is within it"}};
    each(tally, normals_.size(), normals_.size(), [&](std::uint32_t f) {
      const auto facet = body_.facet(f);
      const Arrow mean = sum_of(f);
      const Dyadic size = static_cast<double>(facet.size());
      for (std::uint32_t g = 0; g < normals_.size(); ++g)
        tally.expect((size * h(g) - dot(normals_[g], mean)).sign() != Sign::negative);
      for (const std::uint32_t v : facet) {
        const Arrow twice = sum(points_[v], points_[v]);
        tally.expect(side(f, twice) == Sign::negative);  // y_f is not in rho_0(2 P)
        // y_f / 2 is:
        tally.expect((h(f).scaled(1) - dot(normals_[f], twice)).sign() == Sign::zero);
      }
    });
    return tally.lemma;
  }

  // P moved by t, t / 2 and 2 t, where t takes its lowest vertex along a facet's normal to a vertex of the facet: the
  // first touches P in that vertex, the second has the middle of both vertices in common with P, the third is beyond
  // the facet. Let Q be the polar, so that rho_0(Q) = P. Where x is common, rho(x) parts: Q is within rho_0(x), and
  // what is polar to the moved P is beyond, as x is one of its points. Where the third is beyond the facet, y_f is a
  // point of Q and inside of rho_inf of the third, so no plane parts these.
  PolarLemma theorem_37() const {
    LemmaTally tally{{"Theorem 3.7",
                      "the body, moved until it touches, overlaps or is beyond a facet, meets the body "
                      "where a plane parts its far polar from the polar, and only there"}};
    each(tally, normals_.size(), normals_.size() + points_.size(), [&](std::uint32_t f) {
      const Arrow n = normals_[f];
      const std::uint32_t low = furthest_along({-n.x, -n.y, -n.z}), top = body_.facet(f)[0];
      const Arrow middle = sum(points_[low], points_[top]);
      for (std::uint32_t g = 0; g < normals_.size(); ++g) {
        tally.expect(side(g, points_[top]) != Sign::negative);
        tally.expect(side(g, middle, 2) != Sign::negative);
      }
      const Arrow t = points_[top] - points_[low];
      for (const Arrow& v : points_) tally.expect(side(f, sum(v, sum(t, t))) == Sign::negative);
    });
    return tally.lemma;
  }

 private:
  const Dyadic& h(std::uint32_t f) const { return polar_.vertices[f].h; }

  // Of y_f and x / w: positive where y.x < 1.
  Sign side(std::uint32_t f, const Arrow& x, double w = 1) const {
    return (Dyadic(w) * h(f) - dot(normals_[f], x)).sign();
  }

  Arrow sum_of(std::uint32_t f) const {
    Arrow all{};
    for (const std::uint32_t v : body_.facet(f)) all = sum(all, points_[v]);
    return all;
  }

  // Up the edges, as long as one leads further.
  std::uint32_t furthest_along(const Arrow& d) const {
    std::uint32_t at = 0;
    for (bool goes_on = true; goes_on;) {
      goes_on = false;
      for (const std::uint32_t next : body_.neighbours(at)) {
        if (dot(d, points_[next] - points_[at]).sign() != Sign::positive) continue;
        at = next;
        goes_on = true;
        break;
      }
    }
    return at;
  }

  // visit(i) for some i below n, in equal steps, so that about `most` times `cost` things are visited.
  template <class Visit>
  void each(LemmaTally& tally, std::size_t n, std::size_t cost, const Visit& visit) const {
    const std::uint64_t step = std::max<std::uint64_t>(1, (n * cost + most_ - 1) / most_);
    tally.lemma.there_are = n;
    for (std::uint64_t i = 0; i < n; i += step, ++tally.lemma.of) visit(static_cast<std::uint32_t>(i));
  }

  // The same of pairs of a vertex and a facet; the step shares no divisor with the facets, so that all of them come.
  template <class Visit>
  void each_pair(LemmaTally& tally, std::size_t cost, const Visit& visit) const {
    const std::uint64_t facets = normals_.size(), n = facets * points_.size();
    std::uint64_t step = std::max<std::uint64_t>(1, (n * cost + most_ - 1) / most_);
    while (std::gcd(step, facets) != 1) ++step;
    tally.lemma.there_are = n;
    for (std::uint64_t i = 0; i < n; i += step, ++tally.lemma.of) {
      visit(static_cast<std::uint32_t>(i / facets), static_cast<std::uint32_t>(i % facets));
    }
  }

  const ConvexPolyhedron& body_;
  const PolarAbout& polar_;
  std::uint64_t most_;
  std::vector<Arrow> points_, normals_;
};

}  // namespace

std::vector<PolarLemma> polar_lemmas(const ConvexPolyhedron& body, const PolarAbout& polar, std::uint64_t most) {
  SUNDER_REQUIRE(polar.vertices.size() == body.facet_count());
  const PolarShow show(body, polar, most);
  return {show.lemma_31(), show.lemma_32(), show.lemma_33(),  show.lemma_34(),
          show.lemma_35(), show.lemma_36(), show.theorem_37()};
}

}  // namespace sunder::solid
