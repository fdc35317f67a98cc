// The method of the document, and the settings that it does not use.

#include <functional>
#include <string_view>
#include <tuple>
#include <type_traits>

#include <fmt/format.h>

#include "morph/project/describe.h"
#include "morph/project/form_values.h"
#include "morph/project/project.h"

namespace morphkit::project {
namespace {

/// The names of the keys of `warp` that UsedMethod does not use and that have another value than the default.
template <typename UsedMethod>
class Unused : public Form<Unused<UsedMethod>, Project> {
 public:
  explicit Unused(const Project& project) : project_(project) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access& access, const Facts&, std::string_view) {
    if (name == "filter" && !UsedMethod::kFilters && std::invoke(access, project_) != std::invoke(access, usual_))
      names_.push_back(name);
  }
  template <typename Access>
  void part(const Access& access) {
    using Part = typename Unused::template Member<Access>;
    if constexpr (std::is_same_v<Part, Pull>) {
      if (!UsedMethod::kPulls) add_differing(effective_pull(project_), effective_pull(usual_));
    } else if constexpr (!std::is_same_v<Part, UsedMethod>) {
      add_differing(std::invoke(access, project_), std::invoke(access, usual_));
    }
  }

  const std::vector<std::string_view>& names() const noexcept { return names_; }

 private:
  template <typename Part>
  void add_differing(const Part& value, const Part& usual) {
    Differing<Part> form(value, usual, names_);
    describe(form, Of<Part>{});
  }

  const Project& project_;
  const Project usual_;
  std::vector<std::string_view> names_;
};

}  // namespace

MethodName method_name_of(const Project& project) {
  const bool mesh_alone = project.mesh && project.features.empty();
  return project.warp.method.value_or(mesh_alone ? MethodName::kMesh : MethodName::kLines);
}

Method method_of(const Project& project) {
  Method result;
  const MethodName name = method_name_of(project);
  std::apply(
      [&](const auto&... settings) {
        int index = 0;
        ((index++ == static_cast<int>(name) ? static_cast<void>(result = settings) : void()), ...);
      },
      project.warp.settings);
  return result;
}

std::vector<std::string> unused_settings(const Project& project) {
  return std::visit(
      [&]<typename T>(const T&) {
        Unused<T> form(project);
        describe_warp(form);
        std::vector<std::string> sentences;
        for (const std::string_view name : form.names())
          sentences.push_back(fmt::format("\"{}\" of \"warp\" is not used, for the method is {}", name, T::kName));
        return sentences;
      },
      method_of(project));
}

}  // namespace morphkit::project
