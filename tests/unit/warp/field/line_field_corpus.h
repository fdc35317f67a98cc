#pragma once
// Random line sets for the tests of the field: sets that people draw, and sets that nobody would draw.

#include <random>
#include <vector>

#include "warp/field/line_field.h"

namespace morphkit::test {

/// A line set, the size of its picture, and the seed that reproduces it.
struct FieldCase {
  unsigned seed = 0;
  int width = 0, height = 0;
  int targets = 1;
  std::vector<warp::FieldLine> lines;
};

/// One row of results, the positions of every target and the values.
struct FieldRow {
  FieldRow(int targets, int n)
      : maps(static_cast<size_t>(targets), std::vector<warp::MapPoint>(static_cast<size_t>(n), warp::MapPoint(-7, -7))),
        values(static_cast<size_t>(n), -7.0f),
        value_view(1, n, values.data()) {
    for (auto& map : maps) views.emplace_back(1, n, map.data());
  }
  FieldRow(FieldRow&&) = default;

  cv::Rect area(int y, int x_begin) const { return {x_begin, y, static_cast<int>(values.size()), 1}; }

  std::vector<std::vector<warp::MapPoint>> maps;
  std::vector<float> values;
  std::vector<warp::Map> views;  ///< of the same memory
  cv::Mat1f value_view;
};

inline FieldRow evaluated_row(const warp::LineField& field, int y, int x_begin, int n,
                              warp::FieldAccuracy accuracy = warp::FieldAccuracy::kExact) {
  FieldRow row(field.targets(), n);
  field.evaluate(row.area(y, x_begin), accuracy, row.views, &row.value_view);
  return row;
}

inline FieldRow reference_row(const warp::LineField& field, int y, int x_begin, int n) {
  FieldRow row(field.targets(), n);
  field.reference(row.area(y, x_begin), row.views, &row.value_view);
  return row;
}

class FieldCaseMaker {
 public:
  explicit FieldCaseMaker(unsigned seed) : random_(seed), seed_(seed) {}

  /// Lines all over the picture, moved by up to `move` px and turned a little, equal weights.
  FieldCase ordinary(int width, int height, int lines, int targets, warp::LineWeight weight, double move);

  /// Crossing, tiny, huge, point-like and pixel-aligned lines, wild targets and mixed weights.
  FieldCase wild();

  double uniform(double low, double high) { return std::uniform_real_distribution<>(low, high)(random_); }
  cv::Point2d within(double reach) { return {uniform(-reach, reach), uniform(-reach, reach)}; }
  int integer(int low, int high) { return std::uniform_int_distribution<>(low, high)(random_); }

 private:
  template <typename T>
  T pick(std::initializer_list<T> choices) {
    return *(choices.begin() + integer(0, static_cast<int>(choices.size()) - 1));
  }
  cv::Point2d somewhere(const FieldCase& set) { return {uniform(0, set.width), uniform(0, set.height)}; }
  cv::Point2d pixel_centre(const FieldCase& set) {
    return {integer(0, set.width - 1) + 0.5, integer(0, set.height - 1) + 0.5};
  }
  warp::LineWeight weight();
  warp::Line wild_line(const FieldCase& set);

  std::mt19937 random_;
  unsigned seed_;
};

inline FieldCase FieldCaseMaker::ordinary(int width, int height, int lines, int targets, warp::LineWeight weight,
                                          double move) {
  FieldCase set{seed_, width, height, targets, {}};
  for (int i = 0; i < lines; ++i) {
    const cv::Point2d p = somewhere(set);
    const double reach = 0.1 * width;
    const warp::Line output{p, p + within(reach) + cv::Point2d(reach, 0)};
    warp::FieldLine line{output, {}, weight, pick({warp::LineScale::kAlong, warp::LineScale::kUniform}), uniform(0, 1)};
    for (int t = 0; t < targets; ++t) {
      const cv::Point2d shift = within(move);
      line.targets.push_back({output.p + shift, output.q + shift + within(move / 4)});
    }
    set.lines.push_back(line);
  }
  return set;
}

inline warp::LineWeight FieldCaseMaker::weight() {
  return {pick({0.0, 0.01, 1.0, 10.0, 100.0}),
          pick({0.0, 0.5, 1.0, 1.5, 2.0, 4.0, 8.0, uniform(0.5, 4), uniform(0, 8)}),
          pick({0.0, 0.2, 1.0, uniform(0, 1)})};
}

inline warp::Line FieldCaseMaker::wild_line(const FieldCase& set) {
  const cv::Point2d p = somewhere(set);
  switch (integer(0, 6)) {
    case 0:
      return {p, p};
    case 1:
      return {p, p + within(pick({1e-3, 0.1, 2.0}))};
    case 2:
      return {p - within(1e5), p + within(1e5)};
    case 3:
      return {pixel_centre(set), pixel_centre(set)};
    case 4:  // along a row or column of pixel centres
      return {pixel_centre(set), {integer(0, set.width - 1) + 0.5, integer(0, set.height - 1) + 0.5}};
    case 5:  // through a pixel centre shared by many lines
      return {cv::Point2d(10.5, 10.5) - 20 * within(1), cv::Point2d(10.5, 10.5)};
    default:
      return {p, somewhere(set)};
  }
}

inline FieldCase FieldCaseMaker::wild() {
  FieldCase set{seed_, pick({40, 640, 1920, 3840}), pick({30, 480, 2160}), integer(1, 4), {}};
  const int lines = pick({1, 2, 3, integer(4, 20), integer(21, 70)});
  const bool mixed = integer(0, 1) == 1;
  const warp::LineWeight common = weight();
  for (int i = 0; i < lines; ++i) {
    warp::FieldLine line{wild_line(set),
                         {},
                         mixed ? weight() : common,
                         pick({warp::LineScale::kAlong, warp::LineScale::kUniform}),
                         uniform(-2, 3)};
    const bool point = line.output.p == line.output.q;
    for (int t = 0; t < set.targets; ++t) {
      const cv::Point2d shift = within(pick({0.0, 1.0, 30.0, 500.0}));
      const cv::Point2d turn = point ? cv::Point2d() : within(pick({0.0, 0.5, 20.0, 300.0}));
      line.targets.push_back({line.output.p + shift, line.output.q + shift + turn});
    }
    set.lines.push_back(line);
  }
  return set;
}

}  // namespace morphkit::test
