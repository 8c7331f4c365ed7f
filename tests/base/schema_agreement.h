// Does a JSON Schema say what the reader of such files does? Walks the schema's properties and hands the reader
// documents at and beyond every limit.
#pragma once

#include <functional>
#include <nlohmann/json.hpp>
#include <string>

namespace ocelli::test {

struct SchemaAgreement {
  nlohmann::json schema;
  /// The message of the InputError that reading this text gives, empty where it is read.
  std::function<std::string(const std::string& text)> errorOf;
  /// A document that the reader takes; properties are added to it one at a time.
  nlohmann::json base = nlohmann::json::object();

  /// Fails the test where schema and reader disagree on names, types, ranges, sizes, choices or what is required.
  void check() const;

 private:
  void checkNames() const;
  void checkRange(const std::string& name, const nlohmann::json& property) const;
  void checkArray(const std::string& name, const nlohmann::json& property) const;
  /// The reader's complaint about this very field, empty where it has none.
  std::string complaint(const std::string& name, const nlohmann::json& value) const;
  void expectTaken(const std::string& name, const nlohmann::json& value) const;
  void expectRefused(const std::string& name, const nlohmann::json& value) const;
};

}  // namespace ocelli::test
