#pragma once
// As much of JSON Schema 2020-12 as the project's schema uses. Any other keyword is a failure of the test.

#include <algorithm>
#include <cmath>
#include <regex>
#include <set>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

namespace morphkit::test {

class SchemaValidator {
 public:
  using Json = nlohmann::json;

  explicit SchemaValidator(const std::string& schema) : root_(Json::parse(schema)) { check_keywords(root_); }

  const Json& root() const { return root_; }
  bool accepts(const Json& value) const { return valid(root_, value); }

 private:
  /// A misspelled keyword would silently allow everything.
  static void check_keywords(const Json& schema) {
    static const std::set<std::string> kKnown = {
        "$schema",   "$id",         "title",    "description", "$defs",    "$ref",
        "type",      "enum",        "const",    "properties",  "required", "additionalProperties",
        "items",     "prefixItems", "minItems", "maxItems",    "minimum",  "maximum",
        "minLength", "pattern",     "oneOf",    "anyOf"};
    for (const auto& [key, value] : schema.items()) {
      if (!kKnown.contains(key)) throw std::logic_error("unknown keyword " + key);
      if (key == "properties" || key == "$defs") {
        for (const auto& [name, inner] : value.items()) check_keywords(inner);
      } else if (key == "oneOf" || key == "anyOf" || key == "prefixItems") {
        for (const Json& inner : value) check_keywords(inner);
      } else if (key == "items") {
        check_keywords(value);
      } else if (key == "additionalProperties" && value != false) {
        throw std::logic_error("additionalProperties other than false");
      }
    }
  }

  static bool has_type(const std::string& type, const Json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer") return value.is_number() && value.get<double>() == std::trunc(value.get<double>());
    throw std::logic_error("unknown type " + type);
  }

  bool valid(const Json& schema, const Json& value) const {
    const auto holds = [&](const auto& entry) { return keyword(schema, entry.key(), entry.value(), value); };
    for (auto it = schema.begin(); it != schema.end(); ++it) {
      if (!holds(it)) return false;
    }
    return true;
  }

  bool keyword(const Json& schema, const std::string& key, const Json& rule, const Json& value) const {
    if (key == "$ref") return valid(root_.at(Json::json_pointer(rule.get<std::string>().substr(1))), value);
    if (key == "type") return has_type(rule, value);
    if (key == "const") return value == rule;
    if (key == "enum") return std::find(rule.begin(), rule.end(), value) != rule.end();
    const auto matches = [&](const Json& inner) { return valid(inner, value); };
    if (key == "oneOf") return std::count_if(rule.begin(), rule.end(), matches) == 1;
    if (key == "anyOf") return std::any_of(rule.begin(), rule.end(), matches);
    if (value.is_number()) return number_keyword(key, rule, value);
    if (value.is_string()) return string_keyword(key, rule, value);
    if (value.is_array()) return array_keyword(key, rule, value);
    if (value.is_object()) return object_keyword(schema, key, rule, value);
    return true;
  }

  static bool number_keyword(const std::string& key, const Json& rule, const Json& value) {
    if (key == "minimum") return value.get<double>() >= rule.get<double>();
    if (key == "maximum") return value.get<double>() <= rule.get<double>();
    return true;
  }

  static bool string_keyword(const std::string& key, const Json& rule, const std::string& value) {
    if (key == "minLength") return value.size() >= rule.get<std::size_t>();
    if (key == "pattern") return std::regex_search(value, std::regex(rule.get<std::string>()));
    return true;
  }

  bool array_keyword(const std::string& key, const Json& rule, const Json& value) const {
    if (key == "minItems") return value.size() >= rule.get<std::size_t>();
    if (key == "maxItems") return value.size() <= rule.get<std::size_t>();
    if (key == "items")
      return std::all_of(value.begin(), value.end(), [&](const Json& item) { return valid(rule, item); });
    if (key == "prefixItems") {
      for (std::size_t i = 0; i < std::min(rule.size(), value.size()); ++i) {
        if (!valid(rule[i], value[i])) return false;
      }
    }
    return true;
  }

  bool object_keyword(const Json& schema, const std::string& key, const Json& rule, const Json& value) const {
    if (key == "required") {
      return std::all_of(rule.begin(), rule.end(),
                         [&](const Json& name) { return value.contains(name.get<std::string>()); });
    }
    if (key == "properties") {
      return std::all_of(value.items().begin(), value.items().end(), [&](const auto& item) {
        return !rule.contains(item.key()) || valid(rule.at(item.key()), item.value());
      });
    }
    if (key == "additionalProperties") {
      return std::all_of(value.items().begin(), value.items().end(),
                         [&](const auto& item) { return schema.at("properties").contains(item.key()); });
    }
    return true;
  }

  Json root_;
};

}  // namespace morphkit::test
