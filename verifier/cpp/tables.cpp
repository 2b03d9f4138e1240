#include <verifier/cpp/reader.h>
#include <verifier/cpp/sentences.h>
#include <verifier/cpp/tables.h>

#include <algorithm>
#include <array>
#include <bit>
#include <cstdlib>
#include <limits>
#include <utility>

// long because: one reader for each table of docs/claims.md, in its order
namespace sunder_verifier {
namespace {

// 2^e, in which some doubles are integers; and the bits of the longest.
struct Unit {
  std::int64_t e = 0;
  std::size_t bits = 0;

  Integer integer(const Double& d) const { return d.n == 0 ? Integer(0) : shifted(d.n, d.e - e); }
};

Unit unit_of(const Doubles& doubles) {
  Unit unit;
  std::int64_t least = std::numeric_limits<std::int64_t>::max(), end = least;  // of the bits of all
  for (const Double& d : doubles) {
    if (d.n == 0) continue;
    const std::int64_t end_of_d =
        d.e + static_cast<std::int64_t>(std::bit_width(static_cast<std::uint64_t>(std::abs(d.n))));
    end = least == std::numeric_limits<std::int64_t>::max() ? end_of_d : std::max(end, end_of_d);
    least = std::min(least, d.e);
  }
  if (least == std::numeric_limits<std::int64_t>::max()) return unit;
  return {least, static_cast<std::size_t>(end - least)};
}

// Rows of so many numbers each.
Scaled rows_of(const Doubles& doubles, std::size_t count) {
  const Unit unit = unit_of(doubles);
  Scaled result{{}, unit.e, unit.bits};
  for (std::size_t k = 0; k < doubles.size(); ++k) {
    if (k % count == 0) result.rows.emplace_back();
    result.rows.back().push_back(unit.integer(doubles[k]));
  }
  return result;
}

// A list of lists of so many doubles each.
Doubles read_lists(const Json& list, std::size_t count, const std::string& where) {
  Doubles doubles;
  doubles.reserve(list.size() * count);
  std::size_t k = 0;
  for (const Json& row : list) add_doubles(row, count, where, k++, doubles);
  return doubles;
}

Scaled read_row(const Json& row, std::size_t count, const std::string& where) {
  Doubles doubles;
  add_doubles(row, count, where, 0, doubles);
  return rows_of(doubles, count);
}

void set_name(const Json& item, const std::string& where, Placed& body) {
  const std::string name = text_member(item, "name", where);
  body.name = shortened(name, most_shown);
  body.quoted = in_quotes(name, most_shown);
}

std::size_t dimension_of(const HullBody& body) { return body.dimension(); }
std::size_t dimension_of(const RowBody& body) { return body.dimension; }

// The image of one before it.
template <class Body>
Body read_image(const Json& item, const std::vector<Body>& bodies, const std::string& where) {
  require_members(item, {"name", "of", "linear", "translation"}, {}, where);
  Body body = bodies[index_member(item, "of", bodies.size(), where)];
  if (body.is_image()) refuse_form(where + " is of one that is placed itself");
  if (!body.said.empty()) body.said += ", mapped";
  const std::size_t d = dimension_of(body);
  body.linear = read_row(list_member(item, "linear", where), d * d, where + ".linear");
  body.translation = read_row(list_member(item, "translation", where), d, where + ".translation");
  return body;
}

template <class Body>
using ReadBody = Body (*)(const Json&, const std::vector<Body>&, const InputNames&, const std::string& where);

template <class Body>
void read_each(const Json& list, const std::string& name, ReadBody<Body> read, const InputNames& inputs,
               std::vector<Body>& bodies) {
  for (const Json& item : list) {
    bodies.push_back(read(item, bodies, inputs, "tables." + name + "[" + std::to_string(bodies.size()) + "]"));
  }
}

// The kind and radius of a body of points, if it has some.
void read_radius(const Json& item, const std::string& where, HullBody& body) {
  struct Kind {
    const char* key;
    Around around;
    std::size_t count;  // of points; 0: any
  };
  constexpr std::array kinds{Kind{"radius", Around::hull, 0}, Kind{"cylinder", Around::cylinder, 2},
                             Kind{"cone", Around::cone, 2}, Kind{"ellipsoid", Around::ellipsoid, 1}};
  for (const auto& [key, around, count] : kinds) {
    if (!item.contains(key)) continue;
    const bool is_first = !body.is_round(), is_of_so_many = count == 0 || body.count == count;
    body.radius = number_of(read_double(item[key], where + "." + key));
    body.radius_text = shown(item[key]);
    body.around = around;
    if (!is_first || !is_of_so_many || body.dimension() != 3 || body.rows().size() != body.count || body.radius.n < 0) {
      refuse_form(where + " is no body with a radius");
    }
  }
}

// Points, then ways: vectors, or arrows of twice as many numbers from one point to another.
Scaled read_points_and_ways(const Json& points, const Json* ways, const std::string& where) {
  const std::size_t count = points.size(), d = points[0].size();
  Doubles doubles;
  std::size_t k = 0;
  for (const Json& point : points) add_doubles(point, d, where + " row", k++, doubles);
  if (ways != nullptr) {
    for (const Json& way : *ways) {  // all as arrows
      const bool is_arrow = way.is_array() && way.size() == 2 * d;
      if (!is_arrow) doubles.resize(doubles.size() + d);
      add_doubles(way, is_arrow ? 2 * d : d, where + " row", k++, doubles);
    }
  }
  Scaled scaled = rows_of(doubles, d);
  const std::size_t all = (scaled.rows.size() + count) / 2;
  for (k = count; k < all; ++k) {
    const Integers &from = scaled.rows[2 * k - count], &to = scaled.rows[2 * k - count + 1];
    Integers way;
    for (std::size_t axis = 0; axis < d; ++axis) way.push_back(to[axis] - from[axis]);
    scaled.rows[k] = std::move(way);
  }
  scaled.rows.resize(all);
  scaled.bits = 0;
  for (const Integers& row : scaled.rows) scaled.bits = std::max(scaled.bits, bits(row));
  return scaled;
}

std::string read_said_of(const Json& item, const InputNames& inputs, const std::string& where) {
  return item.contains("said") ? read_description(item["said"], inputs, where + ".said") : "";
}

HullBody read_body(const Json& item, const std::vector<HullBody>& bodies, const InputNames& inputs,
                   const std::string& where) {
  HullBody body;
  if (item.is_object() && item.contains("of")) {
    body = read_image(item, bodies, where);
  } else {
    require_members(item, {"name", "points"}, {"ways", "radius", "cylinder", "cone", "ellipsoid", "said"}, where);
    const Json& points = list_member(item, "points", where);
    if (points.empty() || !points[0].is_array() || points[0].size() < 2 || points[0].size() > 6) {
      refuse_form(where + ".points is not a list of points of 2 to 6 numbers");
    }
    body.base = bodies.size();
    body.count = points.size();
    const Json* ways = item.contains("ways") ? &list_member(item, "ways", where) : nullptr;
    body.given = std::make_shared<const Scaled>(read_points_and_ways(points, ways, where));
    read_radius(item, where, body);
    body.said = read_said_of(item, inputs, where);
  }
  if (body.around == Around::cylinder || body.around == Around::cone) {
    const Integers &base = body.rows()[0], &top = body.rows()[1];
    body.axis = turned(body, {top[0] - base[0], top[1] - base[1], top[2] - base[2]});
    if (dot(body.axis, body.axis) == 0) refuse_form(where + " has no axis");
  }
  set_name(item, where, body);
  return body;
}

RowBody read_polytope(const Json& item, const std::vector<RowBody>& polytopes, const InputNames& inputs,
                      const std::string& where) {
  RowBody body;
  if (item.is_object() && item.contains("of")) {
    body = read_image(item, polytopes, where);
  } else {
    body.is_of_points = item.is_object() && item.contains("points");
    const char* const key = body.is_of_points ? "points" : "half_spaces";
    require_members(item, {"name", "dimension", key}, {"said"}, where);
    body.said = read_said_of(item, inputs, where);
    body.dimension = index_member(item, "dimension", 7, where);
    if (body.dimension < 2) refuse_form(where + ".dimension is not an index in range");
    const Json& rows = list_member(item, key, where);
    if (body.is_of_points && rows.empty()) refuse_form(where + ".points is empty");
    const std::size_t count = body.dimension + (body.is_of_points ? 0 : 1);
    body.given = std::make_shared<const Scaled>(rows_of(read_lists(rows, count, where + " row"), count));
  }
  set_name(item, where, body);
  return body;
}

MeshBody read_mesh(const Json& item, const std::vector<MeshBody>& meshes, const InputNames& inputs,
                   const std::string& where) {
  MeshBody mesh;
  if (item.is_object() && item.contains("of")) {
    mesh = read_image(item, meshes, where);
  } else {
    require_members(item, {"name", "points", "triangles"}, {"said"}, where);
    mesh.said = read_said_of(item, inputs, where);
    const Json& rows = list_member(item, "points", where);
    mesh.given = std::make_shared<const Scaled>(rows_of(read_lists(rows, 3, where + " row"), 3));
    mesh.base = meshes.size();
    mesh.count = mesh.rows().size();
    std::vector<const Integers*> sorted;
    for (const Integers& row : mesh.rows()) sorted.push_back(&row);
    std::sort(sorted.begin(), sorted.end(), [](const Integers* p, const Integers* q) {
      const auto [x, y] = std::mismatch(p->begin(), p->end(), q->begin());
      return x != p->end() && *x < *y;
    });
    const auto are_equal = [](const Integers* p, const Integers* q) { return *p == *q; };
    if (std::adjacent_find(sorted.begin(), sorted.end(), are_equal) != sorted.end()) {
      refuse_form(where + " has two points that are equal");
    }
    std::vector<MeshTriangle> triangles;
    for (const Json& triangle : list_member(item, "triangles", where)) {
      const std::vector<std::size_t> corners = read_indices(triangle, mesh.count, where + ".triangles", 3);
      triangles.push_back({corners[0], corners[1], corners[2]});
    }
    if (triangles.empty()) refuse_form(where + ".triangles is empty");
    set_name(item, where, mesh);
    take_steps(32 * triangles.size(), 2 * mesh.given->bits, 2 * mesh.given->bits);
    mesh.pieces = std::make_shared<const MeshPieces>(pieces_of(std::move(triangles), mesh.rows()));
    return mesh;
  }
  set_name(item, where, mesh);
  return mesh;
}

void read_meshes(const Json& list, Tables& tables) {
  read_each(list, "meshes", read_mesh, tables.inputs, tables.meshes);
}

void read_polytopes(const Json& list, Tables& tables) {
  read_each(list, "polytopes", read_polytope, tables.inputs, tables.polytopes);
}

// To the left of an arrow from p to q, which are in units of 2^e.
LinearConstraint left_of(const Integers& p, const Integers& q, std::int64_t e, const std::string& where) {
  if (p == q) refuse_form(where + " has no direction");
  // a and b are in units of 2^e, c in units of their square.
  const std::int64_t up = std::max<std::int64_t>(-e, 0), down = std::max<std::int64_t>(e, 0);
  return {shifted(q[1] - p[1], up), shifted(p[0] - q[0], up), shifted(p[0] * q[1] - q[0] * p[1], down), e - up};
}

LinearConstraint read_constraint(const Json& item, const std::string& where) {
  if (!item.is_array() || (item.size() != 3 && item.size() != 4)) refuse_form(where + " is not a list of 3 or 4");
  const Scaled row = read_row(item, item.size(), where);
  const Integers& v = row.rows[0];
  if (v.size() == 4) return left_of({v[0], v[1]}, {v[2], v[3]}, row.e, where);
  if (v[0] == 0 && v[1] == 0) refuse_form(where + " has no direction");
  return {v[0], v[1], v[2], row.e};
}

void read_bodies(const Json& list, Tables& tables) {
  read_each(list, "bodies", read_body, tables.inputs, tables.bodies);
}

// Members of so many numbers each, of which `make` makes one. is_one: are these one? Else the reason.
template <class Member, std::size_t columns, class IsOne>
MemberTable<Member> read_members(const Json& list, const std::string& name,
                                 Member (*make)(const std::array<Integer, columns>&), const IsOne& is_one,
                                 const char* otherwise) {
  const Doubles doubles = read_lists(list, columns, name);
  const Unit unit = unit_of(doubles);
  MemberTable<Member> members;
  members.exponent = unit.e;
  members.bits = unit.bits;
  members.reserve(list.size());
  for (auto d = doubles.begin(); d != doubles.end(); d += columns) {
    std::array<Integer, columns> numbers;
    auto next = d;
    for (Integer& number : numbers) number = unit.integer(*next++);
    const Member member = make(numbers);
    if (!is_one(member)) refuse_form(name + "[" + std::to_string(members.size()) + "] " + otherwise);
    members.push_back(member);
  }
  return members;
}

void read_segments(const Json& list, Tables& tables) {
  tables.segments = read_members<PlanarSegment, 4>(
      list, "tables.segments",
      [](const std::array<Integer, 4>& n) { return PlanarSegment{{n[0], n[1]}, {n[2], n[3]}}; },
      [](const PlanarSegment& s) { return !is_less(s.last, s.first); },
      "does not begin with its lexicographically first end");
}

void read_circles(const Json& list, Tables& tables) {
  tables.circles = read_members<PlanarDisc, 3>(
      list, "tables.circles", [](const std::array<Integer, 3>& n) { return PlanarDisc{n[0], n[1], n[2]}; },
      [](const PlanarDisc& c) { return c.r >= 0; }, "has a negative radius");
}

void read_boxes(const Json& list, Tables& tables) {
  const auto is_one = [](const PlanarBox& b) { return b.low_x <= b.high_x && b.low_y <= b.high_y; };
  tables.boxes = read_members<PlanarBox, 4>(
      list, "tables.boxes", [](const std::array<Integer, 4>& n) { return PlanarBox{n[0], n[1], n[2], n[3]}; }, is_one,
      "does not begin with its lowest corner");
}

// The coordinates of the vertices of all rings, in turn.
Doubles read_vertices(const Json& list, PolygonTable& polygons) {
  Doubles doubles;
  std::size_t count = 0;
  for (const Json& item : list) {
    const std::string where = "tables.polygons[" + std::to_string(polygons.rings.size()) + "]";
    const std::string not_rings = where + " is not a list of rings of one vertex or more";
    if (!item.is_array()) refuse_form(not_rings);
    polygons.rings.emplace_back();
    for (const Json& ring : item) {
      if (!ring.is_array() || ring.empty()) refuse_form(not_rings);
      polygons.rings.back().push_back({count, count + ring.size()});
      for (const Json& vertex : ring) add_doubles(vertex, 2, "tables.polygons vertex", count++, doubles);
    }
  }
  return doubles;
}

PlanarSegment edge_between(PlanarPoint p, PlanarPoint q) {
  if (is_less(q, p)) std::swap(p, q);
  return {std::move(p), std::move(q)};
}

// Of a ring whose edges are known.
void add_blocks(PolygonTable& polygons, EdgeRange& ring) {
  ring.first_block = polygons.blocks.size();
  for (std::size_t k = ring.begin; k < ring.end; ++k) {
    const PlanarSegment& edge = polygons.edges[k];
    const Integer& low = std::min(edge.first.y, edge.last.y);
    if ((k - ring.begin) % edges_of_block == 0) {
      polygons.blocks.push_back({edge.first.x, edge.last.x, low});
      continue;
    }
    EdgeBlock& block = polygons.blocks.back();
    if (edge.first.x < block.left) block.left = edge.first.x;
    if (edge.last.x > block.right) block.right = edge.last.x;
    if (low < block.low) block.low = low;
  }
}

void read_polygons(const Json& list, Tables& tables) {
  PolygonTable& polygons = tables.polygons;
  const Doubles doubles = read_vertices(list, polygons);
  const Unit unit = unit_of(doubles);
  polygons.edges.exponent = unit.e;
  polygons.edges.bits = unit.bits;
  const auto vertex = [&](std::size_t k) {
    return PlanarPoint{unit.integer(doubles[2 * k]), unit.integer(doubles[2 * k + 1])};
  };
  for (std::size_t i = 0; i < polygons.rings.size(); ++i) {
    for (EdgeRange& ring : polygons.rings[i]) {
      for (std::size_t k = ring.begin; k < ring.end; ++k) {
        polygons.edges.push_back(edge_between(vertex(k), vertex(k + 1 < ring.end ? k + 1 : ring.begin)));
        polygons.owner.push_back(i);
      }
      add_blocks(polygons, ring);
    }
  }
}

void read_half_planes(const Json& list, Tables& tables) {
  for (const Json& item : list) {
    const std::string where = "tables.half_planes[" + std::to_string(tables.half_planes.size()) + "]";
    LinearConstraint h = read_constraint(item, where);
    tables.half_planes.bits = std::max({tables.half_planes.bits, bits(h.a), bits(h.b), bits(h.c)});
    tables.half_planes.push_back(std::move(h));
  }
}

Scaled read_vertex_list(const Json& item, std::size_t least, const std::string& where) {
  if (!item.is_array() || item.size() < least) {
    refuse_form(where + " is not a list of " + std::to_string(least) + " or more vertices");
  }
  return rows_of(read_lists(item, 2, where), 2);
}

Constraints edges_of(const Scaled& vertices, const std::string& where) {
  Constraints result;
  const std::vector<Integers>& rows = vertices.rows;
  for (std::size_t k = 0; k < rows.size(); ++k) {
    result.push_back(left_of(rows[k], rows[k + 1 == rows.size() ? 0 : k + 1], vertices.e, where));
  }
  return result;
}

// Of each edge of some length of a ring.
void add_neighbours(const EdgeRange& ring, PartTable& parts) {
  std::vector<std::size_t> on;
  for (std::size_t k = ring.begin; k < ring.end; ++k) {
    const PlanarSegment& edge = parts.polygons.edges[k];
    if (!(edge.first == edge.last)) on.push_back(k);
  }
  parts.beside.resize(ring.end);
  for (std::size_t k = 0; k < on.size(); ++k) {
    parts.beside[on[k]] = {on[k == 0 ? on.size() - 1 : k - 1], on[k + 1 == on.size() ? 0 : k + 1]};
  }
}

// Some polygons, with edges and rings numbered anew.
PartTable numbered_anew(const PolygonTable& all, const std::vector<std::size_t>& which) {
  PartTable result;
  PolygonTable& polygons = result.polygons;
  polygons.edges.exponent = all.edges.exponent;
  for (const std::size_t i : which) {
    result.shell.push_back(result.rings.size());
    polygons.rings.emplace_back();
    for (const EdgeRange& ring : all.rings[i]) {
      const std::size_t begin = polygons.edges.size();
      for (std::size_t k = ring.begin; k < ring.end; ++k) {
        const PlanarSegment& edge = all.edges[k];
        for (const Integer* x : {&edge.first.x, &edge.first.y, &edge.last.x, &edge.last.y}) {
          polygons.edges.bits = std::max(polygons.edges.bits, bits(*x));
        }
        polygons.edges.push_back(edge);
        polygons.owner.push_back(polygons.rings.size() - 1);
        result.ring_of.push_back(result.rings.size());
      }
      polygons.rings.back().push_back({begin, polygons.edges.size()});
      add_blocks(polygons, polygons.rings.back().back());
      add_neighbours(polygons.rings.back().back(), result);
      result.rings.push_back(polygons.rings.back().back());
      result.part.push_back(polygons.rings.size() - 1);
    }
  }
  return result;
}

// A ring as the one of a polygon.
std::shared_ptr<const PartTable> alone(const Scaled& vertices) {
  const std::size_t size = vertices.rows.size();
  const auto vertex = [&](std::size_t k) { return PlanarPoint{vertices.rows[k][0], vertices.rows[k][1]}; };
  PolygonTable one;
  one.edges.exponent = vertices.e;
  one.rings = {{{0, size}}};
  for (std::size_t k = 0; k < size; ++k) {
    one.edges.push_back(edge_between(vertex(k), vertex(k + 1 == size ? 0 : k + 1)));
  }
  return std::make_shared<const PartTable>(numbered_anew(one, {0}));
}

void read_rings(const Json& list, Tables& tables) {
  for (const Json& item : list) {
    const std::string where = "tables.rings[" + std::to_string(tables.rings.size()) + "]";
    const Scaled vertices = read_vertex_list(item, 3, where);
    Integer area = 0;
    for (std::size_t k = 0; k < vertices.rows.size(); ++k) {
      const Integers &p = vertices.rows[k], &q = vertices.rows[k + 1 == vertices.rows.size() ? 0 : k + 1];
      area += p[0] * q[1] - p[1] * q[0];
    }
    if (area == 0) refuse_form(where + " has no area");
    tables.rings.push_back(edges_of(vertices, where));
    tables.ring_parts.push_back(alone(vertices));
    if (area > 0) continue;
    for (LinearConstraint& h : tables.rings.back()) {
      h.a = -h.a;
      h.b = -h.b;
      h.c = -h.c;
    }
  }
}

// x or y (axis 0 or 1), times way, is at most so many units of 2^e.
LinearConstraint at_most(std::size_t axis, int way, const Integer& limit, std::int64_t e) {
  const Integer one = shifted(Integer(way), std::max<std::int64_t>(-e, 0));
  const Integer none = 0, most = shifted(limit, std::max<std::int64_t>(e, 0));
  return {axis == 0 ? one : none, axis == 0 ? none : one, most, std::min<std::int64_t>(e, 0)};
}

// A segment, or a point.
Constraints sides_of_flat(const Scaled& vertices, const std::string& where) {
  Constraints result;
  const Integers &p = vertices.rows.front(), &q = vertices.rows.back();
  if (vertices.rows.size() == 2) result = edges_of(vertices, where);
  for (const int way : {1, -1}) {
    for (const std::size_t axis : {0u, 1u}) {
      if (vertices.rows.size() == 2 && axis == (p[0] == q[0] ? 0u : 1u)) continue;
      result.push_back(at_most(axis, way, std::max<Integer>(way * p[axis], way * q[axis]), vertices.e));
    }
  }
  return result;
}

void read_convex_polygons(const Json& list, Tables& tables) {
  std::size_t number = 0;
  for (const Json& item : list) {
    const std::string where = "tables.convex_polygons[" + std::to_string(number++) + "]";
    const Scaled vertices = read_vertex_list(item, 1, where);
    const bool is_flat = vertices.rows.size() < 3;
    const Constraints sides = is_flat ? sides_of_flat(vertices, where) : edges_of(vertices, where);
    if (!is_flat && !goes_round_once(sides)) refuse_form(where + " is not strictly convex and counter-clockwise");
    tables.convex_polygons.insert(tables.convex_polygons.end(), sides.begin(), sides.end());
  }
}

}  // namespace

bool is_less(const PlanarPoint& p, const PlanarPoint& q) { return p.x != q.x ? p.x < q.x : p.y < q.y; }

Integer turn(const LinearConstraint& h, const LinearConstraint& k) { return h.a * k.b - h.b * k.a; }

bool goes_round_once(const Constraints& sides) {
  const auto is_low = [](const LinearConstraint& h) { return h.b < 0 || (h.b == 0 && h.a < 0); };
  std::size_t rounds = 0;
  for (std::size_t k = 0; k < sides.size(); ++k) {
    const LinearConstraint &h = sides[k], &next = sides[k + 1 == sides.size() ? 0 : k + 1];
    if (turn(h, next) <= 0) return false;
    if (is_low(h) && !is_low(next)) ++rounds;
  }
  return rounds == 1;
}

Integers projective(const Numbers& values) {
  Common scaled = common(values);
  const std::int64_t up = std::max<std::int64_t>(scaled.e, 0), down = std::max<std::int64_t>(-scaled.e, 0);
  for (Integer& n : scaled.integers) n = shifted(n, up);
  scaled.integers.push_back(shifted(scaled.d, down));
  return std::move(scaled.integers);
}

Integer dot(const Integers& u, const Integers& v) {
  Integer sum = 0;
  for (std::size_t k = 0; k < u.size(); ++k) sum += u[k] * v[k];
  return sum;
}

Integers cross(const Integers& u, const Integers& v) {
  return {u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]};
}

