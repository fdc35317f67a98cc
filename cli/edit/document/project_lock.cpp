#include "cli/edit/document/project_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/error.h"
#include "base/whole_file.h"

namespace morphkit::edit {
namespace {

namespace fs = std::filesystem;

constexpr int kPlaces = 9;

fs::path autosave_of(const fs::path& project_file, int place) {
  fs::path file = project_file;
  file += place == 1 ? ".autosave" : fmt::format(".autosave-{}", place);
  return file;
}

fs::path lock_of(const fs::path& autosave) {
  return autosave.parent_path() / fmt::format(".{}.lock", autosave.filename().string());
}

bool still_there(int descriptor, const fs::path& file) {
  struct stat ours = {}, there = {};
  return ::fstat(descriptor, &ours) == 0 && ::stat(file.c_str(), &there) == 0 && ours.st_ino == there.st_ino &&
         ours.st_dev == there.st_dev;
}

enum class Claim { kOurs, kTaken, kImpossible };

Claim try_lock(const fs::path& file, Descriptor& lock) {
  for (;;) {
    Descriptor opened(::open(file.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, 0666));
    if (opened.get() < 0) return Claim::kImpossible;
    if (::flock(opened.get(), LOCK_EX | LOCK_NB) != 0) return errno == EWOULDBLOCK ? Claim::kTaken : Claim::kImpossible;
    if (!still_there(opened.get(), file)) continue;  // its owner has just removed it
    lock = std::move(opened);
    return Claim::kOurs;
  }
}

void sign(int descriptor) {
  std::array<char, 256> host = {};
  if (::gethostname(host.data(), host.size() - 1) != 0) host[0] = '?';
  const std::string text = fmt::format("process {} on {}\n", ::getpid(), host.data());
  if (::ftruncate(descriptor, 0) != 0 || ::write(descriptor, text.data(), text.size()) < 0)
    errno = 0;  // for people only
}

std::string signature(const fs::path& file) {
  try {
    constexpr std::size_t kMost = 1000;
    const std::string text = read_file(file, "lock", kMost);
    return text.substr(0, text.find('\n'));
  } catch (const Error&) {
    return "another process";
  }
}

}  // namespace

ProjectLock::ProjectLock(const fs::path& project_file) : autosave_(autosave_of(project_file, 1)) {}

ProjectLock ProjectLock::claim(const fs::path& project_file) {
  ProjectLock result(project_file);
  for (int place = 1; place <= kPlaces; ++place) {
    const fs::path autosave = autosave_of(project_file, place);
    const fs::path file = lock_of(autosave);
    std::error_code error;
    const bool orphan = fs::exists(autosave, error);
    if (place > 1 && result.lock_.get() >= 0 && !orphan && !fs::exists(file, error)) continue;
    Descriptor lock;
    const Claim claim = try_lock(file, lock);
    if (claim == Claim::kImpossible) break;
    if (claim == Claim::kTaken) {
      result.others_.push_back(signature(file));
      continue;
    }
    const bool better = result.lock_.get() < 0 || (orphan && !fs::exists(result.autosave_, error));
    if (!better) {
      ::unlink(file.c_str());
      continue;
    }
    if (result.lock_.get() >= 0) ::unlink(result.lock_file_.c_str());
    result.lock_ = std::move(lock);
    result.autosave_ = autosave;
    result.lock_file_ = file;
  }
  if (result.lock_.get() >= 0) sign(result.lock_.get());
  return result;
}

ProjectLock::~ProjectLock() {
  if (lock_.get() >= 0) ::unlink(lock_file_.c_str());
}

}  // namespace morphkit::edit
