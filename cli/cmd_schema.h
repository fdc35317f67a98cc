#pragma once
// morphkit schema: the JSON Schema of project files.

namespace CLI {
class App;
}

namespace morphkit::cli {

class Output;
struct Session;

void add_schema(CLI::App& app, Session& session);

/// Prints the schema. @return the exit code.
int run_schema(Output& output);

}  // namespace morphkit::cli
