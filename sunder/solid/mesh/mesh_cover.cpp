#include <sunder/base/contract.h>
#include <sunder/base/interruption.h>
#include <sunder/number/interval.h>
#include <sunder/number/root.h>
#include <sunder/predicate/point/along.h>
#include <sunder/predicate/point/further_by.h>
#include <sunder/predicate/point/orient.h>
#include <sunder/solid/exact/exact_gjk.h>
#include <sunder/solid/exact/sweep_simplex.h>
#include <sunder/solid/mesh/mesh_cover.h>
#include <sunder/solid/mesh/mesh_point.h>
#include <sunder/solid/mesh/placed_mesh.h>
#include <sunder/solid/object/convex_polyhedron.h>
#include <sunder/solid/search/gjk.h>
#include <sunder/solid/search/search_vector.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

namespace sunder::solid {

namespace {

// What the walk knows of a mesh: the images of its points, rounded and times a power of two, for searches.
struct Searched {
  Searched(const PlacedMesh& of, double scale) : placed(of), seen_(of.mesh().points().size(), 0) {
    const auto& [m, t] = *of.at(0u).pose;
    for (const Point3& p : of.mesh().points()) {
      const auto row = [&](std::size_t r) {
        return (m[3 * r] * p.x + m[3 * r + 1] * p.y + m[3 * r + 2] * p.z + t[r]) * scale;
      };
      images.push_back({row(0), row(1), row(2)});
    }
  }

  // The corners of triangles, each once.
  std::vector<std::uint32_t> corners_of(const TriangleRange& range) {
    ++round_;
    std::vector<std::uint32_t> corners;
    for (std::uint32_t t = range.first; t < range.end; ++t) {
      for (const std::uint32_t corner : placed.mesh().triangles()[t]) {
        if (std::exchange(seen_[corner], round_) != round_) corners.push_back(corner);
      }
    }
    return corners;
  }

  const PlacedMesh& placed;
  std::vector<Point3> images;

 private:
  std::vector<std::uint32_t> seen_;  // in which round a corner was seen last
  std::uint32_t round_ = 0;
};

// Triangles that follow each other, down to single ones.
struct Part {
  TriangleRange triangles;
  std::size_t node = 0;  // of the tree; 0: less than a leaf
  Box3 box{};            // holds it in the world

  static Part of_node(const PlacedMesh& of, std::size_t node) {
    return {of.mesh().tree().triangles(node), node, of.node_box(node)};
  }

  bool is_node(const PlacedMesh& of) const { return node != 0 && !of.mesh().tree().is_leaf(node); }

  std::array<Part, 2> halves(const PlacedMesh& of) const {
    if (is_node(of)) return {of_node(of, 2 * node), of_node(of, 2 * node + 1)};
    const std::uint32_t middle = triangles.first + triangles.size() / 2;
    std::array<Part, 2> result{Part{{triangles.first, middle}}, Part{{middle, triangles.end}}};
    for (Part& half : result) {
      half.box = of.box(half.triangles.first);
      for (std::uint32_t t = half.triangles.first + 1; t < half.triangles.end; ++t)
        half.box = hull(half.box, of.box(t));
    }
    return result;
  }
};

// How both meshes move, up to the first contact, or to the end.
class Motion {
 public:
  Motion(const Mesh& mesh_a, const Translation& way_a, const Mesh& mesh_b, const Translation& way_b,
         const SweepContact* contact)
      : of_a(way_a), of_b(way_b), end_a(mesh_a, way_a.end()), end_b(mesh_b, way_b.end()), first(contact) {
    const Interval time = contact != nullptr ? contact->time.enclosure() : Interval(1);
    for (std::size_t c = 0; c < 3; ++c) {
      const auto at = [c](const Pose& pose) { return Interval(pose.affine().translation[c]); };
      path_[c] = ((at(of_b.end()) - at(of_b.begin())) - (at(of_a.end()) - at(of_a.begin()))) * time;
    }
  }

