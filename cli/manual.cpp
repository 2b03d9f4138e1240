#include <cli/manual.h>

#include <sunder/base/error.h>
#include <sunder/io/text.h>

#include <fmt/format.h>
#include <CLI/App.hpp>

#include <string>
#include <vector>

namespace sunder::cli {

namespace {

std::vector<const CLI::App*> verbs_of(const CLI::App& program) {
  return program.get_subcommands([](const CLI::App*) { return true; });
}

std::vector<const CLI::Option*> options_of(const CLI::App& app) {
  return app.get_options([](const CLI::Option* option) { return !option->get_lnames().empty(); });
}

std::string name_of(const CLI::Option& option) { return "--" + option.get_lnames().front(); }
bool takes_value(const CLI::Option& option) { return option.get_items_expected_max() > 0; }

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

std::string names_of_verbs(const CLI::App& program) {
  return joined(verbs_of(program), [](const CLI::App& verb) { return verb.get_name(); });
}

std::string bash(const CLI::App& program) {
  std::string text =
      "# Completion of sunder for bash: source it, or put it where bash-completion looks.\n_sunder() {\n";
  text += fmt::format("  local word=${{COMP_WORDS[COMP_CWORD]}} verbs='{}' options=\n", names_of_verbs(program));
  text += "  COMPREPLY=()\n  case ${COMP_WORDS[1]} in\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("    {}) options='{}' ;;\n", verb->get_name(), joined(options_of(*verb), name_of));
  }
  text += "    help) [ \"$COMP_CWORD\" -ne 2 ] || options=$verbs ;;\n  esac\n";
  text +=
      fmt::format("  [ \"$COMP_CWORD\" -ne 1 ] || options=\"$verbs help {}\"\n", joined(options_of(program), name_of));
  text += "  mapfile -t COMPREPLY < <(compgen -W \"$options\" -- \"$word\")\n";
  text += "  [[ $COMP_CWORD -eq 1 || $word == -* || ${COMP_WORDS[1]} == help ]] ||\n";
  text += "    mapfile -t COMPREPLY < <(compgen -f -- \"$word\")\n}\ncomplete -o filenames -F _sunder sunder\n";
  return text;
}

// In single quotes of a shell, and free of what _arguments and _describe take for their own.
std::string zsh_words(const std::string& text) {
  std::string result = replaced(text, "'", "'\\''");
  for (const char* special : {"[", "]", ":"}) result = replaced(result, special, std::string("\\") + special);
  return result;
}

std::string zsh(const CLI::App& program) {
  std::string text = "#compdef sunder\n# Completion of sunder for zsh: put it as _sunder into a folder of $fpath.\n";
  text += "local -a verbs=(\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("  '{}:{}'\n", verb->get_name(), zsh_words(verb->get_description()));
  }
  text += "  'help:the options of a verb'\n)\n";
  text += "if (( CURRENT == 2 )) || { (( CURRENT == 3 )) && [[ $words[2] == help ]]; }; then\n";
  text += "  _describe verb verbs\n  return\nfi\ncase $words[2] in\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("  {})\n    _arguments", verb->get_name());
    for (const CLI::Option* option : options_of(*verb)) {
      text += fmt::format(" \\\n      '{}[{}]{}'", name_of(*option), zsh_words(option->get_description()),
                          takes_value(*option) ? ":" + zsh_words(option->get_type_name()) + ":_files" : "");
    }
    text += " \\\n      '*:file:_files' ;;\n";
  }
  return text + "esac\n";
}

std::string fish(const CLI::App& program) {
  const auto quoted = [](const std::string& text) {
    return "'" + replaced(replaced(text, "\\", "\\\\"), "'", "\\'") + "'";
  };
  std::string text = "# Completion of sunder for fish: put it as sunder.fish into ~/.config/fish/completions.\n";
  for (const CLI::App* verb : verbs_of(program)) {
    text += fmt::format("complete -c sunder -f -n __fish_use_subcommand -a {} -d {}\n", verb->get_name(),
                        quoted(verb->get_description()));
    for (const CLI::Option* option : options_of(*verb)) {
      text += fmt::format("complete -c sunder -n '__fish_seen_subcommand_from {}' -l {} -d {}{}\n", verb->get_name(),
                          option->get_lnames().front(), quoted(option->get_description()),
                          takes_value(*option) ? " -r" : "");
    }
  }
  text += "complete -c sunder -f -n __fish_use_subcommand -a help -d 'the options of a verb'\n";
  return text +
         fmt::format("complete -c sunder -f -n '__fish_seen_subcommand_from help' -a '{}'\n", names_of_verbs(program));
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
    text += fmt::format(".TP\n\\fB{}\\fR{}\n{}\n", roff(is_file ? option->get_name(true) : name_of(*option)), value,
                        roff(option->get_description()));
  }
  return text + ".PP\n" + roff(verb.get_footer()) + "\n";
}

}  // namespace

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
