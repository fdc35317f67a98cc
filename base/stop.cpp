#include "base/stop.h"

#include <utility>

#include "base/error.h"

namespace morphkit {
namespace {

thread_local StopQuestion current_question;

}  // namespace

StopScope::StopScope(StopQuestion question) : outer_(std::exchange(current_question, std::move(question))) {}

StopScope::~StopScope() {
  current_question = std::move(outer_);
}

const StopQuestion& stop_question() noexcept {
  return current_question;
}

void stop_if_asked(const StopQuestion& question) {
  if (question && question()) throw Error(ErrorKind::kInterrupted, "", "interrupted before the work was done");
}

}  // namespace morphkit
