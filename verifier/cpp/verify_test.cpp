// The corpus of cases/certificates, random certificates against a brute-force evaluation, and the Python twin.
#include <tests/support/scale.h>
#include <verifier/cpp/verify.h>

#include <tests/support/places.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <map>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using sunder_verifier::FileResult;
using sunder_verifier::StatementResult;
using sunder_verifier::verify_text;

const fs::path kCases = fs::path(sunder::tests::cases_folder()) / "certificates";
const fs::path kPythonTwin = fs::path(sunder::tests::source_folder()) / "verifier" / "python" / "sunder_verify";

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  EXPECT_TRUE(stream.good()) << path;
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_text(const fs::path& path, const std::string& text) {
  std::ofstream stream(path, std::ios::binary);
  stream << text;
  EXPECT_TRUE(stream.good()) << path;
}

// "-" if accepted, "unreadable", "F", or the first check that failed.
std::string outcome(const FileResult& result) {
  if (!result.readable) return "unreadable";
  if (!result.failed_form.empty()) return "F";
  for (const StatementResult& pair : result.statements) {
    if (!pair.accepted) return pair.failed_check;
  }
  return "-";
}

// What must hold of every result, whatever the text.
void expect_consistent(const FileResult& result) {
  EXPECT_EQ(result.readable, result.error.empty());
  EXPECT_EQ(result.error.find('\n'), std::string::npos);
  if (!result.readable || !result.failed_form.empty()) {
    EXPECT_TRUE(result.statements.empty());
  }
  EXPECT_EQ(result.accepted(), outcome(result) == "-");
  for (const StatementResult& pair : result.statements) {
    EXPECT_EQ(pair.accepted, pair.failed_check.empty());
    EXPECT_EQ(pair.accepted, pair.reason.empty());
  }
}

struct Expected {
  std::string file, check, what;
};

std::vector<Expected> expected_table() {
  std::vector<Expected> table;
  std::ifstream stream(kCases / "EXPECTED.tsv");
  std::string line;
  std::getline(stream, line);
  EXPECT_EQ(line, "file\tcheck\twhat");
  while (std::getline(stream, line)) {
    std::stringstream fields(line);
    Expected row;
    std::getline(fields, row.file, '\t');
    std::getline(fields, row.check, '\t');
    std::getline(fields, row.what, '\t');
    EXPECT_FALSE(row.what.empty()) << line;
    table.push_back(row);
  }
  return table;
}

// ---- The corpus.

TEST(Corpus, IndexAndFoldersAgree) {
  std::set<std::string> listed, present;
  for (const Expected& row : expected_table()) {
    EXPECT_TRUE(listed.insert(row.file).second) << row.file << " is listed twice";
    EXPECT_EQ(row.check == "-", row.file.starts_with("accepted/")) << row.file;
  }
  for (const char* folder : {"accepted", "refused"}) {
    for (const fs::directory_entry& entry : fs::directory_iterator(kCases / folder)) {
      present.insert(std::string(folder) + "/" + entry.path().filename().string());
    }
  }
  EXPECT_EQ(listed, present);
}

TEST(Corpus, EachFileMeetsItsExpectation) {
  std::map<std::string, int> count;
  for (const Expected& row : expected_table()) {
    const FileResult result = verify_text(read_text(kCases / row.file), row.file);
    expect_consistent(result);
    EXPECT_EQ(outcome(result), row.check) << row.file << " (" << row.what << ")";
    if (!result.readable) {
      EXPECT_TRUE(result.error.starts_with(row.file + ": ")) << result.error;
    }
    ++count[row.check];
  }
  EXPECT_GE(count["-"], 12);
  for (const char* check : {"unreadable", "F", "parted", "holds", "sweep", "sides", "cover"})
    EXPECT_GE(count[check], 5);
}

