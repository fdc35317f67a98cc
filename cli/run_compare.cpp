#include "cli/cmd_compare.h"

#include <fmt/format.h>

#include "cli/cmd_morph.h"
#include "cli/command.h"
#include "cli/command_line.h"
#include "cli/exit_code.h"
#include "cli/report.h"
#include "cli/terminal.h"
#include "morph/media/image_file.h"
#include "warp/image/compare.h"

namespace morphkit::cli {
namespace {

/// The reader replaces pixels that are not finite; for comparing, they must not pass as agreement.
struct FileDifference : warp::Difference {
  std::int64_t nonfinite_a = 0, nonfinite_b = 0;
  bool passes(double tolerance) const { return nonfinite_a == 0 && nonfinite_b == 0 && within(tolerance); }
};

std::string pixel_text(const warp::Pixel& pixel) {
  return fmt::format("({:.6g}, {:.6g}, {:.6g}, {:.6g})", pixel[0], pixel[1], pixel[2], pixel[3]);
}

Report pixel_report(const warp::Pixel& pixel) {
  Report report = Report::array();
  for (int c = 0; c < 4; ++c) report.push(static_cast<double>(pixel[c]));
  return report;
}

int report_sizes(const CompareOptions& options, const cv::Size& a, const cv::Size& b, Output& output) {
  if (options.json) {
    Report report;
    report.set("equal_size", false).set("identical", false).set("within_tolerance", false);
    report.set("size_a", Report::array().push(a.width).push(a.height));
    report.set("size_b", Report::array().push(b.width).push(b.height));
    output.line(report.to_json());
  } else {
    output.line(fmt::format("sizes differ: {} is {}x{}, {} is {}x{}", options.a.string(), a.width, a.height,
                            options.b.string(), b.width, b.height));
  }
  if (!options.difference.empty()) output.warning("no difference picture was written: the sizes differ");
  return kExitDifference;
}

void print_json(const CompareOptions& options, const FileDifference& found, const warp::Image& a, const warp::Image& b,
                Output& output) {
  Report report;
  report.set("equal_size", true).set("identical", found.passes(0));
  report.set("within_tolerance", found.passes(options.tolerance)).set("tolerance", options.tolerance);
  report.set("psnr_db", found.psnr_db).set("max_abs", found.max_abs);
  report.set("pixels", static_cast<std::int64_t>(a.total())).set("differing_pixels", found.differing);
  report.set("nonfinite_pixels_a", found.nonfinite_a).set("nonfinite_pixels_b", found.nonfinite_b);
  if (found.worst.x >= 0) {
    Report worst;
    worst.set("x", found.worst.x).set("y", found.worst.y);
    worst.set("a", pixel_report(warp::comparison_value(a(found.worst))));
    worst.set("b", pixel_report(warp::comparison_value(b(found.worst))));
    report.set("worst", worst);
  }
  output.line(report.to_json());
}

void print_text(const CompareOptions& options, const FileDifference& found, const warp::Image& a, const warp::Image& b,
                Output& output) {
  if (found.nonfinite_a > 0 || found.nonfinite_b > 0) {
    output.line(fmt::format("not finite        {} pixels of A, {} of B: always a difference", found.nonfinite_a,
                            found.nonfinite_b));
  }
  if (found.identical()) {
    output.line(fmt::format("{} bit for bit: {}x{} pixels",
                            found.passes(0) ? "identical" : "all other pixels identical", a.cols, a.rows));
    return;
  }
  const auto total = static_cast<double>(a.total());
  output.line(fmt::format("differing pixels  {} of {} ({:.4g} %)", found.differing, a.total(),
                          100 * static_cast<double>(found.differing) / total));
  output.line(fmt::format("PSNR              {:.2f} dB", found.psnr_db));
  output.line(fmt::format("largest           {:.6g} ({:.4g} of 255)", found.max_abs, 255 * found.max_abs));
  output.line(fmt::format("worst pixel       x {} y {}: A {}, B {}", found.worst.x, found.worst.y,
                          pixel_text(warp::comparison_value(a(found.worst))),
                          pixel_text(warp::comparison_value(b(found.worst)))));
  if (options.tolerance > 0) {
    output.line(fmt::format("{} the tolerance of {:g}", found.passes(options.tolerance) ? "within" : "beyond",
                            options.tolerance));
  }
}

}  // namespace

int run_compare(const CompareOptions& options, Output& output) {
  const media::Picture a = media::read_picture(options.a);
  const media::Picture b = media::read_picture(options.b);
  warn_of_pixels(options.a, a, output);
  warn_of_pixels(options.b, b, output);
  if (a.image.size() != b.image.size()) return report_sizes(options, a.image.size(), b.image.size(), output);

  const FileDifference found{warp::compare(a.image, b.image), a.nonfinite_pixels, b.nonfinite_pixels};
  if (options.json) {
    print_json(options, found, a.image, b.image, output);
  } else {
    print_text(options, found, a.image, b.image, output);
  }
  if (!options.difference.empty()) {
    media::WriteOptions write;
    write.overwrite = options.overwrite;
    as_asked(
        [&] { media::write_image(options.difference, warp::difference_image(a.image, b.image, options.gain), write); });
  }
  return found.passes(options.tolerance) ? 0 : kExitDifference;
}

}  // namespace morphkit::cli
