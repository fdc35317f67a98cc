// Latency of the preview tool: plays recorded gestures and times every event until the canvas and the preview show its
// effect. Not a google-benchmark: people feel the slowest events, so it prints percentiles.
//   bench_edit [FEATURES=50] [WIDTH=1920 HEIGHT=1080]

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include <opencv2/imgproc.hpp>

#include "cli/edit/hand/editor.h"
#include "cli/edit/view/layout.h"

namespace morphkit::edit {
namespace {

const cv::Size kCanvas(1600, 900);
constexpr int kMoves = 120;  ///< two seconds of a hand at 60 events a second

double now_ms() {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

warp::Image painted(cv::Size size, unsigned seed) {
  warp::Image image(size);
  std::mt19937 random(seed);
  cv::Mat4f coarse(size.height / 16 + 1, size.width / 16 + 1);
  for (warp::Pixel& pixel : coarse) {
    const auto unit = [&] { return static_cast<float>(random()) / 4294967295.0f; };
    pixel = {unit(), unit(), unit(), 1};
  }
  cv::resize(coarse, image, size, 0, 0, cv::INTER_LINEAR);
  return image;
}

project::Project marked(cv::Size size, int features) {
  std::mt19937 random(7);
  const auto between = [&](double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
  };
  project::Project project;
  project.pictures[project::kSource].image = "a.png";
  project.pictures[project::kDestination].image = "b.png";
  project.file = std::filesystem::temp_directory_path() / "morphkit-bench-edit.json";
  for (int i = 0; i < features; ++i) {
    const cv::Point2d from(between(0.1, 0.9) * size.width, between(0.1, 0.9) * size.height);
    const double angle = between(0, 2 * std::numbers::pi);
    const cv::Point2d to = from + cv::Point2d(std::cos(angle), std::sin(angle)) * (0.06 * size.width);
    const auto moved = [&](cv::Point2d at) { return at + cv::Point2d(between(-12, 12), between(-12, 12)); };
    project::Feature feature;
    feature.id = "line " + std::to_string(i + 1);
    feature.places[project::kSource] = {from, to};
    feature.places[project::kDestination] = {moved(from), moved(to)};
    project.features.push_back(feature);
  }
  return project;
}

/// Plays events and records the time until each is visible.
class Player {
 public:
  explicit Player(Editor& editor) : editor_(editor) {}

  void mouse(Mouse::What what, cv::Point at, Mouse::Button button = Mouse::Button::kLeft, double notches = 0) {
    Mouse event;
    event.what = what;
    event.position = at;
    event.button = what == Mouse::What::kMove ? Mouse::Button::kNone : button;
    event.notches = notches;
    timed([&] { editor_.mouse(event); });
  }

  /// Drags from `from` to `to` and back.
  void drag(cv::Point from, cv::Point to, Mouse::Button button = Mouse::Button::kLeft) {
    mouse(Mouse::What::kMove, from);
    mouse(Mouse::What::kPress, from, button);
    times_.clear();  // only the drag counts
    for (int i = 0; i < kMoves; ++i) {
      const double swing = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / kMoves);
      mouse(Mouse::What::kMove, from + cv::Point(cv::Point2d(to - from) * swing));
    }
    const std::vector<double> kept = times_;
    mouse(Mouse::What::kRelease, from, button);
    times_ = kept;
  }

  void report(const char* what) {
    std::vector<double> sorted = times_;
    std::sort(sorted.begin(), sorted.end());
    const auto at = [&](double share) {
      return sorted[static_cast<std::size_t>(share * static_cast<double>(sorted.size() - 1))];
    };
    std::printf("%-34s %4zu events   median %6.1f ms   95 %% %6.1f ms   worst %6.1f ms\n", what, sorted.size(), at(0.5),
                at(0.95), at(1));
    times_.clear();
  }

 private:
  void timed(const std::function<void()>& act) {
    const double before = now_ms();
    act();
    editor_.turn(before / 1000);
    editor_.finish_preview();
    editor_.draw();
    times_.push_back(now_ms() - before);
  }

  Editor& editor_;
  std::vector<double> times_;
};

cv::Point in_window(const Editor& editor, Pane pane, cv::Point2d picture) {
  const Model& model = editor.model();
  const cv::Rect rect = layout_of(model).pane(pane);
  return rect.tl() + cv::Point(model.view(pane).to_pane(picture, rect.size()));
}

const Widget& widget(const Layout& layout, const Action& action) {
  return *std::find_if(layout.widgets.begin(), layout.widgets.end(),
                       [&](const Widget& candidate) { return candidate.action == action; });
}

void play(cv::Size size, int features) {
  const double begin = now_ms();
  const render::Footage pictures{{render::in_memory(painted(size, 1)), render::in_memory(painted(size, 2))}, {}};
  const double painted_at = now_ms();
  Editor editor(marked(size, features), pictures, kCanvas);
  editor.turn(0);
  editor.finish_preview();
  editor.draw();
  std::printf("%dx%d, %d features; from pictures in memory to the first canvas: %.0f ms (painting them: %.0f ms)\n",
              size.width, size.height, features, now_ms() - painted_at, painted_at - begin);

  Player player(editor);
  const project::Feature feature = editor.model().document.project().features.front();
  const cv::Point end = in_window(editor, Pane::kSource, feature.places[project::kSource][1]);
  player.drag(end, end + cv::Point(60, 40));
  player.report("dragging an end");

  const cv::Point middle =
      in_window(editor, Pane::kDestination,
                (feature.places[project::kDestination][0] + feature.places[project::kDestination][1]) / 2);
  player.drag(middle, middle + cv::Point(40, -30));
  player.report("dragging a feature");

  const Layout layout = layout_of(editor.model());
  const cv::Rect track = slider_track(widget(layout, TimeSlider{}), layout.scale);
  const int y = track.y + track.height / 2;
  player.drag({track.x + track.width / 2, y}, {track.br().x, y});
  player.report("scrubbing t");

  const cv::Rect tune = slider_track(widget(layout, Tuning::kA), layout.scale);
  const int tune_y = tune.y + tune.height / 2;
  player.drag({tune.x + tune.width / 10, tune_y}, {tune.x + tune.width / 2, tune_y});
  player.report("dragging a slider of a");

  const cv::Point result = in_window(editor, Pane::kResult, {size.width / 2.0, size.height / 2.0});
  for (int i = 0; i < 24; ++i) player.mouse(Mouse::What::kWheel, result, Mouse::Button::kNone, i % 12 < 6 ? 1 : -1);
  player.report("zooming the result");

  const cv::Point source = in_window(editor, Pane::kSource, {size.width / 2.0, size.height / 2.0});
  for (int i = 0; i < 24; ++i) player.mouse(Mouse::What::kWheel, source, Mouse::Button::kNone, i % 12 < 6 ? 1 : -1);
  player.drag(source, source + cv::Point(80, 50), Mouse::Button::kMiddle);
  player.report("panning the pictures");
}

}  // namespace
}  // namespace morphkit::edit

int main(int argc, char** argv) {
  const auto number = [&](int index, int fallback) { return argc > index ? std::atoi(argv[index]) : fallback; };
  morphkit::edit::play({number(2, 1920), number(3, 1080)}, number(1, 50));
  return 0;
}
