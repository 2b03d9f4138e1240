#include <sunder/certificate/claims.h>
#include <sunder/certificate/json.h>

namespace sunder {

std::string with_note(std::string certificate, const std::string& note) {
  if (note.empty()) return certificate;
  const std::string version = "certificate\": 1,";
  certificate.insert(certificate.find(version) + version.size(), " \"note\": " + json_string(cut_text(note)) + ",");
  return certificate;
}

}  // namespace sunder
