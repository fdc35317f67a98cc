#pragma once
// Files that appear whole or not at all.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>

#include <sys/types.h>

namespace morphkit {

/// Reserves a temporary file beside `final_name`; `commit` renames it there. Until then, and for ever if the object is
/// destroyed first, nobody sees anything under the final name.
///
/// The temporary name is `.<stem>.<pid>.<counter>.tmp<extension>`: hidden, so that no frame pattern takes it for a
/// frame, with the extension that tells a codec the format, and created exclusively, so that programs do not meet in
/// it. One that a killed program left behind is never used again.
class AtomicFile {
 public:
  /// Creates the (empty) temporary file. A symbolic link is followed: what it points to is replaced, not the link. A
  /// file that is replaced keeps its permissions.
  /// @throws Error kIo if the folder is missing or cannot be written, if `final_name` is a folder or a device, or if it
  ///         exists and `overwrite` is false.
  AtomicFile(const std::filesystem::path& final_name, bool overwrite);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  /// Where to write. The file exists and is empty; whoever writes must have closed it before `commit`.
  const std::filesystem::path& temporary() const noexcept { return temporary_; }

  /// Writes `bytes` as the whole contents. @throws Error kIo, also on a full disk.
  void write(std::span<const std::uint8_t> bytes);

  /// Flushes the file to the disk and gives it its final name. Without `overwrite`, a file that has appeared there in
  /// the meantime is left alone.
  /// @throws Error kIo; the temporary file is removed by the destructor then.
  void commit();

 private:
  void reserve();

  std::string shown_;  ///< the name as it was given, for messages
  std::filesystem::path final_;
  std::filesystem::path temporary_;
  bool overwrite_;
  std::optional<mode_t> mode_;  ///< permissions of the file that is replaced
  bool committed_ = false;
};

/// Writes `bytes` as one file, atomically. @throws Error kIo, also on a full disk.
void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes, bool overwrite);

}  // namespace morphkit
