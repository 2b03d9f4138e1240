#include "sunder_verify.h"

#include "statement_reader.h"
#include "sunder_verify_sets.h"

#include <verifier/cpp/checker.h>

#include <boost/multiprecision/cpp_int.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <iterator>
#include <set>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace sunder_verifier {
namespace {

constexpr std::size_t kMaxNote = 4000;  // characters of a note
constexpr std::size_t kMaxDepth = 500;  // of nested JSON; a certificate needs 5 levels

using Vector = std::array<Integer, 3>;

// Vertex v is v * 2^e.
struct Body {
  std::vector<Vector> vertices;
  std::int64_t e = 0;
  std::size_t bits = 0;  // of the longest integer
};

Body read_body(const json& item, const std::string& where) {
  name_member(item, where);
  Numbers flat;
  std::size_t count = 0;
  for (const json& vertex : list_member(item, "vertices", where)) {
    Numbers numbers = read_numbers(vertex, 3, read_double, where + ".vertices[" + std::to_string(count++) + "]");
    std::move(numbers.begin(), numbers.end(), std::back_inserter(flat));
  }
  if (flat.empty()) refuse_form(where + " has no vertex");
  Common scaled = common(flat);
  Body body;
  body.e = scaled.e;
  body.bits = bits(scaled.integers);
  for (std::size_t i = 0; i < flat.size(); i += 3) {
    Integer* v = &scaled.integers[i];
    body.vertices.push_back({std::move(v[0]), std::move(v[1]), std::move(v[2])});
  }
  return body;
}

// The image of vertex v of the body is linear v * 2^turned + translation * 2^moved.
struct Placed {
  std::string name;
  const Body* body = nullptr;
  Integers linear;  // row by row
  std::int64_t turned = 0;
  Integers translation;
  std::int64_t moved = 0;
};

Placed read_placed(const json& item, const std::vector<Body>& bodies, const std::string& where) {
  Placed placed;
  placed.name = name_member(item, where);
  placed.body = &bodies[index_member(item, "body", bodies.size(), where)];
  const Common linear = common(read_numbers(member(item, "linear", where), 9, read_double, where + ".linear"));
  const Common translation =
      common(read_numbers(member(item, "translation", where), 3, read_double, where + ".translation"));
  placed.linear = linear.integers;
  placed.turned = linear.e + placed.body->e;
  placed.translation = translation.integers;
  placed.moved = translation.e;
  return placed;
}

struct Weights {
  std::vector<std::size_t> vertices;
  Numbers values;
};

Weights read_weights(const json& item, const char* key, std::size_t size, const std::string& parent) {
  const json& list = list_member(item, key, parent);
  const std::string where = parent + "." + key;
  if (list.size() > most_weights) refuse_form(where + " has more than " + std::to_string(most_weights) + " entries");
  Weights weights;
  for (const json& entry : list) {
    if (!entry.is_array() || entry.size() != 2) refuse_form(where + " has an entry that is not a list of 2");
    const std::size_t vertex = read_index(entry[0], size, where + " vertex");
    if (std::count(weights.vertices.begin(), weights.vertices.end(), vertex) > 0) {
      refuse_form(where + " has vertex " + std::to_string(vertex) + " twice");
    }
    weights.vertices.push_back(vertex);
    weights.values.push_back(read_number(entry[1], where));
  }
  return weights;
}

struct Pair {
  std::string verdict;
  const Placed* a = nullptr;
  const Placed* b = nullptr;
  Numbers vector;  // apart: the direction; meet: the point
  std::size_t extreme_a = 0, extreme_b = 0;
  Weights weights_a, weights_b;
};

Pair read_pair(const json& item, const std::vector<Placed>& placed, const std::string& where) {
  Pair pair;
  pair.a = &placed[index_member(item, "a", placed.size(), where)];
  pair.b = &placed[index_member(item, "b", placed.size(), where)];
  pair.verdict = string_member(item, "verdict", where);
  const std::size_t size_a = pair.a->body->vertices.size();
  const std::size_t size_b = pair.b->body->vertices.size();
  if (pair.verdict == "apart") {
    pair.vector = read_numbers(member(item, "direction", where), 3, read_number, where + ".direction");
    pair.extreme_a = index_member(item, "extreme_a", size_a, where);
    pair.extreme_b = index_member(item, "extreme_b", size_b, where);
  } else if (pair.verdict == "meet") {
    pair.vector = read_numbers(member(item, "point", where), 3, read_number, where + ".point");
    pair.weights_a = read_weights(item, "weights_a", size_a, where);
    pair.weights_b = read_weights(item, "weights_b", size_b, where);
  } else {
    refuse_form(where + ".verdict is neither apart nor meet");
  }
  return pair;
}

struct File {
  std::vector<Body> bodies;
  std::vector<Placed> placed;
  std::vector<Pair> pairs;  // points into placed, and placed into bodies: neither grows after it was read
};

void read_file(const json& top, File& file) {
  const json& version = member(top, "sunder_certificate", "the file");
  if (!version.is_number_integer() || version != 1) refuse_form("sunder_certificate is not 1");
  for (const json& item : list_member(top, "bodies", "the file")) {
    file.bodies.push_back(read_body(item, "bodies[" + std::to_string(file.bodies.size()) + "]"));
  }
  for (const json& item : list_member(top, "placed", "the file")) {
    file.placed.push_back(read_placed(item, file.bodies, "placed[" + std::to_string(file.placed.size()) + "]"));
  }
  for (const json& item : list_member(top, "pairs", "the file")) {
    file.pairs.push_back(read_pair(item, file.placed, "pairs[" + std::to_string(file.pairs.size()) + "]"));
  }
}

// What the file says that it does not speak of; empty where it has no note.
std::string read_note(const json& top) {
  if (!top.is_object() || !top.contains("note")) return "";
  std::string note = string_member(top, "note", "the file");
  if (note.empty() || characters(note) > kMaxNote) {
    refuse_form("the note is not of 1 to " + std::to_string(kMaxNote) + " characters");
  }
  return note;
}

// ---- Checking.

Integer dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

Vector row(const Integers& matrix, std::size_t r) { return {matrix[3 * r], matrix[3 * r + 1], matrix[3 * r + 2]}; }

// -1, 0, +1 as m * 2^e is less than, equal to, greater than n * 2^f.
int compare(const Integer& m, std::int64_t e, const Integer& n, std::int64_t f) {
  return shifted(m, std::max<std::int64_t>(e - f, 0)).compare(shifted(n, std::max<std::int64_t>(f - e, 0)));
}

// The image of a vertex is the result * 2^image_exponent.
std::int64_t image_exponent(const Placed& placed) { return std::min(placed.turned, placed.moved); }

Vector image(const Placed& placed, std::size_t vertex) {
  const std::int64_t e = image_exponent(placed);
  Vector result;
  for (std::size_t r = 0; r < 3; ++r) {
    result[r] = shifted(dot(row(placed.linear, r), placed.body->vertices[vertex]), placed.turned - e) +
                shifted(placed.translation[r], placed.moved - e);
  }
  return result;
}

// d^T linear: d . image(v) is this . v * 2^turned plus something that all v share.
Vector pulled_back(const Vector& d, const Placed& placed) {
  const Vector r0 = row(placed.linear, 0), r1 = row(placed.linear, 1), r2 = row(placed.linear, 2);
  Vector result;
  for (std::size_t c = 0; c < 3; ++c) result[c] = d[0] * r0[c] + d[1] * r1[c] + d[2] * r2[c];
  return result;
}

void check_apart(const Pair& pair) {
  const Integers scaled = common(pair.vector).integers;  // a positive multiple of the direction
  const Vector d = row(scaled, 0);

  for (const Placed* placed : {pair.a, pair.b}) take_steps(9, bits(scaled), bits(placed->linear));
  const std::vector<Vector>& of_a = pair.a->body->vertices;
  const Vector row_a = pulled_back(d, *pair.a);
  take_steps(of_a.size(), bits(row_a), pair.a->body->bits);
  const Integer furthest = dot(row_a, of_a[pair.extreme_a]);
  for (std::size_t i = 0; i < of_a.size(); ++i) {
    if (dot(row_a, of_a[i]) > furthest) {
      throw Refused{"A1", "vertex " + std::to_string(i) + " of A is further along the direction than extreme_a"};
    }
  }
  const std::vector<Vector>& of_b = pair.b->body->vertices;
  const Vector row_b = pulled_back(d, *pair.b);
  take_steps(of_b.size(), bits(row_b), pair.b->body->bits);
  const Integer least = dot(row_b, of_b[pair.extreme_b]);
  for (std::size_t i = 0; i < of_b.size(); ++i) {
    if (dot(row_b, of_b[i]) < least) {
      throw Refused{"A2", "vertex " + std::to_string(i) + " of B is less far along the direction than extreme_b"};
    }
  }
  const Integer end_a = dot(d, image(*pair.a, pair.extreme_a));
  const Integer end_b = dot(d, image(*pair.b, pair.extreme_b));
  if (compare(end_a, image_exponent(*pair.a), end_b, image_exponent(*pair.b)) >= 0) {
    throw Refused{"A3", "extreme_a is not strictly less far along the direction than extreme_b"};
  }
}

void check_not_negative(const Weights& weights, const std::string& side) {
  for (std::size_t i = 0; i < weights.values.size(); ++i) {
    if (weights.values[i].n < 0) {
      const std::string vertex = std::to_string(weights.vertices[i]);
      throw Refused{"M1", "the weight of vertex " + vertex + " of " + side + " is negative"};
    }
  }
}

void check_sum_is_one(const Common& weights, const std::string& side) {
  Integer total = 0;
  for (const Integer& weight : weights.integers) total += weight;
  if (compare(total, weights.e, weights.d, 0) != 0) throw Refused{"M2", "the weights of " + side + " do not sum to 1"};
}

void check_sum_is_point(const Placed& placed, const std::vector<std::size_t>& vertices, const Common& weights,
                        const Numbers& point, const std::string& side) {
  Vector total{};
  for (std::size_t i = 0; i < vertices.size(); ++i) {
    const Vector vertex = image(placed, vertices[i]);
    for (std::size_t r = 0; r < 3; ++r) total[r] += weights.integers[i] * vertex[r];
  }
  for (std::size_t r = 0; r < 3; ++r) {
    const Integer left = total[r] * point[r].d;
    const Integer right = point[r].n * weights.d;
    if (compare(left, weights.e + image_exponent(placed), right, point[r].e) != 0) {
      throw Refused{"M3", "the weighted sum of " + side + " is not the point in coordinate " + std::to_string(r)};
    }
  }
}

void check_meet(const Pair& pair) {
  check_not_negative(pair.weights_a, "A");
  check_not_negative(pair.weights_b, "B");
  const Common weights_a = common_weights(pair.weights_a.values);
  const Common weights_b = common_weights(pair.weights_b.values);
  check_sum_is_one(weights_a, "A");
  check_sum_is_one(weights_b, "B");
  check_sum_is_point(*pair.a, pair.weights_a.vertices, weights_a, pair.vector, "A");
  check_sum_is_point(*pair.b, pair.weights_b.vertices, weights_b, pair.vector, "B");
}

PairResult check(const Pair& pair) {
  PairResult result;
  result.name_a = pair.a->name;
  result.name_b = pair.b->name;
  result.verdict = pair.verdict;
  try {
    if (pair.verdict == "apart")
      check_apart(pair);
    else
      check_meet(pair);
    result.accepted = true;
  } catch (const Refused& refused) {
    result.failed_check = refused.check;
    result.reason = refused.reason;
  }
  return result;
}

// ---- The text.

std::string line_and_column(std::string_view text, std::size_t byte) {
  const std::string_view before = text.substr(0, byte > 0 ? byte - 1 : 0);
  const auto line = std::count(before.begin(), before.end(), '\n') + 1;
  const std::size_t start = before.rfind('\n');
  const std::size_t column = before.size() - (start == std::string_view::npos ? 0 : start + 1) + 1;
  return "line " + std::to_string(line) + ", column " + std::to_string(column);
}

// Reads JSON without keeping it: finds what is not JSON, nesting too deep, and keys given twice.
class FirstReading : public nlohmann::json_sax<json> {
 public:
  explicit FirstReading(std::string_view text) : text_(text) {}

  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(std::int64_t) override { return true; }
  bool number_unsigned(std::uint64_t) override { return true; }
  bool number_float(double, const std::string&) override { return true; }
  bool string(std::string&) override { return true; }
  bool binary(json::binary_t&) override { return true; }
  bool start_object(std::size_t) override { return start(); }
  bool key(std::string& key) override {
    repeated |= !keys_.back().insert(key).second;
    return true;
  }
  bool end_object() override { return end(); }
  bool start_array(std::size_t) override { return start(); }
  bool end_array() override { return end(); }
  bool parse_error(std::size_t byte, const std::string&, const nlohmann::detail::exception&) override {
    error = line_and_column(text_, byte) + ": not JSON, or a number beyond the doubles; write the file again";
    return false;
  }

