// XML text as a tree, with messages that name file and line. For readers of small files (URDF, SRDF, COLLADA).
#pragma once

#include <sunder/base/error.h>

#include <tinyxml2.h>

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sunder::io {

using tinyxml2::XMLElement;

// Words between blanks and line breaks.
std::vector<std::string_view> xml_words(std::string_view text);

// What a file is, for messages.
struct XmlKind {
  std::string_view root;     // of its root: "robot"
  std::string_view name, a;  // "URDF", "a URDF"
  std::string_view thing;    // what is exported again: "robot"
};

class XmlFile {
 public:
  // Throws Error bad_file: the text holds zero bytes, is not well-formed, or has another root. place: the file's name
  // for messages; must outlive this. Elements are at most 100 deep. Cost: linear.
  XmlFile(std::string_view bytes, std::string_view place, const XmlKind& kind);

  const XMLElement& root() const { return *document_.RootElement(); }

  static bool is(const XMLElement& element, std::string_view name) { return element.Name() == name; }
  static std::string tag(const XMLElement& element);  // "<name>"

  template <class Action>
  static void each_child(const XMLElement& element, Action action) {
    const XMLElement* child = element.FirstChildElement();
    for (; child != nullptr; child = child->NextSiblingElement()) action(*child);
  }

  // Throw Error bad_file at the element's line.
  [[noreturn]] void fail(const XMLElement& element, const std::string& text) const;
  const char* attribute(const XMLElement& element, const char* name) const;  // it must be there
  std::string name_of(const XMLElement& element) const;                      // name="...", one line, not empty
  double number(const XMLElement& element, const char* name, std::string_view word) const;
  double number_or(const XMLElement& element, const char* name, double otherwise) const;
  std::array<double, 3> triple_or(const XMLElement& element, const char* name, std::array<double, 3> otherwise) const;

  // Calls action(word, line) for each word of the element's text, comments left out. Refuses elements in it.
  template <class Action>
  void each_word(const XMLElement& element, Action action) const {
    for (const tinyxml2::XMLNode* node = element.FirstChild(); node != nullptr; node = node->NextSibling()) {
      if (node->ToComment() != nullptr) continue;
      if (node->ToText() == nullptr) fail(element, tag(element) + " has more than text in it; export the file again");
      each_word_of(node->Value(), node->GetLineNum(), action);
    }
  }

 private:
  template <class Action>
  static void each_word_of(std::string_view text, int first_line, Action action) {
    auto line = static_cast<std::size_t>(first_line < 1 ? 1 : first_line);
    for (std::size_t at = 0; at < text.size();) {
      if (is_blank(text[at])) {
        if (text[at++] == '\n') ++line;
        continue;
      }
      const std::size_t begin = at;
      while (at < text.size() && !is_blank(text[at])) ++at;
      action(text.substr(begin, at - begin), line);
    }
  }

  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

  std::string_view place_;
  tinyxml2::XMLDocument document_;
};

}  // namespace sunder::io
