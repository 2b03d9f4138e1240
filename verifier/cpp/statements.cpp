#include <verifier/cpp/rules.h>
#include <verifier/cpp/sentences.h>
#include <verifier/cpp/shapes.h>
#include <verifier/cpp/statements.h>
#include <verifier/cpp/verify.h>

#include <algorithm>
#include <initializer_list>
#include <stdexcept>
#include <string_view>

namespace sunder_verifier {
namespace {

// ---- Statements: what a question is about, and says; and of each verdict what it says more, its claims in their
// order, each with what it is bound to, and the sentence. What is in [..] may be missing.

struct VerdictRow {
  std::string name, says, claims, sentence;
};

struct QuestionRow {
  std::string name, table, says;
  std::vector<VerdictRow> verdicts;
};

// What is the common part of half-planes?
QuestionRow common_part(const std::string& name, const std::string& table, const std::string& says,
                        const std::string& given, const std::string& of) {
  const std::string sentence = of + " is {region}";
  QuestionRow row{name, table, says, {{"empty", "", "contradict " + given, sentence}}};
  for (const char* kind : {"point", "segment", "ray", "line", "strip", "half-plane", "unbounded", "bounded"}) {
    row.verdicts.push_back({kind, "sides: indices of " + given, "cones " + given + " verdict sides", sentence});
  }
  return row;
}

// Which entries of a table have a contact that counts? The claims of `none`, `these` and `count`.
QuestionRow meetings(const std::string& table, VerdictRow some, const std::string& contacts, const std::string& none,
                     const std::string& these, const std::string& count) {
  const std::string of = " " + table + " groups allowed";
  return {table,
          table,
          "allowed: allowed; [groups]: groups of " + table,
          {std::move(some),
           {"none", "", none + of, "no two of the {all} meet"},
           {"these", "contacts: " + contacts + " of " + table, these + of + " contacts", "exactly {meeting}"},
           {"count", "number: count", count + of + " number", "exactly {meeting}"}}};
}

VerdictRow contact_of(const std::string& table) {
  return {"some", "i, j: index of " + table + "; kind: kind of " + table + "; point: point",
          "contact " + table + " i j kind point groups allowed",
          "{question} {i} and {j} of {all} meet at {point}: {kind}"};
}

// Polygons touch or overlap.
QuestionRow with_kinds(QuestionRow row) {
  row.verdicts.push_back(
      {"these_kinds", "kinds: contacts of polygons", "these_kinds polygons groups allowed kinds", "exactly {meeting}"});
  row.verdicts.push_back({"count_kinds", "overlapping, touching: count",
                          "kinds_count polygons groups allowed overlapping touching",
                          "of the {all}, so many pairs overlap: {overlapping}; touch: {touching}"});
  return row;
}

QuestionRow two_polygons() {
  QuestionRow row{"two_polygons", "polygons", "pair: two parts", {}};
  for (const char* kind : {"apart", "touching", "overlapping"}) {
    row.verdicts.push_back({kind, "", "how_two_meet pair verdict", "polygons {pair} of {all} are {verdict}"});
  }
  return row;
}

QuestionRow covered(const std::string& table) {
  QuestionRow row = meetings(table, contact_of(table), "contacts", "cover", "cover", "cover");
  row.verdicts[1].claims += " none";
  return row;
}

const std::string not_valid = "polygons {parts} of {all}: not {rule}, as ";

const std::vector<QuestionRow> question_rows{
    {"pair",
     "bodies",
     "a, b: body",
     {{"apart", "", "parted a b", "{a} and {b} are apart"},
      {"meet", "point: point", "holds a point, holds b point", "{a} and {b} meet at {point}"},
      {"touching", "point: point", "holds a point, holds b point, parted_weakly a b", "{a} and {b} touch at {point}"},
      {"overlapping", "point: point", "inside a point, inside b point", "{a} and {b} overlap at {point}"}}},
    {"distance",
     "bodies",
     "a, b: plain body",
     {{"closest", "from_a, to_b: point", "holds a from_a, holds b to_b, slab a b from_a to_b",
       "{a} and {b} are closest at {from_a} and {to_b}"}}},
    {"common_part",
     "bodies",
     "a, b: plain body",
     {{"between", "first, last: point",
       "holds a first, holds b first, holds a last, holds b last, no_further a b first last",
       "{a} and {b} have in common what is between {first} and {last}"}}},
    {"nearest",
     "bodies",
     "a: bounded body; b: plain body",
     {{"point", "i: index of a", "first_along a b i",
       "no point of {a} is nearer to {b}, or further within it, than its point {i}"}}},
    {"support",
     "bodies",
     "a: placed points in space; b: plain body",
     {{"two", "on_first, on_last: indices of a", "wedge a b on_first on_last",
       "of the planes through {b}, two have all of {a} on one side and a point of it beside the line; they touch it at "
       "its points {on_first}, and {on_last}"},
      {"one", "on_plane: indices of a", "rests a b on_plane",
       "of the planes through {b}, one has all of {a} on one side; it touches it at its points {on_plane}"},
      {"none", "point: point", "inside a point, holds b point, full a",
       "no plane through {b} has all of {a} on one side, as {point} is inside"}}},
    {"clearance",
     "bodies",
     "a, b: body; least: above zero",
     {{"kept", "", "clear a b least", "{a} and {b} are {least} apart, or more"},
      {"broken", "from_a, to_b: point", "holds a from_a, holds b to_b, nearer from_a to_b least",
       "{a} and {b} are nearer than {least}, at {from_a} and {to_b}"}}},
    {"depth",
     "bodies",
     "a, b: body without ways",
     {{"at_most", "most: not negative", "leaves a b most", "{a} moved by {most}, in a direction, does not overlap {b}"},
      {"at_least", "least: above zero", "surrounds a b least", "{a} moved by {least}, in any direction, meets {b}"}}},
    {"motion",
     "bodies",
     "a, b: body; to_a: end of a; to_b: end of b",
     {{"apart", "", "parted_all_along a b to_a to_b", "{a} and {b} are apart all along their ways"},
      {"meet", "time: time; point: point", "holds_at a to_a time point, holds_at b to_b time point",
       "{a} and {b} meet on their ways, at time {time}, at {point}"},
      {"first", "time: time; point: point",
       "holds_at a to_a time point, holds_at b to_b time point, not_before a b to_a to_b time point",
       "{a} and {b} first meet on their ways at time {time}, at {point}"}}},
    {"bodies",
     "bodies",
     "members: members; allowed: allowed; except: pairs of members; [groups]: groups of members",
     {{"these", "contacts: pairs of members", "each_pair members groups except allowed proved contacts",
       "exactly {meeting}"}}},
    {"clearances",
     "bodies",
     "members: members; except: pairs of members; least: above zero; [groups]: groups of members",
     {{"kept", "", "each_clearance members groups except least proved none",
       "all pairs of the {all} are {least} apart, or more"},
      {"broken", "nearer: some pairs of members", "each_clearance members groups except least proved nearer",
       "exactly {pairs} nearer than {least}: {nearer}"}}},
    {"meshes",
     "meshes",
     "a, b: mesh",
     {{"apart", "", "covered a b", "{a} and {b} are apart"},
      {"meet", "point: point", "on_triangle a point, on_triangle b point", "{a} and {b} meet at {point}"},
      {"overlapping", "point: point", "encloses a point, encloses b point", "{a} and {b} overlap at {point}"},
      {"touching", "point: point", "on_triangle a point, on_triangle b point, insides_apart a b",
       "{a} and {b} meet at {point}, and no point is inside of both"},
      {"a_part_of_b", "", "part_of a b", "what is inside of {a} is inside of {b} or on its triangles"},
      {"b_part_of_a", "", "part_of b a", "what is inside of {b} is inside of {a} or on its triangles"},
      {"equal", "", "equal_insides a b", "{a} and {b} have the same inside, but for points on their triangles"},
      {"a_inside_b", "", "covered_within a b", "{a} is inside of {b}, away from its surface"},
      {"b_inside_a", "", "covered_within b a", "{b} is inside of {a}, away from its surface"},
      {"a_within", "point: point", "on_triangle a point, encloses b point", "{point} of {a} is inside of {b}"},
      {"b_within", "point: point", "encloses a point, on_triangle b point", "{point} of {b} is inside of {a}"}}},
    {"mesh_body",
     "meshes",
     "a: mesh; b: body",
     {{"apart", "", "beside a b", "{a} and {b} are apart"},
      {"meet", "point: point", "on_triangle a point, holds b point", "{a} and {b} meet at {point}"},
      {"b_within", "point: point", "encloses a point, holds b point", "{point} of {b} is inside of {a}"}}},
    {"mesh_body_clearance",
     "meshes",
     "a: mesh; b: body; least: above zero",
     {{"kept", "", "clear_beside a b least", "{a} and {b} are {least} apart, or more"},
      {"broken", "from_a, to_b: point", "on_triangle a from_a, holds b to_b, nearer from_a to_b least",
       "{a} and {b} are nearer than {least}, at {from_a} and {to_b}"},
      {"b_within", "point: point", "encloses a point, holds b point",
       "{a} and {b} are nearer than {least}, as {point} of {b} is inside of {a}"}}},
    {"mesh_crossing",
     "meshes",
     "a: mesh",
     {{"two", "point: point", "triangles_cross a point", "two triangles of {a} cross at {point}"}}},
    {"mesh_distance",
     "meshes",
     "a, b: mesh",
     {{"closest", "from_a, to_b: point", "on_triangle a from_a, on_triangle b to_b, covered_apart a b from_a to_b",
       "{a} and {b} are closest at {from_a} and {to_b}"}}},
    {"mesh_motion",
     "meshes",
     "a, b: mesh; to_a: end mesh of a; to_b: end mesh of b",
     {{"apart", "", "covered_all_along a b to_a to_b", "{a} and {b} are apart all along their ways"},
      {"meet", "time: time; point: point", "on_triangle_at a to_a time point, on_triangle_at b to_b time point",
       "{a} and {b} meet on their ways, at time {time}, at {point}"},
      {"first", "time: time; point: point",
       "on_triangle_at a to_a time point, on_triangle_at b to_b time point, covered_before a b to_a to_b time",
       "{a} and {b} first meet on their ways at time {time}, at {point}"},
      {"a_within", "point: point", "on_triangle a point, encloses b point",
       "{a} and {b} meet at the beginning of their ways, as {point} of {a} is inside of {b}"},
      {"b_within", "point: point", "encloses a point, on_triangle b point",
       "{a} and {b} meet at the beginning of their ways, as {point} of {b} is inside of {a}"}}},
    {"mesh_clearance",
     "meshes",
     "a, b: mesh; least: above zero",
     {{"kept", "", "covered_clear a b least", "{a} and {b} are {least} apart, or more"},
      {"broken", "from_a, to_b: point", "on_triangle a from_a, on_triangle b to_b, nearer from_a to_b least",
       "{a} and {b} are nearer than {least}, at {from_a} and {to_b}"},
      {"a_within", "point: point", "on_triangle a point, encloses b point",
       "{a} and {b} are nearer than {least}, as {point} of {a} is inside of {b}"},
      {"b_within", "point: point", "encloses a point, on_triangle b point",
       "{a} and {b} are nearer than {least}, as {point} of {b} is inside of {a}"}}},
    {"polytopes",
     "polytopes",
     "a, b: polytope",
     {{"apart", "", "parted_by a b", "{a} and {b} are apart"},
      {"apart_by_hyperplanes", "", "parted_by_hyperplanes a b", "{a} and {b} are apart, by half-spaces that hold them"},
      {"meet", "point: point", "keeps a point, keeps b point", "{a} and {b} meet at {point}"}}},
    {"half_spaces",
     "polytopes",
     "half_spaces: half-spaces",
     {{"empty", "", "contradicted half_spaces", "{a} is empty"},
      {"bounded", "dimension: dimension of half_spaces; spanned_by: places",
       "spans half_spaces dimension spanned_by, enclosed half_spaces", "{a} is bounded, of dimension {dimension}"},
      {"unbounded", "dimension: dimension of half_spaces; spanned_by: places",
       "spans half_spaces dimension spanned_by, recedes half_spaces", "{a} is unbounded, of dimension {dimension}"}}},
    {"half_spaces_vertices",
     "polytopes",
     "half_spaces: half-spaces",
     {{"vertices", "vertices: some places", "normal_fan half_spaces vertices",
       "{a} is bounded, and has exactly {vertices}"}}},
    {"half_spaces_program",
     "polytopes",
     "half_spaces: half-spaces; objective: objective",
     {{"one", "point: point", "keeps half_spaces point, tops_only half_spaces objective point",
       "{point} is the best point of {a} along {objective}"},
      {"many", "point, as_good: point",
       "keeps half_spaces point, tops half_spaces objective point, keeps half_spaces as_good, "
       "another objective point as_good",
       "{point} is one of many best points of {a} along {objective}"},
      {"all", "point: point", "keeps half_spaces point, no_objective objective",
       "{point} is as good as all others of {a} along {objective}"},
      {"unbounded", "point: point", "keeps half_spaces point, rises half_spaces objective",
       "there is no best point of {a} along {objective}"},
      {"infeasible", "", "contradicted half_spaces", "no point is in {a}"}}},
    {"hull",
     "bodies",
     "body: points in space",
     {{"solid", "faces: faces of body", "surface body faces", "{a} is solid, with the {n_faces} faces {faces}"},
      {"flat", "outline: outline of body", "outline body outline",
       "{a} is a polygon with the {n_outline} corners {outline}"},
      {"segment", "i, j: index of body", "between body i j", "{a} is the segment between its points {i} and {j}"},
      {"point", "", "one_point body", "{a} is a point"}}},
    {"polytope_hull",
     "bodies",
     "body: points in any dimension",
     {{"facets", "facets: facets of body", "boundary body facets", "{a} has exactly {facets}"},
      {"segment", "i, j: index of body", "between body i j", "{a} is the segment between its points {i} and {j}"},
      {"point", "", "one_point body", "{a} is a point"}}},
    {"mesh",
     "bodies",
     "body: points in space; mesh_faces: faces of body",
     {{"convex", "", "bounds_hull body mesh_faces proved", "a mesh of {n_mesh_faces} polygons bounds {a} exactly"},
      {"not_convex", "face: index of mesh_faces", "leaves_hull body mesh_faces face proved",
       "a mesh of {n_mesh_faces} polygons is not exactly convex: polygon {face} is in no face of {a}"}}},
    {"section",
     "bodies",
     "of: placed points in space; plane: plane",
     {{"nothing", "", "beyond of plane", "the plane {plane} does not meet {a}"},
      {"touching", "corners: section corners of of", "touches of plane corners",
       "the plane {plane} touches {a} at the points {corners}"},
      {"outlined", "corners: section corners of of", "outlined of plane corners proved",
       "the section of {a} by the plane {plane} has the {n_corners} corners {corners}"},
      {"measured", "corners: section corners of of; area_from, area_to: not negative",
       "outlined of plane corners proved, area of plane corners area_from area_to",
       "the section of {a} by the plane {plane} has the {n_corners} corners {corners}, and an area from {area_from} to "
       "{area_to}"}}},
    meetings("segments", contact_of("segments"), "contacts", "none_counts", "these_count", "number_counts"),
    covered("circles"),
    covered("boxes"),
    with_kinds(
        meetings("polygons",
                 {"some", "i, j: index of polygons; point: point", "common_point polygons i j point groups allowed",
                  "polygons {i} and {j} of {all} meet at {point}"},
                 "pairs", "none_counts", "these_count", "number_counts")),
    two_polygons(),
    common_part("half_planes", "half_planes", "", "half_planes", "the common part of {all}"),
    common_part("kernel", "rings", "ring: ring", "ring", "the kernel of ring {ring} of {all}"),
    {"ring", "rings", "ring: ring as part", {{"simple", "", "valid ring simple", "ring {ring} of {all} is simple"}}},
    common_part("convex_polygons_common_part", "convex_polygons", "", "convex_polygons", "the common part of {all}"),
    {"circles_common_part",
     "circles",
     "",
     {{"empty", "", "powers circles verdict", "the common part of {all} is empty"},
      {"point", "point: point", "in_discs circles point verdict, powers circles verdict",
       "the common part of {all} is the point {point}"},
      {"region", "point: point; arcs: arcs of circles", "in_discs circles point verdict, arcs circles point arcs",
       "the common part of {all} is a region around {point}, bounded by {n_arcs} arcs of {arcs}"}}},
    {"valid",
     "polygons",
     "parts: parts; rule: validity",
     {{"valid", "", "valid parts rule", "polygons {parts} of {all}: {rule}"},
      {"too_few_points", "ring: index of parts", "too_few_points parts ring",
       not_valid + "ring {ring} has too few points"},
      {"edges_meet", "i, j: edge of parts; kind: kind of parts; point: point",
       "contact parts i j kind point alone touch", not_valid + "edges {i} and {j} meet at {point}: {kind}"},
      {"comes_twice", "ring: index of parts; point: point", "comes_twice parts rule ring point",
       not_valid + "ring {ring} comes twice to {point}"},
      {"crosses", "ring: index of parts; point: point", "crosses parts ring point",
       not_valid + "ring {ring} crosses itself at {point}"},
      {"misplaced", "ring: index of parts; point: point", "misplaced parts ring point",
       not_valid + "ring {ring} is misplaced at {point}"},
      {"circle", "rings: circle of parts; points: matching points of rings", "circle parts rings points",
       not_valid + "rings {rings} close a circle"},
      {"falls_apart", "", "falls_apart parts", not_valid + "one falls apart"},
      {"repeated", "edge: edge of parts", "repeated parts rule edge", not_valid + "edge {edge} has no length"},
      {"rings_touch", "ring, other: index of parts; point: point", "rings_touch parts rule ring other point",
       not_valid + "rings {ring} and {other} touch at {point}"}}},
    {"linear_program",
     "half_planes",
     "objective: objective",
     {{"one", "point: point", "feasible half_planes point, bounds_only half_planes objective point",
       "{point} is the best point of {all} along {objective}"},
      {"many", "point: point",
       "feasible half_planes point, bounds half_planes objective point, ends half_planes objective point",
       "{point} is one of many best points of {all} along {objective}"},
      {"all", "point: point", "feasible half_planes point, no_objective objective",
       "{point} is as good as all others of {all} along {objective}"},
      {"unbounded", "point: point", "feasible half_planes point, goes_on half_planes objective",
       "there is no best point of {all} along {objective}"},
      {"infeasible", "", "contradict half_planes", "no point is in all of {all}"}}},
};

// ---- The rows, taken apart once.

struct NamedShape {
  std::string name;
  Shape shape;
  std::string of;  // what the shape is of; empty: of nothing
  bool may_be_missing = false;
};

struct ClaimNeeded {
  std::string name;
  std::vector<NamedShape> brings;
  Rule rule;
  std::vector<std::string> bound;
};

struct Verdict {
  std::string name;
  std::vector<NamedShape> says;  // what may be missing comes last
  std::vector<ClaimNeeded> claims;
  std::string sentence;
};

struct Question {
  std::string name, table;
  std::vector<Verdict> verdicts;
};

std::vector<std::string> split(const std::string& text, const std::string& by) {
  std::vector<std::string> parts;
  std::size_t begin = 0;
  while (begin < text.size()) {
    const std::size_t end = std::min(text.find(by, begin), text.size());
    parts.push_back(text.substr(begin, end - begin));
    begin = end + by.size();
  }
  return parts;
}

// "name, name: shape; [name]: shape of what".
std::vector<NamedShape> members_of(const std::string& text) {
  std::vector<NamedShape> result;
  for (const std::string& entry : split(text, "; ")) {
    const std::vector<std::string> parts = split(entry, ": ");
    const std::size_t of = parts[1].rfind(" of ");
    const bool has_of = of != std::string::npos;
    for (const std::string& name : split(parts[0], ", ")) {
      const bool may_be_missing = name.front() == '[';
      result.push_back({may_be_missing ? name.substr(1, name.size() - 2) : name, shape_named(parts[1].substr(0, of)),
                        has_of ? parts[1].substr(of + 4) : "", may_be_missing});
    }
  }
  return result;
}

const ClaimRow& claim_row(const std::string& name) {
  for (const ClaimRows* rows :
       {&claims_of_bodies, &claims_of_polytopes, &claims_of_hulls, &claims_of_boundaries, &claims_of_sections,
        &claims_of_all_pairs, &claims_of_meshes, &claims_of_half_planes, &claims_of_discs, &claims_of_contacts,
        &claims_of_polygons, &claims_of_valid_polygons}) {
    for (const ClaimRow& row : *rows) {
      if (row.name == name) return row;
    }
  }
  throw std::logic_error(name);
}

std::vector<ClaimNeeded> claims_of(const std::string& text) {
  std::vector<ClaimNeeded> result;
  for (const std::string& claim : split(text, ", ")) {
    std::vector<std::string> words = split(claim, " ");
    const ClaimRow& row = claim_row(words[0]);
    ClaimNeeded needed{words[0], members_of(row.brings), row.rule, {words.begin() + 1, words.end()}};
    if (needed.brings.size() + needed.bound.size() != needed.rule.count) throw std::logic_error(claim);
    result.push_back(std::move(needed));
  }
  return result;
}

std::vector<Question> taken_apart(const std::vector<QuestionRow>& rows) {
  std::vector<Question> questions;
  for (const QuestionRow& row : rows) {
    questions.push_back({row.name, row.table, {}});
    for (const VerdictRow& verdict : row.verdicts) {
      std::vector<NamedShape> says;
      for (const bool may_be_missing : {false, true}) {
        for (const std::string* text : {&row.says, &verdict.says}) {
          for (NamedShape& member : members_of(*text)) {
            if (member.may_be_missing == may_be_missing) says.push_back(std::move(member));
          }
        }
      }
      questions.back().verdicts.push_back({verdict.name, std::move(says), claims_of(verdict.claims), verdict.sentence});
    }
  }
  return questions;
}

// ---- Reading.

template <class Entry>
const Entry& find(const std::vector<Entry>& list, const std::string& name, const std::string& refusal) {
  const auto found = std::find_if(list.begin(), list.end(), [&](const Entry& entry) { return entry.name == name; });
  if (found == list.end()) refuse_form(refusal);
  return *found;
}

Value read_member(const Json& item, const NamedShape& member, const Scope& scope, std::string_view of,
                  const Tables& tables, const std::string& where) {
  const std::string place = where + "." + member.name;
  return member.shape({item[member.name], place, scope, of, tables});
}

// Of an ellipsoid alone a claim brings where a point is from.
bool is_brought(const NamedShape& member, const Value& subject) {
  return member.name != "from" || as<HullBody>(subject).around == Around::ellipsoid;
}

Check read_claim(const Json& item, const ClaimNeeded& needed, const std::shared_ptr<const Scope>& said,
                 const Tables& tables, const std::string& where) {
  const std::string& subject = needed.bound[0];
  std::vector<std::string> keys{"claim"};
  for (const NamedShape& member : needed.brings) {
    if (is_brought(member, (*said)[subject])) keys.push_back(member.name);
  }
  require_members(item, keys, {}, where);
  if (string_member(item, "claim", where) != needed.name) refuse_form(where + " is not the claim " + needed.name);
  const auto brought = std::make_shared<Scope>(said.get());
  Check check{needed.rule, {}, said, brought};
  for (const NamedShape& member : needed.brings) {
    const std::string& of = member.of == "subject" ? subject : member.of;
    brought->set(member.name, is_brought(member, (*said)[subject])
                                  ? read_member(item, member, *brought, of, tables, where)
                                  : Value(Numbers()));
  }
  for (const NamedShape& member : needed.brings) check.values.push_back(brought->find(member.name));
  for (const std::string& name : needed.bound) check.values.push_back(said->find(name));
  return check;
}

// Calls with the body of that name, if there is one.
template <class Visit>
void with_body(const Scope& said, std::string_view name, const Visit& visit) {
  const Value* const value = said.find(name);
  if (value == nullptr) return;
  if (const auto* const body = std::get_if<const HullBody*>(value)) visit(**body);
  if (const auto* const polytope = std::get_if<const RowBody*>(value)) visit(**polytope);
  if (const auto* const mesh = std::get_if<const MeshBody*>(value)) visit(**mesh);
}

Thing thing(const Scope& said, std::initializer_list<const char*> names) {
  Thing result;
  for (const char* const name : names) {
    with_body(said, name, [&](const auto& body) { result = {body.title(), body.quoted, body.said}; });
  }
  return result;
}

std::size_t index_of(const Scope& said, const char* name, const Tables& tables) {
  return static_cast<std::size_t>(&as<HullBody>(said[name]) - tables.bodies.data());
}

}  // namespace

Scope scope_of_file(const Tables& tables, const Proved& proved) {
  Scope scope;
  scope.set("segments", &tables.segments);
  scope.set("circles", &tables.circles);
  scope.set("boxes", &tables.boxes);
  scope.set("polygons", &tables.polygons);
  scope.set("half_planes", &tables.half_planes);
  scope.set("convex_polygons", &tables.convex_polygons);
  scope.set("proved", &proved);
  scope.set("none", StatedContacts());
  scope.set("alone", Groups());
  scope.set("touch", AllowedContacts{true, true});
  scope.set("simple", ValidRule::simple);
  return scope;
}

bool is_verdict_of(std::string_view question, std::string_view verdict) {
  return std::ranges::any_of(question_rows, [&](const QuestionRow& row) {
    return row.name == question && std::ranges::find(row.verdicts, verdict, &VerdictRow::name) != row.verdicts.end();
  });
}

Statement read_statement(const Json& item, const Tables& tables, const Scope& file, const std::string& where) {
  static const std::vector<Question> questions = taken_apart(question_rows);
  Statement result;
  result.question = string_member(item, "question", where);
  result.verdict = string_member(item, "verdict", where);
  const Question& question = find(questions, result.question, where + ".question is none that is known");
  const Verdict& verdict = find(question.verdicts, result.verdict, where + ".verdict is none of this question");
  const auto size = tables.sizes.find(question.table);
  if (size == tables.sizes.end() || size->second == 0) {
    refuse_form(where + " is about " + question.table + ", of which the file has none");
  }
  std::vector<std::string> keys{"question", "verdict", "claims"}, more{"said"};
  for (const NamedShape& member : verdict.says) (member.may_be_missing ? more : keys).push_back(member.name);
  require_members(item, keys, more, where);

  const auto said = std::make_shared<Scope>(&file);
  said->set("verdict", result.verdict);
  for (const NamedShape& member : verdict.says) {
    const bool is_there = !member.may_be_missing || item.contains(member.name);
    said->set(member.name, is_there ? read_member(item, member, *said, member.of, tables, where) : Value(Groups()));
  }
  result.said = said;
  for (const char* const name : {"a", "half_spaces"}) {
    with_body(*said, name, [&](const auto& body) { result.a = body.name; });
  }
  with_body(*said, "b", [&](const auto& body) { result.b = body.name; });
  result.sentence = sentence_of(item, verdict.sentence, thing(*said, {"a", "body", "of", "half_spaces"}),
                                thing(*said, {"b"}), question.table, size->second);
  const auto of_rows = tables.said.find(question.table);
  if (of_rows != tables.said.end()) result.sentence += of_rows->second;
  if (item.contains("said")) {
    const Value* const except = said->find("except");
    const std::size_t left_out = except != nullptr ? as<StatedContacts>(*except).size() : 0;
    result.sentence += read_notes(item["said"], tables.inputs, left_out, where + ".said");
  }

  const Json& claims = list_member(item, "claims", where);
  if (claims.size() != verdict.claims.size()) {
    refuse_form(where + " has not " + std::to_string(verdict.claims.size()) + " claims");
  }
  std::size_t k = 0;
  for (const Json& claim : claims) {
    const std::string place = where + ".claims[" + std::to_string(k) + "]";
    result.checks.push_back(read_claim(claim, verdict.claims[k++], said, tables, place));
  }
  return result;
}

void note(const Statement& statement, const Tables& tables, Proved& proved) {
  const Scope& said = *statement.said;
  if (statement.question == "hull") {
    ProvedHull& hull = proved.hulls[as<HullBody>(said["body"]).base];
    hull = {statement.verdict, {}};
    if (statement.verdict == "solid") hull.faces = as<IndexLists>(said["faces"]);
    if (statement.verdict == "flat") hull.faces = {as<Indices>(said["outline"])};
    if (statement.verdict == "segment") hull.faces = {{as<std::size_t>(said["i"]), as<std::size_t>(said["j"])}};
  }
  if (statement.question != "pair" && statement.question != "clearance") return;
  const Number least = statement.question == "pair" ? Number() : as<Number>(said["least"]);
  proved.verdicts.insert(
      {index_of(said, "a", tables), index_of(said, "b", tables), least.n, least.e, statement.verdict});
}

}  // namespace sunder_verifier
