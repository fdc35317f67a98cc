#pragma once
// Runs the built program as a person or a script would, and keeps what it says.

#include <filesystem>
#include <string>
#include <vector>

namespace morphkit::test {

struct RunResult {
  int exit_code = -1;  ///< -1 if it was ended by a signal
  int signal = 0;      ///< the signal that ended it
  std::string out;     ///< standard output
  std::string err;     ///< standard error
};

struct RunOptions {
  std::filesystem::path folder;          ///< current directory; empty: this process's
  std::vector<std::string> environment;  ///< "NAME=value", on top of this process's
  std::string output_to;                 ///< standard output goes to this file instead of RunResult::out
  bool close_output = false;             ///< standard output is closed
  std::string marker;                    ///< once this stands in either stream, `send` is sent
  int send = 0;                          ///< signal number; 0: none
  int send_count = 1;                    ///< how often
};

/// Runs `program` with an argument vector (no shell) to its end. Standard input is empty. A program that says and does
/// nothing for two minutes is killed, which shows as signal 9.
/// @throws std::system_error if it cannot be started.
RunResult run_program(const std::filesystem::path& program, const std::vector<std::string>& arguments,
                      const RunOptions& options = {});

/// The same for the morphkit that was built with the tests.
RunResult run_morphkit(const std::vector<std::string>& arguments, const RunOptions& options = {});

/// That program's file.
std::filesystem::path morphkit_program();

}  // namespace morphkit::test
