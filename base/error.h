#pragma once
// The one exception type for bad input from people and files. cli/program.cpp turns it into an exit code.

#include <stdexcept>
#include <string>
#include <utility>

namespace morphkit {

/// The program's exit codes; see docs/commands.md.
enum class ErrorCode {
  kFailed = 1,    ///< the work failed
  kUsage = 2,     ///< wrong usage
  kBadInput = 3,  ///< an input file says something impossible
  kIo = 4,        ///< could not read or write
  kInterrupted = 130
};

/// what() is "place: message" (or the message alone): the file, the place in it, what is wrong, what would be right.
class Error : public std::runtime_error {
 public:
  Error(ErrorCode code, std::string place, std::string message)
      : std::runtime_error(place.empty() ? message : place + ": " + message),
        code_(code),
        place_(std::move(place)),
        message_(std::move(message)) {}

  ErrorCode code() const noexcept { return code_; }
  const std::string& place() const noexcept { return place_; }
  const std::string& message() const noexcept { return message_; }

 private:
  ErrorCode code_;
  std::string place_;
  std::string message_;
};

}  // namespace morphkit
