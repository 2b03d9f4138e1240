#include <sunder/ask/mesh_memory_option.h>
#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <utility>

#include <algorithm>

namespace sunder::ask {

namespace {

// "a, b and c"
std::string list_of(const std::vector<std::string>& words, const char* last) {
  std::string text;
  for (std::size_t k = 0; k < words.size(); ++k) {
    text += (k == 0 ? "" : k + 1 < words.size() ? ", " : last) + words[k];
  }
  return text;
}

}  // namespace

bool is_given(const Option& option, const Option& unless_given) {
  return std::visit([&](auto* at) { return *at != *std::get<decltype(at)>(unless_given.value); }, option.value);
}

void require_fit(const std::vector<Option>& options, const std::vector<Option>& unless_given,
                 const std::vector<std::string>& kinds) {
  for (std::size_t k = 0; k < options.size(); ++k) {
    const std::vector<std::string>& of = options[k].of;
    if (of.empty() || !is_given(options[k], unless_given[k])) continue;
    if (std::find_first_of(of.begin(), of.end(), kinds.begin(), kinds.end()) != of.end()) continue;
    throw Error(ErrorCode::bad_call,
                fmt::format("is for {}, not for {}; leave it out", list_of(of, " and "), list_of(kinds, " or ")),
                options[k].name);
  }
}

void require_drawable(std::uint64_t things, std::string_view noun, std::uint64_t contacts, std::uint64_t most) {
  using io::count_of;
  if (things + contacts <= most) return;
  throw Error(ErrorCode::bad_call,
              fmt::format("{}{}: more than {}, a picture too large to look at; leave it out, or give --svg-limit {}",
                          count_of(things, noun), contacts > 0 ? " and " + count_of(contacts, "contact") : "", most,
                          things + contacts),
              "--svg");
}

Option svg_limit_option(std::uint64_t& limit) {
  return {.name = "--svg-limit",
          .value = &limit,
          .help = fmt::format("refuse to draw more than N things, contacts included (default {})", limit),
          .type = "N",
          .needs = "--svg"};
}

Option memory_option(std::uint64_t& mebibytes) {
  return {.name = "--memory",
          .value = &mebibytes,
          .help = fmt::format(
              "let meshes take N MiB of memory, by estimate; beyond it the call is refused (default {})", mebibytes),
          .type = "N"};
}

Option json_option(bool& json) { return {"--json", &json, "print a report in JSON"}; }

Option title_option(std::string& title) {
  return {.name = "--title", .value = &title, .help = "the title written on the picture", .needs = "--svg"};
}

Option certificate_option(std::string& file, std::string help) {
  return {"--certificate", &file, std::move(help), "FILE"};
}

std::vector<Verb> verbs() {
  return {pair_verb(),   scene_verb(),  segments_verb(), simple_verb(),  circles_verb(), boxes_verb(), polygons_verb(),
          region_verb(), kernel_verb(), hull_verb(),     section_verb(), polar_verb(),   info_verb(),  verify_verb()};
}

}  // namespace sunder::ask
