#include <sunder/ask/talk.h>

#include <sunder/io/text/file.h>
#include <sunder/io/text/text.h>

#include <algorithm>

namespace sunder::ask {

void Talk::print(std::string_view text) {
  has_printed_ = true;
  if (sinks_.out) sinks_.out(text);
}

void Talk::print_for_people(std::string_view text, bool has_colours) {
  if (is_quiet_ || leaves_output_) return;
  if (has_colours) return print(text);
  std::string shown;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find('\n'), text.size());
    shown += io::one_line(text.substr(0, length));
    if (length < text.size()) shown += '\n';
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  print(shown);
}

void Talk::note(std::string_view text) {
  notes_.push_back(io::one_line(text));
  if (sinks_.note) sinks_.note(notes_.back());
}

void Talk::note_all(const std::vector<std::string>& texts) {
  for (const std::string& text : texts) note(text);
}

void Talk::complain(std::string_view text) {
  if (sinks_.error) sinks_.error(text);
}

std::function<void(double)> Talk::progress(std::string_view what) const {
  return sinks_.progress ? sinks_.progress(what) : nullptr;
}

void Talk::write_file(const std::string& name, std::string_view text) const {
  io::write_file_atomically(name, text, instead(name));
}

TextSink Talk::instead(const std::filesystem::path& name) const { return sinks_.file ? sinks_.file(name) : nullptr; }

void Talk::be_quiet() {
  is_quiet_ = true;
  sinks_.note = nullptr;
  sinks_.progress = nullptr;
}

}  // namespace sunder::ask
