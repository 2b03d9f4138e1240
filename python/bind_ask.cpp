// Questions asked of files, as the program asks them, in this process.
#include <cli/answer.h>

#include "common.h"

#include <cstdlib>

namespace sunder::python {

namespace {

// What an answer told.
struct Told {
  std::string report, errors, proof;
};

// The words of a call as the program takes them; a proof goes to "-". Whole bytes, since names of files are.
nb::tuple ask(const std::vector<nb::bytes>& given) {
  std::vector<std::string> words;
  for (const nb::bytes& word : given) words.emplace_back(word.c_str(), word.size());
  const char* packages = std::getenv("ROS_PACKAGE_PATH");
  Told told;
  unlocked([&] {
    const auto into = [](std::string& text) -> TextSink { return [&text](std::string_view more) { text += more; }; };
    ask::Talk talk({.out = into(told.report),
                    .error = into(told.errors),
                    .file = [&](const std::filesystem::path& name) { return name == "-" ? into(told.proof) : nullptr; },
                    .package_paths = packages == nullptr ? "" : packages});
    cli::Asked asked;
    cli::answer(words, talk, asked);
  });
  const auto bytes_of = [](const std::string& text) { return nb::bytes(text.data(), text.size()); };
  return nb::make_tuple(bytes_of(told.report), bytes_of(told.errors), bytes_of(told.proof));
}

}  // namespace

void bind_ask(nb::module_& module) {
  module.def("_ask", ask, nb::arg("words"), "The report of a call of the program, its errors, and what went to \"-\".");
}

}  // namespace sunder::python
