// The rules about convex hulls of points in space: docs/claims.md, "Hulls".
#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>

#include <algorithm>
#include <map>
#include <set>
#include <string>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

// Of three numbers.
using Vector = Integers;

Vector minus(const Vector& u, const Vector& v) { return {u[0] - v[0], u[1] - v[1], u[2] - v[2]}; }

// All points of a body, from the mean of the named ones, as many times as far as there are of these.
std::vector<Vector> from_mean(const HullBody& body, const std::set<std::size_t>& named, std::size_t corners) {
  const Integer count = named.size();
  const std::size_t size = 2 * (body.given->bits + bits(count));
  take_steps(8 * (body.rows().size() + corners), size, size);
  Vector mean(3);
  for (const std::size_t k : named) {
    for (std::size_t axis = 0; axis < 3; ++axis) mean[axis] += body.rows()[k][axis];
  }
  std::vector<Vector> result;
  for (const Vector& row : body.rows()) {
    result.push_back({count * row[0] - mean[0], count * row[1] - mean[1], count * row[2] - mean[2]});
  }
  return result;
}

// Is a ring in a plane strictly convex, once round, counter-clockwise seen from where the normal points?
bool is_convex(const std::vector<const Vector*>& ring, const Vector& normal) {
  std::size_t axis = 0;
  while (normal[axis] == 0) ++axis;
  std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  if (normal[axis] < 0) std::swap(i, j);
  Constraints ways;
  for (std::size_t k = 0; k < ring.size(); ++k) {
    const Vector &p = *ring[k], &q = *ring[after(k, ring.size())];
    ways.push_back({q[i] - p[i], q[j] - p[j], 0, 0});
  }
  return goes_round_once(ways);
}

struct FacePlane {
  Vector normal;
  Integer height;
};

class Surface {
 public:
  Surface(const std::vector<FaceHome>& homes, const HullBody& body, const IndexLists& faces)
      : homes_(homes), faces_(faces) {
    std::size_t corners = 0;
    for (const auto& face : faces) {
      vertices_.insert(face.begin(), face.end());
      corners += face.size();
    }
    at_ = from_mean(body, vertices_, corners);
  }

  void check() {
    for (std::size_t f = 0; f < faces_.size(); ++f) take_face(f);
    look_at_edges();
    look_through_first_face();
    for (std::size_t k = 0; k < homes_.size(); ++k) look_at_point(k);
  }

 private:
  void take_face(std::size_t f) {
    const Indices& face = faces_[f];
    std::vector<const Vector*> ring;
    for (const std::size_t k : face) ring.push_back(&at_[k]);
    FacePlane plane{cross(minus(*ring[1], *ring[0]), minus(*ring[2], *ring[0])), 0};
    plane.height = dot(plane.normal, *ring[0]);
    const bool is_flat = plane.height > 0 && std::all_of(ring.begin(), ring.end(), [&](const Vector* p) {
                           return dot(plane.normal, *p) == plane.height;
                         });
    require(is_flat && is_convex(ring, plane.normal), "surface",
            "face " + std::to_string(f) + " is no strictly convex polygon that is seen from outside");
    planes_.push_back(std::move(plane));
    for (std::size_t c = 0; c < face.size(); ++c) {
      const std::size_t d = after(c, face.size());
      const bool is_new = edges_.take(edge_of(face[c], face[d]), face[after(d, face.size())]);
      require(is_new, "surface",
              "two faces have the edge from " + std::to_string(face[c]) + " to " + std::to_string(face[d]));
    }
  }

  void look_at_edges() const {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      for (std::size_t c = 0; c < faces_[f].size(); ++c) {
        const std::size_t i = faces_[f][c], j = faces_[f][after(c, faces_[f].size())];
        const std::size_t* const beyond = edges_.beyond(edge_of(i, j));
        const std::string edge = " the edge from " + std::to_string(i) + " to " + std::to_string(j);
        require(beyond != nullptr, "surface", "only one face contains" + edge);
        require(dot(planes_[f].normal, at_[*beyond]) < planes_[f].height, "surface", edge.substr(1) + " is not convex");
      }
    }
  }

  // No other face is met on the way through the middle of the first.
  void look_through_first_face() const {
    Vector middle(3);
    for (const std::size_t k : faces_[0]) {
      for (std::size_t axis = 0; axis < 3; ++axis) middle[axis] += at_[k][axis];
    }
    for (std::size_t f = 1; f < faces_.size(); ++f) {
      require(!holds_way(faces_[f], middle), "surface", "face " + std::to_string(f) + " is in the way of face 0");
    }
  }

  // Is a way within the cone of a ring, seen from the mean?
  bool holds_way(const Indices& ring, const Vector& way) const {
    for (std::size_t c = 0; c < ring.size(); ++c) {
      if (dot(cross(at_[ring[c]], at_[ring[after(c, ring.size())]]), way) < 0) return false;
    }
    return true;
  }

  void look_at_point(std::size_t k) const {
    const FaceHome& home = homes_[k];
    if (home.face == no_index) {
      require(vertices_.contains(k), "surface", "point " + std::to_string(k) + " has no home");
      return;
    }
    const Indices& face = faces_[home.face];
    const bool is_home = holds_way({face[0], face[home.corner], face[home.corner + 1]}, at_[k]);
    require(is_home && dot(planes_[home.face].normal, at_[k]) <= planes_[home.face].height, "surface",
            "point " + std::to_string(k) + " is not in its home");
  }

  const std::vector<FaceHome>& homes_;
  const IndexLists& faces_;
  std::set<std::size_t> vertices_;
  std::vector<Vector> at_;
  std::vector<FacePlane> planes_;
  Ridges<std::size_t> edges_;  // their owners: the corner after the edge, of the face that goes along it
};

