// Two hierarchies, one from inside and one from outside: of P fewer vertices, a smaller body; of R fewer half-spaces, a
// larger one. The walk keeps a reason why what it has of both meet or do not, and each round takes it one level down in
// one of them.
//
// BL15 walks between two spaces, where R is Q, its polar, and half-spaces are points. What they keep is here
//   apart   (the separation invariant)  a plane: no vertex of P so far is beyond it, and R as far as the star of one
//           facet tells is: so P so far does not meet R so far.
//   meet    (the inverse one)  a point of P, in R so far: it lies in the cone from o over the facet that it is nearest
//           to be cut off by. As a direction of the polar space it is a plane, too.
// Apart, P's hierarchy is walked down: the next vertex that comes beyond the plane is p*, and a few points, p* and the
// neighbours it has when it comes, are played against a few half-spaces (matrix_game.h). Either these have another
// plane, or the bodies so far meet, at p*, and R's hierarchy is walked down, where the next facet that cuts the point
// off is q*, and so on. Who has no level left has the answer: of P, they are apart; of R, the point is in both.
//   S1. (The star invariant.) When p* is met, R is on one side of a plane f and P without p* on the other; when q* is,
//       a point y of P is in all half-spaces but q*. So games about stars tell. Let S be the hull of p* and its
//       neighbours, C the cone at p* over it, W the half-spaces of q* and those next to it, K the part of them that is
//       seen from o through the facet q*. What of C is on R's side of f is in S, and K is in R.
//       Back at p*, S does not meet K, so neither does C meet W: were x in both, the way from y to x would pass the
//       facet q*, at a point of K and of C, and as R is on that side of f, of S.
//       Back at q*, C meets W at some x, so S meets K: f is a mixture of W's half-spaces, and the way from y to x
//       passes the facet q* at a point of P on R's side of f.
//   S2. Degrees need no bound, as BL15 4 has it: a game is only about vertices that have just come, with at most
//       most_degree neighbours; a vertex at which the walk just stays may have any number, of which sectors tell the
//       one that matters (hierarchy_walk.h). On bounded hierarchies (bounded_hierarchy.h) all neighbours that come are
//       looked at. There a vertex that was cut off may come with more, on P_1 with any number: a game is about some of
//       them, and a binary search among the others finds one that would change it.
// Rounds: at most one for each level of both. Source: BL15 section 5, Theorem 5.1. Departures: S2; f and y
// are not kept for later games; a plane is kept while a new vertex is only beyond its parallel through the last one,
// and so with points; half-spaces and cones are told apart by games.
#pragma once

#include <sunder/base/cost.h>
#include <sunder/solid/descent/polar_frame.h>
#include <sunder/solid/descent/polar_round.h>
#include <sunder/solid/descent/polar_trees.h>
#include <sunder/solid/search/caratheodory.h>
#include <sunder/solid/search/matrix_game.h>
#include <sunder/solid/search/support.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <optional>

namespace sunder::solid {

namespace polar_walk_detail {

inline constexpr std::size_t most = Hierarchy::most_degree + 1;

template <class T>
class Few {
 public:
  void clear() { size_ = 0; }
  void push_back(const T& x) { of_[size_++] = x; }
  std::size_t size() const { return size_; }
  const T& operator[](std::size_t k) const { return of_[k]; }
  T& operator[](std::size_t k) { return of_[k]; }
  const T* begin() const { return of_.data(); }
  const T* end() const { return of_.data() + size_; }

 private:
  std::array<T, most> of_;
  std::size_t size_ = 0;
};

}  // namespace polar_walk_detail

// P and R in their places; nothing here decides anything. Trees: SectorTrees or BoundedTrees.
template <class Real, class Trees>
class PolarWalk {
 public:
  using Vector = VectorOf<Real>;

  PolarWalk(const Placed& p, const Placed& r, Cost& cost, PolarRounds* rounds)
      : p_(p),
        r_(r),
        frame_(p, r),
        cost_(cost),
        rounds_(rounds),
        facets_(frame_, frame_.polar().hierarchy, cost.probes) {
    if (p.graph.vertices.size() >= 3) vertices_.emplace(p.body, Trees::of(p.body), cost.probes);
  }
  PolarWalk(const PolarWalk&) = delete;
  PolarWalk& operator=(const PolarWalk&) = delete;

  enum class End : std::uint8_t { apart, meet, none };

