#pragma once
// Owns a file descriptor of the system.

#include <unistd.h>

#include <utility>

namespace morphkit {

/// A file descriptor that closes itself. Negative: there is none.
class Descriptor {
 public:
  Descriptor() = default;
  explicit Descriptor(int value) noexcept : value_(value) {}
  Descriptor(Descriptor&& other) noexcept : value_(other.release()) {}
  Descriptor& operator=(Descriptor&& other) noexcept {
    std::swap(value_, other.value_);
    return *this;
  }
  ~Descriptor() { close(); }

  int get() const noexcept { return value_; }

  /// Gives it away: it will not be closed here.
  int release() noexcept { return std::exchange(value_, -1); }

  /// @return false if closing failed, with errno: a full disk may show only now.
  bool close() noexcept {
    const int value = release();
    return value < 0 || ::close(value) == 0;
  }

 private:
  int value_ = -1;
};

}  // namespace morphkit
