// Renders a project into numbered files, as `morphkit morph PROJECT -o frame.%04d.png` does.
//   link_morph PROJECT 'frame.%04d.png'
#include <cstdio>
#include <exception>

#include "morph/media/frame_sink.h"
#include "morph/media/image_file.h"
#include "morph/project/project.h"
#include "morph/render/renderer.h"

using namespace morphkit;

namespace {

/// The picture of a side. Relative paths start at the project's folder.
warp::Image picture_of(const project::Project& project, project::SideIndex side) {
  return media::read_picture(project::resolve(project, project.pictures[side].image)).image;
}

void render_frames(const char* project_file, const char* pattern) {
  const project::Project project = project::load(project_file);
  render::Pictures pictures;
  pictures.source.image = picture_of(project, project::kSource);
  pictures.destination.image = picture_of(project, project::kDestination);
  const render::Renderer renderer(project, pictures);

  media::SinkOptions to;
  to.size = renderer.size();
  to.image.overwrite = true;
  const auto sink = media::open_sink(pattern, to, false);
  for (int frame = 1; frame <= project.output.frames; ++frame) {
    sink->write(frame, sink->encode(frame, renderer.frame(renderer.time_of(frame))));
    std::printf("frame %d of %d\n", frame, project.output.frames);
  }
  sink->finish();
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 3) {
    std::fprintf(stderr, "usage: link_morph PROJECT PATTERN\n");
    return 2;
  }
  try {
    render_frames(argv[1], argv[2]);
  } catch (const std::exception& error) {  // a morphkit::Error says where and what
    std::fprintf(stderr, "link_morph: %s\n", error.what());
    return 1;
  }
  return 0;
}
