// Files in: text, then the document.

#include <memory>
#include <string>
#include <utility>

#include "base/whole_file.h"
#include "morph/json/json.h"
#include "morph/project/project.h"
#include "morph/project/read_project.h"

namespace morphkit::project {

namespace {

Project project_of(std::string text, const std::filesystem::path& name) {
  auto original = std::make_shared<const std::string>(json::strip_bom(std::move(text), name.string()));
  const json::Document document{name.string(), json::parse(*original, name.string())};
  Project project = read_project(document);
  project.file = name;
  project.original = std::move(original);
  return project;
}

}  // namespace

Project parse(const std::string& text, const std::filesystem::path& name) {
  return project_of(text, name);
}

Project load(const std::filesystem::path& file) {
  return project_of(read_file(file, "project", json::kMaxFileBytes), file);
}

void load_features(Project& project, const std::filesystem::path& file) {
  const std::string text = json::strip_bom(read_file(file, "project", json::kMaxFileBytes), file.string());
  read_features_over(project, {file.string(), json::parse(text, file.string())});
}

}  // namespace morphkit::project
