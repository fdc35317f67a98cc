#pragma once
// The preview tool without its window: events in, pictures out. Time is told, never looked up, so that tests can play.

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
#include "morph/render/stage.h"

namespace morphkit::edit {

/// How long changes wait before they are written to the autosave, s.
inline constexpr double kAutosaveAfter = 3;
/// How often the project file is looked at for changes by others, s.
inline constexpr double kLookAtFileEvery = 1;

class Editor {
 public:
  /// @param project  with its `file`, which need not exist. @param pictures  its pictures; their pixels are shared.
  /// @param canvas   size of the window, px, at least kLeastCanvas.
  Editor(project::Project project, const render::Pictures& pictures, cv::Size canvas);

  void mouse(const Mouse& event);
  void key(int key);

  /// One turn of the event loop at the moment `now`, s: plays, fetches previews, saves, notices.
  void turn(double now);

  /// Whether `draw` would give another picture than the last time.
  bool stale() const noexcept { return stale_; }
  /// The canvas, BGR; valid until the next call.
  const cv::Mat3b& draw();

  /// The person wants to leave: asks if something would be lost.
  void close();
  bool done() const noexcept { return done_; }
  /// The program is about to be ended: what is not saved goes to the autosave, now.
  /// @return what became of it, in a few words for a message. Does not throw.
  std::string rescue() noexcept;

  /// What the preview last needed, for the benchmark: waits until it is there.
  void finish_preview();

  const Model& model() const noexcept { return model_; }
  const Storage& storage() const noexcept { return storage_; }
  std::string title() const;  ///< of the window

 private:
  enum class Asked { kNothing, kRestore, kClose, kOverwrite };

  void grant(std::optional<Wish> wish);
  void ask(Asked what, Question question);
  void meet_leftover();
  void put_leftover_aside();
  void take_answer();
  bool save(bool over_changes_of_others);
  void take_theirs();
  void look_at_file();
  void keep_autosave();
  void drop_autosave();
  void request_preview();
  void take_preview();
  void say(std::string message);

  Pyramid source_, destination_;
  Model model_;
  Gestures gestures_;
  Storage storage_;
  Canvas canvas_;
  PreviewPicture preview_;
  Asked asked_ = Asked::kNothing;
  std::optional<Leftover> leftover_;
  bool close_after_save_ = false;
  bool stale_ = true;
  bool done_ = false;
  double now_ = 0;
  bool started_ = false;
  double looked_at_file_ = 0;
  static constexpr std::uint64_t kNoRevision = ~std::uint64_t{0};
  std::uint64_t kept_revision_ = kNoRevision;  ///< the last one that a file has
  std::optional<double> unkept_since_;         ///< when a later one came to be, s
  bool autosave_is_there_ = false;
  std::optional<PreviewRequest> requested_;
  std::uint64_t requested_revision_ = 0;
  PreviewThread thread_;  ///< last: it uses the pyramids, and stops first
};

}  // namespace morphkit::edit
