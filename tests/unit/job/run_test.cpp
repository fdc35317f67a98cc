#include "morph/job/run.h"

#include <atomic>
#include <map>
#include <mutex>
#include <numeric>

#include <gtest/gtest.h>

#include "base/error.h"
#include "tests/support/pictures.h"
#include "tests/support/threads.h"

namespace morphkit::job {
namespace {

using test::pictures;
using test::random_image;
using test::same_bits;
using test::small_project;

/// Keeps frames in memory and watches how it is called.
class MemorySink : public media::FrameSink {
 public:
  Packet encode(int frame, const warp::Image& image) override {
    const int now = ++alive;
    int most = most_alive.load();
    while (now > most && !most_alive.compare_exchange_weak(most, now)) {
    }
    const std::scoped_lock lock(mutex_);
    frames[frame] = image;
    return Packet(1, static_cast<std::uint8_t>(frame));
  }
  void write(int frame, Packet packet) override {
    EXPECT_EQ(packet, Packet(1, static_cast<std::uint8_t>(frame)));
    order.push_back(frame);
    --alive;
    if (fail_at == frame) throw Error(ErrorKind::kIo, "sink", "full");
  }
  void finish() override { finished = true; }
  bool has(int frame) const override { return present.contains(frame); }
  std::vector<std::filesystem::path> existing(const std::vector<int>&) const override { return {}; }

  std::map<int, warp::Image> frames;
  std::map<int, bool> present;
  std::vector<int> order;
  std::atomic<int> alive{0}, most_alive{0};
  int fail_at = -1;
  bool finished = false;

 private:
  std::mutex mutex_;
};

std::vector<int> numbers(int first, int last) {
  std::vector<int> result(static_cast<std::size_t>(last - first + 1));
  std::iota(result.begin(), result.end(), first);
  return result;
}

render::Renderer renderer() {
  return {small_project(), pictures(random_image({96, 64}, 1), random_image({96, 64}, 2))};
}

TEST(Run, DeliversAllFramesInOrderWithFewAlive) {
  const render::Renderer morph = renderer();
  MemorySink sink;
  const Progress progress = run(morph, sink, {numbers(1, 9), false, 2, {}, {}});
  EXPECT_EQ(sink.order, numbers(1, 9));
  EXPECT_LE(sink.most_alive, 2);
  EXPECT_EQ(progress.done, 9);
  EXPECT_TRUE(sink.finished);
}

TEST(Run, FramesDoNotDependOnChunksOrThreads) {
  const render::Renderer morph = renderer();
  MemorySink whole, chunk;
  test::set_threads(5);
  run(morph, whole, {numbers(1, 9), false, 4, {}, {}});
  test::set_threads(1);
  run(morph, chunk, {{7, 8, 9}, false, 0, {}, {}});
  run(morph, chunk, {{2, 5}, false, 0, {}, {}});
  test::set_threads(0);
  for (const auto& [frame, image] : chunk.frames) EXPECT_TRUE(same_bits(image, whole.frames.at(frame))) << frame;
  EXPECT_EQ(chunk.frames.size(), 5u);
}

TEST(Run, ResumeSkipsWhatIsThere) {
  MemorySink sink;
  sink.present = {{2, true}, {3, true}};
  const Progress progress = run(renderer(), sink, {numbers(1, 4), true, 0, {}, {}});
  EXPECT_EQ(sink.order, (std::vector<int>{1, 4}));
  EXPECT_EQ(progress.skipped, 2);
  EXPECT_EQ(progress.done, 2);
}

TEST(Run, CancellingDeliversWhatWasBegunAndDoesNotFinish) {
  MemorySink sink;
  const RunOptions options{numbers(1, 9), false, 1, {}, [&] { return sink.order.size() >= 3; }};
  try {
    run(renderer(), sink, options);
    FAIL() << "not interrupted";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::kInterrupted);
  }
  EXPECT_FALSE(sink.finished);
  EXPECT_EQ(sink.alive, 0);
  EXPECT_EQ(sink.order, numbers(1, static_cast<int>(sink.order.size())));
  EXPECT_GE(sink.order.size(), 3u);
  EXPECT_LT(sink.order.size(), 9u);
}

TEST(Run, AnErrorInTheSinkEndsTheRun) {
  MemorySink sink;
  sink.fail_at = 4;
  EXPECT_THROW(run(renderer(), sink, {numbers(1, 9), false, 3, {}, {}}), Error);
  EXPECT_FALSE(sink.finished);
}

TEST(SinkOptions, TellOfTheFrames) {
  Pictures pictures;
  pictures.sides.resize(2);
  for (media::Picture& side : pictures.sides) side.image = random_image({96, 64}, 1);
  project::Project project = small_project();
  project.output.fps = {30000, 1001};
  const media::SinkOptions opaque = sink_options(render::Renderer(project, footage_of(pictures)), pictures);
  EXPECT_EQ(opaque.size, cv::Size(96, 64));
  EXPECT_EQ(opaque.fps_num, 30000);
  EXPECT_EQ(opaque.fps_den, 1001);
  EXPECT_FALSE(opaque.has_alpha);
  EXPECT_EQ(opaque.image.alpha, false);
  pictures.sides[1].info.has_alpha = true;
  const media::SinkOptions transparent = sink_options(render::Renderer(project, footage_of(pictures)), pictures);
  EXPECT_TRUE(transparent.has_alpha);
  EXPECT_EQ(transparent.image.alpha, true);
}

}  // namespace
}  // namespace morphkit::job
