#include <verifier/cpp/linear.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/shapes.h>

#include <algorithm>
#include <array>

// long because: one reader for each shape
namespace sunder_verifier {
namespace {

// ---- What shapes ask of what was read before.

// What is behind "of".
const Value& of(const Told& t) { return t.scope[t.of]; }

// How many things an index of something may name.
std::size_t count_in(const Value& value) {
  return std::visit(
      [](const auto& held) -> std::size_t {
        using Held = std::remove_cvref_t<decltype(held)>;
        if constexpr (std::is_same_v<Held, const HullBody*> || std::is_same_v<Held, const MeshBody*>) {
          return held->rows().size();
        } else {
          if constexpr (std::is_same_v<Held, const RowBody*>) return held->given->rows.size();
          if constexpr (std::is_same_v<Held, const PolygonTable*>) return held->rings.size();
          if constexpr (std::is_same_v<Held, std::shared_ptr<const PartTable>>) return held->rings.size();
          if constexpr (requires { held->size(); }) return held->size();
          if constexpr (requires { held.size(); }) return held.size();
          return 0;
        }
      },
      value);
}

std::size_t count_in(const Told& t) { return count_in(of(t)); }

// Of the edges of polygons, or of parts; of segments, themselves.
std::size_t edges_in(const Value& value) {
  if (const auto* const polygons = std::get_if<const PolygonTable*>(&value)) return (*polygons)->edges.size();
  if (const auto* const segments = std::get_if<const Segments*>(&value)) return (*segments)->size();
  return as<PartTable>(value).polygons.edges.size();
}

// Of what the statement is about.
std::size_t dimension(const Scope& scope) {
  const Value* about = scope.find("half_spaces");
  if (about == nullptr) about = scope.find("a");
  if (about == nullptr) return 2;
  if (std::holds_alternative<const MeshBody*>(*about)) return 3;
  const auto* const body = std::get_if<const HullBody*>(about);
  return body != nullptr ? (*body)->dimension() : as<RowBody>(*about).dimension;
}

bool is_each_once(Indices named) {
  std::sort(named.begin(), named.end());
  return std::adjacent_find(named.begin(), named.end()) == named.end();
}

// Indices below `size`, each once, and so many at least.
Indices each_once(const Told& t, std::size_t size, std::size_t least, const char* otherwise) {
  Indices named = read_indices(t.value, size, t.where);
  if (named.size() < least || !is_each_once(named)) refuse_form(t.where + otherwise);
  return named;
}

// Of a list.
Indices indices(const Json& list, std::size_t size, const std::string& of_entry) {
  Indices result;
  for (const Json& entry : list) result.push_back(read_index(entry, size, of_entry));
  return result;
}

const Json& list_for_each(const Told& t, std::size_t size) {
  if (as_list(t.value, t.where).size() != size) refuse_form(t.where + " is not as long as what it is about");
  return t.value;
}

void require_list_of_two(const Json& value, const std::string& where) {
  if (!value.is_array() || value.size() != 2) refuse_form(where + " is not a list of 2");
}

// What each entry of a list is read as.
template <class Read>
auto each(const Json& list, const std::string& where, const Read& read) {
  std::vector<decltype(read(list, where))> result;
  const std::string of_entry = where + " entry";
  for (const Json& entry : as_list(list, where)) result.push_back(read(entry, of_entry));
  return result;
}

// ---- Numbers, words and indices.

std::string word(const Told& t) {
  if (!t.value.is_string()) refuse_form(t.where + " is not a string");
  return std::string(t.value.text());
}

// Which of some words it is.
std::size_t choice(const Told& t, const std::array<const char*, 3>& words) {
  const auto found = std::find(words.begin(), words.end(), word(t));
  if (found == words.end()) refuse_form(t.where + " is none of " + words[0] + ", " + words[1] + ", " + words[2]);
  return static_cast<std::size_t>(found - words.begin());
}

// A double whose sign is so much at least.
Value signed_double(const Told& t, int least, const char* otherwise) {
  Number number = number_of(read_double(t.value, t.where));
  if (number.n.sign() < least) refuse_form(t.where + otherwise);
  return number;
}

Numbers doubles(const Told& t, std::size_t count) {
  Numbers result;
  for (const Double& d : read_doubles(as_list(t.value, t.where), count, t.where)) result.push_back(number_of(d));
  return result;
}

std::int64_t whole_number(const Json& value, const std::string& where) {
  constexpr auto most = static_cast<std::int64_t>(most_number);
  if (!value.is_integer() || value.integer() < -most || value.integer() > most) {
    refuse_form(where + " is not a whole number of at most 15 digits");
  }
  return value.integer();
}

Value read_groups_of(const Told& t) {
  const std::size_t size = count_in(t);
  if (as_list(t.value, t.where).size() != size) refuse_form(t.where + " is not a list of " + std::to_string(size));
  Groups groups;
  for (const Json& entry : t.value) groups.push_back(whole_number(entry, t.where + " entry"));
  return groups;
}

// Of entries [i, j], or [i, j, kind], by i, then j, each pair once.
StatedContacts contacts(const Told& t, bool have_kinds) {
  const std::string where = t.where + " entry";
  const std::size_t size = count_in(t);
  StatedContacts result;
  for (const Json& entry : as_list(t.value, t.where)) {
    if (!entry.is_array() || entry.size() != (have_kinds ? 3u : 2u)) {
      refuse_form(where + (have_kinds ? " is no contact" : " is no pair"));
    }
    StatedContact contact{read_index(entry[0], size, where), read_index(entry[1], size, where), ""};
    if (have_kinds) {
      if (entry[2].is_string()) contact.kind = entry[2].text();
      if (!is_kind_of(of(t), contact.kind)) refuse_form(where + " is of no kind");
    }
    const bool is_next =
        result.empty() || std::pair(result.back().i, result.back().j) < std::pair(contact.i, contact.j);
    if (contact.i >= contact.j || !is_next) refuse_form(where + " is not in order");
    result.push_back(std::move(contact));
  }
  return result;
}

// ---- Bodies.

const HullBody& body(const Told& t) { return t.tables.bodies[read_index(t.value, t.tables.bodies.size(), t.where)]; }

// As in "statements[0]", of "statements[0].b".
std::string without_last_name(const std::string& where) { return where.substr(0, where.rfind('.')); }

// Of the second of two: it has as many dimensions as the first.
template <class Body>
Value of_one_dimension(const Told& t, const Body& body, std::size_t d) {
  if (t.scope.find("a") != nullptr && dimension(t.scope) != d) {
    refuse_form(without_last_name(t.where) + " is of bodies of different dimensions");
  }
  return &body;
}

Value read_body(const Told& t) { return of_one_dimension(t, body(t), body(t).dimension()); }

Value body_that(const Told& t, bool (*is_so)(const HullBody&), const char* otherwise) {
  Value result = read_body(t);
  if (!is_so(as<HullBody>(result))) refuse_form(t.where + otherwise);
  return result;
}
bool is_plain(const HullBody& body) { return !body.is_round(); }
bool is_bounded(const HullBody& body) { return is_plain(body) && body.count == body.rows().size(); }
bool is_without_ways(const HullBody& body) { return body.dimension() <= 3 && body.count == body.rows().size(); }

// Are both placed by one matrix?
bool are_turned_alike(const HullBody& one, const HullBody& other) {
  const std::size_t d = one.dimension();
  for (std::size_t k = 0; k < d * d; ++k) {
    const Integer here = k % (d + 1) == 0 ? 1 : 0;
    const auto entry = [&](const HullBody& body) {
      return body.is_image() ? Number{body.linear.rows[0][k], 1, body.linear.e} : Number{here, 1, 0};
    };
    if (!are_equal(entry(one), entry(other))) return false;
  }
  return true;
}

// And to one place?
bool are_placed_alike(const HullBody& one, const HullBody& other) {
  for (std::size_t k = 0; k < one.dimension(); ++k) {
    const auto entry = [&](const HullBody& body) {
      return body.is_image() ? Number{body.translation.rows[0][k], 1, body.translation.e} : Number{0, 1, 0};
    };
    if (!are_equal(entry(one), entry(other))) return false;
  }
  return are_turned_alike(one, other);
}

// Is it the same body, placed by the same matrix?
bool is_moved(const HullBody& begin, const HullBody& end) {
  return begin.base == end.base && are_turned_alike(begin, end);
}

bool is_of_points_in_space(const HullBody& body) {
  return body.count == body.rows().size() && !body.is_round() && body.dimension() == 3;
}

// For each member null, or a mesh that is placed as it is.
Value read_meshes_of(const Told& t) {
  const auto& members = as<Indices>(of(t));
  const std::vector<MeshBody>& meshes = t.tables.meshes;
  const std::string where = t.where + " entry";
  MeshMembers result;
  for (const Json& entry : list_for_each(t, members.size())) {
    const HullBody& body = t.tables.bodies[members[result.size()]];
    result.emplace_back();
    if (entry.is_null()) continue;
    const std::size_t mesh = read_index(entry, meshes.size(), where);
    if (!is_of_points_in_space(body) || !are_placed_alike(body, meshes[mesh])) {
      refuse_form(where + " is not placed as its member");
    }
    result.back() = {true, mesh, meshes[mesh].base, body.base};
  }
  return result;
}

// Lists of one, three or four points.
Value read_holders_of(const Told& t) {
  return each(t.value, t.where, [&](const Json& entry, const std::string& where) {
    Indices holder = read_indices(entry, count_in(t), where);
    const std::size_t n = holder.size();
    if ((n != 1 && n != 3 && n != 4) || !is_each_once(holder)) {
      refuse_form(where + " is not of one, three or four points, each once");
    }
    return holder;
  });
}

Value body_of_points(const Told& t, bool may_be_placed, bool is_in_space) {
  const HullBody& result = body(t);
  const bool is_of_points = result.count == result.rows().size() && !result.is_round();
  if (!is_of_points || (!may_be_placed && result.is_image()) || (is_in_space && result.dimension() != 3)) {
    refuse_form(t.where + " is not of points in space");
  }
  return &result;
}

const RowBody& polytope(const Told& t) {
  return t.tables.polytopes[read_index(t.value, t.tables.polytopes.size(), t.where)];
}

// ---- What statements say of half-spaces, hulls, sections, rings and parts.

Value read_places(const Told& t) {
  return each(t.value, t.where, [&](const Json& entry, const std::string& where) {
    require_members(entry, {"point"}, {}, where);
    return read_numbers(list_member(entry, "point", where), dimension(t.scope), where);
  });
}

// A normal, a point, and how far above it, times the normal.
Value read_plane(const Told& t) {
  const auto [row, d, e] = common(doubles(t, 7));
  if (row[0] == 0 && row[1] == 0 && row[2] == 0) refuse_form(t.where + " has no direction");
  const std::int64_t up = std::max<std::int64_t>(-e, 0), down = std::max<std::int64_t>(e, 0);
  const Integer level = row[0] * row[3] + row[1] * row[4] + row[2] * row[5];
  return StatedPlane{{shifted(row[0], up), shifted(row[1], up), shifted(row[2], up)},
                     shifted(level, down) + shifted(row[6], up)};
}

Value read_section_corners_of(const Told& t) {
  IndexPairs corners = each(t.value, t.where, [&](const Json& entry, const std::string& where) {
    require_list_of_two(entry, where);
    return IndexPair(read_index(entry[0], count_in(t), where), read_index(entry[1], count_in(t), where));
  });
  const std::set<IndexPair> once(corners.begin(), corners.end());
  if (once.empty() || once.size() != corners.size()) refuse_form(t.where + " is empty, or names one twice");
  return corners;
}

Indices ring_of(const Json& value, const Told& t, const std::string& where) {
  Indices corners = read_indices(value, count_in(t), where);
  if (corners.size() < 3) refuse_form(where + " has fewer than three corners");
  return corners;
}

// Lists of simplices, which are lists of corners, all of as many.
Value read_facets_of(const Told& t) {
  const auto& points = as<HullBody>(of(t));
  const std::string not_simplices = t.where + " are no simplices of as many corners";
  std::vector<IndexLists> facets;
  std::size_t size = 0;
  for (const Json& facet : as_list(t.value, t.where)) {
    facets.emplace_back();
    if (!facet.is_array() || facet.empty()) refuse_form(t.where + " entry is empty, or no list");
    for (const Json& simplex : facet) {
      if (!simplex.is_array()) refuse_form(t.where + " entry entry is not a list");
      Indices corners = indices(simplex, count_in(t), t.where + " entry");
      if (size == 0) size = corners.size();
      if (!is_each_once(corners) || corners.size() < 2 || corners.size() != size) refuse_form(not_simplices);
      facets.back().push_back(std::move(corners));
    }
  }
  if (size < 2 || size > points.dimension()) refuse_form(not_simplices);
  return facets;
}

Indices arcs_of(const Json& value, const Told& t, const std::string& where, const char* otherwise) {
  if (!value.is_array() || value.empty() || value.size() > 2 * count_in(t)) refuse_form(where + otherwise);
  return read_indices(value, count_in(t), where);
}

// ---- What claims bring.

WeightList weight_list(const Told& t, std::size_t size, std::size_t least, std::size_t most) {
  as_list(t.value, t.where);
  if (t.value.size() < least || t.value.size() > most) {
    refuse_form(t.where + " has not " + std::to_string(least) + " to " + std::to_string(most) + " entries");
  }
  WeightList result;
  for (const Json& entry : t.value) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(t.where + " has an entry that is not a list of 2");
    result.named.push_back(read_index(entry[0], size, t.where + " entry"));
    result.values.push_back(read_number(entry[1], t.where + " entry"));
  }
  if (!is_each_once(result.named)) refuse_form(t.where + " names something twice");
  return result;
}

// Of points half-spaces around them, of half-spaces none.
Value read_planes_around(const Told& t) {
  const auto& polytope = as<RowBody>(of(t));
  const std::size_t width = polytope.dimension + 1;
  as_list(t.value, t.where);
  if (!polytope.is_of_points && !t.value.empty()) refuse_form(t.where + " is not empty");
  if (t.value.size() % width != 0) refuse_form(t.where + " is no whole number of half-spaces");
  const Numbers numbers = read_numbers(t.value, t.value.size(), t.where);
  Points planes;
  for (auto at = numbers.begin(); at != numbers.end(); at += static_cast<std::ptrdiff_t>(width)) {
    planes.emplace_back(at, at + static_cast<std::ptrdiff_t>(width));
  }
  return planes;
}

// Of each vertex lists of half-spaces, as many as there are dimensions.
Value read_fans_of(const Told& t) {
  std::vector<IndexLists> fans;
  for (const Json& fan : as_list(t.value, t.where)) {
    if (!fan.is_array() || fan.empty()) refuse_form(t.where + " entry is empty, or no list");
    fans.emplace_back();
    for (const Json& cone : fan) {
      if (!cone.is_array()) refuse_form(t.where + " entry entry is not a list");
      Indices rows = indices(cone, count_in(t), t.where + " entry");
      if (rows.size() != dimension(t.scope) || !is_each_once(rows)) {
        refuse_form(t.where + " has not as many half-spaces as there are dimensions, each once");
      }
      fans.back().push_back(std::move(rows));
    }
  }
  if (fans.size() != count_in(t.scope["vertices"])) refuse_form(t.where + " is not as long as the vertices");
  return fans;
}

// Of a hull the index of a point, or weights; of others the weights, the point and, of an ellipsoid, where it is from.
SurfaceEnd surface_end(const Json& value, const HullBody& body, const Told& t, const std::string& where) {
  const std::size_t size = body.rows().size();
  const bool has_point = body.around != Around::nothing && body.around != Around::hull;
  const bool has_from = body.around == Around::ellipsoid;
  if (!has_point && !value.is_object()) return {{{read_index(value, size, where)}, {{1, 1, 0}}}, {}, {}};
  std::vector<std::string> keys{"weights"};
  if (has_point) keys.emplace_back("point");
  if (has_from) keys.emplace_back("from");
  require_members(value, keys, {}, where);
  SurfaceEnd end;
  end.weights = weight_list({value["weights"], where + ".weights", t.scope, t.of, t.tables}, size, 1, most_weights);
  if (has_point) end.point = read_numbers(list_member(value, "point", where), 3, where + ".point");
  if (has_from) end.from = read_numbers(list_member(value, "from", where), 3, where + ".from");
  return end;
}

Value read_rays(const Told& t, std::size_t size) {
  return each(t.value, t.where, [&](const Json& entry, const std::string& where) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(where + " is not a list of 2");
    return StatedRay{read_index(entry[0], size, where), read_numbers(as_list(entry[1], where), 3, where)};
  });
}

