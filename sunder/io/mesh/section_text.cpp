#include <sunder/io/mesh/section_text.h>
#include <sunder/io/text/text.h>

#include <fmt/format.h>

namespace sunder::io {

namespace {

std::string numbers(const Point3& p) {
  const auto unsigned_zero = [](double x) { return x == 0 ? 0.0 : x; };
  return fmt::format("{} {} {}", unsigned_zero(p.x), unsigned_zero(p.y), unsigned_zero(p.z));
}

std::string to_obj(std::span<const SectionText> sections) {
  std::string text;
  std::size_t next = 1;
  for (const SectionText& section : sections) {
    const std::size_t n = section.corners.size();
    if (n == 0) continue;
    text += fmt::format("o {}\n", section.name);
    for (const Point3& p : section.corners) text += "v " + numbers(p) + "\n";
    text += n == 1 ? "p" : n == 2 ? "l" : "f";
    for (std::size_t k = 0; k < n; ++k) text += fmt::format(" {}", next + k);
    text += "\n";
    next += n;
  }
  return text;
}

std::string to_wkt(std::span<const SectionText> sections) {
  std::string text;
  for (const SectionText& section : sections) {
    const std::size_t n = section.corners.size();
    if (n == 0) {
      text += "POLYGON Z EMPTY\n";
      continue;
    }
    std::string list;
    for (const Point3& p : section.corners) list += (list.empty() ? "" : ", ") + numbers(p);
    text += n == 1   ? "POINT Z (" + list + ")\n"
            : n == 2 ? "LINESTRING Z (" + list + ")\n"
                     : "POLYGON Z ((" + list + ", " + numbers(section.corners[0]) + "))\n";
  }
  return text;
}

}  // namespace

SectionFormat section_format_of_name(const std::string& file) {
  const std::string ending = ending_of(file);
  if (ending == ".obj") return SectionFormat::obj;
  if (ending == ".wkt") return SectionFormat::wkt;
  throw Error(ErrorCode::bad_call, "has not the ending of a format for sections; give a name with .obj or .wkt",
              quote(file));
}

std::string to_text(SectionFormat format, std::span<const SectionText> sections) {
  return format == SectionFormat::obj ? to_obj(sections) : to_wkt(sections);
}

}  // namespace sunder::io