  // How B moves as seen from A: in an interval, and rounded.
  const Interval& path(std::size_t axis) const { return path_[axis]; }
  Point3 rounded_path() const {
    const auto middle = [](const Interval& x) { return x.low / 2 + x.high / 2; };
    return {middle(path_[0]), middle(path_[1]), middle(path_[2])};
  }

  // Does B's first corner along a direction come strictly behind A's last one at the end, or weakly at the contact?
  // Requires that it is strictly behind it at time 0. Of each its place at time 0, and at the end.
  bool stay_parted(const WorldDirection& direction, const std::array<Posed3, 2>& last,
                   const std::array<Posed3, 2>& first_of_b) const {
    const Sign at_end = compare_along(direction, last[1], first_of_b[1]);
    if (at_end == Sign::positive || first == nullptr) return at_end == Sign::positive;
    const Vector3<Dyadic> d = direction.exact();
    const auto gap = [&](std::size_t k) {
      return dot(d, coordinates<Dyadic>(first_of_b[k]) - coordinates<Dyadic>(last[k]));
    };
    const auto& [time, over] = first->time;
    return (gap(0) * (over - time) + gap(1) * time).sign() != Sign::negative;
  }

  const Translation &of_a, &of_b;
  const PlacedMesh end_a, end_b;
  const SweepContact* const first;

 private:
  std::array<Interval, 3> path_;
};

// The support of the hulls of some points for the search of Gilbert, Johnson and Keerthi (gjk.h): all are looked at. Where
// B moves by `path`, of the difference and what that is moved by.
class CornersSupport {
 public:
  using Vector = Point3;
  using Vertex = DifferenceVertex;

  CornersSupport(const Searched& a, const Searched& b, const std::vector<std::uint32_t>& of_a,
                 const std::vector<std::uint32_t>& of_b, const Point3& path)
      : a_(a), b_(b), of_a_(of_a), of_b_(of_b), path_(path) {}

  double scale = 1;

  Vector first_direction() const {
    const Vector d = difference(b_.images[of_b_.front()], a_.images[of_a_.front()]);
    return dot(d, d) > 0 ? d : Vector{1, 0, 0};
  }
  Vertex furthest(const Vector& d, const DifferenceSimplex&, Cost&) const {
    Vertex w = of_vertices(extreme(a_, of_a_, d), extreme(b_, of_b_, {-d.x, -d.y, -d.z}));
    if (dot(d, path_) < 0) w.at = difference(w.at, path_);
    return w;
  }
  static bool are_same(const Vertex& v, const Vertex& w) { return (v.a == w.a) & (v.b == w.b) & (v.at == w.at); }
  static double noise(const Vector& d, const Vertex& w) {
    return 0x1p-44 * (std::fabs(d.x * w.at.x) + std::fabs(d.y * w.at.y) + std::fabs(d.z * w.at.z));
  }
  double noise2(const Vertex& v) const {
    const Point3 &p = a_.images[v.a], &q = b_.images[v.b];
    return 0x1p-92 * (dot(p, p) + dot(q, q) + dot(path_, path_));
  }
  static bool is_coarse() { return false; }
  static void refine() {}

 private:
  static Vector difference(const Point3& p, const Point3& q) { return {p.x - q.x, p.y - q.y, p.z - q.z}; }
  static std::uint32_t extreme(const Searched& of, const std::vector<std::uint32_t>& corners, const Vector& d) {
    return *std::max_element(corners.begin(), corners.end(), [&](std::uint32_t i, std::uint32_t j) {
      return dot(d, of.images[i]) < dot(d, of.images[j]);
    });
  }
  Vertex of_vertices(std::uint32_t a, std::uint32_t b) const { return {difference(a_.images[a], b_.images[b]), a, b}; }

