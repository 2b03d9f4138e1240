#include <sunder/ask/verb.h>

#include <sunder/base/error.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <utility>

namespace sunder::ask {

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

Option json_option(bool& json) { return {"--json", &json, "print a report in JSON"}; }

Option title_option(std::string& title) {
  return {.name = "--title", .value = &title, .help = "the title written on the picture", .needs = "--svg"};
}

Option certificate_option(std::string& file, std::string help) {
  return {"--certificate", &file, std::move(help), "FILE"};
}

std::vector<Verb> verbs() {
  return {pair_verb(),   scene_verb(),  segments_verb(), simple_verb(),  circles_verb(), boxes_verb(), polygons_verb(),
          region_verb(), kernel_verb(), hull_verb(),     section_verb(), info_verb(),    verify_verb()};
}

}  // namespace sunder::ask