  // none: floating point contradicts itself.
  End run() {
    top_points();
    walls_.clear();
    for (std::uint32_t q = 0; q < 4; ++q) walls_.push_back(frame_.wall(q));
    if (!play(walls_)) return End::none;
    bool is_apart = game_.value > Real(game_.noise);
    is_apart ? start_at_top_of_p() : start_at_top_of_r();
    record(Space::top, is_apart);
    while (true) {
      if (is_apart) {
        const std::uint32_t w = next_beyond_plane();
        if (w == Hierarchy::none) return End::apart;
        if (!pass_vertex(w, is_apart)) return End::none;
        record(Space::primal, is_apart);
      } else {
        const std::uint32_t w = next_cut();
        if (w == Hierarchy::none) return End::meet;
        if (!pass_facet(w, is_apart)) return End::none;
        record(Space::polar, is_apart);
      }
    }
  }

  // At the end `apart`: from P towards R, in the world's frame; and P's vertex furthest along it.
  Vector direction() const { return frame_.seen_from_world(negated(plane_->n)); }
  std::uint32_t vertex_of_p() const { return vertices_ ? vertices_->node(vertices_->walk.at()).vertex : first_vertex_; }

  // At the end `meet`: the point as a mean of P's vertices, and of R's, and how clearly it is in R.
  const Mixture<Real>& of_p() const { return point_of_p_; }
  Mixture<Real> of_r() const {
    const auto facet = r_.body.facet(facets_.node(facets_.walk.at()).vertex);
    // The triangle of the fan from the first corner that the ray from o through the point passes.
    const auto side = [&](std::size_t k) {  // of the plane through o, the first corner and this one
      return dot(point_, cross(frame_.corner(facet[0]), frame_.corner(facet[k])));
    };
    std::size_t low = 1, high = facet.size() - 1;
    while (high - low > 1) {
      const std::size_t middle = low + (high - low) / 2;
      (side(middle) > Real(0) ? low : high) = middle;
    }
    const std::array<std::uint32_t, 3> corner{facet[0], facet[low], facet[high]};
    const Vector u = frame_.corner(corner[0]), v = frame_.corner(corner[1]), w = frame_.corner(corner[2]);
    const Real scale = Real(1) / dot(u, cross(v, w));
    const std::array<Real, 3> part{dot(point_, cross(v, w)) * scale, dot(point_, cross(w, u)) * scale,
                                   dot(point_, cross(u, v)) * scale};
    Mixture<Real> mixture;
    Real rest = 1;
    for (std::size_t k = 0; k < 3; ++k) {
      const Real positive = part[k] > Real(0) ? part[k] : Real(0);
      mixture.add(corner[k], positive);
      rest -= positive;
    }
    if (rest > Real(0)) {
      for (const std::uint32_t v0 : frame_.polar().base) mixture.add(v0, rest * Real(0.25));
    }
    return mixture;
  }
  bool is_clear() const { return Real(-0x1p-20) > depth_; }

 private:
  using Space = PolarRound::Space;
  static constexpr std::size_t most_rays = Hierarchy::most_degree;
  static constexpr int most_choices = 16;

  struct Column {
    Vector y;
    double w = 1;                        // 0: a direction
    std::uint32_t of = Hierarchy::none;  // the rank, of a body without a hierarchy the vertex; none: a direction

    double scale() const { return HalfSpace<Real>::scale_of(y, w); }
  };

  // --- Games -------------------------------------------------------------------------------------------------------

  bool play(const polar_walk_detail::Few<HalfSpace<Real>>& walls) {
    game_.rows = walls.size();
    game_.columns = columns_.size();
    std::array<double, polar_walk_detail::most> scale;
    for (std::size_t j = 0; j < columns_.size(); ++j) scale[j] = columns_[j].scale();
    for (std::size_t i = 0; i < walls.size(); ++i) {
      const double of_row = walls[i].scale();
      for (std::size_t j = 0; j < columns_.size(); ++j) {
        game_.pay[i][j] = walls[i].pay(columns_[j].y, columns_[j].w, of_row * scale[j]);
      }
    }
    cost_.probes += walls.size() + columns_.size();
    return game_.solve();
  }
  bool is_apart() const { return game_.value > Real(game_.noise); }

