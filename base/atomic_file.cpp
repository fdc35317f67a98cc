#include "base/atomic_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <charconv>
#include <cstdio>
#include <cstring>
#include <string_view>
#include <system_error>

#include "base/descriptor.h"
#include "base/error.h"

namespace morphkit {
namespace {

namespace fs = std::filesystem;

/// Longest part of the final stem in the temporary name, bytes. The rest of the 255 bytes of a name is for the dot, the
/// numbers and the extension.
constexpr std::size_t kLongestStem = 150;

constexpr mode_t kPermissionBits = 07777;

[[noreturn]] void fail(const std::string& place, const std::string& message) {
  throw Error(ErrorKind::kIo, place, message);
}

[[noreturn]] void fail_errno(const std::string& place, const char* what, int error) {
  fail(place, fmt::format("{}: {}", what, std::generic_category().message(error)));
}

constexpr std::string_view kMark = ".tmp";

/// The number of the next temporary file of this process.
std::atomic<unsigned> next_number{0};

std::string cut_name(const fs::path& final_name) {
  return final_name.stem().string().substr(0, kLongestStem) + final_name.extension().string();
}

std::string temporary_name(const fs::path& final_name, unsigned number) {
  const std::string stem = final_name.stem().string().substr(0, kLongestStem);
  return fmt::format(".{}.{}.{}{}{}", stem, static_cast<long>(::getpid()), number, kMark,
                     final_name.extension().string());
}

/// What a temporary name says.
struct TemporaryName {
  std::string final_name;  ///< cut
  long process = 0;
  unsigned number = 0;
};

/// Takes the number behind the last dot of `text` off. @return whether there is one.
template <typename Number>
bool take_number(std::string_view& text, Number& value) {
  const std::size_t dot = text.rfind('.');
  if (dot == std::string_view::npos) return false;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data() + dot + 1, end, value);
  text.remove_suffix(text.size() - dot);
  return error == std::errc() && stop == end;
}

/// The reverse of temporary_name; nothing for other names.
std::optional<TemporaryName> parse_temporary(std::string_view name) {
  const std::size_t mark = name.rfind(kMark);
  if (mark == std::string_view::npos || !name.starts_with('.')) return std::nullopt;
  const std::string_view extension = name.substr(mark + kMark.size());
  if (!extension.empty() && extension.front() != '.') return std::nullopt;
  std::string_view stem = name.substr(1, mark - 1);
  TemporaryName result;
  if (!take_number(stem, result.number) || !take_number(stem, result.process) || stem.empty()) return std::nullopt;
  result.final_name = std::string(stem) + std::string(extension);
  return result;
}

/// Removes a temporary file whose owner is gone.
void remove_if_abandoned(const fs::path& file) {
  const Descriptor descriptor(::open(file.c_str(), O_WRONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC));
  if (descriptor.get() >= 0 && ::flock(descriptor.get(), LOCK_EX | LOCK_NB) == 0) ::unlink(file.c_str());
}

/// Locks a temporary file that was just created. @return false if another program has removed it before.
bool lock_new(int descriptor) {
  while (::flock(descriptor, LOCK_EX) != 0 && errno == EINTR) {
  }
  struct stat status = {};
  return ::fstat(descriptor, &status) != 0 || status.st_nlink > 0;
}

fs::path follow_links(const fs::path& name) {
  std::error_code error;
  if (!fs::is_symlink(fs::symlink_status(name, error))) return name;
  const fs::path target = fs::weakly_canonical(name, error);
  return error ? name : target;
}

/// rename() that does not replace. The kernel checks and renames in one step if the file system supports it; otherwise
/// we check first.
int rename_new(const char* from, const char* to) {
  if (::renameat2(AT_FDCWD, from, AT_FDCWD, to, RENAME_NOREPLACE) == 0) return 0;
  if (errno != EINVAL && errno != ENOSYS) return -1;
  if (::access(to, F_OK) == 0) {
    errno = EEXIST;
    return -1;
  }
  return std::rename(from, to);
}

void write_all(int descriptor, std::span<const std::uint8_t> bytes, const std::string& place) {
  while (!bytes.empty()) {
    const ssize_t written = ::write(descriptor, bytes.data(), bytes.size());
    if (written < 0) {
      if (errno == EINTR) continue;
      fail_errno(place, "cannot be written", errno);
    }
    bytes = bytes.subspan(static_cast<std::size_t>(written));
  }
}

/// Some file systems have no permissions. The contents matter more, so a failure is ignored.
void set_mode(int descriptor, mode_t mode) {
  if (::fchmod(descriptor, mode) != 0) errno = 0;
}

}  // namespace

