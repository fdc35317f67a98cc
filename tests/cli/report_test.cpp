#include "cli/report.h"

#include <limits>
#include <string>

#include <gtest/gtest.h>

namespace morphkit::cli {
namespace {

TEST(Report, PrintsEveryKindInTheOrderSet) {
  Report report;
  report.set("z", 1).set("a", true).set("text", "q\"\n").set("none", nullptr).set("half", 0.5);
  report.set("list", Report::array().push(1).push(Report())).set("empty", Report::array());
  EXPECT_EQ(report.to_json(),
            "{\n  \"z\": 1,\n  \"a\": true,\n  \"text\": \"q\\\"\\n\",\n  \"none\": null,\n  \"half\": 0.5,\n"
            "  \"list\": [\n    1,\n    {}\n  ],\n  \"empty\": []\n}");
}

TEST(Report, SurvivesWhatJsonCannotSay) {
  EXPECT_EQ(Report(std::numeric_limits<double>::infinity()).to_json(), "null");
  EXPECT_EQ(Report(std::string("\xff")).to_json(), "\"\xEF\xBF\xBD\"");
}

}  // namespace
}  // namespace morphkit::cli