  void top_points() {
    columns_.clear();
    if (vertices_) {
      for (std::uint32_t k = 0; k < vertices_->corners(); ++k) columns_.push_back(column_of(k));
    } else {
      const auto points = p_.body.vertices();
      for (std::uint32_t v = 0; v < points.size(); ++v) columns_.push_back({frame_.image(points[v]), 1, v});
    }
  }
  Column column_of(std::uint32_t rank) const {
    const auto& node = vertices_->node(rank);
    const Vector y = frame_.image(node.at);
    return {with_rest(y, vertices_->rest(rank)), 1, rank};
  }
  Vector way_of_p(std::uint32_t from, std::uint32_t to) const {
    const Vector y = frame_.edge(vertices_->node(from).at, vertices_->node(to).at);
    return with_rest(y, minus(vertices_->rest(to), vertices_->rest(from)));
  }
  Vector with_rest(const Vector& y, const Point3& rest) const {
    if (rest == Point3{}) return y;
    const Vector r = frame_.edge({}, rest);
    return {y.x + r.x, y.y + r.y, y.z + r.z};
  }

  // The next game is about the neighbours on the rim of p*, or of q*: about all, or about some of many (chosen_).
  // p* and the ways to its neighbours: all of P so far is in this cone.
  void cone_of(std::uint32_t rank) {
    columns_.clear();
    columns_.push_back(column_of(rank));
    for (const std::uint32_t k : chosen_) {
      columns_.push_back({way_of_p(rank, vertices_->rim(rank, k)), 0, Hierarchy::none});
    }
  }
  // p* and its neighbours.
  void points_about(std::uint32_t rank) {
    columns_.clear();
    columns_.push_back(column_of(rank));
    for (const std::uint32_t k : chosen_) columns_.push_back(column_of(vertices_->rim(rank, k)));
  }
  // q* and its neighbours.
  void walls_about(std::uint32_t rank) {
    walls_.clear();
    walls_.push_back(frame_.wall(rank));
    for (const std::uint32_t k : chosen_) walls_.push_back(frame_.wall(facets_.rim(rank, k)));
  }
  // The cone from o over q*, as far as its neighbours tell, down from q*.
  void cone_over(std::uint32_t rank) {
    cone_.clear();
    cone_.push_back(frame_.wall(rank));
    for (const std::uint32_t k : chosen_) cone_.push_back({frame_.polar_edge(rank, facets_.rim(rank, k)), Real(0)});
  }

  // --- Cones of many rays --------------------------------------------------------------------------------------------

  // Edges at a vertex that was cut off end at its cut points, the corners of a convex polygon. So a game about a few of
  // them is enough if no other one would change it. A search on the polygon finds the one that would change it most.

  void choose(std::size_t rim_size) {
    chosen_.clear();
    const std::size_t few = std::min(rim_size, rim_size > most_rays ? std::size_t{4} : most_rays);
    for (std::size_t k = 0; k < few; ++k) chosen_.push_back(static_cast<std::uint32_t>(k * rim_size / few));
  }

  // is_better(i, j): is corner j further than corner i? On each finer choice of corners the furthest is that of the
  // coarser one or beside it; and a climb from there, for what is uneven where the cycle closes.
  template <class IsBetter>
  std::uint32_t furthest_on_rim(std::size_t size, const IsBetter& is_better) {
    std::size_t step = std::bit_floor(size / 3), best = 0;
    const auto take = [&](std::size_t k) {
      ++cost_.probes;
      if (k == best || !is_better(static_cast<std::uint32_t>(best), static_cast<std::uint32_t>(k))) return false;
      best = k;
      return true;
    };
    for (std::size_t k = step; k < size; k += step) take(k);
    for (step /= 2; step > 0; step /= 2) {
      const std::size_t here = best;
      if (!take((here + step) % size)) take((here + size - step) % size);
    }
    for (std::size_t left = size; left > 0 && (take((best + 1) % size) || take((best + size - 1) % size)); --left) {
    }
    return static_cast<std::uint32_t>(best);
  }

  // Puts a ray in the place of the one that matters least; false: it is one of them.
  template <class Weights>
  bool choose_also(std::uint32_t ray, const Weights& weights) {
    std::size_t least = 0;
    for (std::size_t i = 0; i < chosen_.size(); ++i) {
      if (chosen_[i] == ray) return false;
      if (weights[i + 1] < weights[least + 1]) least = i;
    }
    if (chosen_.size() < most_rays) {
      chosen_.push_back(ray);
    } else {
      chosen_[least] = ray;
    }
    return true;
  }

