#include "tests/base/schema_agreement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <sstream>

namespace ocelli::test {

void SchemaAgreement::check() const {
  ASSERT_EQ(errorOf(base.dump()), "");
  EXPECT_EQ(schema.at("type"), "object");
  EXPECT_EQ(schema.at("additionalProperties"), false);
  checkNames();
  for (const auto& [name, property] : schema.at("properties").items()) {
    if (name == "$schema" || name == "comment") {
      expectTaken(name, "anything");
    } else if (property.contains("enum")) {
      for (const nlohmann::json& choice : property.at("enum")) {
        expectTaken(name, choice);
      }
      expectRefused(name, "no such choice");
      expectRefused(name, 1);
    } else if (!property.contains("type")) {  // what is in an object defined elsewhere is for a test of its own
      expectRefused(name, 1);
    } else if (property.at("type") == "boolean") {
      expectTaken(name, true);
      expectTaken(name, false);
      expectRefused(name, 1);
      expectRefused(name, "true");
    } else if (property.at("type") == "string") {
      expectTaken(name, "text");
      expectRefused(name, 1);
    } else if (property.at("type") == "array") {
      checkArray(name, property);
    } else {
      checkRange(name, property);
    }
  }
  for (const nlohmann::json& name : schema.value("required", nlohmann::json::array())) {
    nlohmann::json without = base;
    without.erase(name.get<std::string>());
    EXPECT_NE(errorOf(without.dump()), "") << name << " is required";
  }
}

/// The reader lists the fields that it knows where it meets one that it does not.
void SchemaAgreement::checkNames() const {
  nlohmann::json document = base;
  document["no_such_field"] = 1;
  const std::string message = errorOf(document.dump());
  const std::string intro = "use one of: ";
  const size_t start = message.find(intro);
  ASSERT_NE(start, std::string::npos) << message;
  std::istringstream list(message.substr(start + intro.size()));
  std::set<std::string> known{"$schema", "comment"};
  for (std::string name; list >> name;) {
    known.insert(name.substr(0, name.find_first_of(",.;)")));
  }
  std::set<std::string> described;
  for (const auto& [name, property] : schema.at("properties").items()) {
    described.insert(name);
  }
  EXPECT_EQ(described, known);
}

void SchemaAgreement::checkRange(const std::string& name, const nlohmann::json& property) const {
  const bool whole = property.at("type") == "integer";
  const auto step = [&](double limit) { return whole ? 1 : std::max(std::abs(limit) * 1e-3, 1e-9); };
  const auto value = [&](double number) {
    return whole ? nlohmann::json(std::lround(number)) : nlohmann::json(number);
  };
  const double least = property.at("minimum");
  expectTaken(name, value(least));
  expectRefused(name, value(least - step(least)));
  if (property.contains("exclusiveMaximum")) {
    const double limit = property.at("exclusiveMaximum");
    expectTaken(name, value(limit - step(limit)));
    expectRefused(name, value(limit));
  } else {
    const double most = property.at("maximum");
    expectTaken(name, value(most));
    expectRefused(name, value(most + step(most)));
  }
  if (property.contains("default")) {
    expectTaken(name, property.at("default"));
  }
  if (whole) {
    expectRefused(name, least + 0.5);
  }
  expectRefused(name, "1");
  expectRefused(name, nullptr);
}

void SchemaAgreement::checkArray(const std::string& name, const nlohmann::json& property) const {
  const nlohmann::json& items = property.at("items");
  if (items.value("type", "") != "number") {  // what is in such a list is for a test of its own
    expectRefused(name, 1);
    nlohmann::json document = base;
    document[name] = nlohmann::json::array({1});
    EXPECT_NE(errorOf(document.dump()), "") << name;
    expectRefused(name, std::vector<nlohmann::json>(property.at("maxItems").get<size_t>() + 1, base.at(name).at(0)));
    return;
  }
  const auto size = property.at("minItems").get<size_t>();
  ASSERT_EQ(property.at("maxItems"), size);
  const nlohmann::json good = property.at("default");
  ASSERT_EQ(good.size(), size);
  expectTaken(name, good);
  nlohmann::json shorter = good;
  shorter.erase(shorter.size() - 1);
  expectRefused(name, shorter);
  nlohmann::json longer = good;
  longer.push_back(0);
  expectRefused(name, longer);
  expectRefused(name, 1);
  for (size_t i = 0; i < size; ++i) {
    for (const char* limit : {"minimum", "maximum"}) {
      nlohmann::json changed = good;
      changed[i] = items.at(limit);
      expectTaken(name, changed);
      const double value = items.at(limit);
      const double outwards = std::string(limit) == "minimum" ? -1 : 1;
      changed[i] = value + outwards * std::max(std::abs(value) * 1e-3, 1e-9);
      expectRefused(name, changed);
    }
    nlohmann::json changed = good;
    changed[i] = "1";
    expectRefused(name, changed);
  }
}

std::string SchemaAgreement::complaint(const std::string& name, const nlohmann::json& value) const {
  nlohmann::json document = base;
  document[name] = value;
  const std::string message = errorOf(document.dump());
  return message.find('"' + name + '"') == std::string::npos ? "" : message;
}

/// Another field may be at odds with the value (near beyond far), but the value is one that the field may have.
void SchemaAgreement::expectTaken(const std::string& name, const nlohmann::json& value) const {
  EXPECT_EQ(complaint(name, value).find("field \"" + name + '"'), std::string::npos) << name << ": " << value;
}

void SchemaAgreement::expectRefused(const std::string& name, const nlohmann::json& value) const {
  EXPECT_NE(complaint(name, value), "") << name << ": " << value;
}

}  // namespace ocelli::test
