// long because: it is the list of all questions, each with what it says and brings.
#include <verifier/cpp/questions.h>
#include <verifier/cpp/reader.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sentences.h>

#include <algorithm>
#include <array>
#include <memory>
#include <set>

namespace sunder_verifier {
namespace {

// What a statement says; what its question does not name is empty.
struct Said {
  const HullBody *a = nullptr, *b = nullptr;
  std::size_t index_a = 0, index_b = 0;
  StatedMotion motion_a, motion_b;
  Number time;
  const RowBody *polytope_a = nullptr, *polytope_b = nullptr;
  const RowBody* half_spaces = nullptr;
  std::size_t dimension = 0;
  std::vector<Numbers> spanned_by, vertices;
  Numbers as_good;
  Number least;
  AllPairs all_pairs;
  const Proved* proved = nullptr;
  const HullBody* body = nullptr;
  StatedPlane plane;
  std::vector<std::pair<std::size_t, std::size_t>> corners;
  std::vector<std::vector<std::size_t>> faces;
  std::vector<std::vector<std::vector<std::size_t>>> facets;  // of simplices
  std::vector<std::size_t> outline;
  Numbers objective, point, from_a, to_b;
  AllowedContacts allowed;
  std::vector<std::int64_t> groups;
  StatedContact contact;
  std::shared_ptr<const PartTable> parts;
  std::vector<std::size_t> named_parts;
  ValidRule rule = ValidRule::valid;
  std::size_t ring = 0, other = 0, edge = 0;
  std::vector<std::size_t> rings;
  std::vector<Numbers> points;
  std::vector<StatedContact> contacts;
  std::uint64_t number = 0;
  std::string verdict;
  const Constraints* kernel_of = nullptr;
  std::vector<std::size_t> sides, arcs;
};

struct Place {
  const Json& item;
  const Tables& tables;
  const std::string& where;
};

using ReadMember = void (*)(const Place& place, Said& said);

struct MemberReader {
  const char* name;
  ReadMember read;
};

void read_a(const Place& p, Said& said) {
  said.index_a = index_member(p.item, "a", p.tables.bodies.size(), p.where);
  said.a = &p.tables.bodies[said.index_a];
}

void read_b(const Place& p, Said& said) {
  said.index_b = index_member(p.item, "b", p.tables.bodies.size(), p.where);
  said.b = &p.tables.bodies[said.index_b];
  if (said.a->dimension() != said.b->dimension()) refuse_form(p.where + " is of bodies of different dimensions");
}

void read_plain_a(const Place& p, Said& said) {
  read_a(p, said);
  if (said.a->is_round()) refuse_form(p.where + ".a has a radius");
}

void read_plain_b(const Place& p, Said& said) {
  read_b(p, said);
  if (said.b->is_round()) refuse_form(p.where + ".b has a radius");
}

// Is it the same body, placed by the same matrix?
bool is_moved(const HullBody& begin, const HullBody& end) {
  if (begin.base != end.base) return false;
  const std::size_t d = begin.dimension();
  for (std::size_t k = 0; k < d * d; ++k) {
    const Integer here = k % (d + 1) == 0 ? 1 : 0;
    const auto entry = [&](const HullBody& body) {
      return body.is_image() ? Number{body.linear.rows[0][k], 1, body.linear.e} : Number{here, 1, 0};
    };
    const Integers both = common({entry(begin), entry(end)}).integers;
    if (both[0] != both[1]) return false;
  }
  return true;
}

template <auto Said::* begin, auto Said::* motion>
void read_end_of(const Place& p, Said& said) {
  const char* const key = begin == &Said::a ? "to_a" : "to_b";
  const HullBody& end = p.tables.bodies[index_member(p.item, key, p.tables.bodies.size(), p.where)];
  if (!is_moved(*(said.*begin), end)) refuse_form(p.where + "." + key + " is not the same body, moved");
  said.*motion = {said.*begin, &end};
}

void read_time(const Place& p, Said& said) {
  said.time = read_number(member(p.item, "time", p.where), p.where + ".time");
  const Integers ends = common({said.time, {1, 1, 0}}).integers;
  if (ends[0] < 0 || ends[0] > ends[1]) refuse_form(p.where + ".time is not from 0 to 1");
}

void read_polytope_a(const Place& p, Said& said) {
  said.polytope_a = &p.tables.polytopes[index_member(p.item, "a", p.tables.polytopes.size(), p.where)];
}

void read_polytope_b(const Place& p, Said& said) {
  said.polytope_b = &p.tables.polytopes[index_member(p.item, "b", p.tables.polytopes.size(), p.where)];
  if (said.polytope_a->dimension != said.polytope_b->dimension) {
    refuse_form(p.where + " is of bodies of different dimensions");
  }
}

void read_half_spaces(const Place& p, Said& said) {
  said.half_spaces = &p.tables.polytopes[index_member(p.item, "half_spaces", p.tables.polytopes.size(), p.where)];
  if (said.half_spaces->is_of_points || said.half_spaces->is_image()) {
    refuse_form(p.where + ".half_spaces is not of half-spaces, or placed");
  }
  if (said.half_spaces->given->rows.empty()) refuse_form(p.where + ".half_spaces is of no half-spaces");
}

std::size_t dimension(const Said& said) {
  if (said.half_spaces != nullptr) return said.half_spaces->dimension;
  if (said.polytope_a != nullptr) return said.polytope_a->dimension;
  return said.a != nullptr ? said.a->dimension() : 2;
}

void read_point(const Place& p, Said& said) {
  said.point = read_numbers(list_member(p.item, "point", p.where), dimension(said), p.where + ".point");
}

void read_from_a(const Place& p, Said& said) {
  said.from_a = read_numbers(list_member(p.item, "from_a", p.where), dimension(said), p.where + ".from_a");
}

void read_to_b(const Place& p, Said& said) {
  said.to_b = read_numbers(list_member(p.item, "to_b", p.where), dimension(said), p.where + ".to_b");
}

void read_as_good(const Place& p, Said& said) {
  said.as_good = read_numbers(list_member(p.item, "as_good", p.where), dimension(said), p.where + ".as_good");
}

void read_dimension(const Place& p, Said& said) {
  said.dimension = index_member(p.item, "dimension", said.half_spaces->dimension + 1, p.where);
}

std::vector<Numbers> read_places(const Place& p, const char* key, const Said& said) {
  std::vector<Numbers> result;
  for (const Json& entry : list_member(p.item, key, p.where)) {
    const std::string where = p.where + "." + key + " entry";
    require_members(entry, {"point"}, {}, where);
    result.push_back(read_numbers(list_member(entry, "point", where), dimension(said), where));
  }
  return result;
}

void read_spanned_by(const Place& p, Said& said) { said.spanned_by = read_places(p, "spanned_by", said); }

void read_vertices(const Place& p, Said& said) {
  said.vertices = read_places(p, "vertices", said);
  if (said.vertices.empty()) refuse_form(p.where + ".vertices is empty");
}

void read_least(const Place& p, Said& said) {
  said.least = number_of(read_double(p.item["least"], p.where + ".least"));
  if (said.least.n <= 0) refuse_form(p.where + ".least is not positive");
}

void read_most(const Place& p, Said& said) {
  said.least = number_of(read_double(p.item["most"], p.where + ".most"));
  if (said.least.n < 0) refuse_form(p.where + ".most is negative");
}

void read_solid_a(const Place& p, Said& said) {
  read_a(p, said);
  if (said.a->dimension() != 3 || said.a->count != said.a->rows().size()) {
    refuse_form(p.where + ".a is not bounded, in space");
  }
}

void read_solid_b(const Place& p, Said& said) {
  read_b(p, said);
  if (said.b->count != said.b->rows().size()) refuse_form(p.where + ".b is not bounded, in space");
}

bool is_of_points(const HullBody& body) {
  return body.count == body.rows().size() && body.dimension() == 3 && !body.is_round();
}

void read_body(const Place& p, Said& said) {
  said.body = &p.tables.bodies[index_member(p.item, "body", p.tables.bodies.size(), p.where)];
  if (said.body->is_image() || !is_of_points(*said.body)) refuse_form(p.where + ".body is not of points in space");
}

void read_body_of_any_dimension(const Place& p, Said& said) {
  said.body = &p.tables.bodies[index_member(p.item, "body", p.tables.bodies.size(), p.where)];
  const bool is_of_points = said.body->count == said.body->rows().size() && !said.body->is_round();
  if (said.body->is_image() || !is_of_points) refuse_form(p.where + ".body is not of points in space");
}

void read_of(const Place& p, Said& said) {
  said.body = &p.tables.bodies[index_member(p.item, "of", p.tables.bodies.size(), p.where)];
  if (!is_of_points(*said.body)) refuse_form(p.where + ".of is not of points in space");
}

// A normal, a point, and how far above it, times the normal.
void read_plane(const Place& p, Said& said) {
  Numbers values;
  for (const Double& d : read_doubles(list_member(p.item, "plane", p.where), 7, p.where + ".plane")) {
    values.push_back(number_of(d));
  }
  const auto [row, d, e] = common(values);
  if (row[0] == 0 && row[1] == 0 && row[2] == 0) refuse_form(p.where + ".plane has no direction");
  const std::int64_t up = std::max<std::int64_t>(-e, 0), down = std::max<std::int64_t>(e, 0);
  const Integer level = row[0] * row[3] + row[1] * row[4] + row[2] * row[5];
  said.plane = {{shifted(row[0], up), shifted(row[1], up), shifted(row[2], up)},
                shifted(level, down) + shifted(row[6], up)};
}

void read_corners(const Place& p, Said& said) {
  const std::string where = p.where + ".corners";
  const std::size_t size = said.body->rows().size();
  for (const Json& entry : list_member(p.item, "corners", p.where)) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(where + " entry is not a list of 2");
    said.corners.emplace_back(read_index(entry[0], size, where + " entry"),
                              read_index(entry[1], size, where + " entry"));
  }
  const std::set<std::pair<std::size_t, std::size_t>> once(said.corners.begin(), said.corners.end());
  if (once.empty() || once.size() != said.corners.size()) refuse_form(where + " is empty, or names one twice");
}

// Corners of a face, or an outline.
std::vector<std::size_t> corners_of(const Json& list, std::size_t size, const std::string& where) {
  std::vector<std::size_t> result;
  if (!list.is_array()) refuse_form(where + " is not a list");
  for (const Json& entry : list) result.push_back(read_index(entry, size, where + " entry"));
  if (result.size() < 3) refuse_form(where + " has fewer than three corners");
  return result;
}

void read_faces(const Place& p, Said& said) {
  for (const Json& face : list_member(p.item, "faces", p.where)) {
    said.faces.push_back(corners_of(face, said.body->rows().size(), p.where + ".faces entry"));
  }
  if (said.faces.empty()) refuse_form(p.where + ".faces is empty");
}

void read_outline(const Place& p, Said& said) {
  said.outline = corners_of(p.item["outline"], said.body->rows().size(), p.where + ".outline");
}

// Lists of simplices, which are lists of corners, all of as many.
void read_facets(const Place& p, Said& said) {
  const std::string where = p.where + ".facets";
  std::size_t size = 0;
  for (const Json& facet : list_member(p.item, "facets", p.where)) {
    said.facets.emplace_back();
    if (!facet.is_array() || facet.empty()) refuse_form(where + " entry is empty, or no list");
    for (const Json& simplex : facet) {
      if (!simplex.is_array()) refuse_form(where + " entry entry is not a list");
      std::vector<std::size_t> corners;
      for (const Json& entry : simplex) {
        corners.push_back(read_index(entry, said.body->rows().size(), where + " entry"));
      }
      const bool are_different = std::set(corners.begin(), corners.end()).size() == corners.size();
      if (size == 0) size = corners.size();
      if (!are_different || corners.size() < 2 || corners.size() != size)
        refuse_form(where + " are no simplices of as many corners");
      said.facets.back().push_back(std::move(corners));
    }
  }
  if (size < 2 || size > said.body->dimension()) refuse_form(where + " are no simplices of as many corners");
}

void read_ends_of_body(const Place& p, Said& said) {
  said.contact.i = index_member(p.item, "i", said.body->rows().size(), p.where);
  said.contact.j = index_member(p.item, "j", said.body->rows().size(), p.where);
}

void read_objective(const Place& p, Said& said) {
  const Json& list = list_member(p.item, "objective", p.where);
  for (const Double& d : read_doubles(list, dimension(said), p.where + ".objective")) {
    said.objective.push_back(number_of(d));
  }
}

void read_allowed(const Place& p, Said& said) {
  const std::string rule = read_rule(p.item, p.where);
  said.allowed = {rule != "nothing", rule == "touch"};
}

void read_segment_groups(const Place& p, Said& said) {
  if (p.item.contains("groups")) said.groups = read_groups(p.item, p.tables.segments.size(), p.where);
}

bool is_segment_kind(const std::string& kind) {
  return kind == "shared-endpoint" || kind == "touch" || kind == "crossing" || kind == "overlap";
}

void read_contact(const Place& p, Said& said) {
  said.contact.i = index_member(p.item, "i", p.tables.segments.size(), p.where);
  said.contact.j = index_member(p.item, "j", p.tables.segments.size(), p.where);
  said.contact.kind = string_member(p.item, "kind", p.where);
  if (!is_segment_kind(said.contact.kind)) refuse_form(p.where + ".kind is no kind of contact");
}

// A list of contacts of two of `size`, by i, then j, each once.
std::vector<StatedContact> contacts_of(const Place& p, std::size_t size, bool (*is_kind)(const std::string&)) {
  const std::string where = p.where + ".contacts entry";
  std::vector<StatedContact> result;
  for (const Json& entry : list_member(p.item, "contacts", p.where)) {
    if (!entry.is_array() || entry.size() != 3) refuse_form(where + " is no contact");
    StatedContact contact;
    contact.i = read_index(entry[0], size, where);
    contact.j = read_index(entry[1], size, where);
    if (entry[2].is_string()) contact.kind = entry[2].text();
    if (!is_kind(contact.kind)) refuse_form(where + " is of no kind");
    const bool is_next =
        result.empty() || std::pair(result.back().i, result.back().j) < std::pair(contact.i, contact.j);
    if (contact.i >= contact.j || !is_next) refuse_form(where + " is not in order");
    result.push_back(std::move(contact));
  }
  return result;
}

void read_segment_contacts(const Place& p, Said& said) {
  said.contacts = contacts_of(p, p.tables.segments.size(), is_segment_kind);
}

void read_polygon_groups(const Place& p, Said& said) {
  if (p.item.contains("groups")) said.groups = read_groups(p.item, p.tables.polygons.rings.size(), p.where);
}

void read_polygon_pair(const Place& p, Said& said) {
  said.contact.i = index_member(p.item, "i", p.tables.polygons.rings.size(), p.where);
  said.contact.j = index_member(p.item, "j", p.tables.polygons.rings.size(), p.where);
}

// A list of pairs of two of `size`, by i, then j, each once.
std::vector<StatedContact> pairs_of(const Place& p, const char* key, std::size_t size) {
  const std::string where = p.where + "." + key + " entry";
  std::vector<StatedContact> result;
  for (const Json& entry : list_member(p.item, key, p.where)) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(where + " is no pair");
    const StatedContact pair{read_index(entry[0], size, where), read_index(entry[1], size, where), ""};
    const bool is_next = result.empty() || std::pair(result.back().i, result.back().j) < std::pair(pair.i, pair.j);
    if (pair.i >= pair.j || !is_next) refuse_form(where + " is not in order");
    result.push_back(pair);
  }
  return result;
}

