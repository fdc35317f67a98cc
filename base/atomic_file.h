#pragma once
// Files that appear whole or not at all.

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <sys/types.h>

#include "base/descriptor.h"
#include "base/error.h"

namespace morphkit {

/// A file is there already, and nobody has asked to replace it.
class FileExists : public Error {
 public:
  explicit FileExists(std::string place) : Error(ErrorKind::kIo, std::move(place), "already exists") {}
};

/// What happens to the temporary files that killed programs left behind.
enum class Leftovers { kRemove, kKeep };

/// Reserves a temporary file beside `final_name`; `commit` renames it there. Until then nothing appears under the final
/// name. If the object is destroyed first, nothing ever does.
///
/// The temporary name is `.<stem>.<pid>.<counter>.tmp<extension>`: hidden, so that no frame pattern takes it for a
/// frame; with the final extension, because codecs read the format from it; created exclusively, so that two programs
/// never share one. It is locked while its owner lives: what a killed program left behind can be told from a file in
/// work, on other machines too, and the next AtomicFile of the same final name removes it.
class AtomicFile {
 public:
  /// Creates the (empty) temporary file. A symbolic link is followed: its target is replaced, not the link. A replaced
  /// file keeps its permissions.
  /// @param leftovers  kKeep for one of many files in a folder: looking for leftovers reads the folder.
  /// @throws Error kIo if the folder is missing or cannot be written, or if `final_name` is a folder or a device;
  ///         FileExists if it exists and `overwrite` is false.
  AtomicFile(const std::filesystem::path& final_name, bool overwrite, Leftovers leftovers = Leftovers::kRemove);
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
  Descriptor lock_;  ///< of the temporary file
  bool overwrite_;
  std::optional<mode_t> mode_;  ///< permissions of the replaced file
  bool committed_ = false;
};

/// Removes from `folder` the temporary files of killed programs whose final name `is_ours` accepts. Final names with
/// more than 150 bytes before the extension are cut there. A file that cannot be removed, or whose lock cannot be asked
/// for, stays. Cost: reads the folder once.
void remove_leftovers(const std::filesystem::path& folder, const std::function<bool(const std::string&)>& is_ours);

/// Writes `bytes` as one file, atomically. @throws Error kIo, also on a full disk.
void write_file(const std::filesystem::path& file, std::span<const std::uint8_t> bytes, bool overwrite);

}  // namespace morphkit
