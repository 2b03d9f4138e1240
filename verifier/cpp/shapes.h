// The shapes of what statements say and claims bring: how the value of a member is read, by the name of its shape.
#pragma once

#include <verifier/cpp/values.h>

#include <string>
#include <string_view>

namespace sunder_verifier {

// A value, and what its shape may look at.
struct Told {
  const Json& value;
  const std::string& where;  // names the value
  const Scope& scope;        // all that was read before
  std::string_view of;       // behind "of": the name of something in that scope
  const Tables& tables;
};

// Refuses by F what has not this shape.
using Shape = Value (*)(const Told& told);

// Requires that there is one of that name.
Shape shape_named(const std::string& name);

}  // namespace sunder_verifier
