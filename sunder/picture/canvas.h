// A sheet of SVG: a head of title, summary and legend, what is drawn, and notes below. All pictures are drawn on one,
// so that their text, colours and path data are made in one place. Pixels; y runs down.
#pragma once

#include <sunder/predicate/point.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::picture {

// What a thing is drawn for. Colours of Okabe and Ito, which colour-blind people can tell apart.
enum class Ink : std::uint8_t {
  calm,    // grey: what is given
  bold,    // blue: what is asked for
  accent,  // vermilion: what matters most: the contact, the best point
  second,  // green: another kind of it
  third,   // pink: and another
  dark,    // evidence
};

// The class of what is drawn in it. With "f" it is filled, where a path or a circle is a shape.
char class_of(Ink ink);

inline constexpr const char *text_colour = "#1f2a3a", *faint_colour = "#55677f";

// Any text as it stands in XML, also within quotes: one line of UTF-8. Two code points that XML has not become '?'.
std::string xml_text(std::string_view text);

// The text, or so many of its bytes and "...": cut between characters.
std::string shortened(std::string_view text, std::size_t longest);

// SVG path data in whole tenths of pixels, steps relative: short. For a group of transform='scale(.1)'.
class PathData {
 public:
  struct Tenths {
    long x = 0, y = 0;
    friend auto operator<=>(const Tenths&, const Tenths&) = default;
  };
  static Tenths tenths(const Point2& pixel);

  void move(const Tenths& p);
  void line(const Tenths& p);
  void close();
  const std::string& text() const { return text_; }

 private:
  void step(char letter, const Tenths& p);  // a blank: goes on with the letter before

  bool after_line_ = false;
  Tenths pen_, begin_;
  std::string text_;
  std::size_t row_begin_ = 0;  // of the text's last row
};

// One line, at its left end; as XML. attributes: more of them.
std::string words(double x, double y, double size, const char* colour, std::string_view text,
                  std::string_view attributes = "");

class Canvas {
 public:
  static constexpr double border = 40;

  explicit Canvas(double width) : width_(width) {}

  // What is drawn: XML; its upper end is at 0, below the head.
  void add(std::string_view xml) { drawn_ += xml; }

  // An entry of the legend. sign: XML of at most 20 by 18 pixels around (10, 0); of an ink a filled circle.
  void legend(std::string_view sign, std::string_view text, bool grey = false);
  void legend(Ink ink, std::string_view text);
  void note(std::string_view text) { notes_.emplace_back(text); }

  // The file. height: of what is drawn. Where they are long, the title is cut, summary and notes are in several rows.
  std::string finish(std::string_view title, std::string_view summary, double height) const;

 private:
  std::string paragraph(double& y, double size, const char* colour, std::string_view text) const;

  double width_ = 0, legend_x_ = border, legend_y_ = 0;
  std::string legend_, drawn_;
  std::vector<std::string> notes_;
};

}  // namespace sunder::picture