void read_polygon_contacts(const Place& p, Said& said) {
  said.contacts = pairs_of(p, "contacts", p.tables.polygons.rings.size());
}

void read_members(const Place& p, Said& said) {
  said.all_pairs.members = index_list(p.item, "members", p.tables.bodies.size(), no_index, p.where);
  const std::set<std::size_t> once(said.all_pairs.members.begin(), said.all_pairs.members.end());
  if (once.empty() || once.size() != said.all_pairs.members.size()) {
    refuse_form(p.where + ".members is empty, or names one twice");
  }
}

void read_groups_of_members(const Place& p, Said& said) {
  if (p.item.contains("groups")) said.groups = read_groups(p.item, said.all_pairs.members.size(), p.where);
}

void read_besides(const Place& p, Said& said) {
  for (const StatedContact& pair : pairs_of(p, "except", said.all_pairs.members.size())) {
    said.all_pairs.besides.emplace_back(pair.i, pair.j);
  }
}

void read_pairs_of_members(const Place& p, Said& said) {
  said.contacts = pairs_of(p, "contacts", said.all_pairs.members.size());
}

void read_nearer_members(const Place& p, Said& said) {
  said.contacts = pairs_of(p, "nearer", said.all_pairs.members.size());
  if (said.contacts.empty()) refuse_form(p.where + ".nearer is empty");
}

