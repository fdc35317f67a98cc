#include "cli/cmd_check.h"

#include <algorithm>

#include <fmt/format.h>

#include "base/stop.h"
#include "cli/cmd_morph.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "morph/job/pictures.h"
#include "morph/render/check.h"

namespace morphkit::cli {
namespace {

Report report_of(const render::Finding& finding) {
  Report features = Report::array();
  for (const std::string& id : finding.features) features.push(id);
  Report vertices = Report::array();
  for (const cv::Point& vertex : finding.vertices) vertices.push(Report::array().push(vertex.x).push(vertex.y));
  Report report;
  report.set("kind", render::name_of(finding.kind)).set("level", finding.warning ? "warning" : "note");
  report.set("where", finding.where).set("features", features).set("t", finding.t);
  report.set("x", finding.position.x).set("y", finding.position.y);
  if (finding.kind == render::Finding::Kind::kFold) report.set("count", finding.count).set("area_px", finding.area_px);
  if (finding.kind == render::Finding::Kind::kBottleneck) report.set("area_lost", finding.area_lost);
  if (!finding.vertices.empty()) report.set("vertices", vertices);
  return report.set("message", finding.message);
}

void print_json(const std::vector<render::Finding>& findings, const std::vector<std::string>& notes, bool good,
                Output& output) {
  Report list = Report::array();
  for (const render::Finding& finding : findings) list.push(report_of(finding));
  Report texts = Report::array();
  for (const std::string& note : notes) texts.push(note);
  Report report;
  report.set("ok", good).set("findings", list).set("notes", texts);
  output.line(report.to_json());
}

void print_text(const std::vector<render::Finding>& findings, const std::vector<std::string>& notes,
                const render::Renderer& renderer, Output& output) {
  for (const std::string& note : notes) output.line("note: " + note);
  for (const render::Finding& finding : findings)
    output.line(fmt::format("{}: {}", finding.warning ? "warning" : "note", finding.message));
  if (findings.empty()) output.line("nothing to complain of: " + renderer.description());
}

}  // namespace

int run_check(const CheckOptions& options, Output& output) {
  const StopScope stopping(interrupted);
  const project::Project project = load_project(options.project);
  const job::Pictures pictures = job::load_pictures(project);
  std::vector<std::string> notes;
  for (std::size_t side = 0; side < pictures.sides.size(); ++side)
    for (const std::string& sentence : media::warnings_of(pictures.sides[side]))
      notes.push_back(fmt::format("{}: {}", project.pictures[side].image.string(), sentence));
  for (std::string& sentence : project::unused_settings(project)) notes.push_back(std::move(sentence));
  if (std::string note = unused_mesh_note(project); !note.empty()) notes.push_back(std::move(note));
  const render::Renderer renderer(project, job::footage_of(pictures), {.allow_folds = true});
  output.detail(canvas_note(renderer));
  const std::vector<render::Finding> findings = render::check(renderer);
  const bool good = std::none_of(findings.begin(), findings.end(), [](const auto& f) { return f.warning; });
  if (options.json)
    print_json(findings, notes, good, output);
  else
    print_text(findings, notes, renderer, output);
  return good ? 0 : kExitDifference;
}

}  // namespace morphkit::cli
