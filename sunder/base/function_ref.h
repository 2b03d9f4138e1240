// A function as a parameter, without a template for each that is passed.
#pragma once

#include <memory>
#include <type_traits>
#include <utility>

namespace sunder {

template <class Signature>
class FunctionRef;

// Refers to something that can be called, and does not keep it: a parameter, for as long as the call lasts. What takes
// it is compiled once, where a template would be for each callable; a call costs an indirect jump.
template <class Result, class... Arguments>
class FunctionRef<Result(Arguments...)> {
 public:
  template <class Function>
    requires(!std::is_same_v<std::remove_cvref_t<Function>, FunctionRef> &&
             std::is_invocable_r_v<Result, const Function&, Arguments...>)
  FunctionRef(const Function& function)  // NOLINT(google-explicit-constructor): lambdas are passed as they are
      : function_(std::addressof(function)), call_([](const void* f, Arguments... arguments) -> Result {
          return (*static_cast<const Function*>(f))(std::forward<Arguments>(arguments)...);
        }) {}

  Result operator()(Arguments... arguments) const { return call_(function_, std::forward<Arguments>(arguments)...); }

 private:
  const void* function_;
  Result (*call_)(const void*, Arguments...);
};

}  // namespace sunder
