#include <csignal>

#include <fcntl.h>
#include <unistd.h>

#include "cli/interrupt.h"
#include "cli/program.h"

namespace {

/// A standard stream that the caller has closed would hand its number to the first file that is opened, and messages
/// would end up in a picture. Its place is taken by something that nothing can be written to.
void hold_standard_streams() {
  for (int descriptor = 0; descriptor <= 2; ++descriptor) {
    if (fcntl(descriptor, F_GETFD) == -1) open("/dev/null", O_RDONLY | O_NOCTTY);
  }
}

}  // namespace

int main(int argc, char** argv) {
  hold_standard_streams();
  // A reader that has gone away is a write error like any other, with its message and exit code.
  std::signal(SIGPIPE, SIG_IGN);
  morphkit::cli::install_interrupt_handlers();
  return morphkit::cli::run_program(argc, argv);
}