void read_count(const Place& p, Said& said) {
  said.number = read_index(p.item["number"], most_number + 1, p.where + ".number");
}

// Of the members of a set: table is one of Tables.
template <auto table>
void read_member_groups(const Place& p, Said& said) {
  if (p.item.contains("groups")) said.groups = read_groups(p.item, (p.tables.*table).size(), p.where);
}

template <auto table>
void read_member_contact(const Place& p, Said& said) {
  said.contact.i = index_member(p.item, "i", (p.tables.*table).size(), p.where);
  said.contact.j = index_member(p.item, "j", (p.tables.*table).size(), p.where);
  said.contact.kind = string_member(p.item, "kind", p.where);
  if (!is_kind_of_full(said.contact.kind)) refuse_form(p.where + ".kind is no kind of contact");
}

template <auto table>
void read_member_contacts(const Place& p, Said& said) {
  said.contacts = contacts_of(p, (p.tables.*table).size(), is_kind_of_full);
}

void read_ring(const Place& p, Said& said) {
  said.kernel_of = &p.tables.rings[index_member(p.item, "ring", p.tables.rings.size(), p.where)];
}

// What a common part is of.
using GivenOf = const Constraints& (*)(const Said&, const Tables&);
const Constraints& half_planes_of(const Said&, const Tables& tables) { return tables.half_planes; }
const Constraints& ring_of(const Said& said, const Tables&) { return *said.kernel_of; }
const Constraints& convex_polygons_of(const Said&, const Tables& tables) { return tables.convex_polygons; }

template <GivenOf given>
void read_sides(const Place& p, Said& said) {
  said.sides = index_list(p.item, "sides", given(said, p.tables).size(), no_index, p.where);
}

void require_arcs(const Json& list, const Tables& tables, const std::string& where) {
  if (!list.is_array() || list.empty() || list.size() > 2 * tables.circles.size()) {
    refuse_form(where + " is empty, or has more than two arcs a circle");
  }
}

void read_arcs(const Place& p, Said& said) {
  require_arcs(p.item["arcs"], p.tables, p.where + ".arcs");
  said.arcs = index_list(p.item, "arcs", p.tables.circles.size(), no_index, p.where);
}

void read_parts(const Place& p, Said& said) {
  const std::string where = p.where + ".parts";
  for (const Json& entry : list_member(p.item, "parts", p.where)) {
    said.named_parts.push_back(read_index(entry, p.tables.polygons.rings.size(), where + " entry"));
  }
  const std::set<std::size_t> once(said.named_parts.begin(), said.named_parts.end());
  if (once.empty() || once.size() != said.named_parts.size()) refuse_form(where + " names none, or one twice");
  said.parts = p.tables.parts_of(said.named_parts);
}

void read_validity(const Place& p, Said& said) {
  static const std::array<std::string, 3> names{"valid", "simple", "valid-with-self-touch"};
  const auto name = std::find(names.begin(), names.end(), string_member(p.item, "rule", p.where));
  if (name == names.end()) refuse_form(p.where + ".rule is none of valid, simple, valid-with-self-touch");
  said.rule = static_cast<ValidRule>(name - names.begin());
}

void read_ring_of_parts(const Place& p, Said& said) {
  said.ring = index_member(p.item, "ring", said.parts->rings.size(), p.where);
}

void read_other_ring(const Place& p, Said& said) {
  said.other = index_member(p.item, "other", said.parts->rings.size(), p.where);
}

void read_edge(const Place& p, Said& said) {
  said.edge = index_member(p.item, "edge", said.parts->polygons.edges.size(), p.where);
}

void read_contact_of_edges(const Place& p, Said& said) {
  said.contact.i = index_member(p.item, "i", said.parts->polygons.edges.size(), p.where);
  said.contact.j = index_member(p.item, "j", said.parts->polygons.edges.size(), p.where);
  said.contact.kind = string_member(p.item, "kind", p.where);
  if (!is_segment_kind(said.contact.kind)) refuse_form(p.where + ".kind is no kind of contact");
}

void read_rings_of_circle(const Place& p, Said& said) {
  for (const Json& entry : list_member(p.item, "rings", p.where)) {
    said.rings.push_back(read_index(entry, said.parts->rings.size(), p.where + ".rings entry"));
  }
  const std::set<std::size_t> once(said.rings.begin(), said.rings.end());
  if (once.size() < 2 || once.size() != said.rings.size()) {
    refuse_form(p.where + ".rings is not of two rings or more, each once");
  }
}

void read_points_of_circle(const Place& p, Said& said) {
  for (const Json& entry : list_member(p.item, "points", p.where)) {
    said.points.push_back(read_numbers(entry, 2, p.where + ".points entry"));
  }
  if (said.points.size() != said.rings.size()) refuse_form(p.where + ".points is not as long as the rings");
}

void read_nothing(const Place&, Said&) {}

// ---- Claims.

using ReadClaim = void (*)(const Json& item, const Said& said, std::size_t size, const std::string& where,
                           Claim& claim);

void read_direction(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  claim.direction = read_numbers(list_member(item, "direction", where), dimension(said), where + ".direction");
}

WeightList weight_list(const Json& item, const char* key, std::size_t size, std::size_t least, std::size_t most,
                       const std::string& where) {
  const Json& list = list_member(item, key, where);
  const std::string of = where + "." + key;
  if (list.size() < least || list.size() > most) {
    refuse_form(of + " has not " + std::to_string(least) + " to " + std::to_string(most) + " entries");
  }
  WeightList result;
  for (const Json& entry : list) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(of + " has an entry that is not a list of 2");
    result.named.push_back(read_index(entry[0], size, of + " entry"));
    result.values.push_back(read_number(entry[1], of + " entry"));
  }
  const std::set<std::size_t> once(result.named.begin(), result.named.end());
  if (once.size() != list.size()) refuse_form(of + " names something twice");
  return result;
}

void read_weights(const Json& item, const Said&, std::size_t size, const std::string& where, Claim& claim) {
  claim.weights = weight_list(item, "weights", size, 1, most_weights, where);
}

// Of half-spaces multipliers, of points none.
template <auto Said::* body, auto Claim::* list>
void read_multipliers(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  const char* const key = list == &Claim::of_a ? "of_a" : "of_b";
  const RowBody& of = *(said.*body);
  const std::size_t most = of.is_of_points ? 0 : most_multipliers;
  claim.*list = weight_list(item, key, of.given->rows.size(), 0, most, where);
}

void read_own_multipliers(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  claim.multipliers =
      weight_list(item, "multipliers", said.half_spaces->given->rows.size(), 0, most_of_half_spaces, where);
}

// Of each vertex lists of half-spaces, as many as there are dimensions.
void read_fans(const Json& item, const Said& said, std::size_t size, const std::string& where, Claim& claim) {
  const std::string place = where + ".fans";
  for (const Json& fan : list_member(item, "fans", where)) {
    if (!fan.is_array() || fan.empty()) refuse_form(place + " entry is empty, or no list");
    claim.fans.emplace_back();
    for (const Json& cone : fan) {
      if (!cone.is_array()) refuse_form(place + " entry entry is not a list");
      std::vector<std::size_t> rows;
      for (const Json& entry : cone) rows.push_back(read_index(entry, size, place + " entry"));
      if (rows.size() != dimension(said) || std::set(rows.begin(), rows.end()).size() != rows.size()) {
        refuse_form(place + " has not as many half-spaces as there are dimensions, each once");
      }
      claim.fans.back().push_back(std::move(rows));
    }
  }
  if (claim.fans.size() != said.vertices.size()) refuse_form(place + " is not as long as the vertices");
}

