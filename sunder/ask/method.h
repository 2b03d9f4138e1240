// Methods by name, as --method has them.
#pragma once

#include <sunder/ask/report.h>

#include <string>
#include <string_view>

namespace sunder::ask {

template <class Method>
struct Named {
  std::string_view name;
  Method* method;
};

// Throws Error bad_call that lists all names, and what they are for.
template <class Methods>
auto* method_by(std::string_view name, const Methods& methods, std::string_view what_for = "") {
  std::string known;
  for (const auto& m : methods) {
    if (m.name == name) return m.method;
    known += (known.empty() ? "" : ", ") + std::string(m.name);
  }
  refuse_method(name, known.append(what_for));
}

}  // namespace sunder::ask
