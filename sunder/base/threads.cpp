#include <sunder/base/threads.h>

#include <new>
#include <system_error>
#include <thread>
#include <vector>

namespace sunder {

void on_threads(std::size_t count, const std::function<void()>& work) {
  std::vector<std::thread> others;
  try {
    while (others.size() + 1 < count) others.emplace_back([&] { work(); });
  } catch (const std::system_error&) {
  } catch (const std::bad_alloc&) {
  }
  work();
  for (std::thread& other : others) other.join();
}

}  // namespace sunder
