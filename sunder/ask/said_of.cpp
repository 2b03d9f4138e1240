#include <sunder/ask/said_of.h>

#include <sunder/io/text/text.h>

#include <algorithm>
#include <filesystem>
#include <utility>

namespace sunder::ask {

Said said_of_file(Said::Source what, const InputFiles& inputs, const std::string& file, const std::string& part,
                  const std::vector<std::string>& without) {
  const std::string shown = io::one_line(file == "/dev/stdin" ? "-" : file);
  const auto found = std::find_if(inputs.begin(), inputs.end(),
                                  [&](const InputFile& input) { return io::one_line(input.name) == shown; });
  if (found == inputs.end()) return {};
  return Said::all(what, static_cast<std::size_t>(found - inputs.begin()), part, without);
}

std::vector<std::string> missing_of(const io::MeshBody& body, const io::LeftOutList& left_out) {
  std::vector<std::string> texts = left_out.texts_of(body.file);
  if (body.inner_vertices == 0) return texts;
  const io::LeftOut inner{std::string(io::unused_vertex), {}, body.inner_vertices};
  const std::vector<std::string> more = io::LeftOutList(body.file, std::span(&inner, 1)).texts_of(body.file);
  texts.insert(texts.end(), more.begin(), more.end());
  return texts;
}

namespace {

Said said_of_its(Said::Source what, const io::MeshBody& body, const InputFiles& inputs,
                 const io::LeftOutList& left_out) {
  const std::filesystem::path path = body.file;
  const bool is_part = body.name != io::one_line(path.stem().string());
  return said_of_file(what, inputs, body.file, is_part ? body.name : "", missing_of(body, left_out));
}

}  // namespace

Said said_of_mesh(const io::MeshBody& body, const InputFiles& inputs, const io::LeftOutList& left_out) {
  const bool is_of_points = body.shape == io::BodyShape::points;
  const Said said = said_of_its(is_of_points ? Said::Source::points : Said::Source::vertices, body, inputs, left_out);
  return said.empty() || body.shape != io::BodyShape::hull ? said : said.hull();
}

Said said_of_triangles(const io::MeshBody& body, const InputFiles& inputs, const io::LeftOutList& left_out) {
  if (body.mesh == nullptr) return said_of_mesh(body, inputs, left_out);
  return said_of_its(Said::Source::triangles, body, inputs, left_out);
}

Said said_in(std::span<const io::SystemOfFile> systems, Said said) {
  const std::string text = io::text_of(systems);
  return said.empty() || text.empty() ? said : said.in_system(text);
}

std::vector<SaidOfRows> said_of_rows(const char* table, std::uint64_t rows, const Said& said) {
  if (rows == 0 || said.empty()) return {};
  return {{table, {{rows, said}}}};
}

}  // namespace sunder::ask
