#pragma once
// Visitors that tell people and editors about the form: JSON Schema, and the rows of the reference page.
// Internal to morph/project.

#include <functional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "morph/project/form.h"
#include "morph/project/form_write.h"

namespace morphkit::project {

/// The sentence of a key with its range.
std::string sentence_of(std::string_view sentence, const Facts& facts, bool is_number);

/// A default as people read it: `word`, 48, none.
std::string default_text(const json::Node& value);

/// What the page and the schema say of a key's default; empty: nothing.
template <typename AnyCodec, typename Owner, typename Access>
std::string default_of(const Owner& usual, const Access& access, const Facts& facts) {
  if (!facts.otherwise.empty()) return std::string(facts.otherwise);
  if (!facts.needed.empty()) return "required";
  if constexpr (requires { AnyCodec::default_node(facts); }) {
    return default_text(AnyCodec::default_node(facts));
  } else {
    return default_text(AnyCodec::write(std::invoke(access, usual), facts, true));
  }
}

/// Builds the schema of an object.
template <typename Owner>
class SchemaForm : public Form<SchemaForm<Owner>, const Owner> {
 public:
  explicit SchemaForm(const Owner& usual = Owner{}) : usual_(usual) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access& access, const Facts& facts, std::string_view sentence) {
    json::Node node = AnyCodec::schema(facts);
    std::string text = sentence_of(sentence, facts, node.find("minimum") != nullptr);
    using T = std::remove_const_t<typename SchemaForm::template Member<Access>>;
    if constexpr (!Described<T>) {
      if (facts.needed.empty())
        text +=
            (text.ends_with('.') ? " Default: " : ". Default: ") + default_of<AnyCodec>(usual_, access, facts) + ".";
    }
    add(name, std::move(node), text);
    if (!facts.needed.empty()) required_.push(json::Node::string(std::string(name)));
  }
  template <typename Access>
  void part(const Access& access) {
    using Part = std::remove_const_t<typename SchemaForm::template Member<Access>>;
    SchemaForm<Part> inner(std::invoke(access, usual_));
    describe(inner, Of<Part>{});
    inner.move_to(properties_);
  }
  template <typename Body>
  void object(std::string_view name, std::string_view sentence, const Body& body) {
    SchemaForm<Owner> inner(usual_);
    body(inner);
    add(name, inner.take(), std::string(sentence));
  }
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view name, const Access& access, std::string_view sentence, const Body& body) {
    Owner usual;
    std::invoke(access, usual) = T{};
    SchemaForm<Owner> inner(usual);
    body(inner);
    add(name, inner.take(), std::string(sentence));
    json::Node names = json::Node::array(), one = json::Node::object();
    names.push(json::Node::string(std::string(name)));
    one.set("required", std::move(names));
    one_of_.push(std::move(one));
  }

  const json::Node& required() const noexcept { return required_; }
  void move_to(json::Node& properties) {
    for (std::size_t i = 0; i < properties_.size(); ++i) {
      properties.set(properties_.keys()[i], std::move(properties_.mutable_items()[i]));
    }
  }
  json::Node take() {
    json::Node node = json::Node::object();
    node.set("type", json::Node::string("object"));
    if (required_.size() > 0) node.set("required", std::move(required_));
    node.set("additionalProperties", json::Node::of_bool(false));
    properties_.mutable_hints().expand = true;
    node.set("properties", std::move(properties_));
    if (one_of_.size() > 0) node.set("oneOf", std::move(one_of_));
    node.mutable_hints().expand = true;
    return node;
  }

 private:
  void add(std::string_view name, json::Node node, const std::string& sentence) {
    node.set("description", json::Node::string(sentence));
    properties_.set(std::string(name), std::move(node));
  }

  Owner usual_;
  json::Node properties_ = json::Node::object(), required_ = json::Node::array(), one_of_ = json::Node::array();
};

template <typename T>
json::Node object_schema() {
  SchemaForm<T> form;
  describe(form, Of<T>{});
  return form.take();
}

/// Collects the rows of the tables on the reference page: "| `key` | sentence | default |".
template <typename Owner>
class KeyRows : public Form<KeyRows<Owner>, const Owner> {
 public:
  explicit KeyRows(std::vector<std::string>& rows, const Owner& usual = Owner{}) : rows_(rows), usual_(usual) {}

  template <typename AnyCodec, typename Access>
  void key(std::string_view name, const Access& access, const Facts& facts, std::string_view sentence) {
    if constexpr (requires { AnyCodec::inner_rows(rows_); }) {
      AnyCodec::inner_rows(rows_);
    } else {
      const bool is_number = AnyCodec::schema(facts).find("minimum") != nullptr;
      rows_.push_back("| `" + std::string(name) + "` | " + sentence_of(sentence, facts, is_number) + " | " +
                      default_of<AnyCodec>(usual_, access, facts) + " |");
    }
  }
  template <typename Access>
  void part(const Access& access) {
    using Part = std::remove_const_t<typename KeyRows::template Member<Access>>;
    KeyRows<Part> inner(rows_, std::invoke(access, usual_));
    describe(inner, Of<Part>{});
  }
  template <typename Body>
  void object(std::string_view, std::string_view, const Body& body) {
    body(*this);
  }
  template <typename T, typename Access, typename Body>
  void alternative(Of<T>, std::string_view, const Access& access, std::string_view, const Body& body) {
    Owner usual;
    std::invoke(access, usual) = T{};
    KeyRows<Owner> inner(rows_, usual);
    body(inner);
  }

 private:
  std::vector<std::string>& rows_;
  Owner usual_;
};

template <typename T>
void collect_rows(std::vector<std::string>& rows) {
  KeyRows<T> form(rows);
  describe(form, Of<T>{});
}

}  // namespace morphkit::project
