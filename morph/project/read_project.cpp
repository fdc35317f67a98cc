#include "morph/project/read_project.h"

#include <utility>

#include "morph/project/checks.h"
#include "morph/project/describe.h"
#include "morph/project/form_read.h"

namespace morphkit::project {
namespace {

/// The version comes first: a newer file may have keys that this program cannot know.
void check_version(const json::Cursor& root, const Project& project) {
  if (!root.is(json::Kind::kObject)) root.fail_expected("an object {\"morphkit\": 1, ...}");
  VersionCodec::read(root.require("morphkit", "the version of the file's form, \"morphkit\": 1"), project, {});
}

}  // namespace

Project read_project(const json::Document& document) {
  const json::Cursor root(document);
  Project project;
  check_version(root, project);
  read_object(root, project, kWhole<Project>);
  check_document(root, project);
  return project;
}

void read_features_over(Project& project, const json::Document& document) {
  const json::Cursor root(document);
  check_version(root, project);
  if (!root.find("features") && !root.find("mesh")) {
    root.fail("this file is asked for what corresponds; it has neither \"features\" nor a \"mesh\"");
  }
  Project result = project;
  result.groups.clear();
  result.features.clear();
  result.mesh.reset();
  read_object(root, result, kWhole<Project>, false);
  check_document(root, result);
  // Pictures and output are checked, although they are not used: whether a file is valid must not depend on its use.
  result.pictures = project.pictures;
  result.output = project.output;
  project = std::move(result);
}

}  // namespace morphkit::project
