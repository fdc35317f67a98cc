// Reading and writing a project as large as they come: a mesh of 500 x 500 vertices on both pictures.

#include <cstdint>
#include <string>

#include <benchmark/benchmark.h>

#include "morph/project/project.h"

namespace morphkit::project {
namespace {

constexpr int kVertices = 500;

std::string mesh_text() {
  Project project;
  project.pictures[kSource].image = "a.png";
  project.pictures[kDestination].image = "b.png";
  Mesh& mesh = project.mesh.emplace();
  mesh.columns = mesh.rows = kVertices;
  for (Points& points : mesh.vertices) {
    for (int i = 0; i < kVertices * kVertices; ++i) points.emplace_back(i % kVertices * 2.125, i / kVertices * 2.375);
  }
  return to_text(project);
}

void load_mesh(benchmark::State& state) {
  const std::string text = mesh_text();
  for (auto _ : state) benchmark::DoNotOptimize(parse(text, "mesh.json").mesh->columns);
  state.SetBytesProcessed(static_cast<std::int64_t>(state.iterations() * text.size()));
}
BENCHMARK(load_mesh)->Unit(benchmark::kMillisecond);

/// One vertex has moved: everything else keeps its text.
void save_mesh(benchmark::State& state) {
  Project project = parse(mesh_text(), "mesh.json");
  project.mesh->vertices[kSource].back().x += 1;
  for (auto _ : state) benchmark::DoNotOptimize(to_text(project).size());
}
BENCHMARK(save_mesh)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace morphkit::project
