#include <sunder/ask/progress.h>
#include <sunder/ask/set/circles_input.h>

#include <sunder/io/text.h>

#include <utility>

namespace sunder::ask {

DiscsInput read_circles(const std::string& name, const std::string& group, const std::string& name_field,
                        InputFiles* inputs) {
  Progress progress("reading");
  io::TripleFile file = io::read_triples(name, io::circle_rows, group, progress.reporter(), name_field, inputs);
  std::vector<Disc> circles;
  circles.reserve(file.rows.size());
  for (std::size_t k = 0; k < file.rows.size(); ++k) {
    const auto& [x, y, r] = file.rows[k];
    if (r < 0) io::fail_line(name, file.line[k], "has a negative radius; give x,y,r with r of at least 0");
    circles.push_back({{x, y}, r});
  }
  return {std::move(file), planar::Discs(std::move(circles))};
}

}  // namespace sunder::ask
