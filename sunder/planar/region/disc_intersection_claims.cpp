#include <sunder/certificate/claims.h>
#include <sunder/planar/region/disc_intersection_claims.h>
#include <sunder/planar/region/discs_prepared.h>
#include <sunder/predicate/disc/disc_powers.h>

#include <array>
#include <numeric>
#include <vector>

namespace sunder::planar {

namespace {

void write_powers(ClaimsWriter& file, const DiscIntersection& part, const DiscBasis& basis) {
  const DeepestWeights of_all = deepest_weights(basis);
  std::vector<Weight> weights;
  for (std::uint32_t k = 0; k < part.deepest.count; ++k) {
    weights.push_back({part.deepest.discs[k], of_all.numerators[k]});
  }
  file.weights_claim("powers", weights);
}

// The chains of the ranges of more than eight discs and of their halves, but for that of all; each after those of its
// halves.
class Parts {
 public:
  Parts(ClaimsWriter& file, ArcChains& chains) : file_(file), chains_(chains) {}

  std::vector<ArcPiece> write(std::uint32_t first, std::uint32_t last, bool is_all = true) {
    std::vector<ArcPiece> chain;
    if (last - first > 8) {
      const std::uint32_t half = first + (last - first) / 2;
      const std::vector<ArcPiece> lower = write(first, half, false), upper = write(half, last, false);
      chains_.merge(lower, upper, chain);
    } else {
      std::vector<std::uint32_t> discs(last - first);
      std::iota(discs.begin(), discs.end(), first);
      chain = chains_.divide(discs);
    }
    if (!is_all) file_.add_list(discs_around(chain));
    return chain;
  }

 private:
  ClaimsWriter& file_;
  ArcChains& chains_;
};

void write_region(ClaimsWriter& file, const Discs& circles, const DiscIntersection& part) {
  Cost cost;
  const Viewpoint point = inside_of_all(circles.all(), part.deepest, cost);
  file.numbers("point", std::array{point.x, point.y});
  file.indices("arcs", part.arcs);
  file.begin_claims();
  file.claim("in_discs");
  file.begin_claim("arcs");
  file.begin_list("parts");
  ArcChains chains(circles.all(), point);
  Parts(file, chains).write(0, circles.size());
  file.end_list();
  file.end_claim();
}

void write_point(ClaimsWriter& file, const Discs& circles, const DiscIntersection& part) {
  const DiscBasis basis = discs_of(circles.all(), part.deepest.basis());
  const ExactPoint2 point = deepest_point(basis);
  file.fractions("point", std::array{point.x, point.y}, point.denominator);
  file.begin_claims();
  file.claim("in_discs");
  write_powers(file, part, basis);
}

}  // namespace

std::string certificate_text(const Discs& circles, const DiscIntersection& part, const Origin& origin) {
  return claims_text(origin, [&](ClaimsWriter& file) {
    file.begin_table("circles");
    for (const Disc& c : circles.all()) file.add_row(std::array{c.center.x, c.center.y, c.radius});
    file.end_table();
    file.begin_statement("circles_common_part");
    file.text("verdict", name_of(part.kind));
    if (part.kind == DiscIntersectionKind::region) {
      write_region(file, circles, part);
    } else if (part.kind == DiscIntersectionKind::point) {
      write_point(file, circles, part);
    } else {
      file.begin_claims();
      write_powers(file, part, discs_of(circles.all(), part.deepest.basis()));
    }
    file.end_statement();
  });
}

}  // namespace sunder::planar
