#include "cli/man_page.h"

#include <gtest/gtest.h>

#include "tests/cli/run_program.h"
#include "tests/support/errors.h"

namespace morphkit::cli {
namespace {

using test::contains;
using test::run_morphkit;

constexpr const char* kHelp =
    "Bend one image\n"
    "onto a mesh\n"
    "Usage: morphkit warp [OPTIONS] IMAGE\n"
    "\n"
    "Arguments:\n"
    "  IMAGE                     A picture\n"
    "\n"
    "Options:\n"
    "  -o,--output OUT (required)\n"
    "                            a picture;\n"
    "                            .png for one\n"
    "\n"
    "Example:\n"
    "  morphkit warp a.png\n"
    "\n"
    "Exit codes: 0 done; 1 the work failed;\n"
    "            5 a difference\n";

TEST(ManPage, HasASectionForEachPartOfTheHelp) {
  EXPECT_EQ(to_roff({"morphkit warp", "1.2.3", kHelp, {"morphkit", "morphkit map"}}),
            ".TH \"MORPHKIT\\-WARP\" 1 \"\" \"morphkit 1.2.3\" \"User Commands\"\n"
            ".SH NAME\nmorphkit\\-warp \\- Bend one image onto a mesh\n"
            ".SH SYNOPSIS\n.B morphkit warp\n[OPTIONS] IMAGE\n"
            ".SH \"ARGUMENTS\"\n.TP\n.B IMAGE\nA picture\n"
            ".SH \"OPTIONS\"\n.TP\n.B \\-o, \\-\\-output OUT (required)\na picture;\n\\&.png for one\n"
            ".SH \"EXAMPLES\"\n.nf\nmorphkit warp a.png\n.fi\n"
            ".SH \"EXIT STATUS\"\n.TP\n.B 0\ndone\n.TP\n.B 1\nthe work failed\n.TP\n.B 5\na difference\n"
            ".SH \"SEE ALSO\"\n.BR morphkit (1),\n.BR morphkit\\-map (1)\n");
}

TEST(ManPage, EscapesWhatRoffWouldRead) {
  const std::string page = to_roff({"x", "1", "a\\b\nUsage: x\n\nOptions:\n  -a    .mp4\n        'quoted'\n", {}});
  EXPECT_TRUE(contains(page, "a\\eb\n"));
  EXPECT_TRUE(contains(page, "\n.B \\-a\n\\&.mp4\n\\&'quoted'\n"));
}

TEST(ManPage, IsPrintedByHelp) {
  const std::string program = run_morphkit({"help", "--man"}).out;
  EXPECT_TRUE(program.starts_with(".TH \"MORPHKIT\" 1 "));
  EXPECT_TRUE(contains(program, "\n.BR morphkit\\-morph (1)"));
  const std::string command = run_morphkit({"help", "--man", "compare"}).out;
  EXPECT_TRUE(command.starts_with(".TH \"MORPHKIT\\-COMPARE\" 1 "));
  EXPECT_TRUE(contains(command, "\n.BR morphkit (1)\n"));
}

}  // namespace
}  // namespace morphkit::cli
