// The form as others read it: a JSON Schema, and the rows of the tables in docs/project-file.md.

#include <utility>

#include "morph/project/describe.h"
#include "morph/project/form_schema.h"
#include "morph/project/reference.h"

namespace morphkit::project {

std::string schema_text() {
  json::Node node = json::Node::object(), definitions = json::Node::object();
  const auto text = [&](const char* key, const char* value) { node.set(key, json::Node::string(value)); };
  text("$schema", "https://json-schema.org/draft/2020-12/schema");
  text("$id", "https://morphkit.invalid/schema/project-1.json");
  text("title", "morphkit project, version 1");
  text("description",
       "Two pictures, what corresponds to what, how the change is timed, and what comes out. Coordinates are pixels, x "
       "right, y down, from the top left corner of the picture; the centre of its first pixel is [0.5, 0.5].");
  json::Node form = object_schema<Project>();
  for (std::size_t i = 0; i < form.size(); ++i) node.set(form.keys()[i], std::move(form.mutable_items()[i]));
  definitions.set("timing", Codec<motion::Timing>::full_schema());
  node.set("$defs", std::move(definitions));
  node.mutable_hints().expand = true;
  return json::write(node, "");
}

std::vector<std::string> reference_rows() {
  std::vector<std::string> rows;
  collect_rows<Project>(rows);
  timing_rows(rows);
  return rows;
}

}  // namespace morphkit::project
