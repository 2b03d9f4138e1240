#include <sunder/base/contract.h>
#include <sunder/certificate/depth_claims.h>

#include <cmath>
#include <cstddef>

namespace sunder {

namespace {

void begin_statement(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, const char* verdict, const char* key,
                     double bound) {
  file.begin_statement("depth");
  file.index("a", a);
  file.index("b", b);
  file.text("verdict", verdict);
  file.real(key, bound);
  file.begin_claims();
}

// Opens the claim and its list of differences.
void begin_surrounds(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least) {
  SUNDER_REQUIRE(least > 0 && std::isfinite(least));
  begin_statement(file, a, b, "at_least", "least", least);
  file.begin_claim("surrounds");
  file.begin_list("differences");
}

// Of a hull the weights alone, of its core.
void add_end(ClaimsWriter& file, const PointOf& point, bool is_curved) {
  file.begin_entry();
  if (is_curved) file.fractions("point", point.at);
  const Combination& made = point.of_body;
  file.begin_list("weights");
  for (const auto& [index, numerator] : made.parts) file.add_weight(index, numerator, made.denominator);
  file.end_list();
  if (made.from) file.fractions("from", *made.from);
  file.end_entry();
}

void add_end(ClaimsWriter& file, std::uint32_t number, const std::vector<PointOf>& points) {
  if (points.empty()) return file.add_index(number);
  add_end(file, points[number], true);
}

// Closes the list of differences, and all else. Pieces are triangles, or in the plane edges.
template <std::size_t Corners>
void end_surrounds(ClaimsWriter& file, std::span<const std::array<std::uint32_t, Corners>> pieces) {
  file.end_list();
  file.begin_list("triangles");
  for (const auto& piece : pieces) file.add_list(piece);
  file.end_list();
  file.end_claim();
  file.end_statement();
}

}  // namespace

void add_depth(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, const EnclosedDepth& found) {
  const auto [low, high] = found.depth;
  if (std::isfinite(high)) {
    const Vector3<Dyadic> d = found.direction.exact();
    add_depth_at_most(file, a, b, high, std::array{d.x, d.y, d.z});
  }
  if (const auto* surface = std::get_if<DepthSurface>(&found.proof_of_low))
    add_depth_at_least(file, a, b, low, *surface);
  if (const auto* points = std::get_if<DepthPoints>(&found.proof_of_low)) add_depth_at_least(file, a, b, low, *points);
}

void add_depth_at_most(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double most,
                       std::span<const Dyadic> direction) {
  SUNDER_REQUIRE(most >= 0 && std::isfinite(most));
  begin_statement(file, a, b, "at_most", "most", most);
  file.begin_claim("leaves");
  file.numbers("direction", direction);
  file.end_claim();
  file.end_statement();
}

void add_depth_at_least(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least,
                        const DepthSurface& surface) {
  begin_surrounds(file, a, b, least);
  for (const auto& [of_a, of_b] : surface.corners) {
    file.begin_list();
    add_end(file, of_a, surface.of_a);
    add_end(file, of_b, surface.of_b);
    file.end_list();
  }
  end_surrounds<3>(file, surface.triangles);
}

void add_depth_at_least(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least,
                        std::span<const std::array<std::uint32_t, 2>> corners,
                        std::span<const std::array<std::uint32_t, 2>> edges) {
  begin_surrounds(file, a, b, least);
  for (const auto& corner : corners) file.add_list(corner);
  end_surrounds(file, edges);
}

void add_depth_at_least(ClaimsWriter& file, std::uint32_t a, std::uint32_t b, double least, const DepthPoints& points) {
  begin_surrounds(file, a, b, least);
  file.begin_list();
  add_end(file, points.of_a, points.a_is_curved);
  add_end(file, points.of_b, points.b_is_curved);
  file.end_list();
  end_surrounds<3>(file, {});
}

}  // namespace sunder
