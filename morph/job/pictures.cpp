#include "morph/job/pictures.h"

#include <filesystem>
#include <future>
#include <variant>

#include "base/parallel.h"
#include "base/stop.h"
#include "base/whole_file.h"
#include "morph/media/made_from.h"

namespace morphkit::job {
namespace {

media::Picture load(const project::Project& project, const project::Picture& side) {
  const media::ColorSpace space =
      side.colorspace.empty() ? media::ColorSpace::kAuto : media::color_space_from(side.colorspace);
  return media::read_picture(project::resolve(project, side.image), space);
}

}  // namespace

Pictures load_pictures(const project::Project& project) {
  // Each picture is read by a thread of its own.
  std::vector<std::future<media::Picture>> loading;
  for (const project::Picture& side : project.pictures)
    loading.push_back(std::async(std::launch::async, [&, workers = Workers::current(), question = stop_question()] {
      const StopScope stopping(question);
      return workers.run([&] { return load(project, side); });
    }));
  Pictures pictures;
  std::vector<std::filesystem::path> files;
  for (const project::Picture& side : project.pictures) files.push_back(project::resolve(project, side.image));
  for (std::future<media::Picture>& picture : loading) pictures.sides.push_back(picture.get());
  if (const auto* file = std::get_if<std::filesystem::path>(&project.output.background))
    pictures.background = media::read_picture(files.emplace_back(project::resolve(project, *file)));
  for (const std::filesystem::path& file : files)
    pictures.digest += media::digest_of(read_file(file, "picture")) + '\n';
  return pictures;
}

render::Footage footage_of(const Pictures& pictures) {
  render::Footage footage;
  for (const media::Picture& side : pictures.sides)
    footage.pictures.push_back(render::in_memory(side.image, side.info.has_alpha || side.nonfinite_pixels > 0));
  if (pictures.background)
    footage.background = render::in_memory(pictures.background->image, pictures.background->info.has_alpha);
  return footage;
}

}  // namespace morphkit::job
