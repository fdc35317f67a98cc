#include "cli/cmd_warp.h"

#include <map>
#include <memory>
#include <utility>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/cmd_morph.h"
#include "cli/command.h"
#include "cli/terminal.h"
#include "morph/error.h"
#include "morph/media/image_file.h"
#include "morph/project/import.h"
#include "morph/render/mesh_inbetween.h"
#include "morph/render/mesh_morpher.h"
#include "warp/mesh_warp.h"

namespace morphkit::cli {
namespace {

const std::map<std::string, warp::MeshSpline> kSplines{{"monotone", warp::MeshSpline::kMonotone},
                                                       {"catmull-rom", warp::MeshSpline::kCatmullRom},
                                                       {"linear", warp::MeshSpline::kLinear}};
const std::map<std::string, warp::PassOrder> kOrders{{"auto", warp::PassOrder::kAuto},
                                                     {"rows-first", warp::PassOrder::kRowsFirst},
                                                     {"columns-first", warp::PassOrder::kColumnsFirst}};
const std::map<std::string, warp::Border> kBorders{{"transparent", warp::Border::kTransparent},
                                                   {"clamp", warp::Border::kClamp}};

bool is_project(const std::filesystem::path& file) {
  return file.extension() == ".json";
}

/// The mesh of a project's side, brought from that side's picture to `frame`.
warp::Mesh project_mesh(const std::filesystem::path& file, render::SideName side, cv::Size frame) {
  const project::Project project = project::load(file);
  if (!project.mesh) throw Error(ErrorCode::kBadInput, file.string(), "has no \"mesh\"");
  const project::Side& named = side == render::SideName::kSource ? project.source : project.destination;
  const media::ImageInfo info = media::read_info(project::resolve(project, named.image));
  warp::Mesh mesh = render::mesh_on(project, side, {info.width, info.height});
  for (cv::Point2d& vertex : mesh.vertices)
    vertex = {vertex.x * frame.width / info.width, vertex.y * frame.height / info.height};
  warp::snap_to_outline(mesh, {{0, 0}, cv::Size2d(frame)});
  return mesh;
}

warp::Mesh read_mesh(const std::filesystem::path& file, render::SideName side, cv::Size frame) {
  return is_project(file) ? project_mesh(file, side, frame) : project::read_xmorph_mesh(file, frame);
}

warp::Mesh from_mesh(const WarpOptions& options, const warp::Mesh& to, cv::Size image) {
  if (!options.from.empty()) return read_mesh(options.from, render::SideName::kSource, image);
  if (is_project(options.mesh)) return read_mesh(options.mesh, render::SideName::kSource, image);
  return warp::uniform_mesh(to.columns, to.rows, {{0, 0}, cv::Size2d(image)});
}

void require_alike(const WarpOptions& options, const warp::Mesh& from, const warp::Mesh& to) {
  if (from.columns != to.columns || from.rows != to.rows)
    throw Error(ErrorCode::kBadInput, options.from.string(),
                fmt::format("is a mesh of {} x {} vertices, but {} has {} x {}; both must be alike", from.columns,
                            from.rows, options.mesh.string(), to.columns, to.rows));
  if (options.allow_folds) return;
  render::require_unfolded(from, "first", options.from.empty() ? options.mesh.string() : options.from.string());
  render::require_unfolded(to, "second", options.mesh.string());
}

std::string describe(const warp::MeshWarp& warp) {
  return fmt::format("mesh of {} x {} vertices; {} first, {:.1f} % of the area lost between the passes",
                     warp.to().columns, warp.to().rows,
                     warp.order() == warp::PassOrder::kRowsFirst ? "rows" : "columns",
                     100 * warp.area_lost(warp.order()));
}

}  // namespace

void add_warp(CLI::App& app, Session& session) {
  CLI::App* command = add_command(app, session,
                                  {"warp", "Bend one image onto a mesh",
                                   "  morphkit warp face.png --mesh smile.mesh -o smiling.png\n"
                                   "  morphkit warp face.png --from neutral.mesh --mesh smile.mesh -o smiling.exr\n"
                                   "  morphkit warp woman.png --mesh pair.json -o as-the-man.png",
                                   kRenderGroup});
  auto options = std::make_shared<WarpOptions>();
  command->add_option("IMAGE", options->image, "The image")->type_name("")->required();
  command
      ->add_option("--mesh", options->mesh,
                   "The mesh to bend onto: an xmorph .mesh file, or the destination's mesh of a project")
      ->type_name("M")
      ->required();
  command
      ->add_option("--from", options->from,
                   "The mesh that lies on the image: a .mesh file, or the source's mesh of a project (default: that of "
                   "the project M, else evenly spaced)")
      ->type_name("F");
  command->add_option("-o,--output", options->output, "The bent image")->type_name("OUT")->required();
  command->add_option("--intermediate", options->intermediate, "Also write the image between the two passes")
      ->type_name("FILE");
  command->add_option("--size", options->size, "Size of the output in pixels (default: that of the image)")
      ->type_name("WxH");
  command->add_option("--spline", options->spline, "Curves: monotone (default), catmull-rom, linear")
      ->type_name("SPLINE")
      ->check(CLI::IsMember(kSplines));
  command->add_option("--order", options->order, "Order of the passes: auto (default), rows-first, columns-first")
      ->type_name("ORDER")
      ->check(CLI::IsMember(kOrders));
  command->add_option("--border", options->border, "Outside the image: transparent (default), clamp")
      ->type_name("BORDER")
      ->check(CLI::IsMember(kBorders));
  command->add_option("--depth", options->depth, "Bits of the output: 8, 16, half, float")->type_name("DEPTH");
  command->add_option("--quality", options->quality, "JPEG and WebP: 1 to 100")
      ->type_name("Q")
      ->check(CLI::Range(1, 100).description(""));
  command->add_flag("--allow-folds", options->allow_folds, "Bend as far as that goes where a mesh folds over");
  command->add_flag("-y,--overwrite", options->overwrite, "Replace files that exist");
  command->callback(
      [&session, options] { session.action = [options](Output& output) { return run_warp(*options, output); }; });
}

int run_warp(const WarpOptions& options, Output& output) {
  for (const std::filesystem::path& file : {options.output, options.intermediate})
    if (!options.overwrite && !file.empty() && std::filesystem::exists(file))
      throw Error(ErrorCode::kIo, file.string(), "already exists; use --overwrite to replace it");
  const media::Picture picture = media::read_picture(options.image);
  const cv::Size size = options.size.empty() ? picture.image.size() : parse_size(options.size);
  const warp::Mesh to = read_mesh(options.mesh, render::SideName::kDestination, size);
  const warp::Mesh from = from_mesh(options, to, picture.image.size());
  require_alike(options, from, to);
  const warp::MeshWarp warp(from, to, {kSplines.at(options.spline), kOrders.at(options.order)});
  output.detail(describe(warp));

  media::WriteOptions write;
  write.alpha = picture.info.has_alpha || picture.nonfinite_pixels > 0;
  write.depth = media::depth_from(options.depth);
  write.overwrite = options.overwrite;
  write.metadata = picture.metadata;
  if (options.quality >= 0) write.quality = options.quality;
  const warp::Border border = kBorders.at(options.border);
  if (!options.intermediate.empty())
    media::write_image(options.intermediate, warp.first_pass(picture.image, size, border), write);
  media::write_image(options.output, warp.apply(picture.image, size, border), write);
  output.note(fmt::format("{}: {}x{}", options.output.string(), size.width, size.height));
  return 0;
}

}  // namespace morphkit::cli
