#pragma once
// Colours and shapes of the preview tool. Colours are BGR, as in OpenCV.

#include <vector>

#include <opencv2/core.hpp>

namespace morphkit::edit {

namespace palette {
inline const cv::Vec3b kBackground(30, 28, 27);
inline const cv::Vec3b kStrip(38, 36, 35);
inline const cv::Vec3b kWidget(58, 54, 52);
inline const cv::Vec3b kWidgetOff(44, 41, 40);
inline const cv::Vec3b kAccent(176, 132, 62);
inline const cv::Vec3b kText(228, 226, 224);
inline const cv::Vec3b kQuiet(158, 154, 152);
inline const cv::Vec3b kFaint(104, 100, 98);
inline const cv::Vec3b kDark(16, 15, 14);
inline const cv::Vec3b kLight(250, 250, 250);
inline const cv::Vec3b kAlert(92, 104, 240);
inline const cv::Vec3b kMesh(214, 200, 130);
}  // namespace palette

/// Colour of a feature on both pictures. Hues are a golden angle apart, so neighbours differ.
cv::Vec3b feature_color(int feature);

/// `share` of the way from a to b.
cv::Vec3b mixed(const cv::Vec3b& a, const cv::Vec3b& b, double share);

/// A rectangle with round corners. @param cover  1: opaque.
void fill(cv::Mat3b& picture, const cv::Rect& rect, const cv::Vec3b& color, int radius = 0, double cover = 1);

/// A picture scaled and moved over the background.
/// @param map  px of the result to px of the picture, both with pixel centres at whole numbers.
/// @param how  an interpolation of OpenCV.
cv::Mat3b placed(const cv::Mat3b& picture, const cv::Matx23d& map, cv::Size size, int how);

// Antialiased, to fractions of a px; positions may lie anywhere.
void stroke(cv::Mat3b& picture, const std::vector<cv::Point2d>& points, const cv::Vec3b& color, int thickness);
void disc(cv::Mat3b& picture, cv::Point2d centre, double radius, const cv::Vec3b& color);
void ring(cv::Mat3b& picture, cv::Point2d centre, double radius, const cv::Vec3b& color, int thickness);
void polygon(cv::Mat3b& picture, const std::vector<cv::Point2d>& corners, const cv::Vec3b& color);

}  // namespace morphkit::edit
