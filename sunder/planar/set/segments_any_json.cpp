#include <sunder/planar/set/segments_any_json.h>

namespace sunder::planar {

namespace {

void append(std::string& text, double x) { text += '"' + Dyadic(x).hexadecimal() + '"'; }

void append(std::string& text, std::span<const std::uint32_t> numbers) {
  text += '[';
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    if (k > 0) text += k % 32 == 0 ? ",\n     " : ",";
    text += numbers[k] == no_segment ? "-1" : std::to_string(numbers[k]);  // and exchange_event
  }
  text += ']';
}

std::string pair_text(const std::array<std::uint32_t, 2>& pair) {
  return '[' + std::to_string(pair[0]) + ',' + std::to_string(pair[1]) + ']';
}

}  // namespace

std::string certificate_text(const Segments& segments, Allowed allowed, const SegmentsAnswer& answer, Groups groups) {
  std::string text = "{\"sunder_set_certificate\": 1,\n \"segments\": [";
  for (std::uint32_t i = 0; i < segments.size(); ++i) {
    text += i > 0 ? ",\n  [" : "\n  [";
    append(text, segments[i].a.x);
    text += ',';
    append(text, segments[i].a.y);
    text += ',';
    append(text, segments[i].b.x);
    text += ',';
    append(text, segments[i].b.y);
    text += ']';
  }
  if (!groups.empty()) {
    text += "],\n \"groups\":\n    ";
    append(text, groups);
    text += ",\n";
  } else {
    text += "],\n";
  }
  text += " \"statements\": [\n  {\"question\": \"segments_any\", \"allowed\": \"" + std::string(name_of(allowed)) +
          "\", \"verdict\": \"" + (answer.meet() ? "some" : "none") + "\",\n   ";
  if (answer.meet()) {
    const ExactPoint2 p = common_point(segments[answer.i], segments[answer.j]);
    text += "\"i\": " + std::to_string(answer.i) + ", \"j\": " + std::to_string(answer.j) + ", \"kind\": \"" +
            std::string(name_of(answer.kind)) + "\", \"point\": [\"" + fraction_text(p.x, p.denominator) + "\", \"" +
            fraction_text(p.y, p.denominator) + "\"]";
  } else {
    text += "\"events\":\n    ";
    append(text, answer.transcript.events);
    text += ",\n   \"below\":\n    ";
    append(text, answer.transcript.below);
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
