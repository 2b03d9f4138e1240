#include <sunder/solid/mesh/mesh_line.h>

#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/solid/mesh/mesh_mesh.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_boxes.h>
#include <sunder/solid/mesh/placed_mesh.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sunder::solid {

namespace {

// The line as images: a + t (b - a) exactly, as the difference of two doubles is the sum of two. Of (t, t, 0); where the
// differences are doubles of (t, u, v), for t + u + v.
class PointsOfLine {
 public:
  explicit PointsOfLine(const LineLike& line)
      : is_line_(std::holds_alternative<Line>(line)), is_segment_(std::holds_alternative<Segment>(line)) {
    std::visit([this](const auto& of) { ends_ = {of.a, of.b}; }, line);
    const auto& [a, b] = ends_;
    for (std::size_t k = 0; k < 3; ++k) {
      const double way = b[k] - a[k], back = way - b[k], rest = (b[k] - (way - back)) - (a[k] + back);  // Knuth
      at_.linear[3 * k] = way;
      at_.linear[3 * k + 1] = rest;
      at_.linear[3 * k + 2] = 0;
      at_.translation[k] = a[k];
      for (std::size_t c = 0; c < 3; ++c) at_sum_.linear[3 * k + c] = way;
      at_sum_.translation[k] = a[k];
      has_rest_ = has_rest_ || rest != 0;
      is_exact_ = is_exact_ && std::isfinite(way) && std::isfinite(rest);
    }
  }

  bool is_line() const { return is_line_; }
  bool is_segment() const { return is_segment_; }
  bool is_exact() const { return is_exact_; }
  const std::array<Point3, 2>& ends() const { return ends_; }
  Posed3 at(double t) const { return {{t, t, 0}, &at_, false}; }
  // At the sum of the three; nothing where two of them are needed and differences are no doubles.
  std::optional<Posed3> at(const Point3& sum) const {
    if (sum.y == 0 && sum.z == 0) return at(sum.x);
    if (has_rest_) return std::nullopt;
    return Posed3{sum, &at_sum_, false};
  }

  // A t up to which the line goes beyond a ball around a point; nothing where that is not known.
  std::optional<double> reach(const Point3& middle, double radius) const {
    const auto& [a, b] = ends_;
    const Point3 way{b.x - a.x, b.y - a.y, b.z - a.z}, to{middle.x - a.x, middle.y - a.y, middle.z - a.z};
    const double length = std::sqrt(dot(way, way)), far = std::sqrt(dot(to, to)) + radius;
    const double t = 2 * far / length;
    if (!is_exact_ || !(length > 0x1p-400) || !(t < 0x1p40)) return std::nullopt;
    return std::max(t, 1.0);
  }

 private:
  bool is_line_, is_segment_, is_exact_ = true, has_rest_ = false;
  std::array<Point3, 2> ends_{};
  Affine3 at_{}, at_sum_{};
};

// A number strictly between the two, as a sum of few doubles, if there is one of three.
std::optional<Point3> between(const ExactFraction& first, const ExactFraction& last) {
  const ExactFraction at = middle(first, last);
  Point3 sum;
  Dyadic left = at.numerator, total;
  for (std::size_t k = 0; k < 3; ++k) {
    sum[k] = nearest_ratio(left, at.denominator);
    if (!std::isfinite(sum[k])) return std::nullopt;
    left = left - Dyadic(sum[k]) * at.denominator;
    total = total + Dyadic(sum[k]);
    const ExactFraction tried{total};
    if (first < tried && tried < last) return sum;
  }
  return std::nullopt;
}

class LineSearch {
 public:
  LineSearch(const Mesh& mesh, const Pose& pose, const LineLike& line)
      : placed_(mesh, pose), line_(line), points_(line) {}

  MeshLine run() {
    const MeshTree& tree = placed_.mesh().tree();
    const Box3 box = placed_.node_box(1);
    const Point3 middle{(box.low.x + box.high.x) / 2, (box.low.y + box.high.y) / 2, (box.low.z + box.high.z) / 2};
    const double radius = longest_side(box);
    const auto reach = points_.is_segment() ? std::optional(1.0) : points_.reach(middle, radius);
    if (!reach || !points_.is_exact() || tree.leaves() == 0) return run_by_scan(DecidedBy::filter);
    const Posed3 from = points_.at(points_.is_line() ? -*reach : 0), to = points_.at(*reach);
    any_triangle_near(placed_, from, to, answer_.cost.probes, [&](std::uint32_t t) {
      ask(t);
      return false;
    });
    return result();
  }

