#pragma once
// morphkit demo: paints a sample pair, writes its project, renders it, and says what to look at.

#include <filesystem>
#include <string>

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct DemoOptions {
  std::string name;  ///< of a sample; empty: the first
  std::filesystem::path folder = "morphkit-demo";
  int frame_count = 0;  ///< 0: as the sample's project says
  bool all = false;
  bool list = false;
  bool overwrite = false;
};

void add_demo(CommandLine& line, Session& session);

/// Paints and renders; does not handle `list`. @throws ArgumentError for an unknown sample; kIo if files cannot be
/// written, or a picture or project of the sample exists with other contents and `overwrite` is off. A rendered demo is
/// always replaced.
int run_demo(const DemoOptions& options, Output& output);

}  // namespace morphkit::cli
