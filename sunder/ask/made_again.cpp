#include <sunder/ask/call_words.h>
#include <sunder/ask/made_again.h>

#include <sunder/base/error.h>
#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <set>
#include <utility>

namespace sunder::ask {

namespace {

// The writer begins each part of a file on a line of its own; no string of JSON holds a line feed.
constexpr std::string_view statements = "\n \"statements\": [";

// The place behind the list that begins before `at`, in valid JSON; npos where the list does not end.
std::size_t end_of_list(std::string_view text, std::size_t at) {
  for (std::size_t depth = 1; at < text.size(); ++at) {
    const char c = text[at];
    if (c == '"') {
      while (++at < text.size() && text[at] != '"') {
        if (text[at] == '\\') ++at;
      }
    } else if (c == '[' || c == '{') {
      ++depth;
    } else if ((c == ']' || c == '}') && --depth == 0) {
      return at;
    }
  }
  return std::string_view::npos;
}

// All that a file has before its statements; empty: it has other things after them, or is not as the writer writes.
std::string_view head_of(std::string_view text) {
  const std::size_t at = text.find(statements);
  if (at == std::string_view::npos) return {};
  const std::size_t head = at + statements.size(), end = end_of_list(text, head);
  if (end == std::string_view::npos) return {};
  const std::string_view rest = text.substr(end);
  return rest == "]}" || rest == "]}\n" ? text.substr(0, head) : std::string_view();
}

// The beginnings of the statements of which a file says more, up to their verdicts: what is said, and of what. The
// writer begins each statement on a line of its own.
class Notes {
 public:
  void take(std::string_view text) {
    for (std::size_t end; (end = text.find('\n')) != std::string_view::npos; text.remove_prefix(end + 1)) {
      line_ += text.substr(0, end);
      end_line();
    }
    line_ += text;
  }
  void end_line() {
    if (line_.starts_with(begin) && line_.find("\"said\": [") != std::string::npos) {
      all_.push_back(line_.substr(0, line_.find("\"verdict\": ")));
    }
    line_.clear();
  }

  // The number of the first of these that the other ones have not; that of all: they have them.
  std::size_t first_not_in(const Notes& others) const {
    const std::set<std::string_view> known(others.all_.begin(), others.all_.end());
    const auto found =
        std::find_if_not(all_.begin(), all_.end(), [&](const auto& note) { return known.contains(note); });
    return static_cast<std::size_t>(found - all_.begin());
  }
  std::size_t size() const { return all_.size(); }
  const std::string& operator[](std::size_t k) const { return all_[k]; }

 private:
  static constexpr std::string_view begin = "  {\"question\": ";
  std::string line_;
  std::vector<std::string> all_;
};

// Takes a file as it is written, and compares its beginning.
class Comparison {
 public:
  explicit Comparison(std::string_view head) : head_(head) {}

  void take(std::string_view text) {
    notes_.take(text);
    if (differs_) {
      if (instead_.size() < most_shown) instead_ += text.substr(0, most_shown);
      return;
    }
    const std::size_t size = std::min(text.size(), head_.size() - at_);
    const std::string_view expected = head_.substr(at_, size);
    const auto first = std::mismatch(expected.begin(), expected.end(), text.begin()).first - expected.begin();
    at_ += static_cast<std::size_t>(first);
    differs_ = static_cast<std::size_t>(first) < size;
    if (differs_) instead_ = text.substr(static_cast<std::size_t>(first), most_shown);
  }

  bool is_same() const { return at_ == head_.size(); }
  const Notes& notes() const { return notes_; }
  std::size_t at() const { return at_; }

  // "line 7, in tables: it says "0x1p+0"]], and the files "0x1p+1"]]"
  std::string difference() const {
    const std::size_t line = static_cast<std::size_t>(std::count(head_.begin(), head_.begin() + at_, '\n')) + 1;
    const std::size_t begin = head_.rfind("\n \"", at_) + 3;
    const std::string_view part = head_.substr(begin, head_.find('"', begin) - begin);
    const auto shown = [](std::string_view rest) {
      return io::one_line(rest.substr(0, std::min(rest.find('\n'), most_shown)));
    };
    return fmt::format("line {}, in {}: it has {}, and what is read has {}", line, part, shown(head_.substr(at_)),
                       shown(instead_));
  }

 private:
  static constexpr std::size_t most_shown = 60;

  std::string_view head_;
  Notes notes_;
  std::size_t at_ = 0;  // what is the same so far
  bool differs_ = false;
  std::string instead_;
};

// Are these the inputs, in their order?
std::string other_files(const InputFiles& inputs, std::span<const GivenInput> given) {
  if (inputs.size() != given.size()) {
    return fmt::format("it names {}, and {} given; give all, in their order", io::count_of(inputs.size(), "input"),
                       given.size() == 1 ? "1 is" : fmt::format("{} are", given.size()));
  }
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    if (inputs[k].sha256 == given[k].sha256) continue;
    return fmt::format("input {}, {}, has another SHA-256 than {}, {}", k + 1, io::quote(inputs[k].name),
                       io::quote(given[k].name), given[k].sha256);
  }
  return "";
}

}  // namespace

GivenInput read_given(const std::string& name) {
  InputFiles read;
  std::string bytes = io::read_file(name, &read);
  return {io::one_line(name), std::move(bytes), read[0].sha256};
}

std::string difference_made_again(std::string_view text, const InputFiles& inputs, std::span<const std::string> call,
                                  std::span<const GivenInput> given) {
  if (std::string other = other_files(inputs, given); !other.empty()) return other;
  if (call.empty()) return "it does not say by which call, so they cannot be read again";
  const std::string_view head = head_of(text);
  if (head.empty()) return "it is not written as the program writes";
  std::vector<io::GivenFiles::File> files;
  for (std::size_t k = 0; k < inputs.size(); ++k) files.push_back({inputs[k].name, &given[k].bytes});
  std::map<std::filesystem::path, Comparison> made;  // a board has a proof a layer
  try {
    run_again(call, std::move(files), [&](const std::filesystem::path& name, std::string_view piece) {
      made.try_emplace(name, head).first->second.take(piece);
    });
  } catch (const Error& error) {
    return fmt::format("its call does not read them: {}", error.what());
  }
  if (made.empty()) return "its call makes no proof of them";
  const auto nearest = std::max_element(made.begin(), made.end(),
                                        [](const auto& a, const auto& b) { return a.second.at() < b.second.at(); });
  if (!nearest->second.is_same()) return nearest->second.difference();
  Notes notes;
  notes.take(text);
  notes.end_line();
  const std::size_t other = notes.first_not_in(nearest->second.notes());
  return other == notes.size() ? "" : fmt::format("they do not make the note {}", io::one_line(notes[other]));
}

}  // namespace sunder::ask
