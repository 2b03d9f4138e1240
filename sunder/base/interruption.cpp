#include <sunder/base/interruption.h>

#include <utility>

namespace sunder {

Interruptible::Interruptible(std::function<void()> check)
    : check_(std::move(check)), left_(0), before_(std::exchange(interruption_detail::current, this)) {}

Interruptible::~Interruptible() { interruption_detail::current = before_; }

}  // namespace sunder
