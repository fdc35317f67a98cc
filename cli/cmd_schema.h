#pragma once
// morphkit schema: the JSON Schema of project files.

namespace morphkit::cli {

class CommandLine;
class Output;
struct Session;

void add_schema(CommandLine& line, Session& session);

/// Prints the schema. @return the exit code.
int run_schema(Output& output);

}  // namespace morphkit::cli