// Of points half-spaces around them, of half-spaces none.
template <auto Said::* body, auto Claim::* planes>
void read_planes(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  const char* const key = planes == &Claim::planes_a ? "planes_a" : "planes_b";
  const RowBody& of = *(said.*body);
  const Json& list = list_member(item, key, where);
  const std::string place = where + "." + key;
  if (!of.is_of_points && !list.empty()) refuse_form(place + " is not empty");
  const std::size_t width = of.dimension + 1;
  if (list.size() % width != 0) refuse_form(place + " is no whole number of half-spaces");
  const Numbers numbers = read_numbers(list, list.size(), place);
  for (auto at = numbers.begin(); at != numbers.end(); at += static_cast<std::ptrdiff_t>(width)) {
    (claim.*planes).emplace_back(at, at + static_cast<std::ptrdiff_t>(width));
  }
}

// Of half-spaces: those of the body, or around it.
template <auto Said::* body, auto Claim::* planes, auto Claim::* list>
void read_multipliers_of_planes(const Json& item, const Said& said, std::size_t, const std::string& where,
                                Claim& claim) {
  const char* const key = list == &Claim::of_a ? "by_a" : "by_b";
  const RowBody& of = *(said.*body);
  const std::size_t size = of.is_of_points ? (claim.*planes).size() : of.given->rows.size();
  claim.*list = weight_list(item, key, size, 0, most_multipliers, where);
}

// Of points weights, of half-spaces a place.
template <auto Said::* body>
void read_row_weights(const Json& item, const Said& said, std::size_t size, const std::string& where, Claim& claim) {
  const bool is_of_points = (said.*body)->is_of_points;
  claim.weights = weight_list(item, "weights", size, is_of_points ? 1 : 0, is_of_points ? most_weights : 0, where);
}

template <auto Said::* body>
void read_place(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  const std::size_t count = (said.*body)->is_of_points ? 0 : (said.*body)->dimension;
  claim.at = read_numbers(list_member(item, "at", where), count, where + ".at");
}

// Of a hull the index of a point, or weights; of others the weights, the point and, of an ellipsoid, where it is from.
SurfaceEnd read_surface_end(const Json& value, const HullBody& body, const std::string& where) {
  SurfaceEnd end;
  const std::size_t size = body.rows().size();
  if (body.around != Around::nothing && body.around != Around::hull) {
    const bool has_from = body.around == Around::ellipsoid;
    require_members(
        value,
        has_from ? std::vector<std::string>{"point", "weights", "from"} : std::vector<std::string>{"point", "weights"},
        {}, where);
    end.weights = weight_list(value, "weights", size, 1, most_weights, where);
    end.point = read_numbers(list_member(value, "point", where), 3, where + ".point");
    if (has_from) end.from = read_numbers(list_member(value, "from", where), 3, where + ".from");
  } else if (value.is_object()) {
    require_members(value, {"weights"}, {}, where);
    end.weights = weight_list(value, "weights", size, 1, most_weights, where);
  } else {
    end.weights = {{read_index(value, size, where)}, {{1, 1, 0}}};
  }
  return end;
}

void read_differences(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  const std::string of = where + ".differences entry";
  for (const Json& entry : list_member(item, "differences", where)) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(of + " is not a list of 2");
    claim.corners.push_back({read_surface_end(entry[0], *said.a, of), read_surface_end(entry[1], *said.b, of)});
  }
}

void read_triangles(const Json& item, const Said&, std::size_t, const std::string& where, Claim& claim) {
  const std::string of = where + ".triangles entry";
  for (const Json& entry : list_member(item, "triangles", where)) {
    if (!entry.is_array() || entry.size() != 3) refuse_form(of + " is not a list of 3");
    const auto corner = [&](std::size_t k) { return read_index(entry[k], claim.corners.size(), of); };
    claim.triangles.push_back({corner(0), corner(1), corner(2)});
  }
}

void read_ends(const Json& item, const Said&, std::size_t size, const std::string& where, Claim& claim) {
  const Json& list = list_member(item, "ends", where);
  if (list.size() != 2) refuse_form(where + ".ends is not a list of 2");
  for (std::size_t k = 0; k < 2; ++k) {
    if (list[k].is_null()) continue;
    if (!list[k].is_array() || list[k].size() != 2) refuse_form(where + ".ends has an entry that is no end");
    claim.ends[k] = EndOnLine{read_numbers(list[k][0], 2, where + ".ends entry"),
                              read_index(list[k][1], size, where + ".ends entry")};
  }
}

std::int64_t read_index_or_minus_one(const Json& value, std::size_t size, const std::string& where) {
  return is_minus_one(value) ? -1 : static_cast<std::int64_t>(read_index(value, size, where));
}

void read_events(const Json& item, const Said&, std::size_t size, const std::string& where, Claim& claim) {
  SweepEvents& events = claim.events;
  const std::string of = where + ".events entry";
  for (const Json& event : list_member(item, "events", where)) {
    if (!event.is_array() || event.size() < 2) refuse_form(of + " is not a list of 2 or more");
    auto entry = event.begin();
    events.at.push_back(read_index_or_minus_one(*entry, 2 * size, of));
    events.below.push_back(read_index_or_minus_one(*++entry, size, of));
    events.begin.push_back(events.row.size());
    while (++entry != event.end()) events.row.push_back(read_index(*entry, size, of));
  }
  events.begin.push_back(events.row.size());
}

void read_order(const Json& item, const Said&, std::size_t size, const std::string& where, Claim& claim) {
  for (const Json& entry : list_member(item, "order", where)) {
    claim.order.push_back(read_index(entry, size, where + ".order entry"));
  }
  const std::set<std::size_t> once(claim.order.begin(), claim.order.end());
  if (once.size() != size || claim.order.size() != size) refuse_form(where + ".order does not name each once");
}

const Json& list_for_each(const Json& item, const char* key, std::size_t size, const std::string& where) {
  const Json& list = list_member(item, key, where);
  if (list.size() != size) refuse_form(where + "." + key + " is not as long as what it is about");
  return list;
}

// size: of points
void read_homes(const Json& item, const Said& said, std::size_t size, const std::string& where, Claim& claim) {
  const std::string of = where + ".homes entry";
  for (const Json& entry : list_for_each(item, "homes", size, where)) {
    claim.homes.emplace_back();
    if (entry.is_null()) continue;
    if (!entry.is_array() || entry.size() != 2) refuse_form(of + " is not a list of 2");
    claim.homes.back().face = read_index(entry[0], said.faces.size(), of);
    claim.homes.back().corner = read_index(entry[1], said.faces[claim.homes.back().face].size() - 1, of);
    if (claim.homes.back().corner == 0) refuse_form(of + " is not an index in range");
  }
}

void read_sectors(const Json& item, const Said& said, std::size_t size, const std::string& where, Claim& claim) {
  for (const Json& entry : list_for_each(item, "sectors", size, where)) {
    claim.sectors.push_back(entry.is_null() ? no_index
                                            : read_index(entry, said.outline.size(), where + ".sectors entry"));
  }
}

// size: of points
void read_simplices(const Json& item, const Said& said, std::size_t size, const std::string& where, Claim& claim) {
  std::size_t count = 0;
  for (const auto& facet : said.facets) count += facet.size();
  for (const Json& entry : list_for_each(item, "simplices", size, where)) {
    claim.simplices.push_back(entry.is_null() ? no_index : read_index(entry, count, where + ".simplices entry"));
  }
}

void read_along(const Json& item, const Said& said, std::size_t, const std::string& where, Claim& claim) {
  claim.along = index_list(item, "along", most_number + 1, said.corners.size(), where);
}

void read_cones(const Json& item, const Said& said, std::size_t size, const std::string& where, Claim& claim) {
  // A corner is between two sides: of those that do not go round, none is after the last one.
  const bool is_open = said.verdict == "ray" || said.verdict == "unbounded";
  const std::size_t count = std::max<std::size_t>(said.sides.size(), is_open ? 1 : 0) - (is_open ? 1 : 0);
  claim.cones = index_list(item, "cones", count, size, where);
}

