#include <sunder/io/text/json_internal.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <string>
#include <unordered_set>
#include <vector>

namespace sunder::io {

namespace {

// For the parser, which would take the last of them.
nlohmann::json::parser_callback_t refuser_of_repeated_keys(std::string_view place) {
  using Event = nlohmann::json::parse_event_t;
  std::vector<std::unordered_set<std::string>> keys;  // of the objects that are open
  return [place, keys](int, Event event, const nlohmann::json& parsed) mutable {
    if (event == Event::object_start) keys.emplace_back();
    if (event == Event::object_end) keys.pop_back();
    if (event == Event::key && !keys.back().insert(parsed.get<std::string>()).second) {
      fail_file(place, fmt::format("the key {} stands twice in one object; remove one",
                                   quote(parsed.get_ref<const std::string&>())));
    }
    return true;
  };
}

// A message quotes all that was read last, which may be long.
std::string beginning(std::string text) {
  constexpr std::size_t most = 200;
  if (text.size() <= most) return text;
  std::size_t end = most;
  while ((static_cast<unsigned char>(text[end]) & 0xc0u) == 0x80u) --end;  // not within a character
  return text.substr(0, end) + "...";
}

}  // namespace

nlohmann::json parse_json(std::string_view text, std::string_view place, std::uint32_t line) {
  try {
    return nlohmann::json::parse(text, refuser_of_repeated_keys(place));
  } catch (const nlohmann::json::exception& error) {  // not JSON, or a number beyond the doubles
    const std::string what = error.what();
    std::size_t at = what.find(" at line ");
    if (at == std::string::npos) at = what.find("] ") + 1;
    const std::string why = "is not JSON that can be read: " + beginning(one_line(what.substr(at + 1)));
    if (line > 0) fail_line(place, line, why);
    fail_file(place, why);
  }
}

}  // namespace sunder::io
