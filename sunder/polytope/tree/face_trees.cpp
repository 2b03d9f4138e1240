#include <sunder/base/contract.h>
#include <sunder/number/rounded_elimination_internal.h>
#include <sunder/polytope/represent/far_apart.h>
#include <sunder/polytope/tree/face_trees.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <utility>

namespace sunder::polytope {

namespace {

std::string tree_name(const char* of, const Polytope& body) {
  return std::string("the tree of the faces of ") + of + std::to_string(body.size()) + " points of dimension " +
         std::to_string(body.dimension());
}

ConvexHull hull_within(const Polytope& body, std::uint64_t most) {
  try {
    return convex_hull(body, most);
  } catch (const Error& error) {
    if (error.code() != ErrorCode::bad_shape) throw;
    throw Error(ErrorCode::bad_shape, tree_name("", body) + " takes the facets of their hull, more than the " +
                                          std::to_string(most) +
                                          " simplices that it may; give fewer points, or use another method");
  }
}

}  // namespace

FaceTrees::FaceTrees(Polytope body, FaceTreesOf which, const FaceTreeOptions& options, const TreeOptions& walks)
    : walks_(std::move(body), walks), hull_(hull_within(walks_.body(), options.most_facets)) {
  SUNDER_REQUIRE(this->body().is_of_points());
  place();
  if (which != FaceTreesOf::polar) make_faces(options, tree_name("", this->body()));
  if (which != FaceTreesOf::faces && is_full()) make_polar(options, tree_name("the polar of ", this->body()));
}

// The center is the mean of points that are far from one another, the unit of a column about its extent.
void FaceTrees::place() {
  const std::size_t d = body().dimension();
  double greatest = 0;
  std::array<double, most_dimension> extent{};
  for (std::size_t c = 0; c < d; ++c) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const std::uint32_t v : hull_.vertices) {
      low = std::min(low, body().row(v)[c] / 2);
      high = std::max(high, body().row(v)[c] / 2);
    }
    extent[c] = high - low;
    greatest = std::max(greatest, extent[c]);
  }
  for (std::size_t c = 0; c < d; ++c) {
    const double size = extent[c] > 0 ? extent[c] : greatest;
    unit_[c] = size > 0 ? std::ilogb(size) + 1 : 0;
  }
  std::vector<double> points;
  for (const std::uint32_t v : hull_.vertices) {
    for (std::size_t c = 0; c < d; ++c) points.push_back(std::ldexp(body().row(v)[c], -unit_[c]));
  }
  for (const std::uint32_t k : far_apart(d, std::move(points), std::nullopt, 0x1p-90)) {
    center_rows_.push_back(hull_.vertices[k]);
  }
  for (std::size_t c = 0; c < d; ++c) {
    for (const std::uint32_t k : center_rows_)
      center_[c] += body().row(k)[c] / static_cast<double>(center_rows_.size());
  }
  for (std::uint32_t k = 0; k < body().size(); ++k) {
    for (std::size_t c = 0; c < d; ++c) rows_.push_back(std::ldexp(body().row(k)[c] - center_[c], -unit_[c]));
  }
}

void FaceTrees::make_faces(const FaceTreeOptions& options, const std::string& name) {
  const std::size_t d = body().dimension();
  if (!is_full()) {
    faces_.emplace(d, rows_, hull_.vertices);
    return;
  }
  FaceSet set{.dimension = d, .common = hull_.vertices[0], .vertices = rows_};
  for (std::size_t f = 0; f < hull_.facet_count(); ++f) {
    const std::span<const std::uint32_t> corners = hull_.facet_vertices(f);
    if (std::binary_search(corners.begin(), corners.end(), set.common)) continue;
    const std::span<const std::uint32_t> simplices = hull_.simplices(f);
    set.face_vertices.insert(set.face_vertices.end(), simplices.begin(), simplices.end());
    for (std::size_t k = 0; k < simplices.size(); k += d)
      set.face_begin.push_back(set.face_begin.back() + static_cast<std::uint32_t>(d));
  }
  faces_.emplace(std::move(set), options, name);
}

// Facet f is q . y <= 1, and q a vertex of the polar.
void FaceTrees::make_polar(const FaceTreeOptions& options, const std::string& name) {
  const std::size_t d = body().dimension();
  FaceSet set{.dimension = d};
  std::vector<std::vector<std::uint32_t>> at(body().size());
  for (std::size_t f = 0; f < hull_.facet_count(); ++f) {
    for (const std::uint32_t v : hull_.facet_vertices(f)) at[v].push_back(static_cast<std::uint32_t>(f));
    const std::span<const std::uint32_t> corners = hull_.simplices(f).first(d);
    std::array<double, most_dimension * most_dimension> matrix{}, inverse{};
    for (std::size_t i = 0; i < d; ++i) {
      std::copy_n(&rows_[corners[i] * d], d, matrix.begin() + static_cast<std::ptrdiff_t>(i * d));
    }
    const bool is_found = rounded_inverse(d, std::span(matrix).first(d * d), std::span(inverse).first(d * d));
    for (std::size_t c = 0; c < d; ++c) {
      double sum = 0;
      for (std::size_t i = 0; is_found && i < d; ++i) sum += inverse[c * d + i];
      set.vertices.push_back(std::isfinite(sum) ? sum : 0);
    }
  }
  for (const std::uint32_t v : hull_.vertices) {
    set.face_vertices.insert(set.face_vertices.end(), at[v].begin(), at[v].end());
    set.face_begin.push_back(static_cast<std::uint32_t>(set.face_vertices.size()));
  }
  polar_.emplace(std::move(set), options, name);
}

void FaceTrees::add_simplex_of(std::uint32_t facet, std::span<const double> y, std::vector<std::uint32_t>& rows) const {
  const std::size_t d = body().dimension();
  const std::span<const std::uint32_t> simplices = hull_.simplices(facet);
  std::size_t best = 0;
  double greatest = -std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < simplices.size(); k += d) {
    std::array<double, most_dimension * most_dimension> matrix{}, inverse{};  // columns are corners
    for (std::size_t i = 0; i < d; ++i) {
      for (std::size_t c = 0; c < d; ++c) matrix[c * d + i] = rows_[simplices[k + i] * d + c];
    }
    if (!rounded_inverse(d, std::span(matrix).first(d * d), std::span(inverse).first(d * d))) continue;
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < d; ++i) {
      double weight = 0;
      for (std::size_t c = 0; c < d; ++c) weight += inverse[i * d + c] * y[c];
      least = std::min(least, weight);
    }
    if (!(least > greatest)) continue;
    greatest = least;
    best = k;
  }
  const std::span<const std::uint32_t> corners = simplices.subspan(best, d);
  rows.insert(rows.end(), corners.begin(), corners.end());
}

std::size_t FaceTrees::memory() const {
  std::size_t bytes = walks_.memory() + rows_.size() * sizeof(double) +
                      (hull_.facet_corners.size() + hull_.simplex_corners.size() + hull_.vertices.size()) * 4 +
                      (hull_.facet_begin.size() + hull_.simplex_begin.size()) * sizeof(std::size_t);
  for (const std::optional<FaceTree>* tree : {&faces_, &polar_}) bytes += *tree ? (*tree)->memory() : 0;
  return bytes;
}

std::uint64_t FaceTrees::looks() const {
  return walks_.looks() + (faces_ ? faces_->looks() : 0) + (polar_ ? polar_->looks() : 0);
}

}  // namespace sunder::polytope
