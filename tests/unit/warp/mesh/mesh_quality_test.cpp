// The mesh warp against exact results: pictures with known values at every point, 16 x 16 samples per output pixel
// through the warp's exact map.

#include <gtest/gtest.h>

#include <string>

#include "tests/unit/warp/mesh/mesh_pictures.h"

namespace morphkit::warp {
namespace {

using test::bent_mesh;
using test::Photograph;
using test::plate_quality;
using test::psnr;
using test::reference_pixels;
using test::sparse_map;
using test::ZonePlate;

const cv::Size kPhotographSize(600, 400);
constexpr int kStride = 11;  // between pixels that are compared

TEST(MeshQuality, TheMeshOfTheZonePlateIsInOrderAndRadialInTheMeasuredPart) {
  const Mesh from = ZonePlate::from();
  const Mesh to = ZonePlate::to();
  EXPECT_TRUE(find_folds(from).empty());
  EXPECT_FALSE(off_outline(from, cv::Rect2d(0, 0, ZonePlate::kSourceSize, ZonePlate::kSourceSize), 0));
  const MeshWarp warp(from, to);
  const cv::Rect measured = ZonePlate::measured();
  for (double y = measured.y; y <= measured.br().y; y += 7.3) {
    for (double x = measured.x; x <= measured.br().x; x += 7.1) {
      EXPECT_LE(cv::norm(warp.source_of({x, y}) - ZonePlate::radial({x, y})), 0.15) << x << " " << y;
    }
  }
}

TEST(MeshQuality, TheMapOfTheReferenceEqualsTheWarp) {
  const MeshWarp warp(ZonePlate::from(), ZonePlate::to());
  const cv::Rect measured = ZonePlate::measured();
  const Map map = sparse_map(warp, measured, 61, {0.25, 0.75});
  for (int y = 0; y < map.rows; ++y) {
    for (int x = 0; x < map.cols; ++x) {
      const cv::Point2d exact =
          warp.source_of(cv::Point2d(measured.tl() + 61 * cv::Point(x, y)) + cv::Point2d(0.25, 0.75));
      EXPECT_LE(cv::norm(exact - cv::Point2d(cv::Vec2d(map(y, x)))), 3e-4) << x << " " << y;
    }
  }
}

TEST(MeshQuality, ZonePlate) {
  const cv::Size size(ZonePlate::kOutputSize, ZonePlate::kOutputSize);
  const Image source = ZonePlate::source();
  const MeshWarp warp(ZonePlate::from(), ZonePlate::to(), {MeshSpline::kMonotone, PassOrder::kRowsFirst});
  const Image out = warp.apply(source, size);
  const auto references = reference_pixels(warp, ZonePlate::measured(), kStride, ZonePlate::value);
  const auto [whole, passband, alias_zone] =
      plate_quality(ZonePlate::plate(), references, [&](cv::Point at) { return static_cast<double>(out(at)[1]); });
  RecordProperty("whole_db", std::to_string(whole));
  RecordProperty("passband_db", std::to_string(passband));
  RecordProperty("alias_zone_db", std::to_string(alias_zone));
  EXPECT_GE(passband, 40);
  EXPECT_GE(alias_zone, 24);
  EXPECT_GE(whole, 28);

  // Plate and meshes are symmetric about the diagonal, so the other order must be as good.
  const MeshWarp other(ZonePlate::from(), ZonePlate::to(), {MeshSpline::kMonotone, PassOrder::kColumnsFirst});
  EXPECT_LE(cv::norm(other.apply(source, size), Image(out.t()), cv::NORM_INF), 1e-5);
}

void expect_photograph(const Mesh& from, const Mesh& to) {
  ASSERT_TRUE(find_folds(from).empty() && find_folds(to).empty());
  const Photograph photograph(kPhotographSize);
  const MeshWarp warp(from, to);
  const Image out = warp.apply(photograph.image(), kPhotographSize);
  const cv::Rect inner(8, 8, kPhotographSize.width - 16, kPhotographSize.height - 16);
  const auto references = reference_pixels(warp, inner, kStride, [&](cv::Point2d at) { return photograph.value(at); });
  const double quality = psnr(
      references, [&](cv::Point at) { return static_cast<double>(out(at)[1]); }, [](cv::Point) { return true; });
  testing::Test::RecordProperty("psnr_db", std::to_string(quality));
  EXPECT_GE(quality, 40);
}

TEST(MeshQuality, PhotographGentlyBent) {
  expect_photograph(bent_mesh(10, 10, kPhotographSize, 0.03, 0.05, 1),
                    bent_mesh(10, 10, kPhotographSize, 0.03, 0.05, 2));
}

TEST(MeshQuality, PhotographStronglyBent) {
  expect_photograph(bent_mesh(10, 10, kPhotographSize, 0.12, 0.25, 3),
                    bent_mesh(10, 10, kPhotographSize, 0.12, 0.25, 4));
}

}  // namespace
}  // namespace morphkit::warp