  const Searched &a_, &b_;
  const std::vector<std::uint32_t>&of_a_, &of_b_;
  Point3 path_;
};

class Covering {
 public:
  // motion: null where both rest; then `width` is of no width.
  Covering(const PlacedMesh& a, const PlacedMesh& b, double scale, const CoverWidth& width,
           const Motion* motion = nullptr)
      : a_(a, scale),
        b_(b, scale),
        width_(width),
        way_(width.way),
        motion_(motion),
        is_wide_(width.squared.numerator.sign() != Sign::zero) {
    if (motion != nullptr) {
      const Point3 path = motion->rounded_path();
      path_ = {path.x * scale, path.y * scale, path.z * scale};
    }
    if (is_wide_) {
      const auto [low, high] = root(width.squared);
      wide_ = high;
      about_ = low * scale * (1 - 0x1p-30);
    }
    outside_a_.resize(a.mesh().pieces().size());
    outside_b_.resize(b.mesh().pieces().size());
  }

  MeshCover run() {
    std::vector<std::array<Part, 2>> waiting{{Part::of_node(a_.placed, 1), Part::of_node(b_.placed, 1)}};
    while (!waiting.empty()) {
      may_be_interrupted(1);
      const auto [of_a, of_b] = waiting.back();
      waiting.pop_back();
      if (auto direction = direction_between(of_a, of_b)) {
        cover_.cuts.push_back(0);
        cover_.directions.push_back(*std::move(direction));
        tell_outside(a_, of_a, b_, of_b, outside_a_);
        tell_outside(b_, of_b, a_, of_a, outside_b_);
        continue;
      }
      const bool is_a = cuts_a(of_a, of_b);
      const auto halves = (is_a ? of_a : of_b).halves((is_a ? a_ : b_).placed);
      const std::int64_t cut = halves[1].triangles.first;
      cover_.cuts.push_back(is_a ? cut : -cut);
      for (const std::size_t k : {1u, 0u}) {
        waiting.push_back(is_a ? std::array{halves[k], of_b} : std::array{of_a, halves[k]});
      }
    }
    cover_.rays_a = rays(a_.placed, outside_a_, b_.placed);
    cover_.rays_b = rays(b_.placed, outside_b_, a_.placed);
    return std::move(cover_);
  }

  // Both meshes are one, which is where it is.
  MeshSelfCover run_with_itself() {
    MeshSelfCover cover;
    std::vector<std::array<Part, 2>> waiting{{Part::of_node(a_.placed, 1), Part::of_node(a_.placed, 1)}};
    while (!waiting.empty()) {
      may_be_interrupted(1);
      const auto [of_a, of_b] = waiting.back();
      waiting.pop_back();
      const bool are_single = of_a.triangles.size() == 1 && of_b.triangles.size() == 1;
      if (of_a.triangles.first == of_b.triangles.first) {
        if (are_single) continue;
        const auto halves = of_a.halves(a_.placed);
        cover.cuts.push_back(halves[1].triangles.first);
        waiting.insert(waiting.end(), {{halves[1], halves[1]}, {halves[0], halves[1]}, {halves[0], halves[0]}});
        continue;
      }
      const bool share = share_corner(of_a.triangles, of_b.triangles);
      if (share && are_single) continue;
      if (auto direction = share ? std::nullopt : direction_between(of_a, of_b)) {
        cover.cuts.push_back(0);
        cover.directions.push_back(*std::move(direction));
        continue;
      }
      SUNDER_REQUIRE(!are_single);
      const bool is_a = cuts_a(of_a, of_b);
      const auto halves = (is_a ? of_a : of_b).halves(a_.placed);
      const std::int64_t cut = halves[1].triangles.first;
      cover.cuts.push_back(is_a ? cut : -cut);
      for (const std::size_t k : {1u, 0u}) {
        waiting.push_back(is_a ? std::array{halves[k], of_b} : std::array{of_a, halves[k]});
      }
    }
    return cover;
  }

