// Tests cli/edit/view/canvas.cpp, cli/edit/view/draw_chrome.cpp, cli/edit/view/draw_marks.cpp,
// cli/edit/view/draw_overlays.cpp and cli/edit/view/model.cpp.
// The window of the preview tool in its main states, against golden pictures that people have approved.

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include "cli/edit/view/canvas.h"
#include "cli/edit/view/layout.h"
#include "cli/edit/view/model.h"
#include "cli/edit/view/picking.h"
#include "cli/edit/view/preview.h"
#include "morph/project/project.h"
#include "samples/samples.h"
#include "samples/write.h"
#include "tests/golden/golden.h"
#include "tests/support/temporary_folder.h"

namespace morphkit::edit {
namespace {

const cv::Size kCanvas(1280, 720);

/// Two pictures, a project and the state of the view.
struct Scene {
  Scene(warp::Image first, warp::Image second, project::Project project, cv::Size canvas = kCanvas)
      : source_picture(std::move(first)),
        destination_picture(std::move(second)),
        model(std::move(project), source_picture.size(), destination_picture.size(), canvas) {
    model.fit_views();
    model.file_name = "woman-man.json";
  }

  const Pyramid& pyramid(SideIndex side) const { return side == project::kSource ? source : destination; }

  /// The image of the result pane, at a third of the size like a draft. Golden pictures of renders are elsewhere.
  PreviewPicture preview() const {
    PreviewRequest request;
    request.project = std::make_shared<project::Project>(model.document.project());
    request.t = model.t;
    request.show = model.show;
    request.folds = model.switches.folds;
    request.view = model.result_view;
    request.size = panes_of(model.canvas_size).pane(Pane::kResult).size();
    return PreviewRenderer(source, destination).render(request, 3);
  }

  /// Puts the mouse on a place of a picture.
  void point_at(SideIndex side, cv::Point2d position) {
    model.mouse = cv::Point(to_canvas(model, layout_of(model), pane_of(side), position));
  }

  cv::Mat3b drawn() const { return Canvas(source, destination).draw(model, preview()).clone(); }

