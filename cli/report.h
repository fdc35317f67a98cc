#pragma once
// The result of a command as JSON for machines. Only report.cpp uses a JSON library in cli.

#include <concepts>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace morphkit::cli {

/// A JSON value. Default: an empty object. Objects keep the order in which keys were set.
class Report {
 public:
  Report() = default;
  Report(std::nullptr_t) : value_(nullptr) {}
  Report(bool value) : value_(value) {}
  Report(std::integral auto value) : value_(static_cast<std::int64_t>(value)) {}
  Report(double value) : value_(value) {}  ///< printed as null if not finite: JSON has no other way
  Report(const char* value) : value_(std::string(value)) {}
  Report(std::string value) : value_(std::move(value)) {}

  static Report array();

  /// Adds a member to an object. The key must be new; this is not checked.
  Report& set(std::string key, Report value);
  /// Adds an element to an array.
  Report& push(Report value);

  /// Indented by two spaces, without a newline at the end. Bytes that are not UTF-8 become U+FFFD.
  std::string to_json() const;

 private:
  friend struct ReportAccess;
  using Array = std::vector<Report>;
  using Object = std::vector<std::pair<std::string, Report>>;
  std::variant<Object, Array, std::nullptr_t, bool, std::int64_t, double, std::string> value_;
};

}  // namespace morphkit::cli
