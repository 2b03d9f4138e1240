#include <sunder/base/contract.h>
#include <sunder/number/dyadic.h>
#include <sunder/number/vector.h>
#include <sunder/solid/object/hull_claims.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <map>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

using Exact = Vector3<Dyadic>;

// A triangle of a facet: its first corner, this one and the next.
struct Home {
  std::uint32_t facet = 0, corner = 1;
};

// Points seen from the mean of the hull's vertices, as many times as far from it as there are of these.
class FromMean {
 public:
  explicit FromMean(const ConvexPolyhedron& hull) : count_(static_cast<double>(hull.vertices().size())) {
    for (const Point3& p : hull.vertices()) sum_ = {sum_.x + p.x, sum_.y + p.y, sum_.z + p.z};
  }

  Exact operator()(const Point3& p) const {
    return {count_ * p.x - sum_.x, count_ * p.y - sum_.y, count_ * p.z - sum_.z};
  }

 private:
  Dyadic count_;
  Exact sum_;
};

// The facets of a body, to look up behind which of them a point is.
class Facets {
 public:
  explicit Facets(const ConvexPolyhedron& hull) : hull_(hull), from_mean_(hull) {
    std::int64_t top = 0;
    bool is_first = true;
    for (const Point3& p : hull.vertices()) {
      at_.push_back(from_mean_(p));
      for (const Dyadic* x : {&at_.back().x, &at_.back().y, &at_.back().z}) {
        if (x->sign() == Sign::zero) continue;
        top = is_first ? x->top() : std::max(top, x->top());
        is_first = false;
      }
    }
    scale_ = -top;
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> facet_of;
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      const auto face = hull.facet(f);
      for (std::size_t c = 0; c < face.size(); ++c) facet_of[{face[c], face[c + 1 < face.size() ? c + 1 : 0]}] = f;
    }
    for (std::uint32_t f = 0; f < hull.facet_count(); ++f) {
      const auto face = hull.facet(f);
      across_.emplace_back();
      for (std::size_t c = 0; c < face.size(); ++c) {
        across_.back().push_back(facet_of.at({face[c + 1 < face.size() ? c + 1 : 0], face[c]}));
      }
      polar_.push_back(polar(face));
    }
  }

  // The triangle of a facet behind which a point of the body is, seen from the mean.
  Home home_of(const Point3& point) {
    const Exact p = from_mean_(point);
    last_ = propose({rounded(p.x), rounded(p.y), rounded(p.z)}, last_);
    for (std::uint32_t k = 0; k < 4 * hull_.facet_count(); ++k) {
      const Look look = look_at(last_, p);
      if (look.home) return *look.home;
      last_ = look.next;
    }
    for (last_ = 0; last_ < hull_.facet_count(); ++last_) {
      if (const Look look = look_at(last_, p); look.home) return *look.home;
    }
    SUNDER_REQUIRE(last_ < hull_.facet_count());  // the point is in the hull
    last_ = 0;
    return {};
  }

 private:
  struct Look {
    std::optional<Home> home;
    std::uint32_t next = 0;  // the facet on the other side of an edge that has the point beyond it
  };

  double rounded(const Dyadic& x) const { return x.scaled(scale_).nearest(); }

  // The normal over the height: of all facets that behind which a point is has the greatest product with it.
  Point3 polar(std::span<const std::uint32_t> face) const {
    const auto corner = [&](std::size_t c) {
      const Exact& p = at_[face[c]];
      return Vector3<double>{rounded(p.x), rounded(p.y), rounded(p.z)};
    };
    const Vector3<double> p = corner(0), q = corner(1), r = corner(2);
    const Vector3<double> u{q.x - p.x, q.y - p.y, q.z - p.z}, v{r.x - p.x, r.y - p.y, r.z - p.z};
    const Vector3<double> n{u.y * v.z - u.z * v.y, u.z * v.x - u.x * v.z, u.x * v.y - u.y * v.x};
    const double height = n.x * p.x + n.y * p.y + n.z * p.z;
    return height > 0 ? Point3{n.x / height, n.y / height, n.z / height} : Point3{};
  }

  std::uint32_t propose(const Point3& p, std::uint32_t from) const {
    const auto product = [&](std::uint32_t f) { return polar_[f].x * p.x + polar_[f].y * p.y + polar_[f].z * p.z; };
    for (double best = product(from);;) {
      const std::uint32_t here = from;
      for (const std::uint32_t f : across_[here]) {
        if (const double other = product(f); other > best) {
          best = other;
          from = f;
        }
      }
      if (from == here) return here;
    }
  }

  Look look_at(std::uint32_t f, const Exact& p) const {
    const auto face = hull_.facet(f);
    const std::size_t last = face.size() - 1;
    const auto side = [&](std::size_t c, std::size_t d) { return dot(cross(at_[face[c]], at_[face[d]]), p).sign(); };
    if (side(0, 1) == Sign::negative) return {std::nullopt, across_[f][0]};
    if (side(last, 0) == Sign::negative) return {std::nullopt, across_[f][last]};
    std::size_t c = 1;  // the last one but one from which on the point is
    for (std::size_t end = last; end - c > 1;) {
      const std::size_t middle = c + (end - c) / 2;
      (side(0, middle) == Sign::negative ? end : c) = middle;
    }
    if (side(c, c + 1) == Sign::negative) return {std::nullopt, across_[f][c]};
    return {Home{f, static_cast<std::uint32_t>(c)}, f};
  }

  const ConvexPolyhedron& hull_;
  const FromMean from_mean_;
  std::vector<Exact> at_;                           // vertices
  std::int64_t scale_ = 0;                          // times two to this, coordinates are about 1
  std::vector<std::vector<std::uint32_t>> across_;  // of each edge of each facet, the facet on the other side
  std::vector<Point3> polar_;
  std::uint32_t last_ = 0;
};