void check_surface(const std::vector<FaceHome>& homes, const HullBody& body, const IndexLists& faces) {
  Surface(homes, body, faces).check();
}

void check_outline(const Indices& sectors, const HullBody& body, const Indices& outline) {
  const std::set<std::size_t> vertices(outline.begin(), outline.end());
  const std::vector<Vector> at = from_mean(body, vertices, outline.size());
  std::vector<const Vector*> ring;
  for (const std::size_t k : outline) ring.push_back(&at[k]);
  const Vector normal = cross(*ring[0], *ring[1]);
  const bool is_flat =
      normal != Vector(3) && std::all_of(at.begin(), at.end(), [&](const Vector& p) { return dot(normal, p) == 0; });
  require(is_flat, "outline", "the points are not in one plane");
  require(is_convex(ring, normal), "outline", "the ring is not strictly convex");
  for (std::size_t k = 0; k < at.size(); ++k) {
    const std::string point = "point " + std::to_string(k);
    if (sectors[k] == no_index) {
      require(vertices.contains(k), "outline", point + " has no sector");
      continue;
    }
    const Vector &p = *ring[sectors[k]], &q = *ring[after(sectors[k], ring.size())];
    const bool is_in = dot(normal, cross(p, at[k])) >= 0 && dot(normal, cross(at[k], q)) >= 0 &&
                       dot(normal, cross(minus(q, p), minus(at[k], p))) >= 0;
    require(is_in, "outline", point + " is not in its sector");
  }
}

void check_between(const HullBody& body, std::size_t i, std::size_t j) {
  take_steps(4 * body.rows().size(), body.given->bits, body.given->bits);
  const Vector &first = body.rows()[i], &last = body.rows()[j];
  for (std::size_t k = 0; k < body.rows().size(); ++k) {
    require(first != last && is_between(first, last, body.rows()[k]), "between",
            "point " + std::to_string(k) + " is not between the ends");
  }
}

void check_one_point(const HullBody& body) {
  take_steps(4 * body.rows().size(), body.given->bits, body.given->bits);
  const bool is_one =
      std::all_of(body.rows().begin(), body.rows().end(), [&](const Vector& row) { return row == body.rows()[0]; });
  require(is_one, "one_point", "two points differ");
}

bool are_in_line(const Vector& p, const Vector& q, const Vector& r) {
  return all_zero(cross(minus(q, p), minus(r, p)));
}

// Faces of a mesh, counted modulo two, cover the boundary of the hull.
void check_bounds_hull(const Indices& beneath, const HullBody& body, const IndexLists& mesh, const Proved& proved) {
  const auto known = proved.hulls.find(body.base);
  require(known != proved.hulls.end() && known->second.verdict == "solid", "bounds_hull",
          "that the hull of " + body.quoted + " is solid has not been proved before");
  const IndexLists& hull = known->second.faces;
  std::size_t looks = 0;
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    require(beneath[f] < hull.size(), "bounds_hull", "a face is none of the hull's");
    looks += 16 * mesh[f].size();
  }
  take_steps(looks, body.given->bits, 2 * body.given->bits);
  const std::vector<Integers>& at = body.rows();
  const Vector &u = at[hull[0][0]], &v = at[hull[0][1]];
  std::map<std::pair<Vector, Vector>, std::size_t> times;  // that an edge comes
  std::size_t beside = 0;                                  // edges from u along the first edge of the hull
  for (std::size_t f = 0; f < mesh.size(); ++f) {
    const Indices& face = hull[beneath[f]];
    const Vector& origin = at[face[0]];
    const Vector normal = cross(minus(at[face[1]], origin), minus(at[face[2]], origin));
    for (std::size_t k = 0; k < mesh[f].size(); ++k) {
      const Vector &p = at[mesh[f][k]], &q = at[mesh[f][after(k, mesh[f].size())]];
      require(dot(normal, minus(p, origin)) == 0, "bounds_hull",
              "face " + std::to_string(f) + " is not in the plane of the one beneath it");
      if (p == q) continue;
      ++times[std::minmax(p, q)];
      if (beneath[f] == 0 && (p == u || q == u) && are_in_line(u, v, p == u ? q : p)) ++beside;
    }
  }
  for (const auto& [edge, count] : times) {
    require(count % 2 == 0, "bounds_hull", "an edge is one of an odd number of faces");
  }
  require(beside % 2 == 1, "bounds_hull", "the faces cover the hull an even number of times");
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
};

}  // namespace sunder_verifier
