#pragma once
// morphkit help [COMMAND].

namespace CLI {
class App;
}

namespace morphkit::cli {

struct Session;

void add_help(CLI::App& app, Session& session);

}  // namespace morphkit::cli
