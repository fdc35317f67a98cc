// Morphs two pictures in memory, with morphkit::morph. They are plain colours, so the middle frame is known.
#include <cstdio>

#include "morph/project/project.h"
#include "morph/render/renderer.h"

using namespace morphkit;

int main() {
  const auto project = project::parse(R"({
    "morphkit": 1,
    "source": {"image": "dark.png"},
    "destination": {"image": "light.png"},
    "features": [{"id": "edge", "line": {"source": [[4, 4], [12, 4]], "destination": [[4, 8], [12, 9]]}}]
  })",
                                      "in memory.json");
  const warp::Image dark(16, 16, warp::Pixel(0, 0, 0, 1)), light(16, 16, warp::Pixel(1, 0.5f, 0.25f, 1));
  const render::Renderer renderer(project, {{render::in_memory(dark), render::in_memory(light)}, {}});

  const warp::Pixel middle = renderer.frame(renderer.clock().at(0.5))(8, 8), expected(0.5f, 0.25f, 0.125f, 1);
  if (cv::norm(middle - expected) < 1e-5) return 0;
  std::printf("the middle is (%g, %g, %g, %g)\n", middle[0], middle[1], middle[2], middle[3]);
  return 1;
}
