#include <sunder/picture/canvas.h>

#include <sunder/io/text/text.h>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace sunder::picture {

namespace {

constexpr double letter_width = 0.53;  // a letter's part of the size

struct Look {
  char letter;
  const char *colour, *fill, *dashes;  // fill: how opaque; dashes of its rings, for those who see no colours
};
constexpr std::array<Look, 6> looks{{{'g', "#8a97a8", ".06;stroke-width:1", "none"},
                                     {'t', "#0072b2", ".22", "8 4"},
                                     {'c', "#d55e00", ".3", "none"},
                                     {'s', "#009e73", ".25", "2 3"},
                                     {'o', "#cc79a7", ".25", "none"},
                                     {'x', "#333", ".25", "none"}}};  // in the order of Ink

// k: numbers of axes; a: their lines; m: a ring with its label; f: a filled shape; d: a dot; v: a hollow one;
// b, r: outlines of bodies.
std::string rules() {
  std::string text =
      "text{font-family:Inter,'Helvetica Neue',Helvetica,Arial,sans-serif}.k{font-size:11px;fill:#55677f}"
      ".a{stroke:#e9ecf1}.m text{font-size:12px;font-weight:600;fill:#1f2a3a}.m rect{fill:#fff;fill-opacity:.85}"
      ".m circle{fill:#fff;fill-opacity:.35;stroke-width:2.5}.m:hover circle{stroke-width:5}"
      ".f{fill-rule:evenodd;stroke-width:2;stroke-linejoin:round}"
      ".l{fill:none;stroke-width:2}.dashed{stroke-width:1.2;stroke-dasharray:6 "
      "4}.n{font-size:13px;fill:#1f2a3a}.h{text-anchor:middle;fill-opacity:.75;pointer-events:none}"
      ".b,.r{fill:none;stroke-width:10}.b{stroke:#46586f}.r{stroke:#7d2115}";
  for (const Look& look : looks) {
    text += fmt::format(
        "path.{0},circle.{0},.{0}>circle{{stroke:{1}}}.{0}>circle{{stroke-dasharray:{3}}}.f.{0}{{fill:{1};"
        "fill-opacity:{2}}}",
        look.letter, look.colour, look.fill, look.dashes);
  }
  return text + ".l.g{stroke-width:.8}.f.d{fill-opacity:1;stroke:#fff;stroke-width:1.5}" +
         ".f.v{fill:#fff;fill-opacity:1;stroke-width:1}";
}

constexpr std::array<std::array<std::string_view, 2>, 7> in_xml{{{"&", "&amp;"},
                                                                 {"<", "&lt;"},
                                                                 {">", "&gt;"},
                                                                 {"\"", "&quot;"},
                                                                 {"'", "&apos;"},
                                                                 {"\xef\xbf\xbe", "?"},
                                                                 {"\xef\xbf\xbf", "?"}}};

bool is_within_character(char byte) { return (static_cast<unsigned char>(byte) & 0xc0u) == 0x80; }

}  // namespace

char class_of(Ink ink) { return looks.at(static_cast<std::size_t>(ink)).letter; }

std::string xml_text(std::string_view text) {
  const std::string line = io::one_line(text);
  std::string out;
  for (std::size_t i = 0; i < line.size();) {
    const auto rest = std::string_view(line).substr(i);
    const auto found =
        std::find_if(in_xml.begin(), in_xml.end(), [&](const auto& e) { return rest.starts_with(e[0]); });
    out += found == in_xml.end() ? rest.substr(0, 1) : (*found)[1];
    i += found == in_xml.end() ? 1 : (*found)[0].size();
  }
  return out;
}

std::string shortened(std::string_view text, std::size_t longest) {
  if (text.size() <= longest) return std::string(text);
  while (longest > 0 && is_within_character(text[longest])) --longest;
  return std::string(text.substr(0, longest)) + "...";
}

PathData::Tenths PathData::tenths(const Point2& pixel) {
  return {std::lround(10 * pixel.x), std::lround(10 * pixel.y)};
}

void PathData::move(const Tenths& p) {
  if (text_.size() - row_begin_ > 200) {
    text_ += '\n';
    row_begin_ = text_.size();
  }
  step('m', p);
  begin_ = p;
  after_line_ = false;
}

void PathData::line(const Tenths& p) {
  step(after_line_ ? ' ' : 'l', p);
  after_line_ = true;
}

void PathData::close() {
  text_ += 'z';
  pen_ = begin_;
  after_line_ = false;
}

void PathData::step(char letter, const Tenths& p) {
  const long x = p.x - pen_.x, y = p.y - pen_.y;
  if (letter != ' ' || x >= 0) text_ += letter;
  fmt::format_to(std::back_inserter(text_), "{}{}{}", x, y < 0 ? "" : " ", y);
  pen_ = p;
}

std::string words(double x, double y, double size, const char* colour, std::string_view text,
                  std::string_view attributes) {
  return fmt::format("<text x='{:.1f}' y='{:.1f}' font-size='{:.0f}' fill='{}' {}>{}</text>\n", x, y, size, colour,
                     attributes, xml_text(text));
}

void Canvas::legend(std::string_view sign, std::string_view text, bool grey) {
  const double size = 34 + 13 * letter_width * static_cast<double>(text.size());
  if (legend_x_ > border && legend_x_ + size > width_ - border) {
    legend_x_ = border;
    legend_y_ += 24;
  }
  legend_ += fmt::format("<g transform='translate({:.1f} {:.1f})'>{}{}</g>\n", legend_x_, legend_y_, sign,
                         words(27, 4.5, 13, grey ? "#9aa6b5" : text_colour, text));
  legend_x_ += size + 16;
}

void Canvas::legend(Ink ink, std::string_view text) {
  legend(fmt::format("<circle class='f {}' cx='10' r='7'/>", class_of(ink)), text);
}

// Rows from y on, which moves to where the next one is.
std::string Canvas::paragraph(double& y, double size, const char* colour, std::string_view text) const {
  const auto longest = static_cast<std::size_t>((width_ - 2 * border) / (letter_width * size));
  std::string rows;
  while (!text.empty()) {
    std::size_t end = text.size() <= longest ? text.size() : text.rfind(' ', longest);
    if (end == 0 || end == std::string_view::npos) end = text.size();
    rows += words(border, y, size, colour, text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
    y += size * 1.5;
  }
  return rows;
}

std::string Canvas::finish(std::string_view title, std::string_view summary, double height) const {
  double y = 74;
  std::string head =
      words(border, 46, 22, text_colour, shortened(title, static_cast<std::size_t>(width_ / 14)), "font-weight='600'");
  head += paragraph(y, 15, text_colour, summary);
  head += fmt::format("<g transform='translate(0 {:.1f})'>\n{}</g>\n", y + 6, legend_);
  y += legend_.empty() ? 0 : legend_y_ + 30;
  head += fmt::format("<g transform='translate(0 {:.1f})'>\n", y);
  y += height + 19;
  std::string foot = "</g>\n";
  for (const std::string& note : notes_) foot += paragraph(y, 12, faint_colour, note);
  return fmt::format(
             "<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {0:.0f} {1:.0f}' width='{0:.0f}' "
             "height='{1:.0f}'>\n<style>{2}</style>\n<rect width='100%' height='100%' fill='#fff'/>\n",
             width_, y + 5, rules()) +
         head + drawn_ + foot + "</svg>\n";
}

}  // namespace sunder::picture
