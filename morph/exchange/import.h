#pragma once
// Correspondences in other tools' files. One table of formats; each format has its own source, import_<name>.cpp.

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <opencv2/core/types.hpp>

#include "morph/project/project.h"
#include "warp/mesh/mesh.h"

namespace morphkit::exchange {

/// The mesh of one picture.
struct PictureMesh {
  warp::Mesh mesh;   ///< px of the picture
  cv::Size size;     ///< of the picture, px
  std::string name;  ///< for remarks
};

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
  /// @throws Error as export_to. Null: the format is only read.
  std::vector<std::string> (*export_files)(const project::Project& project, const ExportOutput& output);
  /// The pictures that the files name. Null: they name none. @throws Error as import_into.
  std::vector<std::filesystem::path> (*pictures)(const std::filesystem::path& file);
};

/// All that are known.
std::span<const Format> formats();

/// The pictures that the files name, the source's first, as seen from the current folder; empty if the format names
/// none.
/// @throws Error as import_into.
std::vector<std::filesystem::path> pictures_in(const std::vector<std::filesystem::path>& files);

/// Lays what other tools' files say over `project`, which is then such that it can be saved. The format is told by the
/// extension.
/// @throws Error kUnsupported for an unknown extension or number of files, kIo, kBadInput naming file and line;
/// `project` is
///         then unchanged.
ImportReport import_into(project::Project& project, const ImportInput& input);

/// Writes what the format can hold. @return remarks: what it cannot hold, a sentence each.
/// @throws Error kUnsupported as import_into, and if two of the files are one; kBadInput if the project lacks what the
///         format holds; kIo (nothing is replaced then that was there, unless only a later one of the files fails to be
///         put in place).
std::vector<std::string> export_to(const project::Project& project, const ExportOutput& output);

/// A .mesh file of xmorph or gtkmorph.
struct MeshFile {
  std::filesystem::path file;
  cv::Size size;                    ///< of the picture to which the mesh is scaled, px
  std::optional<cv::Size2d> frame;  ///< in which the vertices lie, px; unset: as the file says
};

/// The meshes of pictures that belong together, brought to the sizes of the pictures; border vertices lie on the border
/// exactly, and all have equal numbers of columns and rows. A mesh that covers only a part of its picture gets more of
/// them, so do the others then. They may fold.
/// @param remarks  receives what was assumed, a sentence each. @throws Error kIo, kBadInput naming file and line.
std::vector<PictureMesh> read_xmorph_meshes(std::span<const MeshFile> files, std::vector<std::string>& remarks);

}  // namespace morphkit::exchange
