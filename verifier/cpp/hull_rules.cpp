// The rules about convex hulls of points in space: docs/claims.md, "Hulls".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sets.h>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

using Points3 = std::vector<Integers>;  // of three numbers each

// All points of a body, from the mean of the named ones, as many times as far as there are of these.
Points3 seen_from_mean(const HullBody& body, const Set& named, std::size_t corners) {
  const std::size_t size = 2 * (body.given->bits + bits(Integer(named.size())));
  take_steps(8 * (body.rows().size() + corners), size, size);
  return from_mean(body.rows(), named);
}

// Where normal p = height.
struct FacePlane {
  Integers normal;
  Integer height;
};

FacePlane plane_of(const Points3& at, const Indices& face) {
  const Integers& origin = at[face[0]];
  Integers normal = cross(minus(at[face[1]], origin), minus(at[face[2]], origin));
  Integer height = dot(normal, origin);
  return {std::move(normal), std::move(height)};
}

bool holds_all(const FacePlane& plane, const Points3& at, const Indices& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](std::size_t k) { return dot(plane.normal, at[k]) == plane.height; });
}

// Is a ring in a plane strictly convex, once round, counter-clockwise seen from where the normal points?
bool is_convex(const Points3& at, const Indices& ring, const Integers& normal) {
  std::size_t axis = 0;
  while (normal[axis] == 0) ++axis;
  std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(i, j);
  Constraints ways;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Integers way = minus(at[ring[after(k, ring.size())]], at[ring[k]]);
    ways.push_back({way[i], way[j], 0, 0});
  }
  return goes_round_once(ways);
}

// Is a way within the cone of a ring, seen from the mean?
bool is_in_cone(const Points3& at, const Indices& ring, const Integers& way) {
  for (std::size_t c = 0; c < ring.size(); ++c) {
    if (dot(cross(at[ring[c]], at[ring[after(c, ring.size())]]), way) < 0) return false;
  }
  return true;
}

void check_surface(const std::vector<FaceHome>& homes, const HullBody& body, const IndexLists& faces) {
  const Indices corners = joined(faces);
  const Set vertices = as_set(corners);
  const Points3 at = seen_from_mean(body, vertices, corners.size());
  std::vector<FacePlane> planes;
  Ridges<std::size_t> edges;  // their owners: the corner after the edge, of the face that goes along it
  const auto text = [](std::size_t i, std::size_t j) {
    return "the edge from " + std::to_string(i) + " to " + std::to_string(j);
  };
  for (const Indices& face : faces) {
    const std::size_t n = face.size();
    const FacePlane& plane = planes.emplace_back(plane_of(at, face));
    require(plane.height > 0 && holds_all(plane, at, face) && is_convex(at, face, plane.normal), "surface",
            "face " + std::to_string(planes.size() - 1) + " is no strictly convex polygon that is seen from outside");
    for (std::size_t c = 0; c < n; ++c) {
      const std::size_t d = after(c, n);
      const bool is_new = edges.take(edge_of(face[c], face[d]), face[after(d, n)]);
      require(is_new, "surface", "two faces have " + text(face[c], face[d]));
    }
  }
  for (std::size_t f = 0; f < faces.size(); ++f) {
    for (std::size_t c = 0; c < faces[f].size(); ++c) {
      const std::size_t i = faces[f][c], j = faces[f][after(c, faces[f].size())];
      const std::size_t* const beyond = edges.beyond(edge_of(i, j));
      require(beyond != nullptr, "surface", "only one face contains " + text(i, j));
      require(dot(planes[f].normal, at[*beyond]) < planes[f].height, "surface", text(i, j) + " is not convex");
    }
  }
  const Integers middle = sum_of(at, faces[0]);  // no other face is met on the way through it
  for (std::size_t f = 1; f < faces.size(); ++f) {
    require(!is_in_cone(at, faces[f], middle), "surface", "face " + std::to_string(f) + " is in the way of face 0");
  }
  for (std::size_t k = 0; k < homes.size(); ++k) {
    const std::string point = "point " + std::to_string(k);
    const auto& [f, c] = homes[k];
    if (f == no_index) {
      require(has(vertices, k), "surface", point + " has no home");
    } else {
      const bool is_home = is_in_cone(at, {faces[f][0], faces[f][c], faces[f][c + 1]}, at[k]);
      require(is_home && dot(planes[f].normal, at[k]) <= planes[f].height, "surface", point + " is not in its home");
    }
  }
}