Value read_rays_of(const Told& t) { return read_rays(t, as<MeshBody>(of(t)).pieces->triangles.size()); }
Value read_told_rays(const Told& t) { return read_rays(t, static_cast<std::size_t>(most_number) + 1); }

Value read_two_ends_of(const Told& t) {
  require_list_of_two(as_list(t.value, t.where), t.where);
  TwoEnds ends;
  for (std::size_t k = 0; k < 2; ++k) {
    const Json& end = t.value[k];
    if (end.is_null()) continue;
    if (!end.is_array() || end.size() != 2) refuse_form(t.where + " has an entry that is no end");
    ends[k] =
        EndOnLine{read_numbers(end[0], 2, t.where + " entry"), read_index(end[1], count_in(t), t.where + " entry")};
  }
  return ends;
}

std::int64_t read_index_or_minus_one(const Json& value, std::size_t size, const std::string& where) {
  return is_minus_one(value) ? -1 : static_cast<std::int64_t>(read_index(value, size, where));
}

Value read_sweep_of(const Told& t) {
  const std::string where = t.where + " entry";
  const std::size_t size = edges_in(of(t));
  SweepEvents events;
  for (const Json& event : as_list(t.value, t.where)) {
    if (!event.is_array() || event.size() < 2) refuse_form(where + " is not a list of 2 or more");
    auto entry = event.begin();
    events.at.push_back(read_index_or_minus_one(*entry, 2 * size, where));
    events.below.push_back(read_index_or_minus_one(*++entry, size, where));
    events.begin.push_back(events.row.size());
    while (++entry != event.end()) events.row.push_back(read_index(*entry, size, where));
  }
  events.begin.push_back(events.row.size());
  return events;
}

