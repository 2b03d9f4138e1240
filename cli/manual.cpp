#include <cli/call.h>
#include <cli/manual.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/App.hpp>

#include <algorithm>
#include <set>
#include <sstream>
#include <string>
#include <vector>

namespace sunder::cli {

namespace {

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_lnames().empty(); });
}

bool may_repeat(const CLI::Option& option) { return option.get_items_expected_max() > 1; }
bool takes_file(const CLI::Option& option) {
  return option.get_type_name() == "FILE" || option.get_type_name() == "WHAT";
}
bool takes_text(const CLI::Option& option) { return takes_value(option) && !takes_file(option); }

// "-o", "--out"
std::vector<std::string> names_of(const CLI::Option& option) {
  std::vector<std::string> names;
  for (const std::string& name : option.get_snames()) names.push_back("-" + name);
  for (const std::string& name : option.get_lnames()) names.push_back("--" + name);
  return names;
}

// "--json, --svg": those of `wanted`, in the order of the verb.
std::string listed(const CLI::App& verb, const std::set<CLI::Option*>& wanted) {
  std::string names;
  for (const CLI::Option* option : verb.get_options()) {
    const bool is_wanted = std::any_of(wanted.begin(), wanted.end(), [&](const auto* one) { return one == option; });
    if (is_wanted) names += (names.empty() ? "--" : ", --") + option->get_lnames().front();
  }
  return names;
}

// What an option is for, and which others it needs or excludes.
std::string about(const CLI::App& verb, const CLI::Option& option) {
  std::string text = option.get_description();
  const bool is_file = option.get_lnames().empty();
  if (option.check_lname("method")) {
    const bool has_kinds = text.find(':') != std::string::npos;
    text = fmt::format("the algorithm (default automatic); all of them give the same answer. Choices{} {}",
                       has_kinds ? "" : ":", text);
  }
  if (option.get_required() && !is_file) text += "; required";
  if (may_repeat(option) && !is_file) text += "; may be repeated";
  if (const std::string names = listed(verb, option.get_needs()); !names.empty()) text += "; needs " + names;
  if (const std::string names = listed(verb, option.get_excludes()); !names.empty()) text += "; not with " + names;
  return text;
}

constexpr std::size_t most_columns = 100, text_column = 28;  // of help

// The words in lines of at most most_columns; the first line begins at column `at`, the others are indented by
// `indent`.
std::string wrapped(const std::string& text, std::size_t at, std::size_t indent) {
  std::istringstream words(text);
  std::string word, lines;
  while (words >> word) {
    const bool is_first = lines.empty();
    if (!is_first && at + 1 + word.size() > most_columns) {
      lines += "\n" + std::string(indent, ' ');
      at = indent;
    } else if (!is_first) {
      lines += ' ';
      ++at;
    }
    lines += word;
    at += word.size();
  }
  return lines + "\n";
}

// A name on the left, and what it means on the right.
std::string help_row(const std::string& name, const std::string& text) {
  std::string left = "  " + name;
  if (left.size() + 2 > text_column) left += "\n" + std::string(text_column, ' ');
  if (left.size() < text_column) left.resize(text_column, ' ');
  return left + wrapped(text, text_column, text_column);
}

// "FILE...", "[FILE...]", "A"
std::string argument(const CLI::Option& option) {
  const std::string name = option.get_name(true) + (may_repeat(option) ? "..." : "");
  return option.get_required() ? name : "[" + name + "]";
}

std::string words_of(const CLI::Option& option) { return fmt::format("{}", fmt::join(names_of(option), " ")); }

constexpr const char* shells = "bash zsh fish";

// Each word once of "a, b" or of "of lines: a, b; of circles: b, c".
std::string words_listed(std::string_view text) {
  std::vector<std::string> words;
  while (!text.empty()) {
    const std::size_t size = std::min(text.find_first_of(",:;"), text.size());
    const std::string word(text.substr(0, size));
    const bool names_a_kind = size < text.size() && text[size] == ':';
    if (!names_a_kind && std::find(words.begin(), words.end(), word) == words.end()) words.push_back(word);
    text.remove_prefix(std::min(size + 2, text.size()));
  }
  return fmt::format("{}", fmt::join(words, " "));
}

// What may stand for the value of an option, where that is known.
std::string values_of(const CLI::Option& option) {
  if (option.check_lname("completion")) return shells;
  return option.check_lname("method") ? words_listed(option.get_description()) : "";
}

// Every place of `what` is replaced.
std::string replaced(std::string text, std::string_view what, std::string_view by) {
  for (std::size_t at = text.find(what); at != std::string::npos; at = text.find(what, at + by.size())) {
    text.replace(at, what.size(), by);
  }
  return text;
}

template <class List, class Text>
std::string joined(const List& list, const Text& text, std::string_view between = " ") {
  std::string all;
  for (const auto* item : list) all += (all.empty() ? "" : std::string(between)) + text(*item);
  return all;
}