void check_outline(const Indices& sectors, const HullBody& body, const Indices& outline) {
  const Set vertices = as_set(outline);
  const Points3 at = seen_from_mean(body, vertices, outline.size());
  const Integers normal = cross(at[outline[0]], at[outline[1]]);
  const bool is_flat =
      !all_zero(normal) && std::all_of(at.begin(), at.end(), [&](const Integers& p) { return dot(normal, p) == 0; });
  require(is_flat, "outline", "the points are not in one plane");
  require(is_convex(at, outline, normal), "outline", "the ring is not strictly convex");
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::string point = "point " + std::to_string(k);
    if (sectors[k] == no_index) {
      require(has(vertices, k), "outline", point + " has no sector");
      continue;
    }
    const Integers &p = at[outline[sectors[k]]], &q = at[outline[after(sectors[k], outline.size())]];
    const bool is_in = dot(normal, cross(p, at[k])) >= 0 && dot(normal, cross(at[k], q)) >= 0 &&
                       dot(normal, cross(minus(q, p), minus(at[k], p))) >= 0;
    require(is_in, "outline", point + " is not in its sector");
  }
}

void check_between(const HullBody& body, std::size_t i, std::size_t j) {
  take_steps(4 * body.rows().size(), body.given->bits, body.given->bits);
  const Integers &first = body.rows()[i], &last = body.rows()[j];
  for (std::size_t k = 0; k < body.rows().size(); ++k) {
    require(first != last && is_between(first, last, body.rows()[k]), "between",
            "point " + std::to_string(k) + " is not between the ends");
  }
}

void check_one_point(const HullBody& body) {
  take_steps(4 * body.rows().size(), body.given->bits, body.given->bits);
  for (const Integers& row : body.rows()) require(row == body.rows()[0], "one_point", "two points differ");
}

// The faces of the hull, which is solid.
const IndexLists& solid_hull(const char* rule, const HullBody& body, const Proved& proved) {
  const auto known = proved.hulls.find(body.base);
  require(known != proved.hulls.end() && known->second.verdict == "solid", rule,
          "that the hull of " + body.quoted + " is solid has not been proved before");
  return known->second.faces;
}

// Faces of a mesh, counted modulo two, cover the boundary of the hull.
void check_bounds_hull(const Indices& beneath, const HullBody& body, const IndexLists& mesh, const Proved& proved) {
  const IndexLists& hull = solid_hull("bounds_hull", body, proved);
  for (const std::size_t f : beneath) require(f < hull.size(), "bounds_hull", "a face is none of the hull's");
  take_steps(16 * joined(mesh).size(), body.given->bits, 2 * body.given->bits);
  const Points3& at = body.rows();
  const Integers &u = at[hull[0][0]], &v = at[hull[0][1]];
  std::set<std::pair<Integers, Integers>> odd;  // edges that have come an odd number of times
  bool is_beside = false;                       // so have edges from u along the first edge of the hull
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    require(holds_all(plane_of(at, hull[beneath[f]]), at, mesh[f]), "bounds_hull",
            "face " + std::to_string(f) + " is not in the plane of the one beneath it");
    for (std::size_t k = 0; k < mesh[f].size(); ++k) {
      const Integers &p = at[mesh[f][k]], &q = at[mesh[f][after(k, mesh[f].size())]];
      if (p == q) continue;
      const auto [place, is_new] = odd.insert(std::minmax(p, q));
      if (!is_new) odd.erase(place);
      const bool is_at_u = beneath[f] == 0 && (p == u || q == u);
      is_beside ^= is_at_u && all_zero(cross(minus(v, u), minus(p == u ? q : p, u)));
    }
  }
  require(odd.empty(), "bounds_hull", "an edge is one of an odd number of faces");
  require(is_beside, "bounds_hull", "the faces cover the hull an even number of times");
}

// No face of the hull holds all corners of a face of a mesh.
void check_leaves_hull(const HullBody& body, const IndexLists& mesh, std::size_t face, const Proved& proved) {
  const IndexLists& hull = solid_hull("leaves_hull", body, proved);
  take_steps(8 * hull.size() * mesh[face].size(), body.given->bits, 2 * body.given->bits);
  for (const Indices& facet : hull) {
    require(!holds_all(plane_of(body.rows(), facet), body.rows(), mesh[face]), "leaves_hull",
            "face " + std::to_string(face) + " is in the plane of a face of the hull");
  }
}

}  // namespace

bool is_between(const Integers& first, const Integers& last, const Integers& point) {
  std::size_t axis = 0;
  while (axis < first.size() && first[axis] == last[axis]) ++axis;
  if (axis == first.size()) return point == first;
  const Integer part = point[axis] - first[axis], whole = last[axis] - first[axis];
  for (std::size_t c = 0; c < first.size(); ++c) {
    if ((point[c] - first[c]) * whole != (last[c] - first[c]) * part) return false;
  }
  return whole > 0 ? part >= 0 && part <= whole : part <= 0 && part >= whole;
}

const ClaimRows claims_of_hulls{
    {"surface", "homes: homes of subject", rule<check_surface>},
    {"outline", "sectors: sectors of subject", rule<check_outline>},
    {"between", "", rule<check_between>},
    {"one_point", "", rule<check_one_point>},
    {"bounds_hull", "beneath: face for each of mesh_faces", rule<check_bounds_hull>},
    {"leaves_hull", "", rule<check_leaves_hull>},
};

}  // namespace sunder_verifier
