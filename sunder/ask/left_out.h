// What of its files a call does not speak of. It is an error, unless the caller says --leave-out; then it is told with
// the verdict, in the JSON, and in the certificate.
#pragma once

#include <sunder/ask/report.h>

#include <sunder/io/left_out.h>

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace sunder::ask {

// The option's help.
extern const char* const leave_out_help;

class LeftOutList {
 public:
  // consent: the caller said --leave-out.
  explicit LeftOutList(bool consent) : consent_(consent) {}

  // Takes what is left out of a file. Throws Error bad_file where there is something, and no consent: one line with the
  // numbers, the kinds, the first owners, and the remedy: "give ...", what to do instead.
  void add(const std::string& file, std::span<const io::LeftOut> left_out, const std::string& remedy);

  bool consent() const { return consent_; }
  bool empty() const { return kinds_.empty(); }

  // "2 cylinders of a, b; 1 sphere of c"; empty where nothing was left out.
  std::string text() const;
  // "; left out: 2 cylinders of a, b; 1 sphere of c", to stand behind a verdict; or nothing.
  std::string clause() const;
  // What a certificate says, kind by kind: "2 cylinders of a, b", "1 sphere of c".
  std::vector<std::string> texts() const;
  // [{"kind", "count", "of": [...]}], with all owners.
  Json json() const;

 private:
  struct Kind {
    std::string name;
    std::uint64_t count = 0;
    std::vector<std::string> of;
  };
  static std::string text_of(std::span<const Kind> kinds);
  static void gather(const io::LeftOut& item, const std::string& owner, std::vector<Kind>& kinds);

  bool consent_;
  std::vector<Kind> kinds_;  // in the order in which they came
};

}  // namespace sunder::ask
