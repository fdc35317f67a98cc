#pragma once
// The files of the preview tool: the project, and the autosave beside it.

#include <filesystem>
#include <future>
#include <optional>
#include <string>
#include <vector>

#include "cli/edit/document/project_lock.h"
#include "morph/project/project.h"

namespace morphkit::edit {

/// An autosave of a session that did not end normally.
struct Recovery {
  std::optional<project::Project> project;  ///< nothing: unreadable
  std::string when;                         ///< local time, "2026-11-23 14:05"
};

/// Checks that the project can be saved. @throws Error kIo if its file cannot be written; errors of project::to_text.
void require_savable(const project::Project& project);

class Storage {
 public:
  /// @param project  as loaded from its `file`; without `original`, a file that does not exist yet.
  /// @param lock     the place of this editor; its autosave is ours.
  explicit Storage(const project::Project& project);
  Storage(const project::Project& project, ProjectLock lock);
  ~Storage();

  const std::filesystem::path& file() const noexcept { return file_; }
  const std::filesystem::path& autosave_file() const noexcept { return lock_.autosave_file(); }

  /// Who else has the project open.
  const std::vector<std::string>& others() const noexcept { return lock_.others(); }

  /// Writes the project, atomically, and removes the autosave.
  /// @return the project as saved. @throws Error kIo; the file is then unchanged.
  project::Project save(project::Project project);

  /// Whether another program has changed the file since it was last read or written here. Compares time and size first,
  /// so frequent calls are cheap. A deleted file counts as unchanged.
  bool changed_by_others();
  /// The same, but true only once per change.
  bool new_change_by_others();
  /// Loads the file. It counts as changed until `accept`. @throws Error as project::load.
  project::Project read();
  /// Accepts the content of the last `read`.
  void accept();

  /// Writes the project beside its file, in the background. @return false if the last one is still being written.
  bool autosave(const project::Project& project);
  /// Error message of an autosave since the last call; empty if there was none.
  std::string autosave_problem();
  /// Waits for the autosave that is being written.
  void finish();
  void drop_autosave();
  /// Writes the autosave before the program ends, if necessary to the folder for temporary files.
  /// @return its path. @throws Error kIo.
  std::filesystem::path rescue(const project::Project& project);

  /// The autosave, if there is one and it differs from the file.
  std::optional<Recovery> recovery() const;
  /// Renames the autosave to a free name, so that it is kept. @return the name; nothing if renaming failed.
  std::optional<std::filesystem::path> set_autosave_aside();

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  std::optional<Stamp> stamp() const;

  /// The autosave beside the project, or the one that `rescue` had to write elsewhere; the newer one if there are both.
  std::filesystem::path newest_autosave() const;

  std::filesystem::path file_;
  ProjectLock lock_;
  std::optional<std::string> known_;  ///< text of the file when last read or written; nothing: no file
  std::optional<Stamp> stamp_;        ///< of `known_`
  std::optional<Stamp> reported_;     ///< of the last change that `new_change_by_others` reported
  std::optional<std::string> read_;   ///< text of the last `read`
  std::optional<Stamp> read_stamp_;
  std::future<std::string> writing_;  ///< gives the error message
  std::string problem_;
};

}  // namespace morphkit::edit
