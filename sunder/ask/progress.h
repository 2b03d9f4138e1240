// How far a long piece of work is: on standard error, on a terminal only, after a second.
#pragma once

#include <chrono>
#include <functional>
#include <string>
#include <string_view>

namespace sunder::ask {

class Progress {
 public:
  explicit Progress(std::string_view what);
  ~Progress();  // wipes its line
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  // To be called now and then with the part that is done, 0 to 1. Empty where nobody would see it.
  std::function<void(double)> reporter();

 private:
  void report(double part);

  std::string what_;
  std::chrono::steady_clock::time_point start_;
  int shown_ = -1;  // percent
};

}  // namespace sunder::ask
