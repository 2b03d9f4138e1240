#include <sunder/planar/set/segments_any_json.h>
#include <sunder/planar/set/tables_json.h>

namespace sunder::planar {

namespace {

std::string pair_text(const std::array<std::uint32_t, 2>& pair) {
  return '[' + std::to_string(pair[0]) + ',' + std::to_string(pair[1]) + ']';
}

}  // namespace

std::string certificate_text(const Segments& segments, Allowed allowed, const SegmentsAnswer& answer, Groups groups) {
  std::string text = std::string(json_file_begin) + " \"segments\": [";
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    text += i > 0 ? ",\n  " : "\n  ";
    append_doubles(text, std::array{segments[i].a.x, segments[i].a.y, segments[i].b.x, segments[i].b.y});
  }
  if (!groups.empty()) {
    text += "],\n \"groups\":\n    ";
    append_indices(text, groups);
    text += ",\n";
  } else {
    text += "],\n";
  }
  text += " \"statements\": [\n  {\"question\": \"segments_any\", \"allowed\": \"" + std::string(name_of(allowed)) +
          "\", \"verdict\": \"" + (answer.meet() ? "some" : "none") + "\",\n   ";
  if (answer.meet()) {
    text += "\"i\": " + std::to_string(answer.i) + ", \"j\": " + std::to_string(answer.j) + ", \"kind\": \"" +
            std::string(name_of(answer.kind)) + "\", \"point\": ";
    append_point(text, common_point(segments[answer.i], segments[answer.j]));
  } else {
    text += "\"events\":\n    ";
    append_indices(text, answer.transcript.events);
    text += ",\n   \"below\":\n    ";
    append_indices(text, answer.transcript.below);
    if (!answer.transcript.exchanges.empty()) {
      text += ",\n   \"exchanges\": [";
      for (std::size_t k = 0; k < answer.transcript.exchanges.size(); ++k) {
        if (k > 0) text += k % 16 == 0 ? ",\n     " : ",";
        text += pair_text(answer.transcript.exchanges[k]);
      }
      text += ']';
    }
  }
  return text + "}]}\n";
}

}  // namespace sunder::planar
