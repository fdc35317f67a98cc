#include "cli/report.h"

#include <nlohmann/json.hpp>

namespace morphkit::cli {

struct ReportAccess {
  using Json = nlohmann::ordered_json;

  Json operator()(const Report::Object& object) const {
    Json json = Json::object();
    for (const auto& [key, member] : object) json[key] = std::visit(*this, member.value_);
    return json;
  }
  Json operator()(const Report::Array& array) const {
    Json json = Json::array();
    for (const Report& element : array) json.push_back(std::visit(*this, element.value_));
    return json;
  }
  template <typename Value>
  Json operator()(const Value& value) const {
    return value;
  }
  Json operator()(const Report& report) const { return std::visit(*this, report.value_); }
};

Report Report::array() {
  Report report;
  report.value_ = Array{};
  return report;
}

Report& Report::set(std::string key, Report value) {
  std::get<Object>(value_).emplace_back(std::move(key), std::move(value));
  return *this;
}

Report& Report::push(Report value) {
  std::get<Array>(value_).push_back(std::move(value));
  return *this;
}

std::string Report::to_json() const {
  return ReportAccess{}(*this).dump(2, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace morphkit::cli
