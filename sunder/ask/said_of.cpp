#include <sunder/ask/said_of.h>

#include <sunder/io/text.h>

#include <algorithm>
#include <filesystem>

namespace sunder::ask {

Said said_of_file(Said::Source what, const InputFiles& inputs, const std::string& file, const std::string& part,
                  const std::vector<std::string>& without) {
  const std::string shown = io::one_line(file == "/dev/stdin" ? "-" : file);
  const auto found = std::find_if(inputs.begin(), inputs.end(),
                                  [&](const InputFile& input) { return io::one_line(input.name) == shown; });
  if (found == inputs.end()) return {};
  return Said::all(what, static_cast<std::size_t>(found - inputs.begin()), part, without);
}

Said said_of_mesh(const io::MeshBody& body, const InputFiles& inputs, const io::LeftOutList& left_out) {
  const std::filesystem::path path = body.file;
  const bool is_part = body.name != io::one_line(path.stem().string());
  const Said said = said_of_file(body.shape == io::BodyShape::points ? Said::Source::points : Said::Source::vertices,
                                 inputs, body.file, is_part ? body.name : "", left_out.texts_of(body.file));
  return said.empty() || body.shape != io::BodyShape::hull ? said : said.hull();
}

std::vector<SaidOfRows> said_of_rows(const char* table, std::uint64_t rows, const Said& said) {
  if (rows == 0 || said.empty()) return {};
  return {{table, {{rows, said}}}};
}

}  // namespace sunder::ask
