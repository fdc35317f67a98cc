#include "cli/edit/document/groups.h"

#include <string>

#include <gtest/gtest.h>

#include "cli/edit/document/document.h"
#include "tests/unit/edit/document/make_document.h"

namespace morphkit::edit {
namespace {

using test::empty_project;
using test::feature;
using test::kHere;

TEST(Groups, ComeAndGoWithWhatBelongsToThem) {
  project::Project project = empty_project();
  project.groups = {{"tuned", {}, {}}, {"idle", {}, {}}};
  project.groups[0].pull.a = 3;
  Document document(project, {400, 300}, {400, 300});
  document.add_point(kHere, {1, 2});
  document.group_selected("tuned");
  EXPECT_EQ(document.tuning(Tuning::kA), 3);
  EXPECT_FALSE(document.tuning_is_own(Tuning::kA));
  document.group_selected("eye");
  EXPECT_EQ(document.project().groups.size(), 3U) << "tuned says something, idle was never left";
  EXPECT_TRUE(document.group_selected(std::string(1, '\t'))) << "no name";
  EXPECT_EQ(feature(document, 0).group, "eye");
  document.group_selected("");
  ASSERT_EQ(document.project().groups.size(), 2U);
  EXPECT_EQ(document.project().groups[1].id, "idle");
  document.group_selected("eye");
  document.erase_selected();
  EXPECT_EQ(document.project().groups.size(), 2U);
}

}  // namespace
}  // namespace morphkit::edit
