// The one exception type of the library.
//
// Making an object or reading a file throws Error; a query on valid objects never throws.
// A message is one line: what is wrong, and the remedy. The place says where: "FILE:LINE", "vertex 7", "pose".
#pragma once

#include <sunder/base/names.h>

#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>

namespace sunder {

enum class ErrorCode {
  bad_value,  // a number that is not finite, or out of the range that the question allows
  bad_shape,  // an object without vertices, a mesh that is not convex where convexity was required
  bad_pose,   // a pose that is singular or not finite
  bad_file,   // a file that cannot be read, is truncated, or is not of its format
  bad_call,   // an unknown option, method, or combination
};

// As JSON and Python's Error.kind have it: "bad-value" and so on.
constexpr std::string_view name_of(ErrorCode code) noexcept {
  return name_in<ErrorCode::bad_call>({"bad-value", "bad-shape", "bad-pose", "bad-file", "bad-call"}, code);
}

class Error : public std::runtime_error {
 public:
  // text: what is wrong and the remedy; place: where (may be empty).
  Error(ErrorCode code, const std::string& text, std::string place = {})
      : std::runtime_error(place.empty() ? text : place + ": " + text), code_(code), place_(std::move(place)) {}

  ErrorCode code() const { return code_; }
  const std::string& place() const { return place_; }
  std::string text() const { return std::string(what()).substr(place_.empty() ? 0 : place_.size() + 2); }

 private:
  ErrorCode code_;
  std::string place_;
};

}  // namespace sunder
