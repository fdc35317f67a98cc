#include "warp/image/image_pool.h"

#include <thread>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

namespace morphkit::warp {
namespace {

TEST(ImagePool, ReusesMemoryForTheNextImageOfItsSize) {
  const cv::Size size(512, 300);
  Image first = pooled_image(size);
  const void* const memory = first.data;
  Image shared = first;
  first.release();
  Image second = pooled_image(size);
  EXPECT_NE(second.data, memory) << "still in use";
  shared.release();
  EXPECT_EQ(pooled_image(size).data, memory);
  EXPECT_NE(pooled_image({512, 301}).data, memory);
}

TEST(ImagePool, ImagesBehaveLikeAnyOther) {
  Image image = pooled_image({700, 500});
  ASSERT_EQ(image.size(), cv::Size(700, 500));
  EXPECT_TRUE(image.isContinuous());
  image = Pixel(1, 2, 3, 4);
  const Image copy = image.clone(), part = image(cv::Rect(10, 20, 30, 40));
  image.release();
  EXPECT_EQ(part(5, 5), Pixel(1, 2, 3, 4));
  EXPECT_EQ(copy(499, 699), Pixel(1, 2, 3, 4));
  EXPECT_TRUE(pooled_image({0, 0}).empty());
}

TEST(ImagePool, ThreadsNeverShareABlock) {
  std::vector<std::thread> threads;
  std::vector<int> wrong(4, 0);
  for (int t = 0; t < 4; ++t)
    threads.emplace_back([&wrong, t] {
      for (int i = 0; i < 200; ++i) {
        Image image = pooled_image({300, 300 + i % 3});
        image = Pixel::all(static_cast<float>(t));
        for (const Pixel& pixel : image) wrong[static_cast<std::size_t>(t)] += pixel[0] != static_cast<float>(t);
      }
    });
  for (std::thread& thread : threads) thread.join();
  EXPECT_EQ(wrong, std::vector<int>(4, 0));
}

}  // namespace
}  // namespace morphkit::warp