Integers transposed_times(const Scaled& matrix, const Integers& vector) {
  const std::size_t d = vector.size();
  Integers result(d);
  for (std::size_t k = 0; k < d * d; ++k) result[k % d] += vector[k / d] * matrix.rows[0][k];
  return result;
}

Integers turned(const Placed& body, const Integers& vector) {
  if (!body.is_image()) return vector;
  const std::size_t d = body.translation.rows[0].size();
  Integers result(d);
  for (std::size_t k = 0; k < d * d; ++k) result[k / d] += body.linear.rows[0][k] * vector[k % d];
  return result;
}

std::string HullBody::title() const {
  const bool is_hull = around == Around::hull, is_ball = around == Around::ellipsoid || (is_hull && count == 1);
  const bool is_all_mapped = around == Around::ellipsoid && is_image();
  const std::string kind = around == Around::nothing    ? "convex hull"
                           : is_ball                    ? "ball"
                           : is_hull                    ? (count == 2 ? "capsule" : "rounded hull")
                           : around == Around::cylinder ? "cylinder"
                                                        : "cone";
  const std::size_t ways = rows().size() - count;
  return (is_all_mapped ? "the image of the " : "the ") + kind + (is_round() ? " of radius " + radius_text : "") +
         " of the " + counted(count, is_image() && !is_all_mapped ? "mapped point" : "point") +
         (ways > 0 ? " and " + counted(ways, "way") : "") + " of " + quoted;
}