  std::string error;  // empty if the text is JSON
  bool repeated = false;

 private:
  bool start() {
    keys_.emplace_back();
    if (keys_.size() > kMaxDepth) error = "nested too deeply; a certificate needs 5 levels";
    return error.empty();
  }
  bool end() {
    keys_.pop_back();
    return true;
  }

  std::string_view text_;
  std::vector<std::set<std::string>> keys_;  // of the objects around the place of reading; of a list, none
};

void verify_into(std::string_view text, const std::string& prefix, FileResult& result) {
  if (text.find('\0') != std::string_view::npos) {  // the JSON reader takes it for the end
    result.error = prefix + "not text; write the file again";
    return;
  }
  FirstReading first(text);
  json::sax_parse(text.begin(), text.end(), &first);
  if (!first.error.empty()) {
    result.error = prefix + first.error;
    return;
  }
  result.readable = true;
  try {
    if (first.repeated) refuse_form("an object has a key twice");
    const json top = json::parse(text.begin(), text.end());
    if (is_of_claims(top)) return verify_claims(top, result);
    std::string note = read_note(top);
    if (top.is_object() && top.contains("sunder_set_certificate")) {
      result.pairs = verify_set(top);
    } else {
      File file;
      read_file(top, file);
      for (const Pair& pair : file.pairs) result.pairs.push_back(check(pair));
    }
    result.note = std::move(note);  // of a file whose form is right
  } catch (const Refused& refused) {
    result.failed_form = refused.reason;
  }
}

}  // namespace

bool FileResult::accepted() const {
  return readable && failed_form.empty() &&
         std::all_of(pairs.begin(), pairs.end(), [](const PairResult& pair) { return pair.accepted; });
}

FileResult verify_text(std::string_view text, std::string_view place, Limit limit) {
  FileResult result;
  const std::string prefix = std::string(place) + ": ";
  lift_limit();
  if (limit == Limit::by_size) limit_steps(text.size());
  try {
    verify_into(text, prefix, result);
  } catch (const TooLong& error) {
    result = FileResult();
    result.error = prefix + "checking it takes more than " + std::to_string(error.most) +
                   " steps, the limit for a file of its size; give --no-limit to check it all the same";
  } catch (const std::exception& error) {  // memory ran out
    result = FileResult();
    result.error = error.what();
  }
  return result;
}

}  // namespace sunder_verifier