// A flat hull, to look up between which two corners and the mean a point is.
class Outline {
 public:
  explicit Outline(const ConvexPolyhedron& hull) : from_mean_(hull) {
    const auto ring = hull.facet(0);
    const Exact p = from_mean_(hull.vertices()[ring[0]]), q = from_mean_(hull.vertices()[ring[1]]);
    const Exact normal = cross(p, q);
    const std::array<Sign, 3> signs{normal.x.sign(), normal.y.sign(), normal.z.sign()};
    axis_ = static_cast<std::size_t>(std::find_if(signs.begin(), signs.end(), [](Sign s) { return s != Sign::zero; }) -
                                     signs.begin());
    is_turned_ = signs[axis_] == Sign::negative;
    for (const std::uint32_t k : ring) corners_.push_back(seen(hull.vertices()[k]));
  }

  std::uint32_t sector_of(const Point3& point) const {
    const Vector2<Dyadic> p = seen(point);
    const auto next = std::partition_point(corners_.begin() + 1, corners_.end(),
                                           [&](const Vector2<Dyadic>& corner) { return !is_before(p, corner); });
    return static_cast<std::uint32_t>(next - corners_.begin() - 1);
  }

 private:
  // Without one coordinate, so that corners go counter-clockwise.
  Vector2<Dyadic> seen(const Point3& point) const {
    const Exact p = from_mean_(point);
    const std::array<const Dyadic*, 3> all{&p.x, &p.y, &p.z};
    const std::size_t i = (axis_ + 1) % 3, j = (axis_ + 2) % 3;
    return is_turned_ ? Vector2<Dyadic>{*all[j], *all[i]} : Vector2<Dyadic>{*all[i], *all[j]};
  }

  // Less than half a turn from the first corner, or none?
  bool is_upper(const Vector2<Dyadic>& p) const {
    const Sign turn = cross(corners_[0], p).sign();
    return turn == Sign::positive || (turn == Sign::zero && dot(corners_[0], p).sign() != Sign::negative);
  }