  warp::Image source_picture, destination_picture;
  Model model;
  Pyramid source{source_picture}, destination{destination_picture};
};

void expect_looks(const std::string& name, const cv::Mat3b& canvas) {
  const test::TemporaryFolder folder;
  const std::filesystem::path file = folder / (name + ".png");
  ASSERT_TRUE(cv::imwrite(file.string(), canvas, {cv::IMWRITE_PNG_COMPRESSION, 9}));
  test::expect_golden(name, file);
}

/// A sample's project on its own pictures.
Scene scene_of(const std::string& name, bool with_features, cv::Size canvas = kCanvas) {
  static std::map<std::string, samples::Sample> known;
  auto found = known.find(name);
  if (found == known.end()) found = known.emplace(name, samples::paint(name)).first;
  const test::TemporaryFolder folder;
  project::Project project = project::load(samples::write(found->second, folder.path(), true));
  if (!with_features) project.features.clear();
  return {samples::image_of(found->second.pictures[0]), samples::image_of(found->second.pictures[1]),
          std::move(project), canvas};
}

/// The first few features of the sample, like a project after a minute of work.
Scene scene_with(std::size_t features) {
  Scene scene = scene_of("portraits", true);
  project::Project project = scene.model.document.project();
  if (project.features.size() > features) project.features.resize(features);
  scene.model.document.replace(std::move(project));
  return scene;
}

/// A picture of nearly one brightness, with a soft ramp and a fine checkerboard.
warp::Image plain(cv::Size size, float dark, float bright) {
  warp::Image image(size);
  for (int y = 0; y < size.height; ++y)
    for (int x = 0; x < size.width; ++x) {
      const float ramp = static_cast<float>(x) / static_cast<float>(size.width);
      const float share = (ramp + ((x / 40 + y / 40) % 2 == 0 ? 0.0f : 0.25f)) / 1.25f;
      const float value = dark + share * (bright - dark);
      image(y, x) = {value, value, value, 1};
    }
  return image;
}

TEST(CanvasGolden, FreshStart) {
  Scene scene = scene_of("portraits", false);
  scene.model.welcome = true;
  expect_looks("canvas-start", scene.drawn());
}

TEST(CanvasGolden, MarksOneSelectedOneUnderTheMouse) {
  Scene scene = scene_with(14);
  scene.model.document.select({{2}, {}});
  const project::Feature& feature = scene.model.document.project().features[5];
  scene.point_at(project::kSource, feature.places[project::kSource][0]);
  scene.model.hover = Handle{project::kSource, 5, 0, -1};
  expect_looks("canvas-marks", scene.drawn());
}

TEST(CanvasGolden, MeshTool) {
  Scene scene = scene_of("portraits", false);
  Model& model = scene.model;
  model.tool = ToolId::kMesh;
  model.document.make_mesh(6, 7);
  model.document.set_method(project::MethodName::kMesh);
  const int moved[] = {14, 15, 20, 21};
  model.document.move_vertices(moved, project::kDestination, {24, -30});
  model.document.select({{}, {14, 15, 20, 21}});
  model.hover = Handle{project::kDestination, -1, -1, 27};
  scene.point_at(project::kDestination, model.document.mesh_vertices(project::kDestination)[27]);
  model.show = Show::kGrid;
  expect_looks("canvas-mesh", scene.drawn());
}

TEST(CanvasGolden, CurveSnappingWithLoupe) {
  Scene scene = scene_with(4);
  Model& model = scene.model;
  model.tool = ToolId::kCurve;
  model.switches.loupe = true;
  const cv::Point2d next(512, 556);
  model.sketch = Sketch{Sketch::Shape::kCurve, project::kSource, {{262, 500}, {300, 600}, {380, 665}}, next};
  model.snapped = next;
  scene.point_at(project::kSource, next);
  model.show = Show::kDifference;
  expect_looks("canvas-curve", scene.drawn());
}

TEST(CanvasGolden, OnionSkinAndFolds) {
  Scene scene = scene_with(10);
  Model& model = scene.model;
  model.document.select({{0, 1, 2}, {}});
  model.document.swap_ends_on(project::kDestination);  // the line is reversed, so the map folds
  model.switches.onion = true;
  model.t = 0.35;
  model.playing = true;
  model.message = "swapped the ends of 3 features on the destination";
  expect_looks("canvas-onion", scene.drawn());
}

/// What the result pane shows of the whole canvas of a scene.
cv::Mat3b result_of(const Scene& scene, const Pyramid* background = nullptr) {
  PreviewRequest request;
  request.project = std::make_shared<project::Project>(scene.model.document.project());
  request.t = scene.model.t;
  request.show = scene.model.show;
  request.folds = scene.model.switches.folds;
  request.size = {360, 480};
  request.view = fitted(scene.model.content_size(Pane::kResult), request.size);
  const PreviewPicture picture = PreviewRenderer(scene.source, scene.destination, background).render(request);
  EXPECT_EQ(picture.problem, "");
  return picture.image;
}

TEST(PreviewGolden, ABackgroundPictureIsShown) {
  Scene scene = scene_with(10);
  project::Project project = scene.model.document.project();
  project.output.size = cv::Size(900, 900);
  project.output.fit = project::Fit::kContain;
  project.output.background = std::filesystem::path("behind.png");
  scene.model.document.replace(project);
  const warp::Image behind = plain({320, 240}, 0.1F, 0.7F);
  const Pyramid background(behind);
  expect_looks("preview-background", result_of(scene, &background));
}

TEST(PreviewGolden, FoldsOfASideThatDoesNotShowYetAreNotPainted) {
  Scene scene = scene_with(10);
  project::Project project = scene.model.document.project();
  project.pace.dissolve = motion::Timing{motion::LinearEase{}, 0.5, 0.5};
  for (project::Feature& feature : project.features) feature.pace = {};
  for (project::Group& group : project.groups) group.pace = {};
  scene.model.document.replace(project);
  scene.model.document.select({{0, 1, 2}, {}});
  scene.model.document.swap_ends_on(project::kDestination);  // turned over: folds
  scene.model.t = 0.3;
  expect_looks("preview-folds", result_of(scene));
}

TEST(PreviewGolden, TheSourceUnderAMeshIsThatOfTheTwoPasses) {
  Scene scene = scene_of("portraits", false);
  Model& model = scene.model;
  model.document.make_mesh(6, 7);
  model.document.set_method(project::MethodName::kMesh);
  const int moved[] = {14, 15, 20, 21};
  model.document.move_vertices(moved, project::kDestination, {60, -60});
  project::Project project = model.document.project();
  project.warp.filter = warp::Filter::kNearest;  // of which the passes know nothing
  model.document.replace(project);
  model.show = Show::kSource;
  model.t = 1;
  expect_looks("preview-mesh-source", result_of(scene));
}

TEST(CanvasGolden, Help) {
  Scene scene = scene_with(6);
  scene.model.help = true;
  expect_looks("canvas-help", scene.drawn());
}

TEST(CanvasGolden, HelpOnTheSmallestCanvas) {
  Scene scene = scene_of("portraits", false, kMinCanvas);
  scene.model.help = true;
  expect_looks("canvas-help-small", scene.drawn());
}

TEST(CanvasGolden, Question) {
  Scene scene = scene_with(6);
  scene.model.question = Question{"Save before closing?",
                                  {"woman-man.json has changes that are not saved."},
                                  {{'s', "Save and close"}, {'d', "Discard them"}, {'c', "Stay"}}};
  expect_looks("canvas-question", scene.drawn());
}

TEST(CanvasGolden, BrightAndDarkPicturesAndALineOfText) {
  Scene scene(plain({640, 480}, 0.6f, 1.0f), plain({500, 600}, 0.0f, 0.03f), {}, kMinCanvas);
  Model& model = scene.model;
  model.file_name = "ein sehr langer Name f\u00fcr ein Projekt, der nirgends hineinpasst.json";
  for (int i = 0; i < 5; ++i) model.document.add_line(project::kSource, {80.0 + 100 * i, 80}, {130.0 + 100 * i, 200});
  for (int i = 0; i < 4; ++i) model.document.add_point(project::kSource, {90.0 + 120 * i, 290});
  model.document.add_curve(project::kSource, {{80, 400}, {240, 350}, {400, 430}, {560, 380}}, false);
  model.entry = Entry{Entry::What::kName, "Stra\u00dfe"};
  model.sketch = Sketch{Sketch::Shape::kBox, project::kDestination, {{30, 60}, {300, 520}}, {}};
  expect_looks("canvas-contrast", scene.drawn());
}

/// Earlier drawings must leave no trace.
TEST(Canvas, DrawsEqualModelsEqually) {
  Scene scene = scene_with(8);
  Canvas canvas(scene.source, scene.destination);
  const PreviewPicture preview = scene.preview();
  const cv::Mat3b first = canvas.draw(scene.model, preview).clone();
  Model changed = scene.model;
  changed.help = true;
  changed.source_view.zoom *= 3;
  changed.document.select({{1, 2}, {}});
  changed.switches.loupe = changed.switches.onion = true;
  const cv::Mat3b between = canvas.draw(changed, preview).clone();
  EXPECT_GT(cv::norm(first, between, cv::NORM_INF), 0);
  const cv::Mat3b& again = canvas.draw(scene.model, preview);
  EXPECT_EQ(cv::norm(first, again, cv::NORM_INF), 0);
}

TEST(Canvas, DrawsAtEverySizeAndZoom) {
  for (const cv::Size size : {kMinCanvas, cv::Size(1600, 900), cv::Size(1100, 1000), cv::Size(3840, 2160)})
    for (const double zoom : {kMinZoom, 1.0, kMaxZoom}) {
      SCOPED_TRACE(std::to_string(size.width) + " " + std::to_string(zoom));
      Scene scene(plain({64, 48}, 0, 1), plain({48, 64}, 0, 1), {}, size);
      scene.model.document.add_line(project::kSource, {-90000, 3}, {90000, 20});
      scene.model.source_view.zoom = scene.model.destination_view.zoom = zoom;
      scene.model.switches.loupe = true;
      scene.point_at(project::kSource, {32, 24});
      EXPECT_EQ(Canvas(scene.source, scene.destination).draw(scene.model, {}).size(), size);
    }
}

}  // namespace
}  // namespace morphkit::edit
