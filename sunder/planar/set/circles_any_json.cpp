#include <sunder/planar/set/circles_any_json.h>
#include <sunder/planar/set/tables_json.h>

namespace sunder::planar {

std::string certificate_text(const Circles& circles, Allowed allowed, const CirclesAnswer& answer, Groups groups) {
  std::string text = json_file_begin;
  append_circles(text, circles.all());
  text += ",\n \"statements\": [\n  {\"question\": \"circles_any\", \"allowed\": \"" + std::string(name_of(allowed)) +
          "\", \"verdict\": \"" + (answer.meet() ? "some" : "none") + "\",\n   ";
  if (answer.meet()) {
    text += "\"i\": " + std::to_string(answer.i) + ", \"j\": " + std::to_string(answer.j) + ", \"kind\": \"" +
            std::string(name_of(answer.kind)) + "\", \"point\": ";
    append_point(text, common_point(circles[answer.i], circles[answer.j]));
    if (!groups.empty()) {
      text += ",\n   \"groups\": ";
      append_indices(text, groups);
    }
  } else {
    text += "\"events\": ";
    append_indices(text, answer.transcript.events);
    text += ",\n   \"below\": ";
    append_indices(text, answer.transcript.below);
  }
  return text + "}]}\n";
}

}  // namespace sunder::planar
