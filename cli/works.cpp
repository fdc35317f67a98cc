#include "cli/works.h"

#include <new>
#include <optional>

#include <opencv2/core.hpp>

#include "base/parallel.h"
#include "cli/cmd_bench.h"
#include "cli/cmd_check.h"
#include "cli/cmd_compare.h"
#include "cli/cmd_demo.h"
#include "cli/cmd_edit.h"
#include "cli/cmd_export.h"
#include "cli/cmd_import.h"
#include "cli/cmd_info.h"
#include "cli/cmd_map.h"
#include "cli/cmd_morph.h"
#include "cli/cmd_warp.h"

namespace morphkit::cli {
namespace {

int run_work(const CommonOptions& common, const std::function<int()>& work) {
  std::optional<ProcessThreads> bound;
  if (common.threads > 0) {
    bound.emplace(common.threads);
    cv::setNumThreads(common.threads);
  }
  try {
    return Workers(common.threads).run(work);
  } catch (const cv::Exception& error) {
    if (error.code == cv::Error::StsNoMem) throw std::bad_alloc();
    throw;
  }
}

}  // namespace

const Works& all_works() {
  static const Works works{.run = run_work,
                           .bench = run_bench,
                           .check = run_check,
                           .compare = run_compare,
                           .demo = run_demo,
                           .edit = run_edit,
                           .export_ = run_export,
                           .import_ = run_import,
                           .info = run_info,
                           .map = run_map,
                           .morph = run_morph,
                           .warp = run_warp};
  return works;
}

}  // namespace morphkit::cli