  MeshLine run_by_scan(DecidedBy by = DecidedBy::scan) {
    for (std::uint32_t t = 0; t < placed_.mesh().triangles().size(); ++t) {
      may_be_interrupted(1);
      ++answer_.cost.probes;
      ask(t);
    }
    MeshLine answer = result();
    if (by == DecidedBy::scan) answer.decided_by = by;
    return answer;
  }

 private:
  void ask(std::uint32_t t) {
    const auto& [i, j, k] = placed_.mesh().triangles()[t];
    const std::span<const Point3> points = placed_.mesh().points();
    const ConvexPolyhedron triangle(std::array{points[i], points[j], points[k]});
    const PolyhedronCut cut = polyhedron_line_like(triangle, placed_.pose(), line_);
    ++answer_.cost.iterations;
    answer_.cost.exact += cut.cost.exact;
    const auto ends = ends_of(cut.evidence);
    if (!ends) return;
    const auto along = [&](const CutEnd& end) {
      return exact_end(triangle, placed_.pose(), points_.ends()[0], points_.ends()[1], end).along_line;
    };
    hits_.push_back({t, along(ends->first), along(ends->last)});
  }

  MeshLine result() {
    std::sort(hits_.begin(), hits_.end(), [](const LineHit& p, const LineHit& q) {
      const Sign order = compare(p.first, q.first);
      return order == Sign::zero ? p.triangle < q.triangle : order == Sign::negative;
    });
    find_parts();
    if (!parts_.empty()) answer_.evidence = LineInMesh{std::move(hits_), std::move(parts_)};
    conclude(answer_, answer_.cost.exact);
    return answer_;
  }

  bool is_inside(const Posed3& point) {
    if (!placed_.mesh().has_inside()) return false;
    const MeshPoint found = mesh_point(placed_.mesh(), placed_.pose(), point);
    answer_.cost.probes += found.cost.probes;
    answer_.cost.exact += found.cost.exact;
    return found.place == MeshPlace::inside;
  }

  // Hits in order, and what is between them.
  void find_parts() {
    const ExactFraction zero{Dyadic(0.0)}, one{Dyadic(1.0)};
    if (!points_.is_line() && (hits_.empty() || zero < hits_.front().first) && is_inside(points_.at(0.0))) {
      parts_.push_back({zero, zero, {}, {}, true});
    }
    for (const LineHit& hit : hits_) {
      if (parts_.empty()) {
        parts_.push_back({hit.first, hit.last, hit.triangle, hit.triangle});
        continue;
      }
      LinePart& last = parts_.back();
      if (hit.first <= last.last || goes_on(last, hit.first)) {
        if (last.last < hit.last || !last.leaves) {
          last.last = hit.last;
          last.leaves = hit.triangle;
        }
      } else {
        parts_.push_back({hit.first, hit.last, hit.triangle, hit.triangle});
      }
    }
    if (!points_.is_segment() || parts_.empty() || !(parts_.back().last < one)) return;
    LinePart& last = parts_.back();
    if (!goes_on(last, one)) return;
    last.last = one;
    last.leaves.reset();
  }

  // Is what is between the part and the next hit inside? A part that has no leaving triangle is inside where it ends.
  bool goes_on(LinePart& part, const ExactFraction& next) {
    if (!part.leaves) return true;
    const auto t = between(part.last, next);
    const auto point = t && points_.is_exact() ? points_.at(*t) : std::nullopt;
    if (point) {
      const bool is_in = is_inside(*point);
      part.is_through = part.is_through || is_in;
      return is_in;
    }
    part.is_next_near = placed_.mesh().has_inside();
    return false;
  }

  PlacedMesh placed_;
  const LineLike& line_;
  PointsOfLine points_;
  std::vector<LineHit> hits_;
  std::vector<LinePart> parts_;
  MeshLine answer_;
};

}  // namespace

MeshLine mesh_line(const Mesh& mesh, const Pose& pose, const LineLike& line) {
  SUNDER_REQUIRE(can_be_placed(mesh, pose));
  return LineSearch(mesh, pose, line).run();
}

MeshLine mesh_line_by_scan(const Mesh& mesh, const Pose& pose, const LineLike& line) {
  SUNDER_REQUIRE(can_be_placed(mesh, pose));
  return LineSearch(mesh, pose, line).run_by_scan();
}

}  // namespace sunder::solid