  // The cone of a vertex against the walls.
  bool play_cone_of(std::uint32_t rank) {
    const std::size_t size = vertices_->rim_size(rank);
    choose(size);
    for (int k = 0; k < most_choices; ++k) {
      cone_of(rank);
      if (!play(walls_)) return false;
      if (size <= most_rays || !is_apart()) return true;
      const HalfSpace<Real> plane = mixture_of_walls();
      const std::uint32_t ray = furthest_on_rim(size, [&](std::uint32_t i, std::uint32_t j) {
        return dot(plane.n, way_of_p(vertices_->rim(rank, i), vertices_->rim(rank, j))) < Real(0);
      });
      const Vector way = way_of_p(rank, vertices_->rim(rank, ray));
      const Real pay = plane.pay(way, 0, plane.scale() * HalfSpace<Real>::scale_of(way, 0));
      if (!(pay < Real(-game_.noise)) || !choose_also(ray, game_.column_weight)) return true;
    }
    return false;
  }
  // The points so far against the cone over a facet.
  bool play_cone_over(std::uint32_t rank) {
    const std::size_t size = facets_.rim_size(rank);
    choose(size);
    for (int k = 0; k < most_choices; ++k) {
      cone_over(rank);
      if (!play(cone_)) return false;
      if (size <= most_rays || is_apart()) return true;
      const Vector y = mixture_of_points();
      const std::uint32_t ray = furthest_on_rim(size, [&](std::uint32_t i, std::uint32_t j) {
        return dot(y, frame_.polar_edge(facets_.rim(rank, i), facets_.rim(rank, j))) > Real(0);
      });
      const HalfSpace<Real> side{frame_.polar_edge(rank, facets_.rim(rank, ray)), Real(0)};
      if (!(side.pay(y) > Real(game_.noise)) || !choose_also(ray, game_.row_weight)) return true;
    }
    return false;
  }

  // --- What the games leave ----------------------------------------------------------------------------------------

  // The half-space that all of R so far is in and P is not: the mixture of the walls.
  HalfSpace<Real> mixture_of_walls() const {
    HalfSpace<Real> sum{{Real(0), Real(0), Real(0)}, Real(0)};
    for (std::size_t i = 0; i < walls_.size(); ++i) {
      const HalfSpace<Real>& wall = walls_[i];
      const Real part = scaled(game_.row_weight[i], wall.scale());
      sum.n = {sum.n.x + wall.n.x * part, sum.n.y + wall.n.y * part, sum.n.z + wall.n.z * part};
      sum.h += wall.h * part;
    }
    return sum;
  }
  void take_plane() {
    plane_ = mixture_of_walls();
    if (vertices_) vertices_->compare.turn_to(frame_.seen_from_p(negated(plane_->n)));
  }
  void start_at_top_of_p() {
    take_plane();
    if (vertices_) {
      vertices_->walk.start();
      return;
    }
    first_vertex_ = 0;
    for (std::uint32_t v = 1; v < columns_.size(); ++v) {
      if (dot(plane_->n, minus(columns_[v].y, columns_[first_vertex_].y)) < Real(0)) first_vertex_ = v;
    }
  }

  // The mixture of the points: of five at most, as payments have rank four and the game shifts them.
  Vector mixture_of_points(Mixture<Real>* names = nullptr) const {
    Vector y{Real(0), Real(0), Real(0)};
    Real total = 0;
    std::array<Real, polar_walk_detail::most> part;
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      part[j] = scaled(game_.column_weight[j], columns_[j].scale());
      total += part[j];
    }
    for (std::size_t j = 0; j < columns_.size(); ++j) {
      part[j] = part[j] / total;
      if (!(part[j] > Real(0))) continue;
      const Column& c = columns_[j];
      y = {y.x + c.y.x * part[j], y.y + c.y.y * part[j], y.z + c.y.z * part[j]};
      if (names == nullptr) continue;
      if (vertices_) {
        vertices_->add_to(*names, c.of, part[j]);
      } else {
        names->add(c.of, part[j]);
      }
    }
    return y;
  }
  void take_point() {
    point_of_p_ = {};
    point_ = mixture_of_points(&point_of_p_);
    depth_ = game_.value;
    facets_.compare.turn_to(point_);
  }
  void start_at_top_of_r() {
    take_point();
    facets_.walk.start();
  }

  // --- Rounds ------------------------------------------------------------------------------------------------------

