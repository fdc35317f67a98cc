#pragma once
// The preview tool without its window: events in, pictures out. The caller passes the time, so tests control it.

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include <opencv2/core.hpp>

#include "cli/edit/document/storage.h"
#include "cli/edit/hand/gestures.h"
#include "cli/edit/view/canvas.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/preview_thread.h"
#include "cli/edit/view/pyramid.h"
#include "morph/render/footage.h"

namespace morphkit::edit {

/// How long changes wait before they are written to the autosave, s.
inline constexpr double kAutosaveAfter = 3;
/// How often the project file is checked for changes by other programs, s.
inline constexpr double kFileCheckEvery = 1;

class Editor {
 public:
  /// @param project   its `file` need not exist.
  /// @param footage   the pictures of the project; their pixels are shared.
  /// @param canvas    size of the window, px, at least kMinCanvas.
  /// @param lock      the place of this editor at the project; nothing: an unprotected one.
  Editor(project::Project project, const render::Footage& footage, cv::Size canvas,
         std::optional<ProjectLock> lock = std::nullopt);

  void mouse(const Mouse& event);
  void key(int key);

  /// One turn of the event loop at time `now`, s: plays, fetches previews, autosaves, checks the project file.
  void turn(double now);

  /// Whether the canvas must be drawn again.
  bool dirty() const noexcept { return dirty_; }
  /// The canvas, BGR; valid until the next call.
  const cv::Mat3b& draw();

  /// Closes the editor. Asks first if there are unsaved changes.
  void close();
  bool done() const noexcept { return done_; }
  /// Writes unsaved changes to the autosave at once. For the end of the program.
  /// @return what happened, for a message. Does not throw.
  std::string rescue() noexcept;

  /// Waits for the preview of the current state. For the benchmark.
  void finish_preview();

  const Model& model() const noexcept { return model_; }
  const Storage& storage() const noexcept { return storage_; }
  std::string title() const;  ///< of the window

 private:
  enum class Asked { kNothing, kRestore, kClose, kOverwrite };

  void handle_request(std::optional<EditorRequest> request);
  void ask(Asked what, Question question);
  void offer_recovery();
  void set_recovery_aside();
  void take_answer();
  bool save(bool over_changes_of_others);
  void reload_file();
  void check_file();
  void keep_autosave();
  void drop_autosave();
  void request_preview();
  void take_preview();
  void say(std::string message);
  void complain(std::string message);  ///< in red: something was not done

  Pyramid source_, destination_;
  std::optional<Pyramid> background_;
  Model model_;
  Gestures gestures_;
  Storage storage_;
  Canvas canvas_;
  PreviewPicture preview_;
  Asked asked_ = Asked::kNothing;
  std::optional<Recovery> recovery_;
  bool close_after_save_ = false;
  bool dirty_ = true;
  bool done_ = false;
  double now_ = 0;
  bool started_ = false;
  double file_checked_ = 0;
  static constexpr std::uint64_t kNoRevision = ~std::uint64_t{0};
  std::uint64_t stored_revision_ = kNoRevision;  ///< the newest one in the file or the autosave
  std::optional<double> unstored_since_;         ///< time of the first newer revision, s
  bool autosave_exists_ = false;
  std::optional<PreviewRequest> requested_;
  std::uint64_t requested_revision_ = 0;
  PreviewThread thread_;  ///< last member: it uses the pyramids and must stop first
};

}  // namespace morphkit::edit
