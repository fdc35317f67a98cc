#pragma once
// Files that appear whole or not at all.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <sys/types.h>

#include "base/error.h"

namespace morphkit {

/// A file is there already, and nobody has asked to replace it.
class FileExists : public Error {
 public:
  explicit FileExists(std::string place) : Error(ErrorKind::kIo, std::move(place), "already exists") {}
};

/// Reserves a temporary file beside `final_name`; `commit` renames it there. Until then nothing appears under the final
/// name. If the object is destroyed first, nothing ever does.
///
/// The temporary name is `.<stem>.<pid>.<counter>.tmp<extension>`: hidden, so that no frame pattern takes it for a
/// frame; with the final extension, because codecs read the format from it; created exclusively, so that two programs
/// never share one. A file that a killed program left behind is never used again.
class AtomicFile {
 public:
  /// Creates the (empty) temporary file. A symbolic link is followed: its target is replaced, not the link. A replaced
  /// file keeps its permissions.
  /// @throws Error kIo if the folder is missing or cannot be written, or if `final_name` is a folder or a device;
  ///         FileExists if it exists and `overwrite` is false.
  AtomicFile(const std::filesystem::path& final_name, bool overwrite);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write. The file exists and is empty. The writer must close it before `commit`.
  const std::filesystem::path& temporary() const noexcept { return temporary_; }

  /// Writes `bytes` as the whole contents. @throws Error kIo, also on a full disk.
  void write(std::span<const std::uint8_t> bytes);

  /// Flushes the file to the disk and gives it its final name. Without `overwrite`, it never replaces a file that has
  /// appeared there in the meantime.
  /// @throws Error kIo; the temporary file is removed by the destructor then.
  void commit();

 private:
  void reserve();

  std::string shown_;  ///< the name as given, for messages
  std::filesystem::path final_;
  std::filesystem::path temporary_;
  bool overwrite_;
  std::optional<mode_t> mode_;  ///< permissions of the replaced file
  bool committed_ = false;
};

/// Writes `bytes` as one file, atomically. @throws Error kIo, also on a full disk.
void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes, bool overwrite);

}  // namespace morphkit
