// The polygons in which planes cut a body that is searched by its drums (IHH), as sequences of vertices with random
// access (section_against.h), in floating point: a slice, and what a plane through a lateral edge cuts of one drum.
// Vertices are means of the body's; they are seen in the scaled world of another body.
#pragma once

#include <sunder/solid/search/drum_search.h>
#include <sunder/solid/search/placed.h>
#include <sunder/solid/section/scaled_pose.h>
#include <sunder/solid/section/section_polygons.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace sunder::solid {

// A point of a body as a mean of its vertices.
template <class Real>
struct Mean {
  std::array<std::uint32_t, 4> vertex{};
  std::array<Real, 4> weight{};
  std::size_t count = 0;

  void add(std::uint32_t v, const Real& w) {
    if (!(w > Real(0)) && !(w < Real(0))) return;
    vertex[count] = v;
    weight[count++] = w;
  }
};

// The point that a mean of a body's vertices is (of kind Mean or Mixture), by where these are.
template <class Real, class Parts, class At>
VectorOf<Real> mean_of(const Parts& parts, const At& at) {
  VectorOf<Real> sum{Real(0), Real(0), Real(0)};
  for (std::size_t i = 0; i < parts.count; ++i) {
    const VectorOf<Real> p = at(parts.vertex[i]);
    const Real& w = parts.weight[i];
    sum = {sum.x + w * p.x, sum.y + w * p.y, sum.z + w * p.z};
  }
  return sum;
}

// Two vertices on whose line a side is.
using LineOfVertices = std::optional<std::array<std::uint32_t, 2>>;

// A body by its drums in the scaled world of another one, where points are counted from `from`.
template <class Real>
class DrumsInWorld {
 public:
  using Vector = VectorOf<Real>;

  // Keeps references to all but the point.
  DrumsInWorld(const DrumSearch& search, const Placed& body, const ScaledPose& world, const Point3& from)
      : search_(search), body_(body), world_(world), from_(from) {}

  const DrumSearch& search() const { return search_; }
  const Drums& drums() const { return search_.drums(); }

  Vector at(std::uint32_t v) const { return world_.way_to_image<Real>(from_, body_.pose, search_.vertex(v)); }
  Vector at(const Mean<Real>& mean) const {
    return mean_of<Real>(mean, [&](std::uint32_t v) { return at(v); });
  }

  // Where an edge passes a slice.
  Mean<Real> corner(const LateralEdge& e, std::uint32_t slice) const {
    const Real up = search_.share_at<Real>(e, slice);
    Mean<Real> mean;
    mean.add(e.low, Real(1) - up);
    mean.add(e.high, up);
    return mean;
  }
  Real value_at(const LinearForm<Real>& g, const LateralEdge& e, std::uint32_t slice) const {
    const Real up = search_.share_at<Real>(e, slice);
    if (!(up > Real(0))) return g.at(search_, e.low);
    const Real low = g.at(search_, e.low);
    return low + (g.at(search_, e.high) - low) * up;
  }
  Real value_at(const LinearForm<Real>& g, const Mean<Real>& mean) const {
    Real sum(0);
    for (std::size_t i = 0; i < mean.count; ++i) sum += mean.weight[i] * g.at(search_, mean.vertex[i]);
    return sum;
  }

  // Between two corners of a slice, where t is zero; t has different signs there, or is zero.
  Mean<Real> crossing(const LinearForm<Real>& t, const LateralEdge& e, const LateralEdge& f,
                      std::uint32_t slice) const {
    const Real part = share_to_zero(value_at(t, e, slice), value_at(t, f, slice));
    Mean<Real> mean;
    for (const auto& [edge, weight] : {std::pair{e, Real(1) - part}, std::pair{f, part}}) {
      const Real up = search_.share_at<Real>(edge, slice);
      mean.add(edge.low, weight * (Real(1) - up));
      mean.add(edge.high, weight * up);
    }
    return mean;
  }
  // Where t is zero on an edge.
  Mean<Real> crossing(const LinearForm<Real>& t, const LateralEdge& e) const {
    const Real part = share_to_zero(t.at(search_, e.low), t.at(search_, e.high));
    Mean<Real> mean;
    mean.add(e.low, Real(1) - part);
    mean.add(e.high, part);
    return mean;
  }

 private:
  const DrumSearch& search_;
  const Placed& body_;
  const ScaledPose& world_;
  Point3 from_;
};

// A slice, from one of the drums beside it: `upper` tells whether it is above that drum.
template <class Real>
class SliceSequence : public RoundedSequence<SliceSequence<Real>, Real> {
 public:
  using Vertex = RoundedPoint<Real>;

  SliceSequence(const DrumsInWorld<Real>& body, std::uint32_t slice, const std::array<std::size_t, 2>& axes,
                bool turned)
      : body_(body), slice_(slice), axes_(axes), turned_(turned) {
    upper_ = slice == body.drums().drum_count();
    drum_ = upper_ ? slice - 1 : slice;
  }

  std::uint32_t size() const { return body_.drums().size(drum_); }