AtomicFile::AtomicFile(const fs::path& final_name, bool overwrite, Leftovers leftovers)
    : shown_(final_name.string()), final_(follow_links(final_name)), overwrite_(overwrite) {
  if (final_.filename().empty()) fail(shown_, "is not a file name");
  std::error_code error;
  const fs::path folder = final_.has_parent_path() ? final_.parent_path() : fs::path(".");
  const fs::file_status folder_status = fs::status(folder, error);
  if (!fs::exists(folder_status)) {
    fail(shown_, fmt::format("the folder {} does not exist; create it first", folder.string()));
  }
  if (!fs::is_directory(folder_status)) fail(shown_, fmt::format("{} is not a folder", folder.string()));
  const fs::file_status status = fs::status(final_, error);
  if (fs::is_directory(status)) fail(shown_, "is a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) fail(shown_, "is not a regular file");
  if (fs::exists(status) && !overwrite_) throw FileExists(shown_);
  if (leftovers == Leftovers::kRemove) {
    remove_leftovers(folder, [name = cut_name(final_)](const std::string& found) { return found == name; });
  }
  reserve();
}

AtomicFile::~AtomicFile() {
  if (!committed_ && !temporary_.empty()) ::unlink(temporary_.c_str());
}

void AtomicFile::reserve() {
  for (;;) {
    const fs::path name = final_.parent_path() / temporary_name(final_, next_number++);
    Descriptor descriptor(::open(name.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
    if (descriptor.get() < 0) {
      if (errno == EEXIST) continue;
      fail_errno(shown_, "cannot be created", errno);
    }
    if (!lock_new(descriptor.get())) continue;
    // From the start, others get no more permissions than on the replaced file. We ourselves must be able to write.
    struct stat old = {};
    if (::stat(final_.c_str(), &old) == 0) {
      mode_ = old.st_mode & kPermissionBits;
      set_mode(descriptor.get(), *mode_ | S_IRUSR | S_IWUSR);
    }
    temporary_ = name;
    lock_ = std::move(descriptor);
    return;
  }
}

void AtomicFile::write(std::span<const std::uint8_t> bytes) {
  Descriptor descriptor(::open(temporary_.c_str(), O_WRONLY | O_TRUNC | O_CLOEXEC));
  if (descriptor.get() < 0) fail_errno(shown_, "cannot be written", errno);
  write_all(descriptor.get(), bytes, shown_);
  if (!descriptor.close()) fail_errno(shown_, "cannot be written", errno);
}

void AtomicFile::commit() {
  {
    // Without the flush, a power cut after the rename could leave an empty file under the final name, and a network
    // file system could report a full disk too late.
    Descriptor descriptor(::open(temporary_.c_str(), O_RDONLY | O_CLOEXEC));
    if (descriptor.get() < 0) fail_errno(shown_, "its temporary file is gone", errno);
    struct stat written = {};
    if (::fstat(descriptor.get(), &written) != 0) fail_errno(shown_, "cannot be written", errno);
    if (written.st_size == 0) fail(shown_, "nothing was written; is the disk full?");
    if (mode_) set_mode(descriptor.get(), *mode_);
    if (::fsync(descriptor.get()) != 0 && errno != EINVAL) fail_errno(shown_, "cannot be written", errno);
    if (!descriptor.close()) fail_errno(shown_, "cannot be written", errno);
  }
  const int result =
      overwrite_ ? std::rename(temporary_.c_str(), final_.c_str()) : rename_new(temporary_.c_str(), final_.c_str());
  if (result != 0) {
    if (errno == EEXIST) throw FileExists(shown_);
    fail_errno(shown_, "cannot be put in place", errno);
  }
  committed_ = true;
}

void remove_leftovers(const fs::path& folder, const std::function<bool(const std::string&)>& is_ours) {
  std::error_code error;
  for (fs::directory_iterator entry(folder, error), end; !error && entry != end; entry.increment(error)) {
    const std::optional<TemporaryName> name = parse_temporary(entry->path().filename().string());
    if (!name || !is_ours(name->final_name)) continue;
    // A network file system may grant one process the same lock twice.
    const bool in_work_here = name->process == static_cast<long>(::getpid()) && name->number < next_number;
    if (!in_work_here) remove_if_abandoned(entry->path());
  }
}

void write_file(const fs::path& file, std::span<const std::uint8_t> bytes, bool overwrite) {
  AtomicFile target(file, overwrite);
  target.write(bytes);
  target.commit();
}

}  // namespace morphkit