TEST(Corpus, ResultsNameTheStatements) {
  const FileResult result = verify_text(read_text(kCases / "refused" / "parted_second_statement.json"), "here");
  ASSERT_EQ(result.statements.size(), 4u);
  EXPECT_EQ(result.statements[1].name_a, "first");
  EXPECT_EQ(result.statements[1].name_b, "third");
  EXPECT_EQ(result.statements[1].verdict, "apart");
  EXPECT_EQ(result.statements[1].failed_check, "parted");
  EXPECT_EQ(result.statements[1].reason, "\"first\" is not strictly less far along the direction than \"third\"");
  EXPECT_EQ(result.statements[2].verdict, "meet");
  EXPECT_TRUE(result.statements[0].accepted && result.statements[2].accepted && result.statements[3].accepted);
  EXPECT_FALSE(result.accepted());
}

TEST(Corpus, WhatWasLeftOut) {
  const auto left_out = [](const char* file) { return verify_text(read_text(kCases / file), "here").left_out; };
  EXPECT_EQ(left_out("accepted/left_out.json"),
            std::vector<std::string>{"1 cylinder of 'arm'\x1b[2J\x7f\xc2\x9b, \xc3\xa4u\xc3\x9f"
                                     "ere"});
  EXPECT_TRUE(left_out("accepted/segments.json").empty());
  EXPECT_TRUE(left_out("refused/F_left_out_empty.json").empty());
}

TEST(Corpus, VersionOneIsNoLongerRead) {
  for (const char* file : {"refused/F_version_1.json", "refused/F_version_1_of_a_set.json"}) {
    EXPECT_EQ(verify_text(read_text(kCases / file), "here").failed_form,
              "the file is of version 1, and version 3 is needed; make it again");
  }
}

TEST(Text, ErrorNamesLineAndColumn) {
  const FileResult result = verify_text("{\n  \"a\": ?}", "some.json");
  EXPECT_TRUE(result.error.starts_with("some.json: line 2, column 8: ")) << result.error;
}

TEST(Text, NoPartOfAFileIsAccepted) {
  const std::string text = read_text(kCases / "accepted" / "edge_edge_touch.json");
  ASSERT_EQ(text.substr(text.size() - 2), "}\n");
  for (std::size_t length = 0; length + 2 <= text.size(); ++length) {
    const FileResult result = verify_text(std::string_view(text).substr(0, length), "cut");
    ASSERT_FALSE(result.readable) << length;
  }
}

TEST(Text, DeepNestingIsRefusedEarly) {
  const auto nested = [&](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
  EXPECT_EQ(outcome(verify_text(nested(100), "nested")), "F");
  EXPECT_EQ(outcome(verify_text(nested(1000000), "nested")), "unreadable");
  EXPECT_EQ(outcome(verify_text(std::string(1000000, '['), "nested")), "unreadable");
}

// ---- Statements of small integers: made at random, judged without the verifier.

using Integer = std::int64_t;
using Vector = std::array<Integer, 3>;

struct Side {
  std::vector<Vector> vertices;
  std::array<Integer, 9> linear{};
  Vector translation{};
  std::vector<std::pair<std::size_t, Integer>> weights;  // numerators
};

struct Statement {
  Side a, b;
  bool meet = false;
  Vector vector{};          // numerators of the direction or the point
  Integer denominator = 1;  // of vector and of all weights
};

Integer dot(const Vector& u, const Vector& v) { return u[0] * v[0] + u[1] * v[1] + u[2] * v[2]; }

Vector image(const Side& side, std::size_t i) {
  Vector result = side.translation;
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t c = 0; c < 3; ++c) result[r] += side.linear[3 * r + c] * side.vertices[i][c];
  }
  return result;
}

