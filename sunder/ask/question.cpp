#include <sunder/ask/question.h>

#include <sunder/io/text.h>

#include <fmt/format.h>

namespace sunder::ask {

std::string titled(std::string_view title, std::string value) {
  for (std::size_t end = value.find('\n'); end != std::string::npos; end = value.find('\n', end + 1)) {
    value.insert(end + 1, 14, ' ');
  }
  return fmt::format("  {:<10}  {}\n", title, value);
}

std::string outputs_text(const QuestionCall& call) {
  std::string text;
  if (call.proves()) text += titled("proof", io::one_line(call.certificate));
  if (!call.svg.empty()) text += titled("picture", io::one_line(call.svg));
  return text;
}

}  // namespace sunder::ask
