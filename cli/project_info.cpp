#include <algorithm>

#include <fmt/format.h>

#include "base/error.h"
#include "cli/file_info.h"
#include "cli/project_argument.h"
#include "morph/project/clock.h"
#include "morph/project/project.h"
#include "morph/project/words.h"

namespace morphkit::cli {
namespace {

/// The size of a picture that a project names, or why it has none.
void add_side(const char* label, const project::Project& project, const project::Picture& side,
              const SizeReader& size_of, FileInfo& info) {
  Report report;
  report.set("image", side.image.string());
  std::string what;
  try {
    const cv::Size image = size_of(project::resolve(project, side.image));
    what = fmt::format("{}x{}", image.width, image.height);
    report.set("width", image.width).set("height", image.height);
  } catch (const Error& error) {
    what = fmt::format("cannot be read: {}", error.message());
    report.set("error", error.message());
  }
  info.text += fmt::format("  {:<12} {}, {}\n", label, side.image.string(), what);
  info.report.set(label, report);
}

std::string fps_text(const project::Output& output) {
  return output.fps.den == 1 ? fmt::format("{}", output.fps.num) : fmt::format("{}/{}", output.fps.num, output.fps.den);
}

void add_features(const project::Project& project, FileInfo& info) {
  const auto count = [&]<typename Kind>(Kind) {
    return std::count_if(project.features.begin(), project.features.end(),
                         [](const project::Feature& feature) { return std::holds_alternative<Kind>(feature.mark); });
  };
  const auto lines = count(project::Line{});
  const auto points = count(project::Point{});
  const auto curves = count(project::Curve{});
  info.text += fmt::format("  features     {}: {} lines, {} points, {} curves\n", project.features.size(), lines,
                           points, curves);
  Report features;
  features.set("total", project.features.size()).set("lines", lines).set("points", points).set("curves", curves);
  info.report.set("features", features);

  if (project.mesh) {
    info.text += fmt::format("  mesh         {} x {} vertices\n", project.mesh->columns, project.mesh->rows);
    info.report.set("mesh", Report().set("columns", project.mesh->columns).set("rows", project.mesh->rows));
  }
  const std::string method(project::word_of(project::method_name_of(project)));
  info.text += fmt::format("  method       {}\n", method);
  info.report.set("method", method);

  Report groups = Report::array();
  std::string names;
  for (const project::Group& group : project.groups) {
    groups.push(group.id);
    names += (names.empty() ? "" : ", ") + group.id;
  }
  if (!names.empty()) info.text += fmt::format("  groups       {}\n", names);
  info.report.set("groups", groups);
}

void add_output(const project::Output& output, FileInfo& info) {
  const std::string size =
      output.size ? fmt::format("{}x{}", output.size->width, output.size->height) : "the size of the source";
  const project::Clock clock(output);
  info.text +=
      fmt::format("  output       {}, {}; frames {}-{} at {} fps ({:.2f} s)\n", size, project::word_of(output.fit),
                  clock.first(), clock.last(), fps_text(output), clock.duration_s());
  Report report;
  if (output.size) report.set("width", output.size->width).set("height", output.size->height);
  report.set("fit", std::string(project::word_of(output.fit))).set("frames", output.frames).set("start", output.start);
  report.set("fps", fps_text(output));
  info.report.set("output", report);
}

}  // namespace

FileInfo project_info(const std::filesystem::path& file, const ProjectChanges& changes, const SizeReader& size_of) {
  const project::Project project = load_project(file, changes);
  FileInfo info;
  info.text = fmt::format("{}: morphkit project\n", file.string());
  info.report.set("file", file.string()).set("kind", "project");
  add_side("source", project, project.pictures[project::kSource], size_of, info);
  add_side("destination", project, project.pictures[project::kDestination], size_of, info);
  add_features(project, info);
  add_output(project.output, info);
  return info;
}

}  // namespace morphkit::cli
