// Which method the document means, and what it says for the others.

#include <string_view>

#include <fmt/format.h>

#include "morph/project/project.h"

namespace morphkit::project {
namespace {

/// Collects the settings that the method named `method` does not use.
class Unused {
 public:
  explicit Unused(std::string_view method) : method_(method) {}

  /// "key" of "warp", unless it has its default value.
  template <typename T>
  void setting(std::string_view key, const T& value, const T& usual) {
    if (value == usual) return;
    sentences_.push_back(fmt::format("\"{}\" of \"warp\" is not used, for the method is {}", key, method_));
  }
  std::vector<std::string> take() { return std::move(sentences_); }

 private:
  std::string_view method_;
  std::vector<std::string> sentences_;
};

}  // namespace

MethodName method_name_of(const Project& project) {
  const bool mesh_alone = project.mesh && project.features.empty();
  return project.warp.method.value_or(mesh_alone ? MethodName::kMesh : MethodName::kLines);
}

Method method_of(const Project& project) {
  if (method_name_of(project) == MethodName::kMesh) return project.warp.mesh;
  return project.warp.lines;
}

std::vector<std::string> unused_settings(const Project& project) {
  const Warp& warp = project.warp;
  const Warp usual;
  if (method_name_of(project) == MethodName::kLines) {
    Unused unused("lines");
    unused.setting("spline", warp.mesh.spline, usual.mesh.spline);
    unused.setting("order", warp.mesh.order, usual.mesh.order);
    return unused.take();
  }
  const Pull pull = effective_pull(project), usual_pull = effective_pull(Project{});
  Unused unused("mesh");
  unused.setting("a", pull.a, usual_pull.a);
  unused.setting("b", pull.b, usual_pull.b);
  unused.setting("p", pull.p, usual_pull.p);
  unused.setting("scale", pull.scale, usual_pull.scale);
  unused.setting("between", pull.between, usual_pull.between);
  unused.setting("turns", pull.turns, usual_pull.turns);
  unused.setting("field", warp.lines.field, usual.lines.field);
  unused.setting("filter", warp.filter, usual.filter);
  return unused.take();
}

}  // namespace morphkit::project