std::string verbs_in_a_line(const CLI::App& program) {
  return joined(verbs_of(program), [](const CLI::App& verb) { return verb.get_name(); });
}

std::string options_that(const CLI::App& app, bool (*is_wanted)(const CLI::Option&)) {
  std::string names;
  for (const CLI::Option* option : options_of(app)) {
    if (is_wanted(*option)) names += (names.empty() ? "" : " ") + words_of(*option);
  }
  return names;
}

std::string methods_of(const CLI::App& verb) {
  const CLI::Option* method = verb.get_option_no_throw("--method");
  return method == nullptr ? "" : values_of(*method);
}

std::string bash(const CLI::App& program) {
  std::string text =
      "# Completion of sunder for bash: source it, or put it where bash-completion looks.\n_sunder() {\n";
  text += fmt::format("  local verbs='{}' options= methods= texts=\n", verbs_in_a_line(program));
  text += "  local word=${COMP_WORDS[COMP_CWORD]} before=${COMP_WORDS[COMP_CWORD-1]} first=${COMP_WORDS[1]}\n";
  text += "  case $first in\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("    {}) options='{}' methods='{}' texts='{}' ;;\n", verb->get_name(),
                        joined(options_of(*verb), words_of), methods_of(*verb), options_that(*verb, takes_text));
  }
  text += fmt::format("    help|--help) options=$verbs ;;\n    --completion) options='{}' ;;\n  esac\n", shells);
  text += "  if [ \"$COMP_CWORD\" -eq 1 ]; then\n";
  text += fmt::format("    options=\"$verbs help {}\"\n", joined(options_of(program), words_of));
  text += "  elif [[ $first == help || $first == -* ]]; then\n    [ \"$COMP_CWORD\" -eq 2 ] || options=\n";
  text += "  elif [ \"$before\" = --method ]; then\n    options=$methods\n";
  text += "  elif [[ \" $texts \" == *\" $before \"* ]]; then\n    options=\n";
  text += "  elif [[ $word != -* ]]; then\n    compopt -o filenames 2> /dev/null\n";
  text += "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n    return\n  fi\n";
  return text + "  mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\")\n}\ncomplete -F _sunder sunder\n";
}

// In single quotes of a shell, and free of what _arguments and _describe take for their own.
std::string zsh_words(const std::string& text) {
  std::string result = replaced(text, "'", "'\\''");
  for (const char* special : {"[", "]", ":"}) result = replaced(result, special, std::string("\\") + special);
  return result;
}

// What _arguments is told of an option: of each of its names.
std::string zsh_option(const CLI::Option& option) {
  std::string text;
  const std::string values = values_of(option);
  const std::string action = takes_file(option) ? "_files" : values.empty() ? " " : "(" + values + ")";
  for (const std::string& name : names_of(option)) {
    text +=
        fmt::format(" \\\n      '{}{}[{}]{}'", may_repeat(option) ? "*" : "", name, zsh_words(option.get_description()),
                    takes_value(option) ? ":" + zsh_words(option.get_type_name()) + ":" + action : "");
  }
  return text;
}

std::string zsh(const CLI::App& program) {
  std::string text = "#compdef sunder\n# Completion of sunder for zsh: put it as _sunder into a folder of $fpath.\n";
  text += "local -a verbs=(\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("  '{}:{}'\n", verb->get_name(), zsh_words(verb->get_description()));
  }
  text += "  'help:the options of a verb'\n)\nlocal -a options=(\n";
  for (const CLI::Option* option : options_of(program)) {
    for (const std::string& name : names_of(*option)) {
      text += fmt::format("  '{}:{}'\n", name, zsh_words(option->get_description()));
    }
  }
  text += ")\nif (( CURRENT == 2 )); then\n  _describe verb verbs\n  _describe -o option options\n  return\nfi\n";
  text += "if (( CURRENT == 3 )) && [[ $words[2] == help ]]; then\n  _describe verb verbs\n  return\nfi\n";
  text += "case $words[2] in\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("  {})\n    _arguments{} \\\n      '*:file:_files' ;;\n", verb->get_name(),
                        joined(options_of(*verb), zsh_option, ""));
  }
  return text + fmt::format("  --completion)\n    (( CURRENT == 3 )) && compadd {} ;;\nesac\n", shells);
}

std::string fish_quoted(const std::string& text) {
  return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
}

// The words about an option behind `complete -c sunder -n CONDITION`.
std::string fish_option(const CLI::Option& option) {
  std::string text;
  for (const std::string& name : option.get_snames()) text += " -s " + name;
  for (const std::string& name : option.get_lnames()) text += " -l " + name;
  text += " -d " + fish_quoted(option.get_description());
  if (takes_file(option)) return text + " -r -F";
  if (takes_value(option)) text += " -x";
  const std::string values = values_of(option);
  return values.empty() ? text : text + " -a " + fish_quoted(values);
}