  Vertex point(std::uint32_t k) const {
    const LateralEdge& e = edge(k);
    const auto low = body_.at(e.low), high = body_.at(e.high);
    const Real up = body_.search().template share_at<Real>(e, slice_);
    const double opening = (upper_ ? -1 : 1) / nearest(body_.search().template height<Real>(e.high) -
                                                       body_.search().template height<Real>(e.low));
    const auto on = [&](std::size_t axis) {
      const Real from = axis == 0   ? low.x
                        : axis == 1 ? low.y
                                    : low.z,
                 to = axis == 0   ? high.x
                      : axis == 1 ? high.y
                                  : high.z;
      return std::pair{from + (to - from) * up, nearest(to - from) * opening};
    };
    const auto x = on(axes_[0]), y = on(axes_[1]);
    return {x.first, y.first, x.second, y.second};
  }

  template <class Add>
  void add_parts(std::uint32_t k, const Add& add) const {
    const Mean<Real> mean = body_.corner(edge(k), slice_);
    for (std::size_t i = 0; i < mean.count; ++i) add(mean.vertex[i], mean.weight[i]);
  }

  LineOfVertices line_behind(std::uint32_t k) const {
    const auto v = vertex_at(k), w = vertex_at(k + 1 < size() ? k + 1 : 0);
    if (!v || !w || *v == *w) return std::nullopt;
    return std::array{*v, *w};
  }

 private:
  const LateralEdge& edge(std::uint32_t k) const { return body_.search().edge(drum_, turned_ ? size() - 1 - k : k); }
  std::optional<std::uint32_t> vertex_at(std::uint32_t k) const {
    const LateralEdge& e = edge(k);
    if (e.begin == slice_) return e.low;
    if (e.end == slice_) return e.high;
    return std::nullopt;
  }

  const DrumsInWorld<Real>& body_;
  std::uint32_t slice_, drum_ = 0;
  std::array<std::size_t, 2> axes_;
  bool turned_, upper_ = false;
};

// At most four points, then where lateral edges of a drum cross t, then at most two points.
template <class Real>
struct CutPolygon {
  std::array<Mean<Real>, 4> head{};
  std::size_t head_count = 0;
  std::array<LineOfVertices, 4> line_behind{};  // of sides behind the head's points, but the last
  LineOfVertices line_to_first;                 // of the side that closes the polygon
  std::uint32_t drum = 0, first = 0, run = 0;   // `run` edges: first, first + 1, .. or first, first - 1, ..
  bool forward = true;
  LinearForm<Real> t{};
  std::array<Mean<Real>, 2> tail{};
  std::size_t tail_count = 0;

  void add_head(const Mean<Real>& mean, const LineOfVertices& behind = std::nullopt) {
    head[head_count] = mean;
    line_behind[head_count++] = behind;
  }
  void add_tail(const Mean<Real>& mean) { tail[tail_count++] = mean; }
};

template <class Real>
class CutSequence : public RoundedSequence<CutSequence<Real>, Real> {
 public:
  using Vertex = RoundedPoint<Real>;

  CutSequence(const DrumsInWorld<Real>& body, const CutPolygon<Real>& polygon, const std::array<std::size_t, 2>& axes,
              bool turned)
      : body_(body), polygon_(polygon), axes_(axes), turned_(turned) {
    for (std::size_t k = 0; k < polygon.head_count; ++k) points_[k] = on_axes(polygon.head[k]);
    for (std::size_t k = 0; k < polygon.tail_count; ++k) points_[4 + k] = on_axes(polygon.tail[k]);
  }

  std::uint32_t size() const { return heads() + polygon_.run + static_cast<std::uint32_t>(polygon_.tail_count); }

  Vertex point(std::uint32_t k) const {
    const std::uint32_t i = turned(k);
    if (i < heads()) return points_[i];
    if (i >= heads() + polygon_.run) return points_[4 + i - heads() - polygon_.run];
    return on_axes(mean(i));
  }

  template <class Add>
  void add_parts(std::uint32_t k, const Add& add) const {
    const Mean<Real> m = mean(turned(k));
    for (std::size_t i = 0; i < m.count; ++i) add(m.vertex[i], m.weight[i]);
  }

  LineOfVertices line_behind(std::uint32_t k) const {
    const std::uint32_t i = turned_ ? turned(k + 1 < size() ? k + 1 : 0) : k;  // where the side begins, not turned
    if (i + 1 == size()) return polygon_.line_to_first;
    return i < heads() ? polygon_.line_behind[i] : std::nullopt;
  }

 private:
  std::uint32_t heads() const { return static_cast<std::uint32_t>(polygon_.head_count); }
  std::uint32_t turned(std::uint32_t k) const { return turned_ ? size() - 1 - k : k; }
  Mean<Real> mean(std::uint32_t i) const {
    if (i < heads()) return polygon_.head[i];
    i -= heads();
    if (i >= polygon_.run) return polygon_.tail[i - polygon_.run];
    const std::uint32_t k = polygon_.forward ? polygon_.first + i : polygon_.first - i;
    return body_.crossing(polygon_.t, body_.search().edge(polygon_.drum, k));
  }
  Vertex on_axes(const Mean<Real>& m) const {
    const auto p = body_.at(m);
    const std::array<Real, 3> all{p.x, p.y, p.z};
    return {all[axes_[0]], all[axes_[1]]};
  }

  const DrumsInWorld<Real>& body_;
  const CutPolygon<Real>& polygon_;
  std::array<std::size_t, 2> axes_;
  bool turned_;
  std::array<Vertex, 6> points_{};
};

}  // namespace sunder::solid
