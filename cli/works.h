#pragma once
// Two programs are one: `morphkit` understands the command line and links no picture library, so help, messages
// and completion come at once. It hands over to `morphkit-render`, the same command line with all libraries
// (OpenImageIO, OpenCV's windows and what they bring: 270 shared libraries, 0.4 s to load) for the commands below.

#include <functional>
#include <memory>

#include "cli/command.h"

namespace morphkit::cli {

struct BenchOptions;
struct CheckOptions;
struct CompareOptions;
struct DemoOptions;
struct EditOptions;
struct ExportOptions;
struct ImportOptions;
struct InfoOptions;
struct MapOptions;
struct MorphOptions;
struct WarpOptions;

/// The work of the commands that need pictures or a window.
struct Works {
  /// Runs one of the works below with the requested number of threads. Out-of-memory errors of OpenCV become
  /// std::bad_alloc; its other exceptions pass.
  int (*run)(const CommonOptions& common, const std::function<int()>& work);

  int (*bench)(const BenchOptions&, Output&);
  int (*check)(const CheckOptions&, Output&);
  int (*compare)(const CompareOptions&, Output&);
  int (*demo)(const DemoOptions&, Output&);
  int (*edit)(const EditOptions&, Output&);
  int (*export_)(const ExportOptions&, Output&);
  int (*import_)(const ImportOptions&, Output&);
  int (*info)(const InfoOptions&, Output&);
  int (*map)(const MapOptions&, Output&);
  int (*morph)(const MorphOptions&, Output&);
  int (*warp)(const WarpOptions&, Output&);
};

/// All of them. Only the program that links the libraries may call it.
const Works& all_works();

/// Replaces this process by morphkit-render, at a fixed path relative to this program, with the same command line.
/// @throws Error kFailed if it cannot be started; does not return otherwise.
[[noreturn]] void become_renderer(const char* const* argv);

/// The action of a command: its work if that is linked, else the program that has it.
template <typename T>
Action work_of(const Session& session, int (*Works::*work)(const T&, Output&), std::shared_ptr<T> options) {
  return [&session, work, options](Output& output) {
    if (session.works == nullptr) become_renderer(session.argv);
    return session.works->run(session.common, [&] { return (session.works->*work)(*options, output); });
  };
}

}  // namespace morphkit::cli