std::string fish(const CLI::App& program) {
  std::string text = "# Completion of sunder for fish: put it as sunder.fish into ~/.config/fish/completions.\n";
  for (const CLI::Option* option : options_of(program)) {
    text += fmt::format("complete -c sunder -f -n __fish_use_subcommand{}\n", fish_option(*option));
  }
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("complete -c sunder -f -n __fish_use_subcommand -a {} -d {}\n", verb->get_name(),
                        fish_quoted(verb->get_description()));
    for (const CLI::Option* option : options_of(*verb)) {
      text += fmt::format("complete -c sunder -n '__fish_seen_subcommand_from {}'{}\n", verb->get_name(),
                          fish_option(*option));
    }
  }
  text += "complete -c sunder -f -n __fish_use_subcommand -a help -d 'the options of a verb'\n";
  return text +
         fmt::format("complete -c sunder -f -n '__fish_seen_subcommand_from help' -a '{}'\n", verbs_in_a_line(program));
}

// Text of a manual page: hyphens as they are typed, and no line that groff takes for a request.
std::string roff(const std::string& text) {
  const std::string plain = replaced(replaced(text, "\\", "\\e"), "-", "\\-");
  return plain.starts_with('.') || plain.starts_with('\'') ? "\\&" + plain : plain;
}

std::string man_of(const CLI::App& verb) {
  std::string files;
  for (const CLI::Option* option : verb.get_options([](const CLI::Option* o) { return o->get_positional(); })) {
    const bool is_needed = option->get_required();
    files += fmt::format(" {}\\fI{}\\fR{}", is_needed ? "" : "[", roff(option->get_name(true)), is_needed ? "" : "]");
  }
  std::string text = fmt::format(".SS \"sunder {}\"\n{}\n.PP\n\\fBsunder {}\\fR{} [\\fIoptions\\fR]\n", verb.get_name(),
                                 roff(verb.get_description()), verb.get_name(), files);
  for (const CLI::Option* option : verb.get_options()) {
    if (option == verb.get_help_ptr()) continue;
    const bool is_file = option->get_lnames().empty();
    const std::string value =
        takes_value(*option) && !is_file ? fmt::format(" \\fI{}\\fR", roff(option->get_type_name())) : "";
    text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(is_file ? option->get_name(true) : words_of(*option)), value,
                        roff(about(verb, *option)));
  }
  return text + ".PP\n" + roff(verb.get_footer()) + "\n";
}

}  // namespace

std::string help_text(const CLI::App& app) {
  std::string arguments, rows, options;
  for (const CLI::Option* option : app.get_options()) {
    if (option->get_lnames().empty()) {
      arguments += " " + argument(*option);
      rows += help_row(option->get_name(true), about(app, *option));
    } else {
      const std::string value = takes_value(*option) ? " " + option->get_type_name() : "";
      options += help_row(fmt::format("{}{}", fmt::join(names_of(*option), ","), value), about(app, *option));
    }
  }
  const bool is_verb = app.get_parent() != nullptr;
  std::string text = wrapped(app.get_description(), 0, 0);
  if (is_verb) {
    text += fmt::format("Usage: sunder {}{} [OPTIONS]\n\nFiles:\n{}", app.get_name(), arguments, rows);
  } else {
    text += "Usage: sunder VERB FILE... [OPTIONS]\n\nVerbs:\n";
    for (const CLI::App* verb : verbs_of(app)) text += help_row(verb->get_name(), verb->get_description());
  }
  return text + "\nOptions:\n" + options + "\n" + wrapped(app.get_footer(), 0, 0);
}

std::string completion(const CLI::App& program, std::string_view shell) {
  if (shell == "bash") return bash(program);
  if (shell == "zsh") return zsh(program);
  if (shell == "fish") return fish(program);
  throw Error(ErrorCode::bad_call,
              fmt::format("there is no completion for {}; there are bash, zsh, fish", io::quote(shell)),
              "--completion");
}

std::string man_page(const CLI::App& program, std::string_view version) {
  std::string text = fmt::format(
      ".TH SUNDER 1 \"\" \"sunder {}\" \"\"\n.SH NAME\nsunder \\- tells whether things meet, "
      "and proves it\n.SH SYNOPSIS\n\\fBsunder\\fR \\fIverb\\fR [\\fIfiles\\fR] "
      "[\\fIoptions\\fR]\n.br\n\\fBsunder help\\fR [\\fIverb\\fR]\n.br\n\\fBsunder \\-\\-completion\\fR "
      "\\fIshell\\fR\n.br\n\\fBsunder \\-\\-man\\fR\n.br\n\\fBsunder \\-\\-version\\fR\n.SH VERBS\n",
      roff(std::string(version)));
  for (const CLI::App* verb : verbs_of(program)) text += man_of(*verb);
  return text + ".SH \"EXIT STATUS\"\n" + roff(program.get_footer()) + "\n";
}

}  // namespace sunder::cli
