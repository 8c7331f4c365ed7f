// graph_camera.schema.json and curved_ray_camera.schema.json say what graph_operations.cpp and curved_bends.cpp read.
#include <gtest/gtest.h>

#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/curved_bends.h"
#include "oc_core/constructor/graph_operations.h"
#include "tests/camera/test_curved_cameras.h"
#include "tests/camera/test_graph_cameras.h"
#include "tests/constructor/camera_text.h"

namespace ocelli {
namespace {

using nlohmann::json;
using Pointer = json::json_pointer;

/// Walks a document that the reader takes along its schema.
struct SchemaWalk {
  json schema;
  json document;
  std::function<std::string(const std::string& text)> errorOf;

  void check() const {
    ASSERT_EQ(errorOf(document.dump()), "");
    walk(Pointer(""), schema);
  }

 private:
  const json& resolved(const json& node) const {
    const std::string reference = node.value("$ref", "");
    return reference.starts_with('#') ? resolved(schema.at(Pointer(reference.substr(1)))) : node;
  }

  void walk(const Pointer& at, const json& given) const {
    const json& node = resolved(given);
    if (node.contains("oneOf")) {
      const json& operation = document.at(at).at("operation");
      for (const json& choice : node.at("oneOf")) {
        if (resolved(choice).at("properties").at("operation").at("const") == operation) {
          return walk(at, choice);
        }
      }
      FAIL() << operation << " is not in the schema";
    } else if (node.contains("properties")) {
      walkObject(at, node);
    } else if (node.value("type", "") == "array") {
      walkArray(at, node);
    } else if (node.contains("const") || node.contains("enum")) {
      expectRefused(at, "no such choice");
      expectRefused(at, 1);
    } else if (node.contains("maximum")) {
      expectRefused(at, node.at("maximum").get<double>() * 1.001 + 1e-3);
      expectRefused(at, node.at("minimum").get<double>() * 1.001 - 1e-3);
    }
  }

  void walkObject(const Pointer& at, const json& node) const {
    EXPECT_EQ(node.at("additionalProperties"), false) << at;
    json unknown = document;
    unknown[at / "no_such_field"] = 1;
    const std::string message = errorOf(unknown.dump());
    EXPECT_NE(message.find("no_such_field"), std::string::npos) << at << message;
    for (const json& name : node.value("required", json::array())) {
      if (name == "camera") {
        continue;  // whoever reads that knows which of the cameras it is
      }
      json without = document;
      without.at(at).erase(name.get<std::string>());
      EXPECT_NE(errorOf(without.dump()).find(name.get<std::string>()), std::string::npos) << at << " needs " << name;
    }
    for (const auto& [name, value] : document.at(at).items()) {
      ASSERT_TRUE(node.at("properties").contains(name)) << at << " " << name;
      if (name != "camera") {
        walk(at / name, node.at("properties").at(name));
      }
    }
  }

  void walkArray(const Pointer& at, const json& node) const {
    const json& array = document.at(at);
    for (size_t i = 0; i < array.size(); ++i) {
      walk(at / i, node.at("items"));
    }
    json longer = array;
    while (longer.size() <= node.at("maxItems").get<size_t>()) {
      longer.push_back(array[0]);
    }
    expectRefused(at, longer);
    if (node.contains("minItems")) {
      json shorter = array;
      while (shorter.size() >= node.at("minItems").get<size_t>()) {
        shorter.erase(shorter.size() - 1);
      }
      expectRefused(at, shorter);
    }
    expectRefused(at, 1);
  }

  void expectRefused(const Pointer& at, const json& value) const {
    json changed = document;
    changed[at] = value;
    EXPECT_NE(errorOf(changed.dump()), "") << at << " " << value;
  }
};

json frustumAt(const std::string& name, const json& point, const json& normal, const json& viewpoint) {
  return {{"name", name}, {"plane", {{"point", point}, {"normal", normal}}}, {"viewpoint", viewpoint}};
}

// All four operations: those of a camera that exists are bends and limits.
json graphDocument() {
  GraphCamera bent(test::smallCamera());
  bent.limit(bent.bend(0, test::turnAt({0, 0, 2}, {0, 0, -1}, {0, 0, 9}), "bent"),
             Plane::through({0, 0, -40}, {0.1, 0, -1}));
  json document = json::parse(jsonText(bent));
  document["operations"].push_back({{"operation", "split"},
                                    {"of", "bent"},
                                    {"into",
                                     {frustumAt("left", {0, 0, 0.5}, {-0.3, 0, -1}, {1.5, 0, 7}),
                                      frustumAt("right", {0, 0, 0.5}, {0.3, 0, -1}, {-1.5, 0, 7})}}});
  document["operations"].push_back({{"operation", "merge"},
                                    {"of", {"left", "right"}},
                                    {"into", frustumAt("behind", {0, 0, -2}, {0, 0, -1}, {0, 0, 6})}});
  return document;
}

TEST(CameraSchemas, ofGraphCamerasAgreesWithTheReader) {
  const auto errorOf = [](const std::string& text) {
    return test::errorOfText(text, [](JsonFields& fields) { readGraphCamera(fields, test::smallCamera()); });
  };
  SchemaWalk{readJsonFile(OCELLI_CONSTRUCTOR_FOLDER "/graph_camera.schema.json"), graphDocument(), errorOf}.check();
}

TEST(CameraSchemas, ofCurvedRayCamerasAgreesWithTheReader) {
  const auto errorOf = [](const std::string& text) {
    return test::errorOfText(text, [](JsonFields& fields) { readCurvedRayCamera(fields, test::smallCamera()); });
  };
  json document = json::parse(jsonText(test::bendingTwice()));
  document["turns"][0]["name"] = "right";
  SchemaWalk{readJsonFile(OCELLI_CONSTRUCTOR_FOLDER "/curved_ray_camera.schema.json"), document, errorOf}.check();
}

}  // namespace
}  // namespace ocelli