// size: of circles
void read_parts(const Json& item, const Said&, std::size_t size, const std::string& where, Claim& claim) {
  for (const Json& part : list_member(item, "parts", where)) {
    if (!part.is_array() || part.empty() || part.size() > 2 * size) {
      refuse_form(where + ".parts has an entry that is empty, or of more than two arcs a circle");
    }
    claim.parts.emplace_back();
    for (const Json& arc : part) claim.parts.back().push_back(read_index(arc, size, where + ".parts entry"));
  }
}

// ---- The list: what a claim brings, what its indices count, and its rule with what it is bound to.

struct ClaimNeeded {
  const char* kind;
  std::vector<std::pair<const char*, ReadClaim>> brings;
  std::size_t (*size)(const Said&, const Tables&);
  void (*check)(const Claim&, const Said&, const Tables&);
  const HullBody* Said::* from_of = nullptr;  // it brings `from`, too, where this is an ellipsoid
};

std::size_t of_a(const Said& said, const Tables&) { return said.a->rows().size(); }
std::size_t of_b(const Said& said, const Tables&) { return said.b->rows().size(); }
std::size_t of_body(const Said& said, const Tables&) { return said.body->rows().size(); }
std::size_t of_members(const Said& said, const Tables&) { return said.all_pairs.members.size(); }
std::size_t of_segments(const Said&, const Tables& tables) { return tables.segments.size(); }
std::size_t of_parts(const Said& said, const Tables&) { return said.parts->polygons.edges.size(); }
std::size_t of_edges(const Said&, const Tables& tables) { return tables.polygons.edges.size(); }
template <auto table>
std::size_t of_members(const Said&, const Tables& tables) {
  return (tables.*table).size();
}
std::size_t of_half_planes(const Said&, const Tables& tables) { return tables.half_planes.size(); }

const ClaimNeeded parted_a_b{
    "parted", {{"direction", read_direction}}, of_a, [](const Claim& c, const Said& s, const Tables&) {
      check_parted(c, *s.a, *s.b);
    }};
const ClaimNeeded a_holds{"holds",
                          {{"weights", read_weights}},
                          of_a,
                          [](const Claim& c, const Said& s, const Tables&) { check_holds(c, *s.a, s.point); },
                          &Said::a};
const ClaimNeeded b_holds{"holds",
                          {{"weights", read_weights}},
                          of_b,
                          [](const Claim& c, const Said& s, const Tables&) { check_holds(c, *s.b, s.point); },
                          &Said::b};
const ClaimNeeded parted_weakly_a_b{
    "parted_weakly", {{"direction", read_direction}}, of_a, [](const Claim& c, const Said& s, const Tables&) {
      check_parted_weakly(c, *s.a, *s.b);
    }};
const ClaimNeeded inside_a{"inside",
                           {{"weights", read_weights}},
                           of_a,
                           [](const Claim& c, const Said& s, const Tables&) { check_inside(c, *s.a, s.point); },
                           &Said::a};
const ClaimNeeded inside_b{"inside",
                           {{"weights", read_weights}},
                           of_b,
                           [](const Claim& c, const Said& s, const Tables&) { check_inside(c, *s.b, s.point); },
                           &Said::b};
const ClaimNeeded a_holds_from_a{"holds",
                                 {{"weights", read_weights}},
                                 of_a,
                                 [](const Claim& c, const Said& s, const Tables&) { check_holds(c, *s.a, s.from_a); },
                                 &Said::a};
const ClaimNeeded b_holds_to_b{"holds",
                               {{"weights", read_weights}},
                               of_b,
                               [](const Claim& c, const Said& s, const Tables&) { check_holds(c, *s.b, s.to_b); },
                               &Said::b};
const ClaimNeeded slab{
    "slab", {}, of_a, [](const Claim&, const Said& s, const Tables&) { check_slab(*s.a, *s.b, s.from_a, s.to_b); }};
const ClaimNeeded clear{
    "clear", {{"direction", read_direction}}, of_a, [](const Claim& c, const Said& s, const Tables&) {
      check_clear(c, *s.a, *s.b, s.least);
    }};
const ClaimNeeded nearer{
    "nearer", {}, of_a, [](const Claim&, const Said& s, const Tables&) { check_nearer(s.from_a, s.to_b, s.least); }};
const ClaimNeeded leaves{
    "leaves", {{"direction", read_direction}}, of_a, [](const Claim& c, const Said& s, const Tables&) {
      check_leaves(c, *s.a, *s.b, s.least);
    }};
const ClaimNeeded surrounds{
    "surrounds",
    {{"differences", read_differences}, {"triangles", read_triangles}},
    of_a,
    [](const Claim& c, const Said& s, const Tables&) { check_surrounds(c, *s.a, *s.b, s.least); }};
const ClaimNeeded parted_all_along{
    "parted_all_along", {{"direction", read_direction}}, of_a, [](const Claim& c, const Said& s, const Tables&) {
      check_parted_all_along(c, s.motion_a, s.motion_b);
    }};
const ClaimNeeded a_holds_at{
    "holds_at",
    {{"weights", read_weights}},
    of_a,
    [](const Claim& c, const Said& s, const Tables&) { check_holds_at(c, s.motion_a, s.time, s.point); },
    &Said::a};
const ClaimNeeded b_holds_at{
    "holds_at",
    {{"weights", read_weights}},
    of_b,
    [](const Claim& c, const Said& s, const Tables&) { check_holds_at(c, s.motion_b, s.time, s.point); },
    &Said::b};
const ClaimNeeded not_before{
    "not_before", {{"direction", read_direction}}, of_a, [](const Claim& c, const Said& s, const Tables&) {
      check_not_before(c, s.motion_a, s.motion_b, s.time, s.point);
    }};
const ClaimNeeded each_pair{"each_pair", {}, of_members, [](const Claim&, const Said& s, const Tables&) {
                              check_each_pair(s.all_pairs, s.groups, s.allowed, s.proved->pairs, s.contacts);
                            }};
const ClaimNeeded each_clearance{"each_clearance", {}, of_members, [](const Claim&, const Said& s, const Tables&) {
                                   check_each_clearance(s.all_pairs, s.groups, s.least, s.proved->clearances,
                                                        s.contacts);
                                 }};
const ClaimNeeded surface{
    "surface", {{"homes", read_homes}}, of_body, [](const Claim& c, const Said& s, const Tables&) {
      check_surface(c, *s.body, s.faces);
    }};
const ClaimNeeded outline{
    "outline", {{"sectors", read_sectors}}, of_body, [](const Claim& c, const Said& s, const Tables&) {
      check_outline(c, *s.body, s.outline);
    }};
const ClaimNeeded boundary{
    "boundary", {{"simplices", read_simplices}}, of_body, [](const Claim& c, const Said& s, const Tables&) {
      check_boundary(c, *s.body, s.facets);
    }};
const ClaimNeeded between{"between", {}, of_body, [](const Claim&, const Said& s, const Tables&) {
                            check_between(*s.body, s.contact.i, s.contact.j);
                          }};
const ClaimNeeded one_point{
    "one_point", {}, of_body, [](const Claim&, const Said& s, const Tables&) { check_one_point(*s.body); }};
const ClaimNeeded beyond{
    "beyond", {}, of_body, [](const Claim&, const Said& s, const Tables&) { check_beyond(*s.body, s.plane); }};
const ClaimNeeded touches{"touches", {}, of_body, [](const Claim&, const Said& s, const Tables&) {
                            check_touches(*s.body, s.plane, s.corners);
                          }};
const ClaimNeeded outlined{
    "outlined", {{"along", read_along}}, of_body, [](const Claim& c, const Said& s, const Tables&) {
      check_outlined(c, *s.body, s.plane, s.corners, s.proved->hulls);
    }};
const ClaimNeeded none_counts{
    "none_counts", {{"events", read_events}}, of_segments, [](const Claim& c, const Said& s, const Tables& t) {
      check_listed("none_counts", contacts_of_segments(c, t, s.groups, s.allowed), {});
    }};
const ClaimNeeded these_count{
    "these_count", {{"events", read_events}}, of_segments, [](const Claim& c, const Said& s, const Tables& t) {
      check_listed("these_count", contacts_of_segments(c, t, s.groups, s.allowed), s.contacts);
    }};
