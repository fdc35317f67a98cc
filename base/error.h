#pragma once
// The one exception type for bad input from people and files. What a program does about a kind is its own affair:
// cli/exit_code.h.

#include <stdexcept>
#include <string>
#include <utility>

namespace morphkit {

enum class ErrorKind {
  kBadInput,     ///< an input says something impossible
  kIo,           ///< could not read or write
  kUnsupported,  ///< asks for a format or a feature that there is not
  kFailed,       ///< the work failed
  kInterrupted   ///< was told to stop
};

/// what() is "place: message" (or the message alone): the file, the place in it, what is wrong, what would be right.
class Error : public std::runtime_error {
 public:
  Error(ErrorKind kind, std::string place, std::string message)
      : std::runtime_error(place.empty() ? message : place + ": " + message),
        kind_(kind),
        place_(std::move(place)),
        message_(std::move(message)) {}

  ErrorKind kind() const noexcept { return kind_; }
  const std::string& place() const noexcept { return place_; }
  const std::string& message() const noexcept { return message_; }

 private:
  ErrorKind kind_;
  std::string place_;
  std::string message_;
};

}  // namespace morphkit
