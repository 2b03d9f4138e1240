#include <sunder/predicate/filter/stages.h>
#include <sunder/predicate/line/chord.h>

namespace sunder {

namespace {

// The multiples come as a point: whole numbers are tame, and products of two images with them smaller than those of
// three images.
constexpr auto chord_formula = [](const auto& p, const auto& q, const auto& r, const auto& s, const auto& t,
                                  const auto& u, const auto& times) {
  const auto left = s - r;
  const auto right = u - t;
  const auto pq = q - p;
  return pq.x * (times.x * left.y - times.y * right.y) - pq.y * (times.x * left.x - times.y * right.x);
};

Point2 point_of(std::uint32_t m, std::uint32_t n) { return {static_cast<double>(m), static_cast<double>(n)}; }

}  // namespace

Sign chord_order_further(const Point2& p, const Point2& q, std::uint32_t m, const Point2& r, const Point2& s,
                         std::uint32_t n, const Point2& t, const Point2& u, StageTally* tally) {
  return decide(tally, chord_formula, p, q, r, s, t, u, point_of(m, n));
}
Sign chord_order(const Posed2& p, const Posed2& q, std::uint32_t m, const Posed2& r, const Posed2& s, std::uint32_t n,
                 const Posed2& t, const Posed2& u, StageTally* tally) {
  return decide(tally, chord_formula, p, q, r, s, t, u, point_of(m, n));
}

}  // namespace sunder
