// What a file holds and a reader does not take, for readers and those who ask them.
#pragma once

#include <sunder/base/error.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder::io {

// Things of one kind that were not taken. An answer about the rest is silent about them, so callers must show them.
struct LeftOut {
  std::string kind;         // a noun in the singular, in one line of UTF-8: "cylinder", "line"
  std::string of;           // the name of what they belong to, such as a link; empty: the file
  std::uint64_t count = 1;  // at least 1
};

// What of its files a call does not speak of: an error, unless the caller consents; then it is told with the answer.
class LeftOutList {
 public:
  // consent: the caller lets it go (--leave-out).
  explicit LeftOutList(bool consent) : consent_(consent) {}

  // What was left out of a file, with consent.
  LeftOutList(const std::string& file, std::span<const LeftOut> left_out) : consent_(true) { add(file, left_out, ""); }

  // Takes what is left out of a file. Throws Error bad_file where there is something, and no consent: one line with the
  // numbers, the kinds, the first owners, and the remedy: "give ...", what to do instead.
  void add(const std::string& file, std::span<const LeftOut> left_out, const std::string& remedy);

  bool consent() const { return consent_; }
  bool empty() const { return kinds_.empty(); }

  // "2 cylinders of a, b; 1 sphere of c"; empty where nothing was left out.
  std::string text() const;
  // "; left out: 2 cylinders of a, b; 1 sphere of c", to stand behind a verdict; or nothing.
  std::string clause() const;
  // What a certificate says, kind by kind: "2 cylinders of a, b", "1 sphere of c".
  std::vector<std::string> texts() const;

  // What of this was left out of this file; a number, where it is of no other file, too.
  std::vector<std::string> texts_of(const std::string& file) const;

  struct Kind {
    std::string name;
    std::uint64_t count = 0;
    std::vector<std::string> of;  // all owners
  };
  std::span<const Kind> kinds() const { return kinds_; }  // in the order in which they came

 private:
  static std::string text_of(std::span<const Kind> kinds);
  static void gather(const LeftOut& item, const std::string& owner, std::vector<Kind>& kinds);

  bool consent_;
  std::vector<Kind> kinds_;
};

}  // namespace sunder::io
