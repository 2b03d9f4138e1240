// Seen along the line the body is the hull of points in a plane, and the line is the origin: all vertices, exactly. Slow
// and obvious.
#include <sunder/number/exact_vector.h>
#include <sunder/predicate/coordinates.h>
#include <sunder/solid/line/polyhedron_line_support.h>

#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::solid {

namespace {

struct Seen {
  Dyadic x, y;
};

Sign turn_from(const Seen& u, const Seen& w) { return (u.x * w.y - u.y * w.x).sign(); }
bool is_origin(const Seen& u) { return u.x.sign() == Sign::zero && u.y.sign() == Sign::zero; }

class SupportScan {
 public:
  SupportScan(const ConvexPolyhedron& body, const Pose& pose, const Line& line) : body_(body) {
    using Exact = Vector3<Dyadic>;
    const Exact a = coordinates<Dyadic>(line.a), d = coordinates<Dyadic>(line.b) - a;
    // Perpendicular to d, and not parallel to each other: (p x q) = d times a positive number.
    const std::size_t axis = d.x.sign() != Sign::zero ? 0 : d.y.sign() != Sign::zero ? 1 : 2;
    const Exact p = axis == 0 ? Exact{-d.y, d.x, 0.0} : axis == 1 ? Exact{0.0, -d.z, d.y} : Exact{d.z, 0.0, -d.x};
    const Exact q = cross(d, p);
    for (const Point3& v : body.vertices()) {
      const Exact x = coordinates<Dyadic>(Posed3{v, &pose.affine(), false}) - a;
      seen_.push_back({dot(p, x), dot(q, x)});
    }
  }

  LineSupport::Evidence evidence() {
    for (std::uint32_t v = 0; v < seen_.size(); ++v) {
      if (!is_origin(seen_[v]) && !take(v)) return SupportNone{};
    }
    const SupportPlane first = plane(*first_, Sign::positive), last = plane(last_, Sign::negative);
    if (turn_from(seen_[*first_], seen_[last_]) == Sign::zero) return SupportOnly{first};
    const std::vector<std::uint32_t> on = on_line();
    if (on.empty()) return SupportApart{first, last};
    return SupportRange{first, last, feature(on)};
  }

 private:
  // The wedge of all points so far, from the first to the last, which turns to the left by at most half a turn. False:
  // the origin is inside of their hull.
  bool take(std::uint32_t v) {
    if (!first_) {
      first_ = last_ = v;
      return true;
    }
    const Seen &u = seen_[*first_], &w = seen_[last_], &p = seen_[v];
    const Sign from_first = turn_from(u, p), from_last = turn_from(w, p), width = turn_from(u, w);
    if (width == Sign::zero) {
      const bool is_half_turn = (u.x * w.x + u.y * w.y).sign() == Sign::negative;
      if (from_first == Sign::zero) {
        if (!is_half_turn && (u.x * p.x + u.y * p.y).sign() == Sign::negative) last_ = v;
        return true;
      }
      if (!is_half_turn) {
        (from_first == Sign::positive ? last_ : *first_) = v;
        return true;
      }
      if (from_first == Sign::negative) {
        if (is_filled_) return false;
        std::swap(*first_, last_);
      }
      is_filled_ = true;
      return true;
    }
    if (from_first != Sign::negative && from_last != Sign::positive) return true;  // within
    if (from_first == Sign::negative && from_last == Sign::positive) return false;
    is_filled_ = true;  // if this makes it half a turn
    (from_last == Sign::positive ? last_ : *first_) = v;
    return true;
  }

  std::vector<std::uint32_t> on_line() const {
    std::vector<std::uint32_t> found;
    for (std::uint32_t v = 0; v < seen_.size(); ++v) {
      if (is_origin(seen_[v])) found.push_back(v);
    }
    return found;
  }

  SupportPlane plane(std::uint32_t v, Sign side) const {
    std::vector<std::uint32_t> touched;
    for (std::uint32_t w = 0; w < seen_.size(); ++w) {
      if (turn_from(seen_[v], seen_[w]) == Sign::zero) touched.push_back(w);
    }
    return {v, feature(touched), side};
  }

  // By its vertices, in order.
  CutFeature feature(const std::vector<std::uint32_t>& vertices) const {
    if (vertices.size() == 1) return {CutPlace::vertex, vertices[0], 0};
    if (vertices.size() == 2) return {CutPlace::edge, vertices[0], vertices[1]};
    for (std::uint32_t f = 0; f < body_.facet_count(); ++f) {
      const std::span<const std::uint32_t> cycle = body_.facet(f);
      if (std::is_permutation(cycle.begin(), cycle.end(), vertices.begin(), vertices.end())) {
        return {CutPlace::facet, f, 0};
      }
    }
    return {CutPlace::inside, 0, 0};
  }

  const ConvexPolyhedron& body_;
  std::vector<Seen> seen_;
  std::optional<std::uint32_t> first_;
  std::uint32_t last_ = 0;
  bool is_filled_ = false;  // the wedge is known to be left of the first
};

}  // namespace

LineSupport polyhedron_line_support_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Line& line) {
  LineSupport answer{SupportScan(body, pose, line).evidence(), DecidedBy::scan, {}};
  answer.cost.probes = body.vertices().size();
  return answer;
}

}  // namespace sunder::solid
