#include <tests/support/program.h>

#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <sstream>

namespace sunder::tests {

std::string read_text(const fs::path& path) {
  std::ifstream stream(path, std::ios::binary);
  std::stringstream text;
  text << stream.rdbuf();
  return text.str();
}

void write_text(const fs::path& path, const std::string& text) { std::ofstream(path, std::ios::binary) << text; }

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

void Program::SetUp() {
  std::string name = (fs::temp_directory_path() / "sunder_program_XXXXXX").string();
  ASSERT_NE(mkdtemp(name.data()), nullptr);
  folder_ = name;
}

std::size_t Program::files_in_folder() const {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder_), fs::directory_iterator()));
}

Program::Run Program::run(const std::string& arguments) const {
  const std::string err = in_folder("stderr");
  const std::string command = "'" + program() + "' " + arguments + " 2> '" + err + "'";
  Run result;
  std::FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return result;
  std::array<char, 4096> buffer;
  for (std::size_t n = 0; (n = std::fread(buffer.data(), 1, buffer.size(), pipe)) > 0;)
    result.out.append(buffer.data(), n);
  const int status = pclose(pipe);
  if (WIFEXITED(status)) result.code = WEXITSTATUS(status);
  result.err = read_text(err);
  fs::remove(err);
  return result;
}

void Program::expect_bad(const std::string& arguments, const std::string& part) const {
  const std::size_t before = files_in_folder();
  const Run r = run(arguments);
  EXPECT_EQ(r.code, 2) << arguments << "\n" << r.err;
  if (arguments.find("--json") == std::string::npos) {
    EXPECT_EQ(r.out, "") << arguments;
  } else {  // the same as a report
    EXPECT_EQ("sunder: " + json::parse(r.out)["error"].value("text", "") + "\n", r.err) << arguments;
  }
  EXPECT_TRUE(r.err.starts_with("sunder: ")) << arguments << "\n" << r.err;
  EXPECT_EQ(std::count(r.err.begin(), r.err.end(), '\n'), 1) << arguments << "\n" << r.err;
  EXPECT_NE(r.err.find(part), std::string::npos) << arguments << "\n" << r.err << "expected: " << part;
  EXPECT_EQ(files_in_folder(), before) << arguments;
}

json Program::report(const std::string& arguments, int code) const {
  const Run r = run(arguments + " --json");
  EXPECT_EQ(r.code, code) << arguments << "\n" << r.err;
  const json j = json::parse(r.out, nullptr, false);
  EXPECT_FALSE(j.is_discarded()) << r.out;
  for (const char* key : {"sunder", "verb", "answer", "method", "decided_by", "cost", "objects", "notes"}) {
    EXPECT_TRUE(j.contains(key)) << arguments << ": " << key;
  }
  EXPECT_EQ(j.value("sunder", 0), 1);
  EXPECT_EQ(j.value("verb", ""), arguments.substr(0, arguments.find(' ')));
  return j;
}

bool Program::python_accepts(const std::string& file) {
  const std::string verifier = source_folder() + "/verifier/python/sunder_verify";
  return std::system(("'" + python() + "' '" + verifier + "' --quiet '" + file + "' > /dev/null").c_str()) == 0;
}

}  // namespace sunder::tests