  std::uint32_t next_beyond_plane() {
    if (!vertices_) return Hierarchy::none;
    auto& walk = vertices_->walk;
    for (std::uint32_t w = walk.next(); w != Hierarchy::none; w = walk.next()) {
      ++cost_.iterations;
      last_vertex_ = w;
      if (!walk.is_further(w)) {
        walk.pass(w);
      } else if (plane_->pay(column_of(w).y) > Real(game_.noise)) {
        walk.go_to(w);
      } else {
        return w;
      }
    }
    return Hierarchy::none;
  }
  std::uint32_t next_cut() {
    auto& walk = facets_.walk;
    for (std::uint32_t w = walk.next(); w != Hierarchy::none; w = walk.next()) {
      ++cost_.iterations;
      last_facet_ = w;
      if (!walk.is_further(w)) {
        walk.pass(w);
      } else if (!(frame_.wall(w).pay(point_) > Real(game_.noise))) {
        walk.go_to(w);
      } else {
        return w;
      }
    }
    return Hierarchy::none;
  }

  // p* comes beyond the plane.
  bool pass_vertex(std::uint32_t w, bool& is_apart_now) {
    if (!play_cone_of(w)) return false;
    if (is_apart()) {
      take_plane();
      vertices_->walk.go_to(w);
      return true;
    }
    p_star_ = w;
    points_about(w);
    is_apart_now = false;
    if (q_star_ == Hierarchy::none) {
      if (!play(walls_) || is_apart()) return false;
      start_at_top_of_r();
      return true;
    }
    return settle(false, is_apart_now);
  }

  // q* cuts the point off.
  bool pass_facet(std::uint32_t w, bool& is_apart_now) {
    if (!play_cone_over(w)) return false;
    if (!is_apart()) {
      take_point();
      facets_.walk.go_to(w);
      return true;
    }
    q_star_ = w;
    walls_about(w);
    is_apart_now = true;
    if (p_star_ == Hierarchy::none) {
      if (!play(walls_) || !is_apart()) return false;  // P is what it was at the top
      start_at_top_of_p();
      return true;
    }
    return settle(true, is_apart_now);
  }

  // Back at p* with the walls of q*, or at q* with the points of p*. One game tells (S1), where both have few
  // neighbours; of many some were chosen, and what is chosen for one may have to be chosen anew for the other.
  bool settle(bool at_p, bool& is_apart_now) {
    const bool is_one_game = vertices_->rim_size(p_star_) <= most_rays && facets_.rim_size(q_star_) <= most_rays;
    for (int k = 0; k < (is_one_game ? 1 : most_choices); ++k, at_p = !at_p) {
      if (at_p) {
        if (!play_cone_of(p_star_)) return false;
        if (is_apart()) {
          take_plane();
          vertices_->walk.go_to(p_star_);
          is_apart_now = true;
          return true;
        }
        points_about(p_star_);
      } else {
        if (!play_cone_over(q_star_)) return false;
        if (!is_apart()) {
          take_point();
          facets_.walk.go_to(q_star_);
          is_apart_now = false;
          return true;
        }
        walls_about(q_star_);
      }
    }
    return false;
  }

  void record(Space space, bool is_apart_now) {
    if (rounds_ == nullptr) return;
    const Vector at = is_apart_now ? negated(plane_->n) : point_;
    rounds_->push_back({space, is_apart_now, vertex_of_p(), facets_.node(facets_.walk.at()).vertex,
                        vertices_ ? vertices_->level_of(last_vertex_) : 0, facets_.level_of(last_facet_), rounded(at)});
  }

  const Placed& p_;
  const Placed& r_;
  PolarFrame<Real, typename Trees::Polar> frame_;
  Cost& cost_;
  PolarRounds* rounds_;
  std::optional<typename Trees::template Vertices<Real>> vertices_;  // none: P is a point or a segment
  typename Trees::template Facets<Real> facets_;

  MatrixGame<Real, polar_walk_detail::most> game_;
  polar_walk_detail::Few<Column> columns_;                // P as the games see it
  polar_walk_detail::Few<HalfSpace<Real>> walls_, cone_;  // R; and what of the point is in
  polar_walk_detail::Few<std::uint32_t> chosen_;          // places on a rim

  std::uint32_t last_vertex_ = 0, last_facet_ = 0;  // how far down the walks are
  std::uint32_t p_star_ = Hierarchy::none, q_star_ = Hierarchy::none;
  std::optional<HalfSpace<Real>> plane_;
  Vector point_{};
  Mixture<Real> point_of_p_;
  Real depth_ = 0;
  std::uint32_t first_vertex_ = 0;
};

}  // namespace sunder::solid
