// Which planes through a line support a placed convex polyhedron that has an inside: that is, have points of it, and
// all others on one side?
// Also called: tangent planes through a line; supporting planes of a pencil; silhouette along a line.
//
// A half-plane that begins in the line turns around it, counter-clockwise seen against the direction from a to b. The
// first and the last half-plane that have points of the body off the line are in planes of support:
//   the line misses the body: these two are all that there are;
//   it touches a vertex of the body, or an edge and is along that: these two are the ends of a range of planes, of
//     which all others touch the body where the line does, and nowhere else;
//   it touches an edge, across that, or is in a facet: both are in one plane, which is the only one;
//   it goes through the inside: every half-plane has such points, and no plane supports the body.
//   P1. The answer is that of the exact images of the vertices under the pose. The line is in the world.
//   P2. All methods give the same outcome and the same features; `through` is a method's own where a plane touches an
//       edge or a facet, and with it the side of an only plane; so are the facets of a cut.
// Only the scan and exact steps allocate, and vertices of more than 32 edges in which a plane touches the body. None
// throws unless memory runs out. Each function requires a body of dimension 3.
// Source: CD87 section 3.6, Lemma 12. The question for lines that miss the body is not the paper's; see
// docs/design/line-support.md.
#pragma once

#include <sunder/certificate/pair_answer.h>
#include <sunder/number/sign.h>
#include <sunder/solid/line/polyhedron_cut.h>
#include <sunder/solid/object/line.h>

#include <array>
#include <cstdint>
#include <string_view>
#include <variant>
#include <vector>

namespace sunder::solid {

// The plane of the line and a vertex that is not on it. What the body has on the plane is a vertex, an edge or a facet,
// with its ends or boundary. For all other points x of the body orient_3d(a, b, through, x) has the sign `side`:
// positive of a first half-plane, negative of a last one.
struct SupportPlane {
  std::uint32_t through = 0;
  CutFeature touches;
  Sign side = Sign::zero;
};

// The line misses the body.
struct SupportApart {
  static constexpr Verdict verdict = Verdict::apart;
  static constexpr std::string_view name = "two planes";
  SupportPlane first, last;
};

// It touches the body at a vertex, or along an edge: `at`.
struct SupportRange {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr std::string_view name = "a range of planes";
  SupportPlane first, last;
  CutFeature at;
};

// It touches the body at a point inside an edge, or in a facet: that is what the plane touches.
struct SupportOnly {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr std::string_view name = "one plane";
  SupportPlane plane;
};

// It goes through the body's inside, between the ends of the cut.
struct SupportNone {
  static constexpr Verdict verdict = Verdict::meet;
  static constexpr std::string_view name = "none";
  CutAcross cut;
};

using LineSupport = Answer<std::variant<SupportApart, SupportRange, SupportOnly, SupportNone>>;

std::string_view name_of(const LineSupport::Evidence& evidence);  // "two planes"

// The planes named: two, one or none.
std::vector<SupportPlane> planes_of(const LineSupport::Evidence& evidence);

// The numbers of the vertices of a feature, in order; of `inside` none.
std::vector<std::uint32_t> vertices_of(const ConvexPolyhedron& body, const CutFeature& feature);

// Lemma 12 itself: the line is known to support the body, and `at` to be a vertex or an edge where it has a point of
// the body, or a facet that it is in. At a point inside an edge, across it: the plane of both, in constant time. Along
// an edge: those of its two facets. At a vertex: the planes of the line and of the edges around the vertex are a
// bimodal angular sequence, whose extremes are searched by halving. Never SupportApart or SupportNone. Meaningless
// where what is to be known is not so.
// Cost: at most 6 log2 k + 16 signs, counted as probes, for a vertex of k edges.
LineSupport planes_of_support_at(const ConvexPolyhedron& body, const Pose& pose, const Line& line,
                                 const CutFeature& at);

// The front door: polyhedron_line, and then the Lemma where the line touches the body; where it misses, Newton's method
// to either side: to the vertex furthest beyond the plane of the line and the last vertex, over the vertex graph.
// Cost: beside that of polyhedron_line, of a line that misses at most 140 log2 n probes for n of 1,000 and more (the
// constants tested), of one that touches what the Lemma takes.
LineSupport polyhedron_line_support(const ConvexPolyhedron& body, const Pose& pose, const Line& line);

// The same with facets and extreme vertices by the hierarchy. Cost: of a line that misses in all at most 215 log2 n
// probes, likewise.
LineSupport polyhedron_line_support_by_hierarchy(const ConvexPolyhedron& body, const Pose& pose, const Line& line);

// The same by drums: polyhedron_line_by_drums, then a search in slices around the line, and extreme vertices by CD87's
// search in slices. Cost: beside that of polyhedron_line_by_drums, of a line that misses at most 16 log2^2 n probes,
// likewise, times the steps of an access to a drum.
LineSupport polyhedron_line_support_by_drums(const ConvexPolyhedron& body, const Pose& pose, const Line& line);

// All vertices, exactly: the oracle. Of a cut it names neither ends nor facets.
LineSupport polyhedron_line_support_by_scan(const ConvexPolyhedron& body, const Pose& pose, const Line& line);

}  // namespace sunder::solid
