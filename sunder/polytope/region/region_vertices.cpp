#include <sunder/base/contract.h>
#include <sunder/number/exact/elimination_internal.h>
#include <sunder/polytope/hull/full_hull.h>
#include <sunder/polytope/hull/vertices_internal.h>
#include <sunder/polytope/region/region_vertices.h>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

namespace sunder::polytope {

namespace {

using Indices = std::vector<std::uint32_t>;
using Place = ExactPointN;

// b w - a x: what a half-space leaves to the point x / w, times w.
Dyadic slack(std::span<const double> row, std::span<const Dyadic> x, const Dyadic& w) {
  Dyadic sum = Dyadic(row.back()) * w;
  for (std::size_t c = 0; c < x.size(); ++c) {
    if (row[c] != 0) sum = sum - x[c] * row[c];
  }
  return sum;
}

// The common part in the flat of k + 1 of its points p0, .., pk, no k - 1 of which are in a flat of less dimensions:
// numbers t are the point p0 + t1 (p1 - p0) + ... With s_i what a row leaves to p_i, it says t1 (s0 - s1) + .. <= s0.
class FlatPart {
 public:
  FlatPart(const Polytope& body, const RegionExtent& region)
      : body_(body), region_(region), d_(body.dimension()), k_(region.dimension) {
    for (std::size_t i = 0; i <= k_; ++i) {
      Dyadic others = 1.0;
      for (std::size_t j = 0; j <= k_; ++j) {
        if (j != i) others = others * region.points[j].denominator;
      }
      others_.push_back(std::move(others));
    }
    all_ = others_[0] * region.points[0].denominator;
  }

  PolytopeVertices find(std::uint64_t most) {
    PolytopeVertices found;
    found.inside.assign(k_, Dyadic(1.0));  // the mean: in no face, as not all points are
    found.inside.emplace_back(static_cast<double>(k_ + 1));
    const Indices cutting = rows_that_cut();
    if (k_ == 0) {
      found.vertices = {{Dyadic(1.0)}};
      found.at.emplace_back();
    } else if (k_ == 1) {
      find_ends(found);
    } else {
      add_vertices(k_, rows_, most, found);
    }
    for (Indices* const list : lists_of(found)) {
      for (std::uint32_t& row : *list) row = cutting[row];
    }
    for (std::vector<Dyadic>& vertex : found.vertices) vertex = lifted(vertex);
    found.inside = lifted(found.inside);
    add_across(cones_across(most), found);
    return found;
  }

 private:
  static std::vector<Indices*> lists_of(PolytopeVertices& found) {
    std::vector<Indices*> lists{&found.bounding};
    for (Indices& at : found.at) lists.push_back(&at);
    for (Indices& fan : found.fans) lists.push_back(&fan);
    return lists;
  }

  // Those that leave something to some of the points; they, as they are in the flat, go to rows_.
  Indices rows_that_cut() {
    Indices result;
    for (std::uint32_t row = 0; row < body_.size(); ++row) {
      std::vector<Dyadic> left;
      for (std::size_t i = 0; i <= k_; ++i) {
        const Place& point = region_.points[i];
        left.push_back(slack(body_.row(row), point.numbers, point.denominator) * others_[i]);
      }
      if (std::all_of(left.begin(), left.end(), [](const Dyadic& x) { return x.sign() == Sign::zero; })) continue;
      for (std::size_t i = 1; i <= k_; ++i) rows_.push_back(left[0] - left[i]);
      rows_.push_back(left[0]);
      result.push_back(row);
    }
    return result;
  }

  // Of a segment: where the least and the greatest t is.
  void find_ends(PolytopeVertices& found) const {
    std::array<std::uint32_t, 2> ends{};
    for (const bool is_greatest : {false, true}) {
      const Sign way = is_greatest ? Sign::positive : Sign::negative;
      std::optional<std::uint32_t> best;
      for (std::uint32_t k = 0; k < rows_.size() / 2; ++k) {
        const Dyadic &a = rows_[2 * k], &b = rows_[2 * k + 1];
        if (a.sign() != way) continue;
        const Sign further = best ? (b * rows_[2 * *best] - rows_[2 * *best + 1] * a).sign() : Sign::zero;
        if (!best || (further != way && further != Sign::zero)) best = k;
      }
      ends[is_greatest] = *best;
    }
    std::sort(ends.begin(), ends.end());
    for (const std::uint32_t end : ends) {
      const Dyadic &a = rows_[2 * end], &b = rows_[2 * end + 1];
      found.vertices.push_back(a.sign() == Sign::positive ? std::vector{b, a} : std::vector{-b, -a});
      found.bounding.push_back(end);
      found.at.push_back({end});
      found.fans.push_back({end});
    }
  }

