#pragma once
// Correspondences in other tools' files. One table of formats; each format has its own source, import_<name>.cpp.

#include <cstddef>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"
#include "warp/mesh/mesh.h"

namespace morphkit::exchange {

struct ImportInput {
  std::vector<std::filesystem::path> files;  ///< as many as the format wants, the source's first
  cv::Size source_size, destination_size;    ///< of the pictures, px
};

struct ImportReport {
  std::string format;                ///< name of the format in the table
  std::vector<std::string> remarks;  ///< what was assumed, moved or left out; a sentence each
};

struct ExportOutput {
  std::vector<std::filesystem::path> files;  ///< as many as the format wants, the source's first
  cv::Size source_size, destination_size;    ///< of the pictures, px
  bool overwrite = false;
};

/// A format of another tool.
struct Format {
  std::string_view name;                         ///< "xmorph"
  std::span<const std::string_view> extensions;  ///< ".mesh", in lower case
  std::size_t files;                             ///< how many hold one morph
  std::string_view wants;                        ///< what they are: "two files, the source's mesh first"
  /// Lays what the files say over the project. @throws Error as import_into.
  std::vector<std::string> (*import_files)(project::Project& project, const ImportInput& input);
  /// @throws Error as export_to.
  std::vector<std::string> (*export_files)(const project::Project& project, const ExportOutput& output);
};

/// All that are known.
std::span<const Format> formats();

/// Lays what other tools' files say over `project`, which is then such that it can be saved. The format is told by the
/// extension.
/// @throws Error kUnsupported for an unknown extension or number of files, kIo, kBadInput naming file and line;
/// `project` is
///         then unchanged.
ImportReport import_into(project::Project& project, const ImportInput& input);

/// Writes what the format can hold. @return remarks: what it cannot hold, a sentence each.
/// @throws Error kUnsupported as import_into, and if two of the files are one; kBadInput if the project has not what
/// the
///         format is for; kIo (nothing is replaced then that was there, unless only a later one of the files fails to
///         be put in place).
std::vector<std::string> export_to(const project::Project& project, const ExportOutput& output);

/// One side of xmorph's meshes, brought to a picture of `size` px; border vertices lie on its border exactly.
/// @param remarks  receives what was assumed, a sentence each. @throws Error kIo, kBadInput naming file and line.
warp::Mesh read_xmorph_mesh(const std::filesystem::path& file, cv::Size size, std::vector<std::string>& remarks);

}  // namespace morphkit::exchange
