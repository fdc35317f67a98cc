// The project reader: any bytes give a project or an Error, and a project survives saving.

#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>

#include "base/error.h"
#include "morph/project/project.h"

namespace {

namespace project = morphkit::project;

/// Not `assert`: release builds of the fuzzer and the replay test check too.
void require_same(const project::Project& saved, const char* step) {
  const std::string text = project::to_text(saved);
  if (project::same_document(project::parse(text, "fuzz.json"), saved)) return;
  std::fprintf(stderr, "%s: the saved text says something else:\n%s\n", step, text.c_str());
  std::abort();
}

void change(project::Project& project) {
  project.output.frames = project.output.frames % 1000 + 1;
  project.pull.b = 1.25;
  project.output.background = project::Color{0.5, 0, 0, 1};
  if (!project.features.empty()) project.features.pop_back();
  if (project.mesh && !project.mesh->vertices[project::kSource].empty())
    project.mesh->vertices[project::kSource].back() = {7.5, 8};
  if (project.mesh && !project.mesh->groups.empty()) project.mesh->groups.pop_back();
  if (!project.groups.empty()) project.groups.front().pace.shape = morphkit::motion::Timing{};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  project::Project project;
  try {
    project = project::parse(text, "fuzz.json");
  } catch (const morphkit::Error&) {
    return 0;
  }
  require_same(project, "as read");
  change(project);
  require_same(project, "changed");
  project.original = nullptr;
  require_same(project, "from nothing");
  return 0;
}