// The rule that must fail first, or "-".
std::string judge(const Statement& s) {
  if (!s.meet) {
    for (std::size_t i = 0; i < s.a.vertices.size(); ++i) {
      for (std::size_t j = 0; j < s.b.vertices.size(); ++j) {
        if (dot(s.vector, image(s.a, i)) >= dot(s.vector, image(s.b, j))) return "parted";
      }
    }
    return "-";
  }
  if (s.a.weights.empty() || s.b.weights.empty()) return "F";
  for (const Side* side : {&s.a, &s.b}) {
    Integer sum = 0;
    Vector point{};
    for (const auto& [vertex, weight] : side->weights) {
      if (weight < 0) return "holds";
      sum += weight;
      for (std::size_t r = 0; r < 3; ++r) point[r] += weight * image(*side, vertex)[r];
    }
    if (sum != s.denominator || point != s.vector) return "holds";
  }
  return "-";
}

class Generator {
 public:
  explicit Generator(std::uint64_t seed) : engine_(seed) {}

  // An integer from low to high.
  Integer pick(Integer low, Integer high) {
    return low + static_cast<Integer>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  std::size_t below(std::size_t n) { return static_cast<std::size_t>(pick(0, static_cast<Integer>(n) - 1)); }
  Vector vector(Integer size) { return {pick(-size, size), pick(-size, size), pick(-size, size)}; }

  Side side() {
    Side side;
    const std::size_t size = below(8) == 0 ? 1 + below(3) : 4;
    for (std::size_t i = 0; i < size; ++i) side.vertices.push_back(vector(3));
    for (Integer& entry : side.linear) entry = pick(-2, 2);
    side.translation = vector(3);
    return side;
  }

  // A true statement. apart: along an axis, now and then along another small direction. meet: B is moved there.
  Statement true_statement() {
    Statement s;
    s.a = side();
    s.b = side();
    s.meet = below(2) == 0;
    s.denominator = pick(1, 6);
    if (s.meet) {
      for (Side* side : {&s.a, &s.b}) {
        Integer left = s.denominator;
        for (std::size_t i = 0; i < side->vertices.size(); ++i) {
          const Integer weight = i + 1 == side->vertices.size() ? left : pick(0, left);
          if (weight > 0 || below(2) == 0) side->weights.emplace_back(i, weight);
          left -= weight;
        }
        // All vertices are multiples of the denominator, so that the sum of the images is one.
        for (Vector& v : side->vertices) {
          for (Integer& coordinate : v) coordinate *= s.denominator;
        }
      }
      Vector sum_a{}, sum_b{};
      for (const auto& [i, w] : s.a.weights) sum_a = plus(sum_a, image(s.a, i), w);
      for (const auto& [i, w] : s.b.weights) sum_b = plus(sum_b, image(s.b, i), w);
      for (std::size_t r = 0; r < 3; ++r) s.b.translation[r] += (sum_a[r] - sum_b[r]) / s.denominator;
      s.vector = sum_a;
    } else {
      while (dot(s.vector, s.vector) == 0) {
        s.vector = below(4) == 0 ? vector(3) : Vector{};
        if (s.vector == Vector{}) s.vector[below(3)] = pick(0, 1) * 2 - 1;
      }
      const auto gap = [&] {
        Integer least = std::numeric_limits<Integer>::max();
        for (std::size_t i = 0; i < s.a.vertices.size(); ++i) {
          for (std::size_t j = 0; j < s.b.vertices.size(); ++j) {
            least = std::min(least, dot(s.vector, image(s.b, j)) - dot(s.vector, image(s.a, i)));
          }
        }
        return least;
      };
      while (gap() > dot(s.vector, s.vector)) s.b.translation = plus(s.b.translation, s.vector, -1);
      while (gap() <= 0) s.b.translation = plus(s.b.translation, s.vector, 1);
    }
    return s;
  }

  // One change of one thing.
  void mutate(Statement& s) {
    Side& side = below(2) == 0 ? s.a : s.b;
    const Integer step = pick(0, 1) * 2 - 1;
    switch (below(s.meet ? 8 : 5)) {
      case 0: side.vertices[below(side.vertices.size())][below(3)] += step; break;
      case 1: side.linear[below(9)] += step; break;
      case 2: side.translation[below(3)] += step * pick(1, 3); break;
      case 3: s.vector[below(3)] += step; break;
      case 4:
        if (s.meet)
          std::swap(side.weights[below(side.weights.size())].second, side.weights[0].second);
        else
          s.vector = {-s.vector[0], -s.vector[1], -s.vector[2]};
        break;
      case 5: side.weights[below(side.weights.size())].second += step; break;
      case 6: std::swap(s.a.weights, s.b.weights), trim(s); break;
      default: {  // the sum stays
        const std::size_t last = side.weights.size() - 1;
        side.weights[below(side.weights.size())].second += step;
        side.weights[last].second -= step;
      }
    }
  }

  // A number in one of its spellings.
  std::string spell(Integer numerator, Integer denominator) {
    const std::string sign = numerator < 0 ? "-" : "";
    const Integer size = numerator < 0 ? -numerator : numerator;
    if (denominator != 1 || below(3) == 0) {
      const Integer factor = pick(1, 1000000);
      return sign + std::to_string(size * factor) + "/" + std::to_string(denominator * factor);
    }
    return below(2) == 0 ? sign + std::to_string(size) : spell_double(numerator);
  }

  std::string spell_double(Integer value) {
    std::array<char, 64> text{};
    if (below(2) == 0) {
      std::snprintf(text.data(), text.size(), "%a", static_cast<double>(value));
    } else {
      const long long size = value < 0 ? -value : value;
      const unsigned shift = static_cast<unsigned>(below(10));
      std::snprintf(text.data(), text.size(), "%s0x%llXp-%u", value < 0 ? "-" : "", size << shift, shift);
    }
    return text.data();
  }

 private:
  static Vector plus(Vector u, const Vector& v, Integer times) {
    for (std::size_t r = 0; r < 3; ++r) u[r] += times * v[r];
    return u;
  }
  // Drops weights of vertices that are not there.
  static void trim(Statement& s) {
    for (Side* side : {&s.a, &s.b}) {
      std::erase_if(side->weights, [&](const auto& entry) { return entry.first >= side->vertices.size(); });
    }
  }

  std::mt19937_64 engine_;
};

// A file of many statements, each with its own two bodies, and an image of each.
json to_file(const std::vector<Statement>& statements, Generator& random) {
  json bodies = json::array(), stated = json::array();
  for (const Statement& s : statements) {
    json item = {{"question", "pair"}, {"verdict", s.meet ? "meet" : "apart"}, {"claims", json::array()}};
    json vector = json::array();
    for (Integer entry : s.vector) vector.push_back(random.spell(entry, s.denominator));
    if (s.meet) {
      item["point"] = vector;
    } else {
      item["claims"].push_back({{"claim", "parted"}, {"direction", vector}});
    }
    for (const Side* side : {&s.a, &s.b}) {
      const std::string name(side == &s.a ? "a" : "b");
      const std::size_t number = bodies.size();
      json body = {{"name", name}, {"points", json::array()}};
      json placed = {{"name", name + std::to_string(number)}, {"of", number}};
      for (const Vector& v : side->vertices) {
        body["points"].push_back({random.spell_double(v[0]), random.spell_double(v[1]), random.spell_double(v[2])});
      }
      for (Integer entry : side->linear) placed["linear"].push_back(random.spell_double(entry));
      for (Integer entry : side->translation) placed["translation"].push_back(random.spell_double(entry));
      if (s.meet) {
        json weights = json::array();
        for (const auto& [vertex, weight] : side->weights) {
          json entry = json::array();
          entry.push_back(vertex);
          entry.push_back(random.spell(weight, s.denominator));
          weights.push_back(entry);
        }
        item["claims"].push_back({{"claim", "holds"}, {"weights", weights}});
      }
      item[name] = number + 1;
      bodies.push_back(body);
      bodies.push_back(placed);
    }
    stated.push_back(item);
  }
  json file = json::object();
  file["sunder_certificate"] = 3;
  for (const char* key : {"inputs", "call", "left_out"}) file[key] = json::array();
  file["tables"]["bodies"] = bodies;
  file["statements"] = stated;
  return file;
}

TEST(Random, TrueStatementsAreAcceptedAndMutationsJudgedAlike) {
  constexpr std::uint64_t seed = 20240607;
  SCOPED_TRACE(seed);
  Generator random(seed);
  std::map<std::string, int> count;
  const int rounds = sunder::tests::scaled_count(10000, 1000);
  for (int round = 0; round < rounds; ++round) {
    Statement s = random.true_statement();
    ASSERT_EQ(judge(s), "-") << "the generator is wrong";
    const std::string text = to_file({s}, random).dump();
    ASSERT_EQ(outcome(verify_text(text, "true")), "-") << text;
    random.mutate(s);
    const std::string mutated = to_file({s}, random).dump();
    const std::string check = judge(s);
    ASSERT_EQ(outcome(verify_text(mutated, "mutated")), check) << mutated;
    ++count[(s.meet ? "meet " : "apart ") + check];
  }
  // Most mutations are untrue, some stay true.
  for (const char* key : {"apart -", "apart parted", "meet -", "meet holds"}) {
    EXPECT_GE(count[key], rounds / 100) << key;
    RecordProperty(key, count[key]);
  }
  EXPECT_LE(count["apart -"] + count["meet -"], rounds / 2);
}

// ---- The Python twin.

std::string on_one_line(const std::string& text) {
  std::string result;
  for (const char c : text) {
    const bool is_control = (c >= 0 && c < ' ') || c == '\x7f';
    std::array<char, 8> code{};
    std::snprintf(code.data(), code.size(), "\\x%02x", static_cast<unsigned>(c));
    result += is_control ? code.data() : std::string(1, c);
  }
  return result;
}

// The lines that the Python twin prints for one file, reasons of F and of unreadable files left out.
std::string summary(const FileResult& result, const std::string& place) {
  if (!result.readable) return place + ": unreadable\n";
  if (!result.failed_form.empty()) return place + ": refused: F\n";
  const auto quoted = [](const std::string& name) { return json(name).dump(-1, ' ', true); };
  std::string lines;
  for (const sunder_verifier::FileInput& input : result.inputs) {
    lines += place + ": of " + quoted(input.name) + ", SHA-256 " + input.sha256 + "\n";
  }
  std::string call;
  for (const std::string& word : result.call) call += " " + quoted(word);
  if (!call.empty()) lines += place + ": called with:" + call + "\n";
  for (const std::string& text : result.left_out) lines += place + ": left out: " + quoted(text) + "\n";
  for (std::size_t i = 0; i < result.statements.size(); ++i) {
    const StatementResult& pair = result.statements[i];
    lines += place + ": statement " + std::to_string(i) + ": " + (pair.accepted ? "accepted: " : "refused: ");
    lines += pair.sentence + (pair.accepted ? "" : ": " + pair.failed_check + ": " + on_one_line(pair.reason)) + "\n";
  }
  return lines;
}

// What the Python twin prints for the files in a folder that are named 0, 1, 2, ..., in the form of summary().
std::string python_summary(const fs::path& folder, std::size_t count) {
  std::string command =
      "cd '" + folder.string() + "' && '" + sunder::tests::python() + "' '" + kPythonTwin.string() + "'";
  for (std::size_t i = 0; i < count; ++i) command += " " + std::to_string(i);
  FILE* pipe = popen((command + " 2>&1").c_str(), "r");
  if (pipe == nullptr) return "no interpreter";
  std::string output;
  std::array<char, 4096> block{};
  while (const std::size_t size = std::fread(block.data(), 1, block.size(), pipe)) output.append(block.data(), size);
  pclose(pipe);
  std::string result, line;
  std::stringstream lines(output);
  while (std::getline(lines, line)) {
    const std::string place = line.substr(0, line.find(':'));
    if (place.find(' ') != std::string::npos) continue;  // the last line, the totals
    const auto tells = [&](const char* what) { return line.starts_with(place + what); };
    if (tells(": refused: F: ")) {
      line = place + ": refused: F";
    } else if (!tells(": statement ") && !tells(": called with: ") && !tells(": of \"") && !tells(": left out: ")) {
      line = place + ": unreadable";
    }
    result += line + "\n";
  }
  return result;
}

// Python prints errors and results to two streams: compare them sorted.
std::string sorted_lines(const std::string& text) {
  std::vector<std::string> lines;
  std::stringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  std::sort(lines.begin(), lines.end());
  std::string result;
  for (const std::string& line : lines) result += line + "\n";
  return result;
}

void expect_twins_agree(const std::vector<std::string>& texts) {
  ASSERT_FALSE(texts.empty());
  const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
  const fs::path folder = fs::path(testing::TempDir()) / ("sunder_verify_" + test + std::to_string(getpid()));
  fs::create_directories(folder);
  std::string expected;
  for (std::size_t i = 0; i < texts.size(); ++i) {
    write_text(folder / std::to_string(i), texts[i]);
    expected += summary(verify_text(texts[i], "twin"), std::to_string(i));
  }
  const std::string found = python_summary(folder, texts.size());
  EXPECT_EQ(sorted_lines(found), sorted_lines(expected)) << "the files are in " << folder;
  if (!testing::Test::HasFailure()) fs::remove_all(folder);
}

TEST(Twins, AgreeOnTheCorpus) {
  std::vector<std::string> texts;
  for (const Expected& row : expected_table()) texts.push_back(read_text(kCases / row.file));
  expect_twins_agree(texts);
}

TEST(Twins, AgreeOnRandomStatements) {
  Generator random(7);
  std::vector<Statement> statements;
  for (int i = 0; i < 1000; ++i) {
    statements.push_back(random.true_statement());
    if (i % 4 != 0) random.mutate(statements.back());
  }
  expect_twins_agree({to_file(statements, random).dump()});
}

// Files with a few bytes changed: mostly unreadable or wrong in form, some wrong in what they state.
TEST(Twins, AgreeOnDamagedFiles) {
  Generator random(11);
  std::vector<std::string> sound, texts;
  for (const Expected& row : expected_table()) {
    const std::string text = read_text(kCases / row.file);
    if (row.check == "-" && text.size() < 3000) sound.push_back(text);
  }
  ASSERT_GE(sound.size(), 10u);
  const std::string bytes = "0123456789abcdefpx-+./,:[]{}\" \n\t\\untE\x7f\xc3\xa9\xff";
  std::map<std::string, int> count;
  for (int i = 0; i < 4000; ++i) {
    std::string text = sound[random.below(sound.size())];
    for (std::size_t changes = 1 + random.below(2); changes > 0; --changes) {
      const std::size_t at = random.below(text.size());
      const std::size_t other = random.below(text.size());
      switch (random.below(4)) {
        case 0: text[at] = bytes[random.below(bytes.size())]; break;
        case 1: text.erase(at, 1 + random.below(3)); break;
        case 2: text.insert(at, 1, bytes[random.below(bytes.size())]); break;
        default: text.replace(at, 1, text, other, 1 + random.below(8));
      }
    }
    const FileResult result = verify_text(text, "damaged");
    expect_consistent(result);
    ++count[outcome(result)];
    texts.push_back(text);
  }
  for (const char* key : {"-", "unreadable", "F"}) EXPECT_GE(count[key], 8) << key;
  EXPECT_GE(count["holds"], 1);
  expect_twins_agree(texts);
}

}  // namespace
