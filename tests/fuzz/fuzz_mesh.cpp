// The reader of xmorph's meshes: any bytes give a mesh or an Error, and a mesh survives writing.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

#include "base/error.h"
#include "morph/exchange/import_xmorph.h"

namespace {

namespace exchange = morphkit::exchange;
namespace warp = morphkit::warp;

constexpr double kHalfUnit = 0.05 + 1e-9;  // px
constexpr double kMostPixels = 1e6;

/// Not `assert`: release builds of the fuzzer and the replay test check too.
void require(bool holds, const char* what) {
  if (holds) return;
  std::fprintf(stderr, "%s\n", what);
  std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  const cv::Size picture(640, 480);
  std::vector<std::string> remarks;
  warp::Mesh mesh;
  try {
    mesh = exchange::parse_xmorph_mesh(text, "fuzz.mesh", picture, remarks);
  } catch (const morphkit::Error& error) {
    require(error.kind() == morphkit::ErrorKind::kBadInput, error.what());
    return 0;
  }
  require(mesh.vertices.size() == static_cast<std::size_t>(mesh.columns) * static_cast<std::size_t>(mesh.rows),
          "the vertices are not as many as promised");
  const warp::Mesh back =
      exchange::parse_xmorph_mesh(exchange::xmorph_mesh_text(mesh, picture), "back.mesh", picture, remarks);
  require(back.columns == mesh.columns && back.rows == mesh.rows, "written, the mesh has another size");
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const cv::Point2d before = mesh.vertices[i], moved = back.vertices[i] - before;
    require(std::abs(before.x) <= kMostPixels && std::abs(before.y) <= kMostPixels, "a vertex is out of range");
    require(std::max(std::abs(moved.x), std::abs(moved.y)) <= kHalfUnit, "written, a vertex is elsewhere");
  }
  return 0;
}