const ClaimNeeded number_counts{
    "number_counts", {{"events", read_events}}, of_segments, [](const Claim& c, const Said& s, const Tables& t) {
      check_number("number_counts", number_of_segments(c, t, s.groups, s.allowed), s.number);
    }};
const ClaimNeeded no_polygons_meet{
    "none_counts", {{"events", read_events}}, of_edges, [](const Claim& c, const Said& s, const Tables& t) {
      check_listed("none_counts", contacts_of_polygons(c, t, s.groups, s.allowed), {});
    }};
const ClaimNeeded these_polygons_meet{
    "these_count", {{"events", read_events}}, of_edges, [](const Claim& c, const Said& s, const Tables& t) {
      check_listed("these_count", contacts_of_polygons(c, t, s.groups, s.allowed), s.contacts);
    }};
const ClaimNeeded so_many_polygons_meet{
    "number_counts", {{"events", read_events}}, of_edges, [](const Claim& c, const Said& s, const Tables& t) {
      check_number("number_counts", number_of(contacts_of_polygons(c, t, s.groups, s.allowed)), s.number);
    }};
const ClaimNeeded parts_valid{
    "valid", {{"events", read_events}}, of_parts, [](const Claim& c, const Said& s, const Tables&) {
      check_valid(c, *s.parts, s.rule);
    }};
const ClaimNeeded too_few_points{"too_few_points", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                                   check_too_few_points(*s.parts, s.ring);
                                 }};
const ClaimNeeded edges_meet{"contact", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                               const PolygonTable& polygons = s.parts->polygons;
                               check_contact(polygons.edges, polygons.exponent, polygons.bits, s.contact, s.point, {},
                                             {true, true});
                             }};
const ClaimNeeded comes_twice{"comes_twice", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                                check_comes_twice(*s.parts, s.rule, s.ring, s.point);
                              }};
const ClaimNeeded crosses{"crosses", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                            check_crosses(*s.parts, s.ring, s.point);
                          }};
const ClaimNeeded falls_apart{
    "falls_apart", {{"events", read_events}}, of_parts, [](const Claim& c, const Said& s, const Tables&) {
      check_falls_apart(c, *s.parts);
    }};
const ClaimNeeded misplaced{"misplaced", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                              check_misplaced(*s.parts, s.ring, s.point);
                            }};
const ClaimNeeded circle{"circle", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                           check_circle(*s.parts, s.rings, s.points);
                         }};
const ClaimNeeded repeated{"repeated", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                             check_repeated(*s.parts, s.rule, s.edge);
                           }};
const ClaimNeeded rings_touch{"rings_touch", {}, of_parts, [](const Claim&, const Said& s, const Tables&) {
                                check_rings_touch(*s.parts, s.rule, s.ring, s.other, s.point);
                              }};
const ClaimNeeded common_point{"common_point", {}, of_edges, [](const Claim&, const Said& s, const Tables& t) {
                                 check_common_point(t, s.contact, s.point, s.groups, s.allowed);
                               }};
const ClaimNeeded contact{"contact", {}, of_segments, [](const Claim&, const Said& s, const Tables& t) {
                            check_contact(t.segments, t.segment_exponent, t.segment_bits, s.contact, s.point, s.groups,
                                          s.allowed);
                          }};
template <auto table>
const ClaimNeeded member_contact{"contact", {}, of_members<table>, [](const Claim&, const Said& s, const Tables& t) {
                                   check_member_contact(t.*table, s.contact, s.point, s.groups, s.allowed);
                                 }};
template <auto table>
const ClaimNeeded cover{
    "cover", {{"order", read_order}}, of_members<table>, [](const Claim& c, const Said& s, const Tables& t) {
      check_cover(c, t.*table, s.groups, s.allowed, s.contacts);
    }};
template <auto table>
const ClaimNeeded cover_number{
    "cover", {{"order", read_order}}, of_members<table>, [](const Claim& c, const Said& s, const Tables& t) {
      check_cover_number(c, t.*table, s.groups, s.allowed, s.number);
    }};
const ClaimNeeded feasible{
    "feasible", {}, of_half_planes, [](const Claim&, const Said& s, const Tables& t) { check_feasible(t, s.point); }};
const ClaimNeeded bounds{
    "bounds", {{"weights", read_weights}}, of_half_planes, [](const Claim& c, const Said& s, const Tables& t) {
      check_bounds(c, t, s.objective, s.point);
    }};
const ClaimNeeded bounds_only{
    "bounds_only", {{"weights", read_weights}}, of_half_planes, [](const Claim& c, const Said& s, const Tables& t) {
      check_bounds_only(c, t, s.objective, s.point);
    }};
const ClaimNeeded no_objective{"no_objective", {}, of_half_planes, [](const Claim&, const Said& s, const Tables&) {
                                 check_no_objective(s.objective);
                               }};
template <GivenOf given>
std::size_t size_of(const Said& said, const Tables& tables) {
  return given(said, tables).size();
}
template <GivenOf given>
const ClaimNeeded contradict{
    "contradict", {{"weights", read_weights}}, size_of<given>, [](const Claim& c, const Said& s, const Tables& t) {
      check_contradict(c, given(s, t));
    }};
template <GivenOf given>
const ClaimNeeded cones{
    "cones", {{"cones", read_cones}}, size_of<given>, [](const Claim& c, const Said& s, const Tables& t) {
      check_cones(c, given(s, t), s.verdict, s.sides);
    }};
const ClaimNeeded in_discs{
    "in_discs", {}, of_members<&Tables::circles>, [](const Claim&, const Said& s, const Tables& t) {
      check_in_discs(t, s.point, s.verdict == "region");
    }};
const ClaimNeeded powers{
    "powers",
    {{"weights", read_weights}},
    of_members<&Tables::circles>,
    [](const Claim& c, const Said& s, const Tables& t) { check_powers(c, t, s.verdict == "point"); }};
const ClaimNeeded arcs{
    "arcs", {{"parts", read_parts}}, of_members<&Tables::circles>, [](const Claim& c, const Said& s, const Tables& t) {
      check_arcs(c, t, s.point, s.arcs);
    }};
const ClaimNeeded goes_on{
    "goes_on", {{"direction", read_direction}}, of_half_planes, [](const Claim& c, const Said& s, const Tables& t) {
      check_goes_on(c, t, s.objective);
    }};
const ClaimNeeded ends{
    "ends", {{"ends", read_ends}}, of_half_planes, [](const Claim& c, const Said& s, const Tables& t) {
      check_ends(c, t, s.objective, s.point);
    }};

template <auto Said::* body>
const ClaimNeeded keeps{"keeps",
                        {{"weights", read_row_weights<body>}, {"at", read_place<body>}},
                        [](const Said& s, const Tables&) { return (s.*body)->given->rows.size(); },
                        [](const Claim& c, const Said& s, const Tables&) { check_keeps(c, *(s.*body), s.point); }};
const ClaimNeeded parted_by{
    "parted_by",
    {{"direction", read_direction},
     {"of_a", read_multipliers<&Said::polytope_a, &Claim::of_a>},
     {"of_b", read_multipliers<&Said::polytope_b, &Claim::of_b>}},
    [](const Said&, const Tables&) { return std::size_t{0}; },
    [](const Claim& c, const Said& s, const Tables&) { check_parted_by(c, *s.polytope_a, *s.polytope_b); }};

const ClaimNeeded parted_by_hyperplanes{
    "parted_by_hyperplanes",
    {{"direction", read_direction},
     {"planes_a", read_planes<&Said::polytope_a, &Claim::planes_a>},
     {"by_a", read_multipliers_of_planes<&Said::polytope_a, &Claim::planes_a, &Claim::of_a>},
     {"planes_b", read_planes<&Said::polytope_b, &Claim::planes_b>},
     {"by_b", read_multipliers_of_planes<&Said::polytope_b, &Claim::planes_b, &Claim::of_b>}},
    [](const Said&, const Tables&) { return std::size_t{0}; },
    [](const Claim& c, const Said& s, const Tables&) { check_parted_by_hyperplanes(c, *s.polytope_a, *s.polytope_b); }};

