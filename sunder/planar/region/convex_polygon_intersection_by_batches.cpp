// Batches that double: a polygon of the second half is compared once with a box around the common part of the first
// half.
#include <sunder/base/random.h>
#include <sunder/planar/region/convex_polygon_intersection_closed.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sunder::planar {

namespace {

class Batches {
 public:
  Batches(std::span<const ConvexPolygon> polygons, const CommonAbscissas& common)
      : polygons_(polygons), common_(common), chains_(polygons, common.between) {}

  PolygonsPart run() {
    const std::vector<std::uint32_t> order = sample_first();
    const std::span<const std::uint32_t> all(order);
    std::size_t done = std::min(sample_size_, all.size());
    take(all.first(done));
    while (done < all.size() && part_.kind != PolygonsPartKind::empty) {
      const std::size_t batch = std::min(done, all.size() - done);
      const Enclosure2 box = box_of_part();
      left_.clear();
      for (const std::uint32_t i : all.subspan(done, batch)) {
        if (!holds(polygons_[i], box)) left_.push_back(i);
      }
      done += batch;
      if (!left_.empty()) take(left_);
    }
    part_.cost.probes = probes_ + chains_.cost().probes;
    part_.cost.exact = chains_.cost().exact;
    return std::move(part_);
  }

 private:
  // The two polygons that bound the abscissas, without which a part is not closed; a random sample of about twice the
  // square root of all; then the others in order: they lie in memory so.
  std::vector<std::uint32_t> sample_first() {
    const auto n = static_cast<std::uint32_t>(polygons_.size());
    sample_size_ = std::min<std::size_t>(n, 16 + static_cast<std::size_t>(2 * std::sqrt(n)));
    std::vector<bool> is_taken(n, false);
    std::vector<std::uint32_t> order;
    order.reserve(n);
    const auto take_first = [&](std::uint32_t i) {
      if (!is_taken[i]) order.push_back(i);
      is_taken[i] = true;
    };
    take_first(common_.begins);
    take_first(common_.ends);
    Random random(14);
    for (std::size_t tries = 0; tries < 2 * sample_size_ && order.size() < sample_size_; ++tries) {
      take_first(static_cast<std::uint32_t>(random.below(n)));
    }
    for (std::uint32_t i = 0; i < n; ++i) {
      if (!is_taken[i]) order.push_back(i);
    }
    return order;
  }

  void take(std::span<const std::uint32_t> polygons) {
    merge(upper_, chains_.divide(polygons, Boundary::upper));
    merge(lower_, chains_.divide(polygons, Boundary::lower));
    std::vector<EdgePiece> lower = lower_;
    turn_over(lower);
    part_ = closed_part(polygons_, common_, upper_, lower, chains_.tally());
    probes_ += part_.cost.probes;
  }

  void merge(std::vector<EdgePiece>& chain, std::vector<EdgePiece> other) {
    if (chain.empty()) {
      chain.swap(other);
      return;
    }
    next_.clear();
    chains_.merge(chain, other, next_);
    chain.swap(next_);
  }

  Enclosure2 box_of_part() const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    Enclosure2 box{{infinity, -infinity}, {infinity, -infinity}};
    for (const PolygonsCorner& corner : part_.corners) box = hull(box, corner_point(polygons_, corner).in);
    return box;
  }

  bool holds(const ConvexPolygon& p, const Enclosure2& box) {
    const std::span<const Point2> v = p.vertices();
    if (v.size() < 3) return ++probes_, false;
    for (std::size_t from = v.size() - 1, to = 0; to < v.size(); from = to++) {
      ++probes_;
      if (!is_surely_left(v[from], v[to], box)) return false;
    }
    return true;
  }

  std::span<const ConvexPolygon> polygons_;
  const CommonAbscissas& common_;
  EdgeChains chains_;
  std::size_t sample_size_ = 0;
  std::vector<EdgePiece> upper_, lower_, next_;  // of what was taken so far; the lower one turned over
  std::vector<std::uint32_t> left_;
  PolygonsPart part_;
  std::uint64_t probes_ = 0;
};

}  // namespace

PolygonsPart convex_polygon_intersection_by_batches(std::span<const ConvexPolygon> polygons) {
  if (polygons.empty()) return {};
  const CommonAbscissas common = common_abscissas(polygons);
  if (!(common.between.low < common.between.high)) return thin_part(polygons, common);
  return Batches(polygons, common).run();
}

}  // namespace sunder::planar