 private:
  bool share_corner(const TriangleRange& s, const TriangleRange& t) {
    corners_a_ = a_.corners_of(s);
    corners_b_ = b_.corners_of(t);
    std::sort(corners_a_.begin(), corners_a_.end());
    return std::any_of(corners_b_.begin(), corners_b_.end(), [&](std::uint32_t corner) {
      return std::binary_search(corners_a_.begin(), corners_a_.end(), corner);
    });
  }

  // Is A's part the one to cut? The larger one, down to leaves; then the one of more triangles.
  bool cuts_a(const Part& of_a, const Part& of_b) const {
    const bool node_a = of_a.is_node(a_.placed), node_b = of_b.is_node(b_.placed);
    if (node_a != node_b) return node_a;
    return node_a ? longest_side(of_a.box) >= longest_side(of_b.box) : of_a.triangles.size() >= of_b.triangles.size();
  }

  std::optional<std::array<Dyadic, 3>> direction_between(const Part& of_a, const Part& of_b) {
    for (std::size_t c = 0; c < 3; ++c) {
      const Interval path = motion_ != nullptr ? hull_with_zero(motion_->path(c)) : Interval();
      const Interval of_b_c = Interval(of_b.box.low[c], of_b.box.high[c]) + path;
      const bool is_up = is_behind(of_b_c.low, of_a.box.high[c]);
      if (!is_up && !is_behind(of_a.box.low[c], of_b_c.high)) continue;
      std::array<Dyadic, 3> axis;
      axis[c] = is_up ? 1.0 : -1.0;
      return axis;
    }
    corners_a_ = a_.corners_of(of_a.triangles);
    corners_b_ = b_.corners_of(of_b.triangles);
    Gjk<double, CornersSupport> search(a_, b_, corners_a_, corners_b_, path_);
    search.begin({});
    Cost cost;
    std::optional<std::array<Dyadic, 3>> found;
    search.run({.steps = 60, .in_vain = 4}, cost, [&](const DifferenceVertex& w) {
      const double gap = search.gap_at(w);
      return gap > 0 && gap * gap >= about_ * about_ * dot(search.direction, search.direction) &&
             (found = in_doubles(search.direction));
    });
    if (found) return found;
    if (way_ && search.distance2 >= about_ * about_ && (found = shortened(*way_))) return found;
    if (of_a.is_node(a_.placed) || of_b.is_node(b_.placed)) return std::nullopt;
    return motion_ != nullptr ? exactly_on_the_way() : exactly(search.simplex);
  }

  static Interval hull_with_zero(const Interval& x) { return {std::min(x.low, 0.0), std::max(x.high, 0.0)}; }

  // The direction, if it parts the corners.
  std::optional<std::array<Dyadic, 3>> in_doubles(Point3 d) {
    if (!make_tame(d) || !parts(WorldDirection(d))) return std::nullopt;
    return std::array<Dyadic, 3>{d.x, d.y, d.z};
  }

  bool parts(const WorldDirection& direction) {
    const std::uint32_t last_a = extreme(a_, corners_a_, direction, Sign::positive, corners_a_.front()),
                        first_b = extreme(b_, corners_b_, direction, Sign::negative, corners_b_.front());
    const Posed3 last = a_.placed.at(last_a), first = b_.placed.at(first_b);
    if (!is_wide_) {
      return compare_along(direction, last, first) == Sign::positive &&
             (motion_ == nullptr ||
              motion_->stay_parted(direction, {last, motion_->end_a.at(last_a)}, {first, motion_->end_b.at(first_b)}));
    }
    return is_further_by(direction, last, first, width_.squared);
  }

