#include "cli/cmd_warp.h"

#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "cli/cmd_morph.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/interrupt.h"
#include "cli/terminal.h"
#include "morph/exchange/import.h"
#include "morph/media/image_file.h"
#include "morph/render/mesh_inbetween.h"
#include "morph/render/mesh_warper.h"
#include "warp/mesh/mesh_warp.h"

namespace morphkit::cli {
namespace {

/// A mesh with its name for messages.
struct NamedMesh {
  warp::Mesh mesh;
  std::string place;  ///< see render::require_unfolded
};

project::Project with_mesh(project::Project project) {
  if (!project.mesh) throw Error(ErrorKind::kBadInput, project.file.string(), "has no \"mesh\"");
  return project;
}

/// The settings of the command line, as changes of the project that --mesh names, or of a new one for another mesh. The
/// project's own settings of its morph are for two pictures and do not count.
project::Project settings_of(const WarpOptions& options) {
  project::Project project;
  if (is_project(options.mesh)) {
    project = with_mesh(project::load(options.mesh));
  } else {
    for (project::Picture& picture : project.pictures) picture.image = options.image;
    project::Mesh& mesh = project.mesh.emplace();
    mesh.columns = mesh.rows = 2;
  }
  project.warp = {};
  project.warp.method = project::MethodName::kMesh;
  project.pull = {};
  project.output = {};
  const std::optional<project::Mesh> mesh = project.mesh;
  apply_changes(options.changes, project);
  if (!is_project(options.mesh) && project.mesh != mesh)
    throw ArgumentError("--set",
                        fmt::format("the mesh is that of {}; expected a key of warp or output", options.mesh.string()));
  return project;
}

/// The mesh of a project's side, brought from that side's picture to `frame`.
NamedMesh project_mesh(const project::Project& project, project::SideIndex side, cv::Size frame) {
  const project::Picture& named = project.pictures[side];
  const media::ImageInfo info = media::read_info(project::resolve(project, named.image));
  const cv::Size picture(info.width, info.height);
  return {render::scaled_to(render::mesh_on(*project::evaluate(project, {}).mesh, side, picture, project.file), picture,
                            frame),
          fmt::format("{}: /mesh/{}/", project.file.string(), render::name_of(side))};
}

/// The meshes of files that belong together.
std::vector<NamedMesh> read_meshes(std::span<const exchange::MeshFile> files, Output& output) {
  std::vector<std::string> remarks;
  std::vector<NamedMesh> meshes;
  for (exchange::PictureMesh& one : exchange::read_xmorph_meshes(files, remarks))
    meshes.push_back({std::move(one.mesh), one.name});
  for (const std::string& remark : remarks) output.note(remark);
  return meshes;
}

/// The mesh on the image and the one on the result.
struct Bend {
  NamedMesh from, to;
};

Bend read_bend(const WarpOptions& options, const project::Project& settings, cv::Size image, cv::Size size,
               Output& output) {
  const bool to_file = !is_project(options.mesh), from_file = !options.from.empty() && !is_project(options.from);
  const exchange::MeshFile to{options.mesh, size, {}}, from{options.from, image, {}};
  Bend bend;
  if (to_file && from_file) {
    const exchange::MeshFile files[] = {to, from};
    std::vector<NamedMesh> meshes = read_meshes(files, output);
    return {std::move(meshes[1]), std::move(meshes[0])};
  }
  bend.to =
      to_file ? std::move(read_meshes({&to, 1}, output).front()) : project_mesh(settings, project::kDestination, size);
  if (from_file) {
    bend.from = std::move(read_meshes({&from, 1}, output).front());
  } else if (!options.from.empty()) {
    bend.from = project_mesh(with_mesh(project::load(options.from)), project::kSource, image);
  } else if (!to_file) {
    bend.from = project_mesh(settings, project::kSource, image);
  } else {
    bend.from = {warp::uniform_mesh(bend.to.mesh.columns, bend.to.mesh.rows, {{0, 0}, cv::Size2d(image)}),
                 options.mesh.string()};
  }
  return bend;
}

void require_alike(const WarpOptions& options, const warp::Mesh& from, const warp::Mesh& to) {
  if (from.columns == to.columns && from.rows == to.rows) return;
  throw Error(ErrorKind::kBadInput, options.from.string(),
              fmt::format("is a mesh of {} x {} vertices, but {} has {} x {}; both must be alike", from.columns,
                          from.rows, options.mesh.string(), to.columns, to.rows));
}

void require_free(const WarpOptions& options) {
  const auto real = [](const std::filesystem::path& file) {
    return std::filesystem::weakly_canonical(std::filesystem::absolute(file));
  };
  if (!options.intermediate.empty() && real(options.intermediate) == real(options.output))
    throw ArgumentError("--intermediate", "names the same file as --output");
  for (const std::filesystem::path& file : {options.output, options.intermediate})
    if (!options.overwrite && !file.empty() && std::filesystem::exists(file)) throw FileExists(file.string());
}

/// The warp; prints its notes and warnings. @throws Error if a mesh folds without --allow-folds.
warp::MeshWarp mesh_warp(const WarpOptions& options, const project::Project& settings, cv::Size image, cv::Size size,
                         Output& output) {
  const auto [from, to] = read_bend(options, settings, image, size, output);
  require_alike(options, from.mesh, to.mesh);
  warp::MeshWarp warp(from.mesh, to.mesh,
                      {settings.warp.of<project::MeshMethod>().spline, settings.warp.of<project::MeshMethod>().order});
  const char* const order = render::text_of(warp.order());
  if (!options.allow_folds) {
    render::require_unfolded(from.mesh, "the mesh folds over", from.place);
    render::require_unfolded(to.mesh, "the mesh folds over", to.place);
    render::require_unfolded(warp::intermediate_mesh(from.mesh, to.mesh, warp.order()),
                             fmt::format("the image turns too far for two passes, {}, and folds between them", order),
                             options.mesh.string());
  }
  const double lost = warp::area_lost(from.mesh, to.mesh, warp.order());
  const std::string text = fmt::format("{:.1f} % of the area is lost between the passes ({})", 100 * lost, order);
  if (lost > render::kVisibleLoss)
    output.warning(text + ": the image turns far and loses detail");
  else
    output.detail(fmt::format("mesh of {} x {} vertices; {}", to.mesh.columns, to.mesh.rows, text));
  return warp;
}

}  // namespace

int run_warp(const WarpOptions& options, Output& output) {
  require_free(options);
  const media::Picture picture = media::read_picture(options.image);
  warn_of_pixels(options.image, picture, output);
  const project::Project settings = settings_of(options);
  warn_of_unused_settings(settings, output);
  const cv::Size size = settings.output.size.value_or(picture.image.size());
  const warp::MeshWarp warp = mesh_warp(options, settings, picture.image.size(), size, output);
  stop_if_interrupted("nothing was written");

  media::WriteOptions write;
  write.alpha = picture.info.has_alpha || picture.nonfinite_pixels > 0;
  write.depth = media::depth_from(options.depth);
  write.overwrite = options.overwrite;
  write.metadata = picture.metadata;
  if (options.quality >= 0) write.quality = options.quality;
  // A mesh reaches the borders of both images, so the edge colour fills gaps of rounding.
  const warp::Image between = warp.first_pass(picture.image, size, warp::Border::kClamp);
  stop_if_interrupted("nothing was written");
  const warp::Image bent = warp.second_pass(between, size, warp::Border::kClamp);
  stop_if_interrupted("nothing was written");
  as_asked([&] {
    if (!options.intermediate.empty()) media::write_image(options.intermediate, between, write);
    media::write_image(options.output, bent, write);
  });
  output.note(fmt::format("{}: {}x{}", options.output.string(), size.width, size.height));
  return 0;
}

}  // namespace morphkit::cli
