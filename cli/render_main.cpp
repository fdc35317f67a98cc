// morphkit-render: the same command line with all that renders, reads pictures and opens windows.

#include "cli/interrupt.h"
#include "cli/program.h"
#include "cli/works.h"
#include "morph/media/image_file.h"

int main(int argc, char** argv) {
  morphkit::cli::install_interrupt_handlers();
  morphkit::media::set_up_process();
  return morphkit::cli::run_program(argc, argv, &morphkit::cli::all_works());
}
