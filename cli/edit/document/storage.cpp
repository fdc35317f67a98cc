#include "cli/edit/document/storage.h"

#include <sys/stat.h>
#include <unistd.h>

#include <chrono>
#include <cstdint>
#include <ctime>
#include <memory>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/error.h"
#include "base/whole_file.h"

namespace morphkit::edit {
namespace {

namespace fs = std::filesystem;

std::optional<std::string> text_of(const fs::path& file) {
  std::string text;
  try {
    text = read_file(file, "project");
  } catch (const Error&) {
    return std::nullopt;
  }
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) text.erase(0, kByteOrderMark.size());
  return text;
}

void write_text(const fs::path& file, const std::string& text) {
  write_file(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, true);
}

/// Where an autosave goes that cannot be written beside its project: a name of its own for every project.
fs::path elsewhere(const fs::path& autosave) {
  std::error_code error;
  const std::string path = fs::absolute(autosave, error).lexically_normal().string();
  std::uint64_t hash = 0xcbf29ce484222325;  // FNV-1a, 64 bits
  for (const char letter : path) hash = (hash ^ static_cast<unsigned char>(letter)) * 0x100000001b3;
  return fs::temp_directory_path(error) / fmt::format("morphkit-{:016x}-{}", hash, autosave.filename().string());
}

/// In a folder that everybody may write to, only our own files count.
bool is_ours(const fs::path& file) {
  struct stat status = {};
  return ::lstat(file.c_str(), &status) == 0 && S_ISREG(status.st_mode) && status.st_uid == ::geteuid();
}

std::string local_time(fs::file_time_type time) {
  const auto since_now = std::chrono::duration_cast<std::chrono::seconds>(time - fs::file_time_type::clock::now());
  const std::time_t seconds = std::chrono::system_clock::to_time_t(std::chrono::system_clock::now() + since_now);
  std::tm parts = {};
  localtime_r(&seconds, &parts);
  char text[sizeof("2026-11-23 14:05")] = {};
  std::strftime(text, sizeof text, "%Y-%m-%d %H:%M", &parts);
  return text;
}

}  // namespace

void require_savable(const project::Project& project) {
  static_cast<void>(project::to_text(project));
  const AtomicFile there(project.file, true);  // creates a file and removes it
}

Storage::Storage(const project::Project& project) : Storage(project, ProjectLock(project.file)) {}

Storage::Storage(const project::Project& project, ProjectLock lock) : file_(project.file), lock_(std::move(lock)) {
  if (project.original) known_ = *project.original;
  const std::optional<Stamp> now = stamp();
  if (text_of(file_) == known_) stamp_ = now;
}

Storage::~Storage() {
  finish();
}

std::optional<Storage::Stamp> Storage::stamp() const {
  std::error_code error;
  const fs::file_time_type time = fs::last_write_time(file_, error);
  if (error) return std::nullopt;
  const std::uintmax_t size = fs::file_size(file_, error);
  if (error) return std::nullopt;
  return Stamp{time, size};
}

project::Project Storage::save(project::Project project) {
  project.file = file_;
  auto text = std::make_shared<const std::string>(project::to_text(project));
  write_text(file_, *text);
  known_ = *text;
  stamp_ = stamp();
  project.original = std::move(text);
  drop_autosave();
  return project;
}

bool Storage::changed_by_others() {
  const std::optional<Stamp> now = stamp();
  if (!now || now == stamp_) return false;
  const std::optional<std::string> text = text_of(file_);
  if (text != known_) return text.has_value();
  stamp_ = now;
  return false;
}

bool Storage::new_change_by_others() {
  const std::optional<Stamp> now = stamp();
  if (now == reported_ || !changed_by_others()) return false;
  reported_ = now;
  return true;
}

project::Project Storage::read() {
  read_stamp_ = stamp();
  project::Project project = project::load(file_);
  read_ = *project.original;
  return project;
}

void Storage::accept() {
  known_ = read_;
  stamp_ = read_stamp_;
}

bool Storage::autosave(const project::Project& project) {
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) != std::future_status::ready) return false;
  finish();
  writing_ = std::async(std::launch::async, [file = autosave_file(), project] {
    try {
      write_text(file, project::to_text(project));
      return std::string();
    } catch (const std::exception& error) {
      return std::string(error.what());
    }
  });
  return true;
}

std::string Storage::autosave_problem() {
  if (writing_.valid() && writing_.wait_for(std::chrono::seconds(0)) == std::future_status::ready) finish();
  return std::exchange(problem_, {});
}

void Storage::finish() {
  if (!writing_.valid()) return;
  std::string problem = writing_.get();
  if (!problem.empty()) problem_ = std::move(problem);
}

void Storage::drop_autosave() {
  finish();
  std::error_code ignored;  // it is offered again then, which loses nothing
  fs::remove(autosave_file(), ignored);
  fs::remove(elsewhere(autosave_file()), ignored);
}

fs::path Storage::rescue(const project::Project& project) {
  finish();
  const std::string text = project::to_text(project);
  try {
    write_text(autosave_file(), text);
    return autosave_file();
  } catch (const Error&) {
    fs::path file = elsewhere(autosave_file());
    write_text(file, text);
    return file;
  }
}

fs::path Storage::newest_autosave() const {
  const fs::path& beside = autosave_file();
  fs::path rescued = elsewhere(beside);
  std::error_code missing_beside, missing_rescued;
  const fs::file_time_type time = fs::last_write_time(beside, missing_beside);
  const fs::file_time_type rescued_time = fs::last_write_time(rescued, missing_rescued);
  if (missing_rescued || !is_ours(rescued)) return beside;
  return missing_beside || rescued_time > time ? rescued : beside;
}

std::optional<fs::path> Storage::set_autosave_aside() {
  const fs::path autosave = newest_autosave();
  for (int number = 1;; ++number) {
    fs::path aside = autosave;
    aside += std::string(".").append(std::to_string(number));
    std::error_code error;
    if (fs::exists(aside, error)) continue;
    if (!error) fs::rename(autosave, aside, error);
    return error ? std::nullopt : std::optional(aside);
  }
}

std::optional<Recovery> Storage::recovery() const {
  std::error_code error;
  const fs::path autosave = newest_autosave();
  const fs::file_time_type time = fs::last_write_time(autosave, error);
  const std::optional<std::string> text = error ? std::nullopt : text_of(autosave);
  if (!text || text == known_) return std::nullopt;
  Recovery recovery{std::nullopt, local_time(time)};
  try {
    recovery.project = project::parse(*text, autosave);
    recovery.project->file = file_;
  } catch (const Error&) {
    // Unreadable: `project` stays empty.
  }
  return recovery;
}

}  // namespace morphkit::edit
