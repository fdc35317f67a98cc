// The document as text, and text into files that are whole or not there.

#include <cstdint>
#include <string>

#include "base/atomic_file.h"
#include "morph/json/json.h"
#include "morph/json/merge.h"
#include "morph/project/build.h"
#include "morph/project/project.h"

namespace morphkit::project {
std::string to_text(const Project& project) {
  json::Node minimal = build(project, false);
  if (!project.original) return json::write(minimal, "");
  const std::string name = project.file.string();
  json::Document original{name, json::parse(*project.original, name)};
  json::locate(original.root, *project.original);
  json::Node full = build(project, true);
  return json::write(json::merge(original, *project.original, full, minimal), *project.original);
}

void save(const Project& project, const std::filesystem::path& file, bool overwrite) {
  const std::string text = to_text(project);
  write_file(file, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}, overwrite);
}

}  // namespace morphkit::project
