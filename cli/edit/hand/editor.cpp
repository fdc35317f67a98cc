#include "cli/edit/hand/editor.h"

#include <algorithm>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/error.h"
#include "cli/edit/hand/snap.h"

namespace morphkit::edit {
namespace {

EdgeFinder edges_of(const Pyramid& source, const Pyramid& destination) {
  return [&](SideIndex side, cv::Point2d position, double radius, double zoom) {
    return strongest_edge(side == project::kSource ? source : destination, position, radius, zoom);
  };
}

bool same_view(const PreviewRequest& a, const PreviewRequest& b) {
  return a.t == b.t && a.show == b.show && a.folds == b.folds && a.view == b.view && a.size == b.size;
}

/// Whether both sides name the same file, however it is spelled.
bool same_picture(const project::Project& a, const project::Picture& of_a, const project::Project& b,
                  const project::Picture& of_b) {
  project::Picture renamed = of_a;
  renamed.image = of_b.image;
  std::error_code error;
  return renamed == of_b &&
         (of_a.image == of_b.image ||
          std::filesystem::equivalent(project::resolve(a, of_a.image), project::resolve(b, of_b.image), error));
}

bool same_pictures(const project::Project& a, const project::Project& b) {
  return std::ranges::equal(a.pictures, b.pictures, [&](const project::Picture& of_a, const project::Picture& of_b) {
    return same_picture(a, of_a, b, of_b);
  });
}

/// The project as its file has it; without a file, its pictures. What it came with beyond that is the first change.
project::Project last_saved(const project::Project& project) {
  if (project.original) return project::parse(*project.original, project.file);
  project::Project begun;
  begun.pictures = project.pictures;
  begun.file = project.file;
  return begun;
}

}  // namespace

Editor::Editor(project::Project project, const render::Footage& footage, cv::Size canvas,
               std::optional<ProjectLock> lock)
    : source_(footage.pictures[project::kSource].at(1)),
      destination_(footage.pictures[project::kDestination].at(1)),
      background_(footage.background ? std::optional<Pyramid>(footage.background->at(1)) : std::nullopt),
      model_(last_saved(project), source_.size(), destination_.size(), canvas),
      gestures_(model_, edges_of(source_, destination_)),
      storage_(model_.document.project(), lock ? std::move(*lock) : ProjectLock(model_.document.project().file)),
      canvas_(source_, destination_),
      thread_(source_, destination_, background_ ? &*background_ : nullptr) {
  if (!project::same_document(project, model_.document.project())) model_.document.replace(std::move(project));
  const project::Project& loaded = model_.document.project();
  model_.fit_views();
  model_.file_name = storage_.file().filename().string();
  model_.welcome = loaded.features.empty() && !loaded.mesh;
  if (loaded.mesh && project::method_name_of(loaded) == project::MethodName::kMesh) model_.tool = ToolId::kMesh;
  if (!model_.document.changed()) stored_revision_ = model_.document.revision();
  if (!storage_.others().empty())
    complain(fmt::format("{} is also being edited by {}", model_.file_name, fmt::join(storage_.others(), ", ")));
  recovery_ = storage_.recovery();
  if (recovery_) offer_recovery();
}

/// Asks whether to restore it. Sets it aside if it belongs to other pictures.
void Editor::offer_recovery() {
  if (recovery_->project && same_pictures(*recovery_->project, model_.document.project())) {
    ask(Asked::kRestore, {"Unsaved work was found",
                          {fmt::format("{} was being changed until {}", model_.file_name, recovery_->when),
                           "and not saved when the program ended."},
                          {{'r', "Restore it (r)"}, {'d', "Discard it (d)"}, {'n', "Not now (n)"}}});
    return;
  }
  set_recovery_aside();
}

void Editor::set_recovery_aside() {
  recovery_.reset();
  const std::optional<std::filesystem::path> aside = storage_.set_autosave_aside();
  say(aside ? fmt::format("unsaved work of an earlier session is kept in {}", aside->filename().string())
            : "unsaved work of an earlier session could not be put aside");
}

std::string Editor::title() const {
  if (model_.question) return fmt::format("{} - morphkit", model_.question->title);
  return fmt::format("{}{} - morphkit", model_.document.changed() ? "*" : "", model_.file_name);
}

void Editor::mouse(const Mouse& event) {
  if (event.what == Mouse::What::kPress) model_.message.clear();
  handle_request(gestures_.mouse(event));
  dirty_ = true;
}

void Editor::key(int key) {
  model_.message.clear();
  handle_request(gestures_.key(key));
  dirty_ = true;
}

void Editor::handle_request(std::optional<EditorRequest> request) {
  if (request == EditorRequest::kSave) save(false);
  if (request == EditorRequest::kClose) close();
}

void Editor::say(std::string message) {
  model_.message = std::move(message);
  model_.complaint = false;
  dirty_ = true;
}

void Editor::complain(std::string message) {
  say(std::move(message));
  model_.complaint = true;
}

void Editor::ask(Asked what, Question question) {
  asked_ = what;
  model_.question = std::move(question);
  model_.answer.reset();
  dirty_ = true;
}

void Editor::turn(double now) {
  if (started_) {
    const double t = model_.t;
    gestures_.tick(now - now_);
    if (model_.t != t) dirty_ = true;
  }
  started_ = true;
  now_ = now;
  if (model_.answer) take_answer();
  check_file();
  keep_autosave();
  request_preview();
  take_preview();
}

const cv::Mat3b& Editor::draw() {
  dirty_ = false;
  return canvas_.draw(model_, preview_);
}

void Editor::take_answer() {
  const char answer = *model_.answer;
  model_.question.reset();
  model_.answer.reset();
  dirty_ = true;
  const auto asked = std::exchange(asked_, Asked::kNothing);
  if (asked == Asked::kRestore) {
    if (answer == 'r') {
      model_.document.replace(std::move(*recovery_->project));
      model_.welcome = false;
      autosave_exists_ = true;
      say("restored; s saves it");
    } else if (answer == 'd') {
      storage_.drop_autosave();
    } else {
      set_recovery_aside();
    }
    recovery_.reset();
  } else if (asked == Asked::kClose) {
    if (answer == 's') {
      close_after_save_ = true;
      if (save(false)) done_ = true;
    } else if (answer == 'd') {
      storage_.drop_autosave();
      done_ = true;
    }
  } else if (asked == Asked::kOverwrite) {
    if (answer == 'o' && save(true) && close_after_save_) done_ = true;
    if (answer == 't') reload_file();
    close_after_save_ = false;
  }
}

bool Editor::save(bool over_changes_of_others) {
  if (!over_changes_of_others && storage_.changed_by_others()) {
    ask(Asked::kOverwrite, {fmt::format("{} has been changed by another program", model_.file_name),
                            {"Saving would overwrite what it wrote. Theirs can be taken instead;",
                             "your own state then stays one step of undo away."},
                            {{'o', "Overwrite it (o)"}, {'t', "Take theirs (t)"}, {'c', "Cancel (c)"}}});
    return false;
  }
  try {
    model_.document.mark_saved(storage_.save(model_.document.project()));
  } catch (const Error& error) {
    close_after_save_ = false;
    complain(fmt::format("not saved: {}", error.what()));
    return false;
  }
  autosave_exists_ = false;
  stored_revision_ = model_.document.revision();
  say(fmt::format("saved {}", model_.file_name));
  return true;
}

void Editor::reload_file() {
  try {
    project::Project theirs = storage_.read();
    if (!same_pictures(theirs, model_.document.project())) {
      say(fmt::format("{} names other pictures now: close and open it again", model_.file_name));
      return;
    }
    storage_.accept();
    model_.document.replace(theirs);
    model_.document.mark_saved(theirs);
    say(fmt::format("{} was changed by another program; this is what it says now", model_.file_name));
  } catch (const Error& error) {
    complain(fmt::format("not taken: {}", error.what()));
  }
}

void Editor::check_file() {
  if (now_ - file_checked_ < kFileCheckEvery || model_.document.in_step() || model_.question) return;
  file_checked_ = now_;
  if (!storage_.new_change_by_others()) return;
  if (model_.document.changed()) {
    say(fmt::format("{} has been changed by another program; s asks what to do", model_.file_name));
  } else {
    reload_file();
  }
}

void Editor::keep_autosave() {
  if (std::string problem = storage_.autosave_problem(); !problem.empty()) {
    complain(fmt::format("autosave failed: {}", problem));
    stored_revision_ = kNoRevision;
    unstored_since_ = now_;
  }
  if (asked_ == Asked::kRestore) return;  // the autosave on disk is still needed
  const std::uint64_t revision = model_.document.revision();
  if (revision == stored_revision_) {
    unstored_since_.reset();
    return;
  }
  if (!unstored_since_) unstored_since_ = now_;
  if (now_ - *unstored_since_ < kAutosaveAfter) return;
  if (!model_.document.changed()) {
    drop_autosave();
  } else if (storage_.autosave(model_.document.project())) {
    autosave_exists_ = true;
  } else {
    return;
  }
  stored_revision_ = revision;
}

void Editor::drop_autosave() {
  if (std::exchange(autosave_exists_, false)) storage_.drop_autosave();
}

std::string Editor::rescue() noexcept try {
  if (!model_.document.changed()) return "nothing was unsaved";
  // An earlier autosave still waits for its answer.
  if (std::exchange(asked_, Asked::kNothing) == Asked::kRestore) storage_.set_autosave_aside();
  return fmt::format("what was not saved is in {}", storage_.rescue(model_.document.project()).string());
} catch (const std::exception& error) {
  return fmt::format("what was not saved is lost: {}", error.what());
}

void Editor::close() {
  if (!model_.document.changed()) {
    drop_autosave();
    done_ = true;
    return;
  }
  ask(Asked::kClose, {fmt::format("Save {} before closing?", model_.file_name),
                      {"Changes since the last save would be lost."},
                      {{'s', "Save and close (s)"}, {'d', "Close without saving (d)"}, {'c', "Cancel (c)"}}});
}

void Editor::request_preview() {
  PreviewRequest request;
  request.t = model_.t;
  request.show = model_.show;
  request.folds = model_.switches.folds;
  request.view = model_.result_view;
  request.size = panes_of(model_.canvas_size).pane(Pane::kResult).size();
  const std::uint64_t revision = model_.document.revision();
  if (requested_ && same_view(*requested_, request) && requested_revision_ == revision) return;
  const bool same_project = requested_ && requested_revision_ == revision;
  request.project =
      same_project ? requested_->project : std::make_shared<const project::Project>(model_.document.project());
  request.number = requested_ ? requested_->number + 1 : 1;
  requested_ = request;
  requested_revision_ = revision;
  thread_.request(std::move(request));
}

void Editor::take_preview() {
  std::optional<PreviewPicture> picture = thread_.take();
  if (!picture) return;
  preview_ = std::move(*picture);
  dirty_ = true;
}

void Editor::finish_preview() {
  request_preview();
  thread_.finish();
  take_preview();
}

}  // namespace morphkit::edit