  // From `from` on, the corner that is furthest along the direction, or least far: `from`, where none is beyond it.
  static std::uint32_t extreme(const Searched& of, const std::vector<std::uint32_t>& corners,
                               const WorldDirection& direction, Sign beyond, std::uint32_t from) {
    const Posed3 any = of.placed.at(0u);
    Along along(direction, *any.pose, any.tame);
    const std::span<const Point3> points = of.placed.mesh().points();
    for (const std::uint32_t v : corners) {
      if (along.compare(points[from], points[v]) == beyond) from = v;
    }
    return from;
  }

  // What begins at `low` along an axis, behind what ends at `high`?
  bool is_behind(double low, double high) const {
    return high < low && (!is_wide_ || std::nextafter(low - high, 0.0) >= wide_);
  }

  // By the linear program of sweep_simplex.h, of few corners. Its direction of the first contact parts them before, and at
  // that time weakly; so it will do, if that is not before what is asked.
  std::optional<std::array<Dyadic, 3>> exactly_on_the_way() {
    const auto hull_of = [](const Searched& of, const std::vector<std::uint32_t>& corners) {
      std::vector<Point3> points;
      for (const std::uint32_t corner : corners) points.push_back(of.placed.mesh().points()[corner]);
      return ConvexPolyhedron(points);
    };
    const ConvexPolyhedron of_a = hull_of(a_, corners_a_), of_b = hull_of(b_, corners_b_);
    Cost cost;
    StageTally tally;
    const SweepOutcome outcome =
        decide_by_sweep_simplex(of_a, motion_->of_a, of_b, motion_->of_b,
                                motion_->first != nullptr ? SweepTime::first : SweepTime::any, 0, 0, cost, tally);
    const auto& [x, y, z] = outcome.contact ? outcome.contact->direction : outcome.direction;
    if (x.sign() == Sign::zero && y.sign() == Sign::zero && z.sign() == Sign::zero) return std::nullopt;
    std::optional<std::array<Dyadic, 3>> found = shortened({x, y, z});
    if (found) way_ = {(*found)[0], (*found)[1], (*found)[2]};
    return found;
  }

  // The exact search, of few corners. Nothing where their hulls meet, or are not that far apart.
  std::optional<std::array<Dyadic, 3>> exactly(const DifferenceSimplex& simplex) {
    ExactNearest nearest;
    join(nearest, {corners_a_.front(), corners_b_.front()});
    if (simplex.count > 0) {
      nearest = {};
      for (std::size_t k = 0; k < static_cast<std::size_t>(std::min(simplex.count, 3)); ++k) {
        join(nearest, {simplex.vertex[k].a, simplex.vertex[k].b});
      }
    }
    std::uint32_t ways = 0;
    if (!exact_gjk(*this, nearest, ways)) return std::nullopt;
    return shortened(nearest.closest.way.way);
  }

 public:
  // As the support of that search.
  std::array<std::uint32_t, 2> extreme(const ExactNearest& nearest) const {
    const WorldDirection direction(nearest.closest.way.way);
    return {extreme(a_, corners_a_, direction, Sign::positive, nearest.of_a()),
            extreme(b_, corners_b_, direction, Sign::negative, nearest.of_b())};
  }
  void join(ExactNearest& nearest, const std::array<std::uint32_t, 2>& next) const {
    if (!nearest.a.has(next[0])) nearest.a.add(next[0], coordinates<Dyadic>(a_.placed.at(next[0])));
    if (!nearest.b.has(next[1])) nearest.b.add(next[1], coordinates<Dyadic>(b_.placed.at(next[1])));
  }