  // Does p come before q, going round from the first corner?
  bool is_before(const Vector2<Dyadic>& p, const Vector2<Dyadic>& q) const {
    const bool p_upper = is_upper(p), q_upper = is_upper(q);
    return p_upper == q_upper ? cross(p, q).sign() == Sign::positive : p_upper;
  }

  const FromMean from_mean_;
  std::size_t axis_ = 0;
  bool is_turned_ = false;
  std::vector<Vector2<Dyadic>> corners_;
};

// The points of a certificate's body, of which source[v] is vertex v of the hull.
struct Named {
  std::span<const Point3> points;
  std::span<const std::uint32_t> source;

  std::vector<std::uint32_t> corners(const ConvexPolyhedron& hull, std::uint32_t facet) const {
    std::vector<std::uint32_t> named;
    for (const std::uint32_t v : hull.facet(facet)) named.push_back(source[v]);
    return named;
  }
};

void write_surface(ClaimsWriter& file, const Named& names, const ConvexPolyhedron& hull,
                   const std::vector<bool>& is_vertex) {
  file.begin_list("faces");
  for (std::uint32_t f = 0; f < hull.facet_count(); ++f) file.add_list(names.corners(hull, f));
  file.end_list();
  file.begin_claims();
  file.begin_claim("surface");
  file.begin_list("homes");
  std::optional<Facets> facets;  // made for the first point that is no vertex
  for (std::size_t k = 0; k < names.points.size(); ++k) {
    if (is_vertex[k]) {
      file.add_null();
    } else {
      if (!facets) facets.emplace(hull);
      const Home home = facets->home_of(names.points[k]);
      file.add_list(std::array{home.facet, home.corner});
    }
  }
  file.end_list();
  file.end_claim();
}

void write_outline(ClaimsWriter& file, const Named& names, const ConvexPolyhedron& hull,
                   const std::vector<bool>& is_vertex) {
  file.indices("outline", names.corners(hull, 0));
  file.begin_claims();
  file.begin_claim("outline");
  file.begin_list("sectors");
  const Outline outline(hull);
  for (std::size_t k = 0; k < names.points.size(); ++k) {
    is_vertex[k] ? file.add_null() : file.add_index(outline.sector_of(names.points[k]));
  }
  file.end_list();
  file.end_claim();
}

void write_statement(ClaimsWriter& file, const Named& names, const ConvexPolyhedron& hull) {
  std::vector<bool> is_vertex(names.points.size());
  for (const std::uint32_t k : names.source) is_vertex[k] = true;
  constexpr std::array<const char*, 4> verdicts{"point", "segment", "flat", "solid"};
  file.begin_statement("hull");
  file.index("body", 0);
  file.text("verdict", verdicts[static_cast<std::size_t>(hull.dimension())]);
  if (hull.dimension() == 3) {
    write_surface(file, names, hull, is_vertex);
  } else if (hull.dimension() == 2) {
    write_outline(file, names, hull, is_vertex);
  } else {
    if (hull.dimension() == 1) {
      file.index("i", names.source[0]);
      file.index("j", names.source[1]);
    }
    file.begin_claims();
    file.begin_claim(hull.dimension() == 1 ? "between" : "one_point");
    file.end_claim();
  }
  file.end_statement();
}

}  // namespace

void write_hull_of_vertices(ClaimsWriter& file, const ConvexPolyhedron& hull) {
  std::vector<std::uint32_t> all(hull.vertices().size());
  std::iota(all.begin(), all.end(), 0u);
  write_statement(file, {hull.vertices(), all}, hull);
}

void write_hull(ClaimsWriter& file, const std::string& name, std::span<const Point3> points,
                const ConvexPolyhedron& hull) {
  file.begin_table("bodies");
  file.begin_entry();
  file.text("name", name);
  file.begin_list("points");
  for (const Point3& p : points) file.add_row(std::array{p.x, p.y, p.z});
  file.end_list();
  file.end_entry();
  file.end_table();
  write_statement(file, {points, hull.source()}, hull);
}

}  // namespace sunder::solid
