#include "morph/project/build.h"

#include "morph/project/describe.h"
#include "morph/project/form_write.h"

namespace morphkit::project {

json::Node build(const Project& project, bool defaults) {
  static const Project kUsual;
  json::Node node = write_object(project, kUsual, defaults);
  node.mutable_hints().expand = true;
  return node;
}

}  // namespace morphkit::project