 private:
  // The direction, if it parts the corners, in as few digits as will do: as doubles, as sums of two, or as it is.
  std::optional<std::array<Dyadic, 3>> shortened(const Vector3<Dyadic>& d) {
    std::int64_t top = std::numeric_limits<std::int64_t>::min();
    for (const Dyadic* x : {&d.x, &d.y, &d.z}) {
      if (x->sign() != Sign::zero) top = std::max(top, x->top());
    }
    const std::array<Dyadic, 3> exact{d.x.scaled(-top), d.y.scaled(-top), d.z.scaled(-top)};
    const Point3 once{exact[0].nearest(), exact[1].nearest(), exact[2].nearest()};
    if (auto found = in_doubles(once)) return found;
    std::array<Dyadic, 3> twice;
    for (std::size_t c = 0; c < 3; ++c) twice[c] = Dyadic(once[c]) + Dyadic((exact[c] - Dyadic(once[c])).nearest());
    for (const auto& tried : {twice, exact}) {
      if (parts(WorldDirection(Vector3<Dyadic>{tried[0], tried[1], tried[2]}))) return tried;
    }
    return std::nullopt;
  }

  // Marks the pieces in `part` as outside of the other mesh, if `other_part` is the whole of that.
  static void tell_outside(const Searched& of, const Part& part, const Searched& other, const Part& other_part,
                           std::vector<bool>& outside) {
    if (other_part.triangles.size() < other.placed.mesh().triangles().size()) return;
    for (std::uint32_t t = part.triangles.first; t < part.triangles.end; ++t) {
      outside[of.placed.mesh().piece_of(t)] = true;
    }
  }

  static std::vector<MeshCover::Ray> rays(const PlacedMesh& of, const std::vector<bool>& outside,
                                          const PlacedMesh& other) {
    std::vector<MeshCover::Ray> result;
    if (!other.mesh().has_inside()) return result;
    for (std::size_t k = 0; k < outside.size(); ++k) {
      if (outside[k]) continue;
      const std::uint32_t first = of.mesh().pieces()[k].first;
      result.push_back({first, ray_away(other, of.at(of.mesh().triangles()[first][0])).along});
    }
    return result;
  }

  Searched a_, b_;
  const CoverWidth& width_;
  std::optional<Vector3<Dyadic>>
      way_;  // may do for many parts: that given, or, of a motion, the last one found exactly
  const Motion* motion_;
  Point3 path_{};  // of B as seen from A, in units of the search
  bool is_wide_;
  double wide_ = 0, about_ = 0;                       // not less than the width; not more, in units of the search
  std::vector<std::uint32_t> corners_a_, corners_b_;  // of the pair that is looked at
  std::vector<bool> outside_a_, outside_b_;           // of each piece
  MeshCover cover_;
};

}  // namespace

std::optional<MeshSelfCover> mesh_self_cover(const Mesh& mesh) {
  const std::span<const Point3> points = mesh.points();
  for (const Mesh::Triangle& t : mesh.triangles()) {
    if (are_collinear(points[t[0]], points[t[1]], points[t[2]])) return std::nullopt;
  }
  const Pose here;
  const PlacedMesh placed(mesh, here);
  return Covering(placed, placed, scale_to_one(placed.at(0u).reach), {}).run_with_itself();
}

MeshCover mesh_cover(const Mesh& a, const Pose& pose_a, const Mesh& b, const Pose& pose_b, const CoverWidth& width) {
  const PlacedMesh placed_a(a, pose_a), placed_b(b, pose_b);
  const double scale = scale_to_one(std::max(placed_a.at(0u).reach, placed_b.at(0u).reach));
  return Covering(placed_a, placed_b, scale, width).run();
}

MeshCover mesh_cover_on_the_way(const Mesh& a, const Translation& of_a, const Mesh& b, const Translation& of_b,
                                const SweepContact* first) {
  const PlacedMesh placed_a(a, of_a.begin()), placed_b(b, of_b.begin());
  const Motion motion(a, of_a, b, of_b, first);
  const double scale = scale_to_one(
      std::max({placed_a.at(0u).reach, placed_b.at(0u).reach, motion.end_a.at(0u).reach, motion.end_b.at(0u).reach}));
  CoverWidth width;
  if (first != nullptr) width.way = {first->direction[0], first->direction[1], first->direction[2]};
  return Covering(placed_a, placed_b, scale, width, &motion).run();
}

}  // namespace sunder::solid