// Of half-spaces.
std::size_t of_half_spaces(const Said& said, const Tables&) { return said.half_spaces->given->rows.size(); }
template <auto Said::* where>
const ClaimNeeded half_spaces_keep{
    "keeps",
    {{"weights", read_row_weights<&Said::half_spaces>}, {"at", read_place<&Said::half_spaces>}},
    of_half_spaces,
    [](const Claim& c, const Said& s, const Tables&) { check_keeps(c, *s.half_spaces, s.*where); }};
const ClaimNeeded contradicted{
    "contradicted",
    {{"multipliers", read_own_multipliers}},
    of_half_spaces,
    [](const Claim& c, const Said& s, const Tables&) { check_contradicted(c, *s.half_spaces); }};
const ClaimNeeded spans{
    "spans", {{"multipliers", read_own_multipliers}}, of_half_spaces, [](const Claim& c, const Said& s, const Tables&) {
      check_spans(c, *s.half_spaces, s.dimension, s.spanned_by);
    }};
const ClaimNeeded normal_fan{
    "normal_fan", {{"fans", read_fans}}, of_half_spaces, [](const Claim& c, const Said& s, const Tables&) {
      check_normal_fan(c, *s.half_spaces, s.vertices);
    }};
const ClaimNeeded enclosed{"enclosed",
                           {{"multipliers", read_own_multipliers}},
                           of_half_spaces,
                           [](const Claim& c, const Said& s, const Tables&) { check_enclosed(c, *s.half_spaces); }};
const ClaimNeeded recedes{
    "recedes", {{"direction", read_direction}}, of_half_spaces, [](const Claim& c, const Said& s, const Tables&) {
      check_recedes(c, *s.half_spaces);
    }};
const ClaimNeeded rises{
    "rises", {{"direction", read_direction}}, of_half_spaces, [](const Claim& c, const Said& s, const Tables&) {
      check_rises(c, *s.half_spaces, s.objective);
    }};
const ClaimNeeded tops{
    "tops", {{"multipliers", read_own_multipliers}}, of_half_spaces, [](const Claim& c, const Said& s, const Tables&) {
      check_tops(c, *s.half_spaces, s.objective, s.point);
    }};
const ClaimNeeded tops_only{
    "tops_only",
    {{"multipliers", read_own_multipliers}},
    of_half_spaces,
    [](const Claim& c, const Said& s, const Tables&) { check_tops_only(c, *s.half_spaces, s.objective, s.point); }};
const ClaimNeeded another{"another", {}, of_half_spaces, [](const Claim&, const Said& s, const Tables&) {
                            check_another(s.objective, s.point, s.as_good);
                          }};

struct VerdictNeeds {
  const char* name;
  std::vector<MemberReader> says;
  std::vector<const ClaimNeeded*> claims;
};

struct Question {
  const char *name, *table;
  std::vector<MemberReader> says, may_say;
  std::vector<VerdictNeeds> verdicts;
};

const MemberReader point{"point", read_point};

// The kinds of the common part of half-planes.
template <GivenOf given>
std::vector<VerdictNeeds> regions() {
  std::vector<VerdictNeeds> result{{"empty", {}, {&contradict<given>}}};
  for (const char* kind : {"point", "segment", "ray", "line", "strip", "half-plane", "unbounded", "bounded"}) {
    result.push_back({kind, {{"sides", read_sides<given>}}, {&cones<given>}});
  }
  return result;
}

// Which members of a table have a contact that counts? By a cover.
template <auto table>
Question covered(const char* name) {
  const ClaimNeeded* by_cover = &cover<table>;
  return {name,
          name,
          {{"allowed", read_allowed}},
          {{"groups", read_member_groups<table>}},
          {{"some",
            {{"i", read_member_contact<table>}, {"j", read_nothing}, {"kind", read_nothing}, point},
            {&member_contact<table>}},
           {"none", {}, {by_cover}},
           {"these", {{"contacts", read_member_contacts<table>}}, {by_cover}},
           {"count", {{"number", read_count}}, {&cover_number<table>}}}};
}

const std::vector<Question> questions{
    {"pair",
     "bodies",
     {{"a", read_a}, {"b", read_b}},
     {},
     {{"apart", {}, {&parted_a_b}},
      {"meet", {point}, {&a_holds, &b_holds}},
      {"touching", {point}, {&a_holds, &b_holds, &parted_weakly_a_b}},
      {"overlapping", {point}, {&inside_a, &inside_b}}}},
    {"distance",
     "bodies",
     {{"a", read_plain_a}, {"b", read_plain_b}},
     {},
     {{"closest", {{"from_a", read_from_a}, {"to_b", read_to_b}}, {&a_holds_from_a, &b_holds_to_b, &slab}}}},
    {"clearance",
     "bodies",
     {{"a", read_a}, {"b", read_b}, {"least", read_least}},
     {},
     {{"kept", {}, {&clear}},
      {"broken", {{"from_a", read_from_a}, {"to_b", read_to_b}}, {&a_holds_from_a, &b_holds_to_b, &nearer}}}},
    {"depth",
     "bodies",
     {{"a", read_solid_a}, {"b", read_solid_b}},
     {},
     {{"at_most", {{"most", read_most}}, {&leaves}}, {"at_least", {{"least", read_least}}, {&surrounds}}}},
    {"motion",
     "bodies",
     {{"a", read_a},
      {"b", read_b},
      {"to_a", read_end_of<&Said::a, &Said::motion_a>},
      {"to_b", read_end_of<&Said::b, &Said::motion_b>}},
     {},
     {{"apart", {}, {&parted_all_along}},
      {"meet", {{"time", read_time}, point}, {&a_holds_at, &b_holds_at}},
      {"first", {{"time", read_time}, point}, {&a_holds_at, &b_holds_at, &not_before}}}},
    {"bodies",
     "bodies",
     {{"members", read_members}, {"allowed", read_allowed}, {"except", read_besides}},
     {{"groups", read_groups_of_members}},
     {{"these", {{"contacts", read_pairs_of_members}}, {&each_pair}}}},
    {"clearances",
     "bodies",
     {{"members", read_members}, {"except", read_besides}, {"least", read_least}},
     {{"groups", read_groups_of_members}},
     {{"kept", {}, {&each_clearance}}, {"broken", {{"nearer", read_nearer_members}}, {&each_clearance}}}},
    {"polytopes",
     "polytopes",
     {{"a", read_polytope_a}, {"b", read_polytope_b}},
     {},
     {{"apart", {}, {&parted_by}},
      {"apart_by_hyperplanes", {}, {&parted_by_hyperplanes}},
      {"meet", {point}, {&keeps<&Said::polytope_a>, &keeps<&Said::polytope_b>}}}},
    {"half_spaces",
     "polytopes",
     {{"half_spaces", read_half_spaces}},
     {},
     {{"empty", {}, {&contradicted}},
      {"bounded", {{"dimension", read_dimension}, {"spanned_by", read_spanned_by}}, {&spans, &enclosed}},
      {"unbounded", {{"dimension", read_dimension}, {"spanned_by", read_spanned_by}}, {&spans, &recedes}}}},
    {"half_spaces_vertices",
     "polytopes",
     {{"half_spaces", read_half_spaces}},
     {},
     {{"vertices", {{"vertices", read_vertices}}, {&normal_fan}}}},
    {"half_spaces_program",
     "polytopes",
     {{"half_spaces", read_half_spaces}, {"objective", read_objective}},
     {},
     {{"one", {point}, {&half_spaces_keep<&Said::point>, &tops_only}},
      {"many",
       {point, {"as_good", read_as_good}},
       {&half_spaces_keep<&Said::point>, &tops, &half_spaces_keep<&Said::as_good>, &another}},
      {"all", {point}, {&half_spaces_keep<&Said::point>, &no_objective}},
      {"unbounded", {point}, {&half_spaces_keep<&Said::point>, &rises}},
      {"infeasible", {}, {&contradicted}}}},
    {"hull",
     "bodies",
     {{"body", read_body}},
     {},
     {{"solid", {{"faces", read_faces}}, {&surface}},
      {"flat", {{"outline", read_outline}}, {&outline}},
      {"segment", {{"i", read_ends_of_body}, {"j", read_nothing}}, {&between}},
      {"point", {}, {&one_point}}}},
    {"polytope_hull",
     "bodies",
     {{"body", read_body_of_any_dimension}},
     {},
     {{"facets", {{"facets", read_facets}}, {&boundary}},
      {"segment", {{"i", read_ends_of_body}, {"j", read_nothing}}, {&between}},
      {"point", {}, {&one_point}}}},
    {"section",
     "bodies",
     {{"of", read_of}, {"plane", read_plane}},
     {},
     {{"nothing", {}, {&beyond}},
      {"touching", {{"corners", read_corners}}, {&touches}},
      {"outlined", {{"corners", read_corners}}, {&outlined}}}},
    {"segments",
     "segments",
     {{"allowed", read_allowed}},
     {{"groups", read_segment_groups}},
     {{"some", {{"i", read_contact}, {"j", read_nothing}, {"kind", read_nothing}, point}, {&contact}},
      {"none", {}, {&none_counts}},
      {"these", {{"contacts", read_segment_contacts}}, {&these_count}},
      {"count", {{"number", read_count}}, {&number_counts}}}},
    covered<&Tables::circles>("circles"),
    covered<&Tables::boxes>("boxes"),
    {"half_planes", "half_planes", {}, {}, regions<half_planes_of>()},
    {"kernel", "rings", {{"ring", read_ring}}, {}, regions<ring_of>()},
    {"convex_polygons_common_part", "convex_polygons", {}, {}, regions<convex_polygons_of>()},
    {"circles_common_part",
     "circles",
     {},
     {},
     {{"empty", {}, {&powers}},
      {"point", {point}, {&in_discs, &powers}},
      {"region", {point, {"arcs", read_arcs}}, {&in_discs, &arcs}}}},
    {"polygons",
     "polygons",
     {{"allowed", read_allowed}},
     {{"groups", read_polygon_groups}},
     {{"some", {{"i", read_polygon_pair}, {"j", read_nothing}, point}, {&common_point}},
      {"none", {}, {&no_polygons_meet}},
      {"these", {{"contacts", read_polygon_contacts}}, {&these_polygons_meet}},
      {"count", {{"number", read_count}}, {&so_many_polygons_meet}}}},
    {"valid",
     "polygons",
     {{"parts", read_parts}, {"rule", read_validity}},
     {},
     {{"valid", {}, {&parts_valid}},
      {"too_few_points", {{"ring", read_ring_of_parts}}, {&too_few_points}},
      {"edges_meet", {{"i", read_contact_of_edges}, {"j", read_nothing}, {"kind", read_nothing}, point}, {&edges_meet}},
      {"comes_twice", {{"ring", read_ring_of_parts}, point}, {&comes_twice}},
      {"crosses", {{"ring", read_ring_of_parts}, point}, {&crosses}},
      {"misplaced", {{"ring", read_ring_of_parts}, point}, {&misplaced}},
      {"circle", {{"rings", read_rings_of_circle}, {"points", read_points_of_circle}}, {&circle}},
      {"falls_apart", {}, {&falls_apart}},
      {"repeated", {{"edge", read_edge}}, {&repeated}},
      {"rings_touch", {{"ring", read_ring_of_parts}, {"other", read_other_ring}, point}, {&rings_touch}}}},
    {"linear_program",
     "half_planes",
     {{"objective", read_objective}},
     {},
     {{"one", {point}, {&feasible, &bounds_only}},
      {"many", {point}, {&feasible, &bounds, &ends}},
      {"all", {point}, {&feasible, &no_objective}},
      {"unbounded", {point}, {&feasible, &goes_on}},
      {"infeasible", {}, {&contradict<half_planes_of>}}}},
};

