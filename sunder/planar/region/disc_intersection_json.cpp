#include <sunder/certificate/claims.h>
#include <sunder/planar/region/disc_intersection_json.h>
#include <sunder/planar/region/discs_prepared.h>
#include <sunder/predicate/disc_powers.h>

#include <array>
#include <numeric>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder::planar {

namespace {

void write_claim(ClaimsWriter& file, std::string_view name) {
  file.begin_claim(name);
  file.end_claim();
}

void write_powers(ClaimsWriter& file, const DiscIntersection& part, const DeepestWeights& weights) {
  file.begin_claim("powers");
  file.begin_list("weights");
  for (std::uint32_t k = 0; k < part.deepest.count; ++k) {
    file.add_weight(part.deepest.discs[k], weights.numerators[k]);
  }
  file.end_list();
  file.end_claim();
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
  write_claim(file, "in_discs");
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
  write_claim(file, "in_discs");
  write_powers(file, part, deepest_weights(basis));
}

}  // namespace

std::string certificate_text(const Discs& circles, const DiscIntersection& part, const Origin& origin) {
  std::string text;
  ClaimsWriter file([&](std::string_view piece) { text += piece; });
  file.add_origin(origin);
  file.begin_table("circles");
  for (const Disc& c : circles.all()) file.add_row(std::array{c.center.x, c.center.y, c.radius});
  file.end_table();
  file.begin_statement("circles_common_part");
  file.text("verdict", std::string(name_of(part.kind)));
  switch (part.kind) {
    case DiscIntersectionKind::region: write_region(file, circles, part); break;
    case DiscIntersectionKind::point: write_point(file, circles, part); break;
    case DiscIntersectionKind::empty:
      file.begin_claims();
      write_powers(file, part, deepest_weights(discs_of(circles.all(), part.deepest.basis())));
      break;
    case DiscIntersectionKind::plane:
      file.begin_claims();
      write_claim(file, "no_entries");
      break;
  }
  file.end_statement();
  file.end();
  return text;
}

}  // namespace sunder::planar
