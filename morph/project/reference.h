#pragma once
// The rows of the tables in docs/project-file.md, as the form tells them.

#include <string>
#include <vector>

namespace morphkit::project {

/// "| `key` | what it means | default |" for every key of the document. A test checks that the page names each key.
std::vector<std::string> reference_rows();

}  // namespace morphkit::project