std::string RowBody::title() const {
  return (is_image() ? "the image of the " : "the ") + std::string(is_of_points ? "convex hull" : "common part") +
         " of the " + counted(given->rows.size(), is_of_points ? "point" : "half-space") + " of " + quoted;
}

std::size_t HullBody::size() const {
  std::size_t sum = length({radius});
  for (const Scaled* part : {given.get(), &linear, &translation}) {
    sum += part->bits + static_cast<std::size_t>(std::abs(part->e));
  }
  return sum;
}

std::pair<Integers, std::int64_t> image(const HullBody& body, std::size_t k) {
  if (!body.is_image()) return {body.rows()[k], body.given->e};
  const std::int64_t unit = body.linear.e + body.given->e, e = std::min(unit, body.translation.e);
  Integers result;
  for (const Integer& n : turned(body, body.rows()[k])) {
    const std::size_t r = result.size();
    result.push_back(shifted(n, unit - e));
    if (!body.is_way(k)) result.back() += shifted(body.translation.rows[0][r], body.translation.e - e);
  }
  return {std::move(result), e};
}

std::pair<Integers, std::int64_t> products(const HullBody& body, const Integers& direction) {
  Integers row = direction, result;
  std::int64_t turned = body.given->e, e = turned;
  Integer moved = 0;
  if (body.is_image()) {
    const std::size_t d = body.dimension();
    take_steps(d * d, bits(direction), body.linear.bits);
    row = transposed_times(body.linear, direction);
    turned += body.linear.e;
    e = std::min(turned, body.translation.e);
    moved = shifted(dot(direction, body.translation.rows[0]), body.translation.e - e);
  }
  take_steps(body.rows().size(), bits(row), body.given->bits);
  for (std::size_t k = 0; k < body.rows().size(); ++k) {
    result.push_back(shifted(dot(row, body.rows()[k]), turned - e));
    if (!body.is_way(k)) result.back() += moved;
  }
  return {std::move(result), e};
}

