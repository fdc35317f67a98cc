#pragma once
// morphkit compare A B: how far apart two pictures are, and where.

#include <filesystem>

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

struct CompareOptions {
  std::filesystem::path a, b;
  double tolerance = 0;              ///< largest difference of a channel that passes; 1 is black to white
  std::filesystem::path difference;  ///< picture of the difference to write; empty: none
  double gain = 10;                  ///< amplification of that picture
  bool overwrite = false;
  bool json = false;
};

void add_compare(CommandLine& line, Session& session);

/// @return 0 if the pictures agree within the tolerance, else kExitDifference (also for unequal sizes).
/// @throws Error as media::read_picture and write_image.
int run_compare(const CompareOptions& options, Output& output);

}  // namespace morphkit::cli
