#pragma once
// Several editors on one project: each has an autosave of its own, and knows of the others.

#include <filesystem>
#include <string>
#include <vector>

#include "base/descriptor.h"

namespace morphkit::edit {

/// The place of one editor at a project. Advisory: it keeps editors from taking one another's autosaves and tells who
/// else is there. A hidden file beside the project, `.pair.json.autosave.lock`, is locked (flock) while the object
/// lives, and removed with it; it holds the process and the host for people. Where no file can be written or locked,
/// the place is the first one, unprotected.
class ProjectLock {
 public:
  /// An unprotected first place.
  explicit ProjectLock(const std::filesystem::path& project_file);
  /// The first free place that has an autosave left by an editor that is gone, else the first free one.
  static ProjectLock claim(const std::filesystem::path& project_file);

  ProjectLock(ProjectLock&&) noexcept = default;
  ProjectLock& operator=(ProjectLock&&) = delete;
  ~ProjectLock();

  /// The autosave of this place: `pair.json.autosave`, `pair.json.autosave-2`, ...
  const std::filesystem::path& autosave_file() const noexcept { return autosave_; }

  /// Who else has the project open: "process 123 on host".
  const std::vector<std::string>& others() const noexcept { return others_; }

 private:
  std::filesystem::path autosave_, lock_file_;
  Descriptor lock_;
  std::vector<std::string> others_;
};

}  // namespace morphkit::edit
