#pragma once
// The types that every part of morphkit shares, and the conventions they carry.
//
// Pixels: x right, y down, origin at the top left corner of the image. Pixel (i, j) covers [i, i+1) x [j, j+1); its
// centre is (i + 0.5, j + 0.5). Every coordinate is in these pixels of the image that it refers to.
//
// Colour: linear light, premultiplied alpha, float; values above 1 and below 0 are legal. Files are converted at the
// border (morph/media), once.

#include <opencv2/core.hpp>

namespace morphkit::warp {

/// RGBA, float, linear light, premultiplied alpha.
using Image = cv::Mat4f;
using Pixel = cv::Vec4f;

/// For every output pixel centre, the position in the source, in source pixels. NaN means "nothing there".
using Map = cv::Mat2f;
using MapPoint = cv::Vec2f;

}  // namespace morphkit::warp