bool PolygonTable::is_flat(std::size_t polygon) const {
  std::size_t count = 0;
  for (const EdgeRange& ring : rings[polygon]) count += ring.end - ring.begin;
  return count < 3;
}

bool PolygonTable::is_point(std::size_t polygon) const {
  for (const EdgeRange& ring : rings[polygon]) {
    for (std::size_t k = ring.begin; k < ring.end; ++k) {
      if (!(edges[k].first == edges[k].last)) return false;
    }
  }
  return true;
}

std::shared_ptr<const PartTable> Tables::parts_of(const std::vector<std::size_t>& which) const {
  if (last_parts_ == nullptr || last_named_ != which) {
    std::size_t size = 0;
    for (const std::size_t i : which) {
      for (const EdgeRange& ring : polygons.rings[i]) size += ring.end - ring.begin;
    }
    take_steps(20 * size, 1, 1);
    last_named_ = which;
    last_parts_ = std::make_shared<const PartTable>(numbered_anew(polygons, which));
    ++part_tables_made_;
  }
  return last_parts_;
}

Tables read_tables(const Json& item, InputNames inputs) {
  using Reader = void (*)(const Json&, Tables&);
  std::map<std::string, Reader> readers;
  readers["bodies"] = read_bodies;
  readers["boxes"] = read_boxes;
  readers["circles"] = read_circles;
  readers["convex_polygons"] = read_convex_polygons;
  readers["half_planes"] = read_half_planes;
  readers["meshes"] = read_meshes;
  readers["polygons"] = read_polygons;
  readers["polytopes"] = read_polytopes;
  readers["rings"] = read_rings;
  readers["segments"] = read_segments;
  Tables tables;
  tables.inputs = std::move(inputs);
  std::vector<std::string> names;
  for (const auto& [name, reader] : readers) names.push_back(name);
  require_members(item, {}, names, "tables");
  for (const bool are_meshes : {false, true}) {  // these last, as finding their pieces takes steps
    for (const auto& [key, list] : item.members()) {
      const std::string name(key);
      if ((name == "meshes") != are_meshes) continue;
      const ReadNow table(*list);
      if (!(*table).is_array()) refuse_form("tables." + name + " is not a list");
      readers.at(name)(*table, tables);
      tables.sizes[name] = (*table).size();
    }
  }
  return tables;
}

void read_said(const Json& item, Tables& tables) {
  if (!item.is_object()) refuse_form("said is not an object");
  for (const auto& [key, list] : item.members()) {
    const std::string name(key), where = "said." + name;
    const auto size = tables.sizes.find(name);
    if (size == tables.sizes.end() || name == "bodies" || name == "polytopes" || name == "meshes") {
      refuse_form(where + " is of no table of rows that the file has");
    }
    tables.said[name] = read_said_of_rows(*ReadNow(*list), tables.inputs, size->second, where);
  }
}

}  // namespace sunder_verifier
