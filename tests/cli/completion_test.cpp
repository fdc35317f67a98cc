// Tests cli/cmd_completion.cpp and cli/completion_script.cpp.

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "cli/program.h"
#include "tests/cli/commands.h"
#include "tests/cli/run_program.h"
#include "tests/support/errors.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::test {
namespace {

namespace fs = std::filesystem;

TEST(Completion, BashScriptIsBashAndCompletes) {
  TemporaryFolder folder;
  const fs::path script = folder / "completion.bash";
  write_text(script, run_morphkit({"completion", "bash"}).out);
  EXPECT_EQ(run_program("/bin/bash", {"-n", script.string()}).exit_code, 0);
  const auto complete = [&](const std::string& words, int index) {
    return run_program("/bin/bash", {"-c",
                                     "source \"$0\"; COMP_WORDS=(" + words + "); COMP_CWORD=" + std::to_string(index) +
                                         "; _morphkit; echo \"${COMPREPLY[*]}\"",
                                     script.string()})
        .out;
  };
  EXPECT_EQ(complete("morphkit comp", 1), "compare completion\n");
  EXPECT_EQ(complete("morphkit compare --tol", 2), "--tolerance\n");
  EXPECT_EQ(complete("morphkit completion ''", 2), "bash zsh fish\n");
  EXPECT_EQ(complete("morphkit help sch", 2), "schema\n");
}

TEST(Completion, EveryShellKnowsEveryOptionOfEveryCommand) {
  for (const std::string shell : {"bash", "zsh", "fish"}) {
    const RunResult result = run_morphkit({"completion", shell});
    EXPECT_EQ(result.exit_code, 0);
    for (const cli::CommandShape& command : cli::program_shape().commands) {
      EXPECT_TRUE(contains(result.out, command.name)) << shell << command.name;
      for (const std::string& name : cli::option_names(command)) {
        const bool is_long = name.starts_with("--");
        const std::string spelling =
            shell != "fish" ? name : (is_long ? "-l " + name.substr(2) : "-s " + name.substr(1));
        EXPECT_TRUE(contains(result.out, spelling)) << shell << " " << command.name << " " << name;
      }
    }
  }
}

TEST(Completion, RefusesAShellItDoesNotKnow) {
  expect_usage_error(run_morphkit({"completion", "tcsh"}), "bash,zsh,fish");
  expect_usage_error(run_morphkit({"completion"}), "SHELL is required");
}

}  // namespace
}  // namespace morphkit::test
