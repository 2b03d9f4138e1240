#include <sunder/ask/call_words.h>
#include <sunder/ask/report.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string_view>
#include <utility>

namespace sunder::ask {

namespace {

using Words = std::vector<std::string>;

constexpr std::array<std::string_view, 2> proof_options{"--certificate", "--meeting-certificate"};

// What changes no proof.
constexpr std::array<std::string_view, 10> other_options{
    "--csv", "--geojson", "--svg", "--svg-limit", "--gltf", "--json-lines", "--json", "--title", "--threads", "--out"};

// The name of a proof that is made again, and not written: no input is called so.
constexpr const char* no_file = "(the proof)";

template <class List>
bool is_in(const List& list, std::string_view name) {
  return std::find(list.begin(), list.end(), name) != list.end();
}

// "--out" of "-o,--out".
std::string_view name_of(const Option& option) {
  return std::string_view(option.name).substr(option.name.find(',') + 1);
}

Words values_of(const OptionValue& value) {
  if (const auto* text = std::get_if<std::string*>(&value)) return {**text};
  if (const auto* number = std::get_if<std::uint64_t*>(&value)) return {std::to_string(**number)};
  if (const auto* list = std::get_if<Words*>(&value)) return **list;
  return {};
}

std::optional<Verb> verb_named(std::string_view name) {
  std::vector<Verb> all = verbs();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Verb& verb) { return verb.name == name; });
  return found == all.end() ? std::nullopt : std::optional(std::move(*found));
}

[[noreturn]] void fail_words(const std::string& what) {
  throw Error(ErrorCode::bad_call, what + ", so these words are no call that makes a proof");
}

// ---- Words into values.

class Reader {
 public:
  explicit Reader(std::span<const std::string> words) : words_(words.subspan(std::min<std::size_t>(1, words.size()))) {
    std::optional<Verb> named = words.empty() ? std::nullopt : verb_named(words[0]);
    if (!named) fail_words("there is no such verb");
    verb_ = std::move(*named);
    given_.assign(verb_.options.size(), false);
  }

  Verb read() {
    while (!words_.empty() && words_[0].starts_with("--") && words_[0] != "--") take_option();
    if (!words_.empty() && words_[0] == "--") words_ = words_.subspan(1);
    for (std::size_t k = 0; k < verb_.options.size() && !words_.empty(); ++k) {
      if (!verb_.options[k].name.starts_with('-')) take_files(k);
    }
    if (!words_.empty()) fail_words("nothing is expected at " + io::quote(words_[0]));
    require_fit();
    return std::move(verb_);
  }

 private:
  std::size_t number_of(std::string_view name) const {
    const auto found =
        std::find_if(verb_.options.begin(), verb_.options.end(), [&](const Option& o) { return name_of(o) == name; });
    if (found == verb_.options.end()) fail_words("there is no option " + io::quote(std::string(name)));
    return static_cast<std::size_t>(found - verb_.options.begin());
  }

  std::string next() {
    if (words_.empty()) fail_words("a value is missing");
    std::string word = words_[0];
    words_ = words_.subspan(1);
    return word;
  }

  void take_option() {
    const std::string name = next();
    const std::size_t k = number_of(name);
    if (is_in(other_options, name)) fail_words("the option " + name + " changes no proof");
    const OptionValue& value = verb_.options[k].value;
    if (given_[k] && !std::holds_alternative<Words*>(value)) fail_words(name + " is given twice");
    given_[k] = true;
    if (auto* const* flag = std::get_if<bool*>(&value)) {
      **flag = true;
      return;
    }
    std::string word = next();
    if (is_in(proof_options, name)) {
      if (word != "-") fail_words("the proof has a name");
      word = no_file;
    }
    if (auto* const* text = std::get_if<std::string*>(&value)) {
      **text = std::move(word);
    } else if (auto* const* list = std::get_if<Words*>(&value)) {
      (*list)->push_back(std::move(word));
    } else {
      fail_words(name + " takes a number");
    }
  }

  void take_files(std::size_t k) {
    const Option& option = verb_.options[k];
    given_[k] = true;
    if (auto* const* text = std::get_if<std::string*>(&option.value)) {
      **text = next();
      return;
    }
    Words& list = *std::get<Words*>(option.value);
    const std::size_t most = option.most > 0 ? static_cast<std::size_t>(option.most) : words_.size();
    while (!words_.empty() && list.size() < most) list.push_back(next());
  }

  bool is_given(std::string_view name) const { return given_[number_of(name)]; }

  void require_fit() const {
    bool makes_proof = false;
    for (std::size_t k = 0; k < verb_.options.size(); ++k) {
      const Option& option = verb_.options[k];
      if (option.required && !given_[k]) fail_words(option.name + " is missing");
      if (!given_[k]) continue;
      makes_proof = makes_proof || is_in(proof_options, name_of(option));
      if (!option.needs.empty() && !is_given(option.needs)) fail_words(option.name + " needs " + option.needs);
      for (const std::string& other : option.excludes) {
        if (is_given(other)) fail_words(option.name + " excludes " + other);
      }
    }
    if (!makes_proof) fail_words("no proof is asked for");
  }

  std::span<const std::string> words_;
  Verb verb_;
  std::vector<bool> given_;  // of each option
};

}  // namespace

Words words_of(const Verb& verb) {
  Words words{verb.name}, files;
  const std::optional<Verb> unless_given = verb_named(verb.name);
  for (std::size_t k = 0; k < verb.options.size(); ++k) {
    const Option& option = verb.options[k];
    const std::string name(name_of(option));
    if (!ask::is_given(option, unless_given->options[k]) || is_in(other_options, name)) continue;
    if (!name.starts_with('-')) {
      for (std::string& file : values_of(option.value)) files.push_back(std::move(file));
    } else if (std::holds_alternative<bool*>(option.value)) {
      words.push_back(name);
    } else {
      for (std::string& value : values_of(option.value)) {
        words.push_back(name);
        words.push_back(is_in(proof_options, name) ? "-" : std::move(value));
      }
    }
  }
  if (!files.empty() && files[0].starts_with("--")) words.emplace_back("--");
  words.insert(words.end(), files.begin(), files.end());
  return words;
}

Report run_call(const Verb& verb, Talk& talk) {
  talk.words = words_of(verb);
  return verb.run(talk);
}

Origin by_this_call(const Talk& talk, Origin origin) {
  origin.call = talk.words;
  return origin;
}

Origin origin_of(const Talk& talk, InputFiles inputs, Words left_out) {
  return by_this_call(talk, {std::move(inputs), std::move(left_out), {}});
}

void run_again(std::span<const std::string> words, std::vector<io::GivenFiles::File> files, const ProofSink& write) {
  const Verb verb = Reader(words).read();
  Talk talk({.file = [&](const std::filesystem::path& name) {
    return [&write, name](std::string_view text) { write(name, text); };
  }});
  talk.words.assign(words.begin(), words.end());
  const io::GivenFiles given(std::move(files));
  verb.run(talk);
}

std::string call_text(std::span<const std::string> words) {
  constexpr std::string_view plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-+=.,:;/@%#";
  std::string text = "sunder";
  for (const std::string& word : words) {
    const bool is_plain = !word.empty() && word.find_first_not_of(plain) == std::string::npos;
    text += ' ';
    if (is_plain) text += word;
    if (is_plain) continue;
    text += '\'';
    for (const char c : io::one_line(word)) text += c == '\'' ? "'\\''" : std::string(1, c);
    text += '\'';
  }
  return text;
}

}  // namespace sunder::ask
