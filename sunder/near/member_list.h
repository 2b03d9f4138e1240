// The members of a set, numbered from 0, each as it must be.
#pragma once

#include <sunder/base/error.h>

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace sunder {

// Immutable; any number of threads may use it.
template <class Member>
class MemberList {
 public:
  std::uint32_t size() const { return static_cast<std::uint32_t>(members_.size()); }
  const Member& operator[](std::uint32_t i) const { return members_[i]; }
  std::span<const Member> all() const { return members_; }

 protected:
  // Throws Error bad_value, "circle 7: ..." with what is wrong about it (null: nothing); bad_shape for 2^31 or more.
  MemberList(std::vector<Member> given, const std::string& noun, const char* (*what_is_wrong)(const Member&))
      : members_(std::move(given)) {
    if (members_.size() >= std::size_t{1} << 31) {
      throw Error(ErrorCode::bad_shape, "a set holds fewer than 2^31 members; split it", noun);
    }
    for (std::uint32_t i = 0; i < size(); ++i) {
      if (const char* wrong = what_is_wrong(members_[i]); wrong != nullptr) {
        throw Error(ErrorCode::bad_value, wrong, noun + " " + std::to_string(i));
      }
    }
  }

 private:
  std::vector<Member> members_;
};

}  // namespace sunder
