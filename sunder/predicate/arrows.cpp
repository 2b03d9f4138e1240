#include <sunder/predicate/arrows.h>
#include <sunder/predicate/stages.h>

namespace sunder {

namespace {

constexpr auto cross_formula = [](const auto& p, const auto& q, const auto& r, const auto& s) {
  return cross(q - p, s - r);
};
constexpr auto dot_formula = [](const auto& p, const auto& q, const auto& r, const auto& s) {
  return dot(q - p, s - r);
};

}  // namespace

Sign cross_2d_further(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally) {
  return decide(tally, cross_formula, p, q, r, s);
}
Sign cross_2d_further(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally) {
  return decide(tally, cross_formula, p, q, r, s);
}
Sign dot_2d_further(const Point2& p, const Point2& q, const Point2& r, const Point2& s, StageTally* tally) {
  return decide(tally, dot_formula, p, q, r, s);
}
Sign dot_2d_further(const Posed2& p, const Posed2& q, const Posed2& r, const Posed2& s, StageTally* tally) {
  return decide(tally, dot_formula, p, q, r, s);
}

}  // namespace sunder
