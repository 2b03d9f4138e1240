// How every method answers what a convex polyhedron has in common with a line, a ray or a segment: its search proposes,
// dispose() checks what it proposes, and where nothing holds finish() decides. Both are written once; both are exact.
#pragma once

#include <sunder/solid/line/line_proposal.h>
#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/line.h>
#include <sunder/solid/search/placed.h>

namespace sunder::solid {

// As exact_end of polyhedron_cut.h.
ExactEnd exact_end(const Placed& body, const Line& line, const CutEnd& end);

// The line through a and b; of a segment that is one point, any line through that.
inline Line line_through(const Point3& a, const Point3& b) {
  return {a, a == b ? Point3{a.x > 0 ? a.x / 2 : 1, b.y, b.z} : b};
}

// Where filters do not decide, and what a proposal leaves open, is counted as an exact sign.
class LineAnswer {
 public:
  // Requires two different points. Keeps references.
  LineAnswer(const Placed& body, const Line& line);

  // Of a body with an inside. Does the proposal hold? Fills in what the line has in common with the body where it does.
  // A proposal may come from anywhere: one that names no facets of this body does not hold. A line that goes into a
  // neighbour of the facet is followed there, some steps far.
  bool dispose(const LineProposal& proposal);

  // The same, whatever the body with an inside is: from facet to facet that a ray from inside to the line goes through,
  // by Newton's method, each in O(log n) by the hierarchy, exactly. Allocates.
  void finish();

  // Of a body without an inside. Allocates where filters do not decide.
  void decide_flat(OwnEnds ends, bool is_point);

  // From what the line has in common with a body with an inside to what the ray or segment has. is_point: of a segment
  // whose ends are both a.
  void clip(OwnEnds ends, bool is_point);

  PolyhedronCut conclude(bool finished) const;

  Cost& cost() { return cost_; }

 private:
  struct Pierced {
    bool is_pierced = false;
    CutFeature at;                              // where it is
    std::array<std::uint32_t, 2> across{0, 0};  // else an edge of the facet that the line passes outside of
  };
  enum class Sense : std::int8_t { leaving = -1, entering = 1 };

  Sign turn(std::uint32_t p, std::uint32_t q, Sense sense);
  Pierced pierce(std::uint32_t facet, Sense sense);
  Sign facing(std::uint32_t facet);                   // of the normal and the line
  Sign beyond(const Point3& x, std::uint32_t facet);  // positive: outside of its plane
  std::array<Posed3, 3> corners(std::uint32_t facet) const;
  bool through(std::uint32_t enters, std::uint32_t leaves);
  bool apart(std::uint32_t enters, std::uint32_t leaves);
  void decide_kind();
  bool is_across();

  CutFeature feature_at(const std::array<std::uint32_t, 3>& triangle, const WayFromMiddle& way);
  std::array<std::uint32_t, 3> triangle_towards(const WayFromMiddle& way);
  std::array<Point3, 4> top() const;

  void set_apart(CutParting parting);
  void set_point(const CutEnd& at);
  PolyhedronCut::Evidence evidence() const;

  // Of bodies without an inside; they give what parts the body from an own end beyond a point of the line.
  void decide_point();
  void decide_segment();
  void decide_polygon();
  void decide_in_plane();
  void clip_flat(OwnEnds ends, bool is_point);
  CutParting parting_at(const CutEnd& end, Sign sense, OwnEnd beyond);

  // From what the line has in common with the body to what the ray or segment has. beyond(at_last, own): positive where
  // the own end is outside beyond the first or last end of that, zero where it is there; parting(at_last, own): what
  // parts the body from it then.
  template <class Beyond, class Parting>
  void clip_by(OwnEnds ends, bool is_point, const Beyond& beyond, const Parting& parting);

  const Placed& body_;
  Line line_;
  Sign orientation_;  // of the pose
  // What is known so far; what it means depends on the kind.
  CutKind kind_ = CutKind::nothing;
  CutParting parting_;
  CutEnd first_, last_;
  CutFeature surface_;
  LineFacets facets_;
  Cost cost_;
  StageTally tally_;
};

template <class Beyond, class Parting>
void LineAnswer::clip_by(OwnEnds ends, bool is_point, const Beyond& beyond, const Parting& parting) {
  const OwnEnd own_b = is_point ? OwnEnd::a : OwnEnd::b;
  const Sign a_last = beyond(true, OwnEnd::a);
  if (a_last == Sign::positive) return set_apart(parting(true, OwnEnd::a));
  const Sign b_first = ends.b ? beyond(false, own_b) : Sign::negative;
  if (b_first == Sign::positive) return set_apart(parting(false, own_b));
  if (a_last == Sign::zero || b_first == Sign::zero) {
    return a_last == Sign::zero ? set_point({last_.at, OwnEnd::a}) : set_point({first_.at, own_b});
  }
  if (kind_ == CutKind::point) return;
  const CutFeature between = kind_ == CutKind::along ? surface_ : CutFeature{CutPlace::inside, 0, 0};
  const auto shorten = [&](Sign outward, CutEnd& end, OwnEnd own) {
    if (outward == Sign::positive) return;
    if (outward == Sign::negative) end.at = between;
    end.own = own;
  };
  shorten(beyond(false, OwnEnd::a), first_, OwnEnd::a);
  if (ends.b) shorten(beyond(true, own_b), last_, own_b);
  if (is_point) kind_ = CutKind::point;
}

// The answer of a method that proposes: propose(line, holds, cost) calls holds(proposal) until that is true, and tells
// whether it was.
template <class Propose>
PolyhedronCut cut_by(const ConvexPolyhedron& body, const Pose& pose, const Point3& a, const Point3& b, OwnEnds ends,
                     const Propose& propose) {
  const Placed placed(body, pose);
  const bool is_point = a == b;
  const Line line = line_through(a, b);
  LineAnswer answer(placed, line);
  if (body.dimension() < 3) {
    answer.decide_flat(ends, is_point);
    return answer.conclude(false);
  }
  const auto holds = [&](const LineProposal& proposal) {
    ++answer.cost().proposals;
    return answer.dispose(proposal);
  };
  const bool held = propose(placed, line, holds, answer.cost());
  if (!held) answer.finish();
  answer.clip(ends, is_point);
  return answer.conclude(!held);
}

}  // namespace sunder::solid
