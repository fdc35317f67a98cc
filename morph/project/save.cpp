// The document as text, and text into files that are whole or not there.

#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "morph/error.h"
#include "morph/project/build.h"
#include "morph/project/json.h"
#include "morph/project/merge.h"
#include "morph/project/project.h"

namespace morphkit::project {
namespace {

/// A file under a temporary name beside its target; gone unless committed.
class PendingFile {
 public:
  explicit PendingFile(const std::filesystem::path& target)
      : target_(target), path_(target.string() + ".XXXXXX"), descriptor_(::mkstemp(path_.data())) {
    if (descriptor_ < 0) fail(errno);
  }
  PendingFile(const PendingFile&) = delete;
  PendingFile& operator=(const PendingFile&) = delete;
  ~PendingFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!committed_) ::unlink(path_.c_str());
  }

  void write(std::string_view text) {
    while (!text.empty()) {
      const ssize_t count = ::write(descriptor_, text.data(), text.size());
      if (count < 0 && errno == EINTR) continue;
      if (count < 0) fail(errno);
      text.remove_prefix(static_cast<std::size_t>(count));
    }
  }

  /// @param mode  permissions of the finished file.
  void commit(mode_t mode) {
    // Some file systems know no permissions; the text matters more.
    [[maybe_unused]] const int changed = ::fchmod(descriptor_, mode);
    if (::fsync(descriptor_) != 0) fail(errno);
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0 || ::rename(path_.c_str(), target_.c_str()) != 0) fail(errno);
    committed_ = true;
  }

 private:
  /// The destructor does not run for a constructor that throws; there is nothing to remove then.
  [[noreturn]] void fail(int error) const {
    throw Error(ErrorCode::kIo, target_.string(),
                fmt::format("cannot be written: {}", std::generic_category().message(error)));
  }

  std::filesystem::path target_;
  std::string path_;
  int descriptor_;
  bool committed_ = false;
};

/// Those of the file that is replaced, else what the umask leaves of rw-rw-rw-.
mode_t permissions_for(const std::filesystem::path& file) {
  struct stat status = {};
  if (::stat(file.c_str(), &status) == 0) return status.st_mode & 07777;
  const mode_t mask = ::umask(0);
  ::umask(mask);
  return 0666 & ~mask;
}

}  // namespace

std::string to_text(const Project& project) {
  const json::Node minimal = build(project, false);
  if (!project.original) return json::write(minimal, "");
  const std::string name = project.file.string();
  Document original{name, json::parse(*project.original, name)};
  json::locate(original.root, *project.original);
  return json::write(merge(original, build(project, true), minimal), *project.original);
}

void save(const Project& project, const std::filesystem::path& file) {
  const std::string text = to_text(project);
  std::error_code error;
  if (std::filesystem::is_directory(file, error)) {
    throw Error(ErrorCode::kIo, file.string(), "cannot be written: it is a directory");
  }
  // A link stays a link: what it points to is replaced.
  const std::filesystem::path real = std::filesystem::weakly_canonical(file, error);
  const std::filesystem::path& target = error ? file : real;
  PendingFile pending(target);
  pending.write(text);
  pending.commit(permissions_for(target));
}

}  // namespace morphkit::project
