// Renders a project into numbered files, as `morphkit morph PROJECT -o frame.%04d.png` does.
//   link_morph PROJECT 'frame.%04d.png'
#include <cstdio>
#include <exception>

#include "morph/job/pictures.h"
#include "morph/job/run.h"
#include "morph/media/frame_sink.h"
#include "morph/project/project.h"
#include "morph/render/renderer.h"

using namespace morphkit;

namespace {

void render_frames(const char* project_file, const char* pattern) {
  const project::Project project = project::load(project_file);
  const job::Pictures pictures = job::load_pictures(project);
  const render::Renderer renderer(project, job::footage_of(pictures));

  media::SinkOptions to = job::sink_options(renderer, pictures);
  to.image.overwrite = true;
  const auto sink = media::open_sink(pattern, to, false);
  job::RunOptions run;
  for (int frame = renderer.clock().first(); frame <= renderer.clock().last(); ++frame) run.frames.push_back(frame);
  run.on_progress = [](const job::Progress& p) { std::printf("frame %d, %d of %d\n", p.frame, p.done, p.total); };
  job::run(renderer, *sink, run);
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
