// The form of a toy document: one member and one line make a key that every visitor knows.

#include "morph/project/form.h"

#include <algorithm>
#include <fstream>
#include <iterator>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/codecs.h"
#include "morph/project/form_read.h"
#include "morph/project/form_schema.h"
#include "morph/project/form_values.h"
#include "morph/project/form_write.h"
#include "morph/project/reference.h"

namespace morphkit::project {
namespace {

/// Settings that are inherited.
struct Stiffness {
  std::optional<double> bend, stretch;
  bool operator==(const Stiffness&) const = default;
};

struct Spring {
  int coils = 3;
  std::string name;
  Stiffness stiffness;
  bool operator==(const Spring&) const = default;
};

template <typename F>
void describe(F& form, Of<Stiffness>) {
  form("bend", &Stiffness::bend, {.least = 0, .most = 10, .usual = 1}, "how hard it is to bend");
  form("stretch", &Stiffness::stretch, {.least = 0, .most = 20, .usual = 2}, "how hard it is to stretch");
}

template <typename F>
void describe(F& form, Of<Spring>) {
  form("coils", &Spring::coils, {.least = 1, .most = 9}, "number of coils");
  form("name", &Spring::name, {.what = "a name", .needed = "give the spring a name"}, "its name");
  form("stiffness", &Spring::stiffness, {}, "How stiff it is.");
}

Spring read(const std::string& text) {
  const json::Document document{"spring.json", json::parse(text, "spring.json")};
  Spring spring;
  read_object(json::Cursor(document), spring, kWhole<Spring>);
  return spring;
}

json::Node write(const Spring& spring, bool defaults) {
  return write_object(spring, Spring{}, defaults);
}

/// The message of the error that reading ends with.
std::string message_of(const std::string& text) {
  try {
    read(text);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(Form, ReadsEveryKey) {
  const Spring spring = read(R"({"name": "s", "coils": 5, "stiffness": {"bend": 4, "stretch": 0.5}})");
  EXPECT_EQ(spring, (Spring{5, "s", {4, 0.5}}));
  EXPECT_EQ(read(R"({"name": "s"})"), (Spring{3, "s", {}}));
}

TEST(Form, RefusesWithThePlaceAndTheReason) {
  EXPECT_NE(message_of(R"({"name": "s", "coil": 5})").find("did you mean \"coils\"?"), std::string::npos);
  EXPECT_NE(message_of(R"({"name": "s", "stiffness": {"bend": 11}})").find("/stiffness/bend"), std::string::npos);
  EXPECT_NE(message_of("{}").find("give the spring a name"), std::string::npos);
}

TEST(Form, WritesWhatIsNotUsual) {
  const json::Node brief = write({3, "s", {{}, 0.5}}, false);
  EXPECT_EQ(brief.keys(), (std::vector<std::string>{"name", "stiffness"}));
  EXPECT_EQ(brief.find("stiffness")->keys(), (std::vector<std::string>{"stretch"}));
  const json::Node full = write({3, "s", {{}, 0.5}}, true);
  EXPECT_EQ(full.keys(), (std::vector<std::string>{"coils", "name", "stiffness"}));
}

TEST(Form, ReadsBackWhatItWrites) {
  const Spring spring{7, "s", {4, 0.5}};
  EXPECT_EQ(read(json::write(write(spring, false), "")), spring);
  EXPECT_EQ(read(json::write(write(spring, true), "")), spring);
}

TEST(Form, StatesTypesAndRangesInTheSchema) {
  const json::Node schema = object_schema<Spring>();
  const json::Node* keys = schema.find("properties");
  EXPECT_EQ(keys->keys(), (std::vector<std::string>{"coils", "name", "stiffness"}));
  EXPECT_EQ(keys->find("coils")->find("type")->text(), "integer");
  EXPECT_EQ(keys->find("coils")->find("maximum")->number(), 9);
  EXPECT_EQ(keys->find("stiffness")->find("properties")->find("stretch")->find("maximum")->number(), 20);
  EXPECT_EQ(keys->find("coils")->find("description")->text(), "number of coils; 1 to 9. Default: 3.");
  EXPECT_EQ(schema.find("required")->items().at(0).text(), "name");
}

TEST(Form, RowsForTheReferencePage) {
  std::vector<std::string> rows;
  collect_rows<Spring>(rows);
  EXPECT_EQ(rows, (std::vector<std::string>{"| `coils` | number of coils; 1 to 9 | 3 |",  //
                                            "| `name` | its name | required |",
                                            "| `bend` | how hard it is to bend; 0 to 10 | 1 |",
                                            "| `stretch` | how hard it is to stretch; 0 to 20 | 2 |"}));
}

TEST(Form, InheritsTheNearestValue) {
  const Stiffness farther = with_defaults(Stiffness{{}, 7});
  EXPECT_EQ(farther, (Stiffness{1, 7}));
  EXPECT_EQ(inherited(Stiffness{4, {}}, farther), (Stiffness{4, 7}));
}

TEST(ReferenceRows, ThePageNamesEveryKey) {
  std::ifstream stream(MORPHKIT_SOURCE_DIR "/docs/project-file.md");
  const std::string page{std::istreambuf_iterator<char>(stream), {}};
  const std::vector<std::string> rows = reference_rows();
  EXPECT_GT(rows.size(), 30U);
  for (const std::string& row : rows) {
    const std::string key = row.substr(2, row.find(" |", 2) - 2);
    EXPECT_NE(page.find(key), std::string::npos) << row;
  }
}

/// The cells of a row "| a | b | c |"; code spans hold no bars.
std::vector<std::string> cells_of(const std::string& row) {
  std::vector<std::string> cells;
  for (std::size_t at = 0; at + 1 < row.size();) {
    const std::size_t end = row.find('|', at + 1);
    if (end == std::string::npos) break;
    cells.push_back(row.substr(at + 1, end - at - 1));
    at = end;
  }
  return cells;
}

/// A row of the page with a key that has rows of its own in the form is one of these, whole. What it should be stands
/// in the message: paste it.
TEST(ReferenceRows, ThePageHasThemWhole) {
  std::map<std::string, std::vector<std::string>> rows_of_key;
  for (const std::string& row : reference_rows()) rows_of_key[cells_of(row)[0]].push_back(row);
  std::ifstream page(MORPHKIT_SOURCE_DIR "/docs/project-file.md");
  int compared = 0;
  for (std::string line; std::getline(page, line);) {
    const std::vector<std::string> cells = cells_of(line);
    if (cells.size() != 3 || !rows_of_key.contains(cells[0])) continue;
    const std::vector<std::string>& rows = rows_of_key[cells[0]];
    EXPECT_NE(std::ranges::find(rows, line), rows.end()) << line << "\nshould be\n" << rows.front();
    ++compared;
  }
  EXPECT_GE(compared, 28);
}

}  // namespace
}  // namespace morphkit::project
