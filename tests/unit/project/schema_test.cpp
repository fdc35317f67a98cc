#include <fstream>
#include <functional>
#include <iterator>
#include <set>
#include <string>

#include <gtest/gtest.h>

#include "base/error.h"
#include "morph/project/limits.h"
#include "morph/project/project.h"
#include "tests/unit/project/documents.h"
#include "tests/unit/project/random_project.h"
#include "tests/unit/project/schema_validator.h"

namespace morphkit::project {
namespace {

using nlohmann::json;
using test::SchemaValidator;

bool loads(const std::string& text) {
  try {
    parse(text, "x.json");
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST(Schema, AcceptsWhatTheLoaderAccepts) {
  const SchemaValidator schema(schema_text());
  for (const std::string& text : test::good_documents()) EXPECT_TRUE(schema.accepts(json::parse(text))) << text;
}

TEST(Schema, AcceptsWhatIsSaved) {
  const SchemaValidator schema(schema_text());
  for (unsigned seed = 0; seed < 200; ++seed) {
    const std::string text = to_text(test::RandomProject(seed).make());
    EXPECT_TRUE(schema.accepts(json::parse(text))) << seed << text;
  }
}

TEST(Schema, RefusesWrongStructure) {
  const SchemaValidator schema(schema_text());
  for (const test::Bad& bad : test::structurally_bad_documents()) {
    EXPECT_FALSE(schema.accepts(json::parse(bad.text))) << bad.text;
  }
}

/// Calls `visit` with every value in `value`.
void for_each(json& value, const std::function<void(json&)>& visit) {
  visit(value);
  if (!value.is_structured()) return;
  for (json& inner : value) for_each(inner, visit);
}

TEST(Schema, AgreesWithTheLoaderOnMutatedDocuments) {
  // Replaces each value of good documents by values of other types and sizes. Whatever the schema refuses the loader
  // must refuse; the loader alone knows rules between values (ids, curves, coinciding ends).
  const SchemaValidator schema(schema_text());
  const json replacements[] = {nullptr,
                               true,
                               0,
                               -1,
                               0.5,
                               1e7,
                               "",
                               "x",
                               "linear",
                               json::array(),
                               json::object(),
                               json::array({1, 2}),
                               json::array({0, 0, 0}),
                               json{{"image", "i"}},
                               json{{"x", 1}}};
  int refused = 0;
  for (const std::string& text : test::good_documents()) {
    json document = json::parse(text);
    for_each(document, [&](json& place) {
      const json before = place;
      for (const json& replacement : replacements) {
        place = replacement;
        if (schema.accepts(document)) continue;
        ++refused;
        EXPECT_FALSE(loads(document.dump())) << document.dump();
      }
      place = before;
    });
  }
  EXPECT_GT(refused, 1000);
}

TEST(Schema, AcceptsEveryMutationThatLoads) {
  const SchemaValidator schema(schema_text());
  const json replacements[] = {0, 1, 3, 0.25, "sine", "mirror", "black", "none", json::array({1, 2}), json::object()};
  int loaded = 0;
  for (const std::string& text : test::good_documents()) {
    json document = json::parse(text);
    for_each(document, [&](json& place) {
      const json before = place;
      for (const json& replacement : replacements) {
        place = replacement;
        if (!loads(document.dump())) continue;
        ++loaded;
        EXPECT_TRUE(schema.accepts(document)) << document.dump();
      }
      place = before;
    });
  }
  EXPECT_GT(loaded, 100);
}

TEST(Schema, StatesTheLoadersLimits) {
  const json schema = json::parse(schema_text());
  const auto at = [&](const std::string& pointer) { return schema.at(json::json_pointer(pointer)); };
  const std::string feature = "/properties/features/items/properties", mesh = "/properties/mesh/properties",
                    output = "/properties/output/properties",
                    point = feature + "/point/properties/source/prefixItems/0";
  EXPECT_EQ(at("/properties/features/maxItems"), kMaxFeatures);
  EXPECT_EQ(at("/properties/groups/maxItems"), kMaxFeatures);
  EXPECT_EQ(at(feature + "/curve/properties/source/maxItems"), kMaxPoints);
  EXPECT_EQ(at(mesh + "/size/prefixItems/0/maximum"), kMaxMeshSize);
  EXPECT_EQ(at(mesh + "/groups/items/properties/vertices/items/prefixItems/0/maximum"), kMaxMeshSize - 1);
  EXPECT_EQ(at(mesh + "/source/anyOf/1/maxItems"), kMaxMeshVertices);
  EXPECT_EQ(at(mesh + "/groups/items/properties/vertices/maxItems"), kMaxMeshVertices);
  EXPECT_EQ(at(mesh + "/groups/maxItems"), kMaxFeatures);
  EXPECT_EQ(at(point + "/minimum"), -kMaxCoordinate);
  EXPECT_EQ(at(point + "/maximum"), kMaxCoordinate);
  EXPECT_EQ(at(output + "/size/prefixItems/0/maximum"), kMaxSize);
  EXPECT_EQ(at("/properties/warp/properties/turns/maximum"), kMaxTurns);
  EXPECT_EQ(at("/properties/warp/properties/b/maximum"), kMaxFalloff);
  EXPECT_EQ(at(output + "/frames/maximum"), kMaxFrames);
  EXPECT_EQ(at(output + "/start/maximum"), kMaxStart);
  EXPECT_EQ(at(output + "/fps/anyOf/0/maximum"), kMaxFps);
}

void collect_names(const json& schema, std::set<std::string>& names) {
  if (schema.is_object()) {
    if (const auto properties = schema.find("properties"); properties != schema.end()) {
      for (const auto& item : properties->items()) names.insert(item.key());
    }
    if (const auto choices = schema.find("enum"); choices != schema.end()) {
      for (const json& choice : *choices) names.insert(choice.is_string() ? choice.get<std::string>() : choice.dump());
    }
  }
  if (!schema.is_structured()) return;
  for (const json& inner : schema) collect_names(inner, names);
}

std::string reference_page() {
  std::ifstream stream(MORPHKIT_SOURCE_DIR "/docs/project-file.md");
  return {std::istreambuf_iterator<char>(stream), {}};
}

TEST(ReferencePage, NamesEveryKeyAndChoice) {
  const std::string page = reference_page();
  std::set<std::string> names;
  collect_names(json::parse(schema_text()), names);
  EXPECT_GT(names.size(), 60U);
  for (const std::string& name : names) {
    const bool is_named =
        page.find("`" + name + "`") != std::string::npos || page.find("`\"" + name + "\"`") != std::string::npos;
    EXPECT_TRUE(is_named) << name;
  }
}

TEST(ReferencePage, ItsProjectsLoad) {
  const std::string page = reference_page();
  const std::string open = "```json\n", close = "```";
  int whole = 0;
  for (std::size_t at = page.find(open); at != std::string::npos; at = page.find(open, at)) {
    at += open.size();
    const std::string text = page.substr(at, page.find(close, at) - at);
    ASSERT_TRUE(json::accept(text)) << text;
    if (!json::parse(text).contains("source") || !json::parse(text).contains("morphkit")) continue;
    EXPECT_NO_THROW(parse(text, "docs")) << text;
    ++whole;
  }
  EXPECT_GE(whole, 2);
}

}  // namespace
}  // namespace morphkit::project
