#pragma once
// The files of the preview tool: the project, and the autosave beside it.

#include <filesystem>
#include <future>
#include <optional>
#include <string>

#include "morph/project/project.h"

namespace morphkit::edit {

/// What an earlier session that did not end well has left.
struct Leftover {
  std::optional<project::Project> project;  ///< nothing: it cannot be read
  std::string when;                         ///< local time, "2026-11-23 14:05"
};

/// @throws Error kIo if no file could be written at the project's place, or what project::to_text says.
void require_savable(const project::Project& project);

class Storage {
 public:
  /// @param project  as loaded from its `file`; without `original`, a file that does not exist yet.
  explicit Storage(const project::Project& project);
  ~Storage();

  const std::filesystem::path& file() const noexcept { return file_; }
  std::filesystem::path autosave_file() const;

  /// Writes the project, atomically, and removes the autosave.
  /// @return the project as the file has it now. @throws Error kIo; the file is then what it was.
  project::Project save(project::Project project);

  /// Whether the file holds something else than what was last read or written here. Looks at the file's time and size
  /// first, so it may be asked often. A file that has gone away has not changed.
  bool changed_by_others();
  /// The same, but true only once for what is there.
  bool news_of_others();
  /// What the file holds now. It counts as changed until it is accepted. @throws Error as project::load.
  project::Project read();
  /// What was read last is known from now on.
  void accept();

  /// Writes the project beside its file, in the background. @return false if the last one is still being written.
  bool autosave(const project::Project& project);
  /// What went wrong with an autosave since the last call, in a sentence; empty if nothing did.
  std::string autosave_problem();
  /// Waits for the autosave that is being written.
  void finish();
  void drop_autosave();
  /// The last moment before the program ends: writes the autosave, if need be to the folder for temporary files.
  /// @return where it is. @throws Error kIo.
  std::filesystem::path rescue(const project::Project& project);

  /// The autosave that is there, if it says something else than the file.
  std::optional<Leftover> leftover() const;
  /// Gives the autosave a name that nothing is written to. @return the name; nothing if it could not be renamed.
  std::optional<std::filesystem::path> set_autosave_aside();

 private:
  struct Stamp {
    std::filesystem::file_time_type time;
    std::uintmax_t size = 0;
    bool operator==(const Stamp&) const = default;
  };
  std::optional<Stamp> stamp() const;

  std::filesystem::path file_;
  std::optional<std::string> known_;  ///< text of the file as last read or written; nothing: no file
  std::optional<Stamp> stamp_;        ///< of `known_`
  std::optional<Stamp> told_;         ///< of what `news_of_others` has told of
  std::optional<std::string> read_;   ///< and its stamp: what `read` has read
  std::optional<Stamp> read_stamp_;
  std::future<std::string> writing_;  ///< gives what went wrong
  std::string problem_;
};

}  // namespace morphkit::edit
