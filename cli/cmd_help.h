#pragma once
// morphkit help [COMMAND].

namespace morphkit::cli {

class CommandLine;
struct Session;

void add_help(CommandLine& line, Session& session);

}  // namespace morphkit::cli
