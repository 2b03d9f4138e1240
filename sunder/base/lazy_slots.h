// What is made of an object on demand and kept with it: a few slots in the block that copies of the object share.
// Also called: lazy initialization, extension slots.
//
// The object does not know what lies there. Who makes a thing has a slot's number for it: of two things in one object,
// no two have the same.
#pragma once

#include <sunder/base/contract.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <mutex>
#include <utility>

namespace sunder {

class LazySlots {
 public:
  static constexpr std::size_t count = 9;

  LazySlots() = default;
  LazySlots(const LazySlots&) = delete;
  LazySlots& operator=(const LazySlots&) = delete;
  ~LazySlots() {
    for (const auto& slot : kept_) delete slot.load(std::memory_order_relaxed);
  }

  // The T of the slot; where there is none yet, what make() returns: called once, whichever threads ask at once, and
  // again only after it threw. It may ask for other slots. Requires slot < count, and a T where the slot is taken.
  // Cost: a load, once it is there.
  template <class T, class Make>
  const T& get(std::size_t slot, const Make& make) const {
    SUNDER_REQUIRE(slot < count);
    const Kept* kept = kept_[slot].load(std::memory_order_acquire);
    if (kept == nullptr) [[unlikely]] {
      const std::scoped_lock lock(making_);
      kept = kept_[slot].load(std::memory_order_relaxed);
      if (kept == nullptr) {
        kept = new KeptOf<T>(make());
        kept_[slot].store(kept, std::memory_order_release);
      }
    }
    SUNDER_REQUIRE(dynamic_cast<const KeptOf<T>*>(kept) != nullptr);
    return static_cast<const KeptOf<T>*>(kept)->value;
  }

 private:
  struct Kept {
    virtual ~Kept() = default;
  };
  template <class T>
  struct KeptOf final : Kept {
    explicit KeptOf(T&& made) : value(std::move(made)) {}
    const T value;
  };

  mutable std::array<std::atomic<const Kept*>, count> kept_{};
  mutable std::recursive_mutex making_;  // one thread makes, and what it makes may ask for other slots
};

}  // namespace sunder
