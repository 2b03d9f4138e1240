#include <verifier/cpp/question_rows.h>
#include <verifier/cpp/rules.h>
#include <verifier/cpp/sentences.h>
#include <verifier/cpp/shapes.h>
#include <verifier/cpp/statements.h>
#include <verifier/cpp/verify.h>

#include <algorithm>
#include <initializer_list>
#include <optional>
#include <stdexcept>
#include <string_view>

namespace sunder_verifier {
namespace {

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
        &claims_of_all_pairs, &claims_of_meshes, &claims_of_holders, &claims_of_crossings, &claims_of_half_planes,
        &claims_of_discs, &claims_of_contacts, &claims_of_polygons, &claims_of_valid_polygons}) {
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

// Of a body or a mesh its index in its table; of what else statements are about, nothing.
std::optional<std::size_t> index_of(const Scope& said, const char* name, const Tables& tables) {
  const Value* const value = said.find(name);
  if (value == nullptr) return std::nullopt;
  if (const auto* const body = std::get_if<const HullBody*>(value)) {
    return static_cast<std::size_t>(*body - tables.bodies.data());
  }
  if (const auto* const mesh = std::get_if<const MeshBody*>(value)) {
    return static_cast<std::size_t>(*mesh - tables.meshes.data());
  }
  return std::nullopt;
}

bool has_open_piece(const Value& mesh) {
  const MeshPieces& pieces = *as<MeshBody>(mesh).pieces;
  return pieces.closed < pieces.triangles.size();
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
    const Value missing = member.name == "as_meshes" ? Value(MeshMembers()) : Value(Groups());
    said->set(member.name, is_there ? read_member(item, member, *said, member.of, tables, where) : missing);
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
  const auto a = index_of(said, "a", tables), b = index_of(said, "b", tables);
  if (!a || !b) return;
  const Value* const stated = said.find("least");
  const Number least = stated != nullptr ? as<Number>(*stated) : Number();
  std::string verdict = statement.verdict;
  if (verdict == "touching" && statement.question == "meshes" &&
      (has_open_piece(said["a"]) || has_open_piece(said["b"]))) {
    verdict = "meet";  // what a surface alone may do, where touching is allowed, is not told
  }
  proved.verdicts[statement.question][{*a, *b, least.n, least.e}].insert(std::move(verdict));
}

}  // namespace sunder_verifier