// For each point a triangle of a face, or null.
Value read_homes_of(const Told& t) {
  const auto& faces = as<IndexLists>(t.scope["faces"]);
  return each(list_for_each(t, count_in(t)), t.where, [&](const Json& entry, const std::string& where) {
    FaceHome home;
    if (entry.is_null()) return home;
    require_list_of_two(entry, where);
    home.face = read_index(entry[0], faces.size(), where);
    home.corner = read_index(entry[1], faces[home.face].size() - 1, where);
    if (home.corner == 0) refuse_form(where + " is not an index in range");
    return home;
  });
}

// For each of what it is about an index below `count`, or null.
Indices indices_or_null(const Told& t, std::size_t count) {
  return each(list_for_each(t, count_in(t)), t.where, [&](const Json& entry, const std::string& where) {
    return entry.is_null() ? no_index : read_index(entry, count, where);
  });
}

}  // namespace

Shape shape_named(const std::string& shape) {
  static const std::map<std::string, Shape> shapes{
      {"point",
       [](const Told& t) -> Value { return read_numbers(as_list(t.value, t.where), dimension(t.scope), t.where); }},
      {"above zero", [](const Told& t) { return signed_double(t, 1, " is not positive"); }},
      {"not negative", [](const Told& t) { return signed_double(t, 0, " is negative"); }},
      {"time",
       [](const Told& t) -> Value {
         Number time = read_number(t.value, t.where);
         const Integers ends = common({time, {1, 1, 0}}).integers;
         if (ends[0] < 0 || ends[0] > ends[1]) refuse_form(t.where + " is not from 0 to 1");
         return time;
       }},
      {"objective", [](const Told& t) -> Value { return doubles(t, dimension(t.scope)); }},
      {"count", [](const Told& t) -> Value { return read_index(t.value, most_number + 1, t.where); }},
      {"index", [](const Told& t) -> Value { return read_index(t.value, count_in(t), t.where); }},
      {"edge", [](const Told& t) -> Value { return read_index(t.value, edges_in(of(t)), t.where); }},
      {"indices", [](const Told& t) -> Value { return read_indices(t.value, count_in(t), t.where); }},
      {"dimension",
       [](const Told& t) -> Value { return read_index(t.value, as<RowBody>(of(t)).dimension + 1, t.where); }},
      {"order",
       [](const Told& t) -> Value { return each_once(t, count_in(t), count_in(t), " does not name each once"); }},
      {"kind",
       [](const Told& t) -> Value {
         std::string kind = word(t);
         if (!is_kind_of(of(t), kind)) refuse_form(t.where + " is no kind of contact");
         return kind;
       }},
      {"allowed",
       [](const Told& t) -> Value {
         const std::size_t which = choice(t, {"nothing", "shared-endpoint", "touch"});
         return AllowedContacts{which > 0, which > 1};
       }},
      {"validity",
       [](const Told& t) -> Value {
         return static_cast<ValidRule>(choice(t, {"valid", "simple", "valid-with-self-touch"}));
       }},
      {"groups", read_groups_of},
      {"contacts", [](const Told& t) -> Value { return contacts(t, true); }},
      {"pairs", [](const Told& t) -> Value { return contacts(t, false); }},
      {"some pairs",
       [](const Told& t) -> Value {
         StatedContacts pairs = contacts(t, false);
         if (pairs.empty()) refuse_form(t.where + " is empty");
         return pairs;
       }},
      {"body", read_body},
      {"plain body", [](const Told& t) { return body_that(t, is_plain, " has a radius"); }},
      {"bounded body", [](const Told& t) { return body_that(t, is_bounded, " is not bounded"); }},
      {"body without ways",
       [](const Told& t) { return body_that(t, is_without_ways, " is not bounded, in the plane or in space"); }},
      {"end",
       [](const Told& t) -> Value {
         const HullBody& end = body(t);
         if (!is_moved(as<HullBody>(of(t)), end)) refuse_form(t.where + " is not the same body, moved");
         return &end;
       }},
      {"points in space", [](const Told& t) -> Value { return body_of_points(t, false, true); }},
      {"placed points in space", [](const Told& t) -> Value { return body_of_points(t, true, true); }},
      {"points in any dimension", [](const Told& t) -> Value { return body_of_points(t, false, false); }},
      {"mesh",
       [](const Told& t) -> Value { return &t.tables.meshes[read_index(t.value, t.tables.meshes.size(), t.where)]; }},
      {"unplaced mesh",
       [](const Told& t) -> Value {
         const MeshBody& mesh = t.tables.meshes[read_index(t.value, t.tables.meshes.size(), t.where)];
         if (mesh.is_image()) refuse_form(t.where + " is an image, or not of points in space");
         return &mesh;
       }},
      {"unplaced body",
       [](const Told& t) -> Value {
         const HullBody& result = body(t);
         if (result.is_image() || !is_of_points_in_space(result)) {
           refuse_form(t.where + " is an image, or not of points in space");
         }
         return &result;
       }},
      {"meshes", read_meshes_of},
      {"holders", read_holders_of},
      {"held",
       [](const Told& t) -> Value { return read_indices(t.value, count_in(t), t.where, count_in(t.scope["a"])); }},
      {"end mesh",
       [](const Told& t) -> Value {
         const MeshBody& end = t.tables.meshes[read_index(t.value, t.tables.meshes.size(), t.where)];
         if (!is_moved(as<MeshBody>(of(t)), end)) refuse_form(t.where + " is not the same body, moved");
         return &end;
       }},
      {"triangle",
       [](const Told& t) -> Value {
         return read_index(t.value, as<MeshBody>(of(t)).pieces->triangles.size(), t.where);
       }},
      {"cuts",
       [](const Told& t) -> Value {
         return each(t.value, t.where,
                     [](const Json& entry, const std::string& where) { return whole_number(entry, where); });
       }},
      {"points",
       [](const Told& t) -> Value {
         return each(t.value, t.where, [&](const Json& entry, const std::string& where) {
           return read_numbers(as_list(entry, where), dimension(t.scope), where);
         });
       }},
      {"rays", read_rays_of},
      {"told rays", read_told_rays},
      {"planes",
       [](const Told& t) -> Value {
         return each(t.value, t.where, [](const Json& entry, const std::string& where) {
           return read_numbers(as_list(entry, where), 4, where);
         });
       }},
      {"polytope", [](const Told& t) { return of_one_dimension(t, polytope(t), polytope(t).dimension); }},
      {"half-spaces",
       [](const Told& t) -> Value {
         const RowBody& result = polytope(t);
         if (result.is_of_points || result.is_image()) refuse_form(t.where + " is not of half-spaces, or placed");
         if (result.given->rows.empty()) refuse_form(t.where + " is of no half-spaces");
         return &result;
       }},
      {"members",
       [](const Told& t) -> Value { return each_once(t, t.tables.bodies.size(), 1, " is empty, or names one twice"); }},
      {"places", read_places},
      {"some places",
       [](const Told& t) -> Value {
         Value result = read_places(t);
         if (as<Points>(result).empty()) refuse_form(t.where + " is empty");
         return result;
       }},
      {"plane", read_plane},
      {"section corners", read_section_corners_of},
      {"outline", [](const Told& t) -> Value { return ring_of(t.value, t, t.where); }},
      {"faces",
       [](const Told& t) -> Value {
         IndexLists faces = each(t.value, t.where,
                                 [&](const Json& face, const std::string& where) { return ring_of(face, t, where); });
         if (faces.empty()) refuse_form(t.where + " is empty");
         return faces;
       }},
      {"facets", read_facets_of},
      {"ring",
       [](const Told& t) -> Value { return &t.tables.rings[read_index(t.value, t.tables.rings.size(), t.where)]; }},
      {"ring as part",
       [](const Told& t) -> Value { return t.tables.ring_parts[read_index(t.value, t.tables.rings.size(), t.where)]; }},
      {"arcs",
       [](const Told& t) -> Value {
         return arcs_of(t.value, t, t.where, " is empty, or has more than two arcs a circle");
       }},
      {"lists of arcs",
       [](const Told& t) -> Value {
         IndexLists lists;
         for (const Json& part : as_list(t.value, t.where)) {
           lists.push_back(arcs_of(part, t, t.where, " has an entry that is empty, or of more than two arcs a circle"));
         }
         return lists;
       }},
      {"parts",
       [](const Told& t) -> Value {
         return t.tables.parts_of(each_once(t, t.tables.polygons.rings.size(), 1, " names none, or one twice"));
       }},
      {"two parts",
       [](const Told& t) -> Value {
         require_list_of_two(t.value, t.where);
         return shape_named("parts")(t);
       }},
      {"circle",
       [](const Told& t) -> Value { return each_once(t, count_in(t), 2, " is not of two rings or more, each once"); }},
      {"matching points",
       [](const Told& t) -> Value {
         Points points = each(t.value, t.where, [](const Json& entry, const std::string& where) {
           return read_numbers(entry, 2, where);
         });
         if (points.size() != count_in(t)) refuse_form(t.where + " is not as long as the " + std::string(t.of));
         return points;
       }},
      {"weights", [](const Told& t) -> Value { return weight_list(t, count_in(t), 1, most_weights); }},
      // Of points weights, of half-spaces none.
      {"point weights",
       [](const Told& t) -> Value {
         const bool is_of_points = as<RowBody>(of(t)).is_of_points;
         return weight_list(t, count_in(t), is_of_points ? 1 : 0, is_of_points ? most_weights : 0);
       }},
      // Of half-spaces a place, of points none.
      {"place",
       [](const Told& t) -> Value {
         const auto& polytope = as<RowBody>(of(t));
         return read_numbers(as_list(t.value, t.where), polytope.is_of_points ? 0 : polytope.dimension, t.where);
       }},
      // Of half-spaces multipliers, of points none.
      {"row multipliers",
       [](const Told& t) -> Value {
         return weight_list(t, count_in(t), 0, as<RowBody>(of(t)).is_of_points ? 0 : most_multipliers);
       }},
      {"multipliers", [](const Told& t) -> Value { return weight_list(t, count_in(t), 0, most_of_half_spaces); }},
      {"surrounding planes", read_planes_around},
      // Multipliers of half-spaces: those of the polytope, or around it.
      {"plane multipliers",
       [](const Told& t) -> Value {
         const bool is_of_points = as<RowBody>(of(t)).is_of_points;
         const std::size_t size = is_of_points ? count_in(t.scope["planes_" + std::string(t.of)]) : count_in(t);
         return weight_list(t, size, 0, most_multipliers);
       }},
      {"fans", read_fans_of},
      {"differences",
       [](const Told& t) -> Value {
         const auto &a = as<HullBody>(t.scope["a"]), &b = as<HullBody>(t.scope["b"]);
         return each(t.value, t.where, [&](const Json& entry, const std::string& where) {
           require_list_of_two(entry, where);
           return SurfaceCorner{surface_end(entry[0], a, t, where), surface_end(entry[1], b, t, where)};
         });
       }},
      {"triangles",
       [](const Told& t) -> Value {
         return each(t.value, t.where, [&](const Json& entry, const std::string& where) {
           const std::size_t corners = as<HullBody>(t.scope["a"]).dimension();
           if (!entry.is_array() || entry.size() != corners) {
             refuse_form(where + " is not a list of " + std::to_string(corners));
           }
           return indices(entry, count_in(t), where);
         });
       }},
      {"two ends", read_two_ends_of},
      {"sweep", read_sweep_of},
      {"homes", read_homes_of},
      {"sectors", [](const Told& t) -> Value { return indices_or_null(t, count_in(t.scope["outline"])); }},
      {"simplices",
       [](const Told& t) -> Value {
         std::size_t count = 0;
         for (const IndexLists& facet : as<std::vector<IndexLists>>(t.scope["facets"])) count += facet.size();
         return indices_or_null(t, count);
       }},
      {"face for each",
       [](const Told& t) -> Value { return read_indices(t.value, most_number + 1, t.where, count_in(t)); }},
      // A corner is between two sides: of those that do not go round, none is after the last one.
      {"corners",
       [](const Told& t) -> Value {
         const auto& verdict = as<std::string>(t.scope["verdict"]);
         const std::size_t sides = count_in(t.scope["sides"]),
                           open = verdict == "ray" || verdict == "unbounded" ? 1 : 0;
         return read_indices(t.value, std::max(sides, open) - open, t.where, count_in(t));
       }},
  };
  return shapes.at(shape);
}

}  // namespace sunder_verifier