template <class Entry>
const Entry& find(const std::vector<Entry>& list, const std::string& name, const std::string& refusal) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Entry& entry) { return entry.name == name; });
  if (found == list.end()) refuse_form(refusal);
  return *found;
}

std::function<void()> read_claim(const Json& item, const ClaimNeeded& needed, const std::shared_ptr<const Said>& shared,
                                 const Tables& tables, const std::string& where) {
  const Said& said = *shared;
  std::vector<std::string> keys{"claim"};
  for (const auto& [name, read] : needed.brings) keys.emplace_back(name);
  const bool has_from = needed.from_of != nullptr && (said.*needed.from_of)->around == Around::ellipsoid;
  if (has_from) keys.emplace_back("from");
  require_members(item, keys, {}, where);
  if (string_member(item, "claim", where) != needed.kind) refuse_form(where + " is not the claim " + needed.kind);
  Claim claim;
  for (const auto& [name, read] : needed.brings) read(item, said, needed.size(said, tables), where, claim);
  if (has_from) claim.from = read_numbers(list_member(item, "from", where), 3, where + ".from");
  return [claim = std::make_shared<const Claim>(std::move(claim)), &needed, shared, &tables] {
    needed.check(*claim, *shared, tables);
  };
}

template <class Body>
Thing named(const Body* body) {
  return body == nullptr ? Thing{} : Thing{body->title(), body->quoted, body->said};
}

}  // namespace

ClaimedStatement read_statement(const Json& item, const Tables& tables, const Proved& proved,
                                const std::string& where) {
  ClaimedStatement result;
  result.question = string_member(item, "question", where);
  result.verdict = string_member(item, "verdict", where);
  const Question& question = find(questions, result.question, where + ".question is none that is known");
  const VerdictNeeds& verdict = find(question.verdicts, result.verdict, where + ".verdict is none of this question");
  const auto size = tables.sizes.find(question.table);
  if (size == tables.sizes.end() || size->second == 0) {
    refuse_form(where + " is about " + question.table + ", of which the file has none");
  }
  std::vector<std::string> keys{"question", "verdict", "claims"}, more{"said"};
  std::vector<MemberReader> readers = question.says;
  readers.insert(readers.end(), verdict.says.begin(), verdict.says.end());
  for (const MemberReader& reader : readers) keys.emplace_back(reader.name);
  for (const MemberReader& reader : question.may_say) more.emplace_back(reader.name);
  require_members(item, keys, more, where);
  readers.insert(readers.end(), question.may_say.begin(), question.may_say.end());
  Said said;
  said.verdict = result.verdict;
  said.proved = &proved;
  for (const MemberReader& reader : readers) reader.read({item, tables, where}, said);
  if (said.a != nullptr) {
    result.a = said.a->name;
    result.b = said.b->name;
    result.index_a = said.index_a;
    result.index_b = said.index_b;
    result.least = said.least;
  }
  if (said.polytope_a != nullptr) {
    result.a = said.polytope_a->name;
    result.b = said.polytope_b->name;
  }
  if (result.question == "hull") {
    result.hull_of = said.body->base;
    result.hull = {result.verdict, said.faces};
    if (!said.outline.empty()) result.hull.faces = {said.outline};
    if (result.verdict == "segment") result.hull.faces = {{said.contact.i, said.contact.j}};
  }
  if (said.half_spaces != nullptr) result.a = said.half_spaces->name;
  const RowBody* const polytope = said.half_spaces != nullptr ? said.half_spaces : said.polytope_a;
  result.sentence = polytope != nullptr
                        ? sentence_of(item, named(polytope), named(said.polytope_b), question.table, size->second)
                        : sentence_of(item, named(said.body != nullptr ? said.body : said.a), named(said.b),
                                      question.table, size->second);
  const auto of_rows = tables.said.find(question.table);
  if (of_rows != tables.said.end()) result.sentence += of_rows->second;
  if (item.contains("said")) {
    result.sentence += read_notes(item["said"], tables.inputs, said.all_pairs.besides.size(), where + ".said");
  }
  const Json& claims = list_member(item, "claims", where);
  if (claims.size() != verdict.claims.size()) {
    refuse_form(where + " has not " + std::to_string(verdict.claims.size()) + " claims");
  }
  const auto shared = std::make_shared<const Said>(std::move(said));
  for (std::size_t k = 0; k < claims.size(); ++k) {
    result.checks.push_back(
        read_claim(claims[k], *verdict.claims[k], shared, tables, where + ".claims[" + std::to_string(k) + "]"));
  }
  return result;
}

}  // namespace sunder_verifier