  // Of t1 / w, .., tk / w: with the others of p_i over all_, the point is (w - sum t) p0 + ..
  std::vector<Dyadic> lifted(const std::vector<Dyadic>& t) const {
    std::vector<Dyadic> result(d_ + 1);
    Dyadic rest = t.back();
    for (std::size_t i = 0; i < k_; ++i) rest = rest - t[i];
    for (std::size_t i = 0; i <= k_; ++i) {
      const Dyadic share = (i == 0 ? rest : t[i - 1]) * others_[i];
      for (std::size_t c = 0; c < d_; ++c) result[c] = result[c] + share * region_.points[i].numbers[c];
    }
    result[d_] = t.back() * all_;
    return result;
  }

  // Of the rows on whose hyperplanes all is, which span what is across the flat and have a positive sum that is zero:
  // cones of d - k of them that are all that is across.
  Indices cones_across(std::uint64_t most) const {
    const std::size_t m = d_ - k_;
    const std::vector<std::size_t> columns = columns_across();
    Indices rows;
    std::vector<Dyadic> points;
    for (const Weights::Part& part : region_.flat.parts) {
      rows.push_back(part.index);
      for (const std::size_t c : columns) points.emplace_back(body_.row(part.index)[c]);
      points.emplace_back(1.0);
    }
    Indices result;
    if (m == 1) {
      for (const Sign way : {Sign::negative, Sign::positive}) {
        std::size_t k = 0;
        while (points[2 * k].sign() != way) ++k;
        result.push_back(rows[k]);
      }
      return result;
    }
    ConvexHull hull;
    hull.space = hull.dimension = m;
    Indices all(rows.size());
    std::iota(all.begin(), all.end(), 0u);
    hull_of_full(PlanePoints(m, std::move(points)), std::move(all), most, hull);
    for (const std::uint32_t corner : hull.simplex_corners) result.push_back(rows[corner]);
    return result;
  }

  // As many columns of these rows as tell the others.
  std::vector<std::size_t> columns_across() const {
    std::vector<std::size_t> columns;
    Elimination span(region_.flat.parts.size());
    for (std::size_t c = 0; c < d_; ++c) {
      std::vector<Dyadic> column;
      for (const Weights::Part& part : region_.flat.parts) column.emplace_back(body_.row(part.index)[c]);
      if (span.add(column)) columns.push_back(c);
    }
    return columns;
  }

  // Each cone in the flat with each across it.
  void add_across(const Indices& across, PolytopeVertices& found) const {
    if (k_ == 0) found.fans = {across};
    for (Indices& fan : found.fans) {
      const Indices before = k_ == 0 ? Indices() : std::exchange(fan, {});
      for (std::size_t cone = 0; cone < before.size(); cone += k_) {
        for (std::size_t other = 0; other < across.size(); other += d_ - k_) {
          for (std::size_t i = 0; i < k_; ++i) fan.push_back(before[cone + i]);
          for (std::size_t i = 0; i < d_ - k_; ++i) fan.push_back(across[other + i]);
        }
      }
    }
  }

  const Polytope& body_;
  const RegionExtent& region_;
  std::size_t d_, k_;
  std::vector<Dyadic> others_;  // of each point, the product of the denominators of the others
  Dyadic all_;                  // of all
  std::vector<Dyadic> rows_;    // that cut, of k + 1 numbers
};

}  // namespace

RegionVertices region_vertices(const Polytope& half_spaces, std::uint64_t most) {
  SUNDER_REQUIRE(!half_spaces.is_of_points());
  RegionVertices result{half_space_region(half_spaces), {}};
  const auto* bounded = std::get_if<BoundedRegion>(&result.region.evidence);
  if (bounded == nullptr) return result;
  result.found = bounded->dimension == half_spaces.dimension() ? vertices_of(half_spaces, most)
                                                               : FlatPart(half_spaces, *bounded).find(most);
  return result;
}

}  // namespace sunder::polytope
