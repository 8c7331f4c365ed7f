#include "oc_core/constructor/graph_operations.h"

#include <algorithm>
#include <list>
#include <map>
#include <set>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/camera/graph_overlap.h"
#include "oc_core/constructor/camera_fields.h"

namespace ocelli {
namespace {

constexpr const char* kRootName = "root";
constexpr size_t kMaxCorners = 64;  // of a part

/// A frustum to be made.
struct NewFrustum {
  std::string name;
  GraphCamera::Bend bend;
  GraphCamera::Part part;  // in shares of the image; empty for all
};

struct Operation {
  enum class Kind { kBend, kSplit, kMerge, kLimit };
  Kind kind = Kind::kBend;
  std::string where;
  std::vector<std::string> of;
  std::vector<NewFrustum> into;
  Plane limit;
};

GraphCamera::Part readPart(JsonFields& fields) {
  const nlohmann::json& corners = fields.value("part");
  if (!corners.is_array() || corners.size() < 3 || corners.size() > kMaxCorners) {
    fields.fail("part", "must be an array of 3 to " + std::to_string(kMaxCorners) + " corners");
  }
  GraphCamera::Part part;
  for (const nlohmann::json& corner : corners) {
    const nlohmann::json wrapped{{"corner", corner}};
    const std::vector<double> uv =
        JsonFields(wrapped, fields.where() + ", \"part\", corner " + std::to_string(part.size() + 1))
            .numbers("corner", 2, 0, 1);
    part.emplace_back(uv[0], uv[1]);
  }
  return part;
}

NewFrustum readFrustum(const nlohmann::json& json, const std::string& where) {
  JsonFields fields(json, where);
  NewFrustum frustum;
  frustum.name = fields.text("name");
  if (frustum.name.empty()) {
    fields.fail("name", "is empty");
  }
  frustum.bend = {readPlane(fields.value("plane"), where + ", \"plane\""), readVector(fields, "viewpoint")};
  if (fields.has("part")) {
    frustum.part = readPart(fields);
  }
  fields.rejectUnknown();
  return frustum;
}

/// One text, or an array of `count` of them.
std::vector<std::string> readNames(JsonFields& fields, size_t count) {
  if (count == 1) {
    return {fields.text("of")};
  }
  const nlohmann::json& names = fields.value("of");
  if (!names.is_array() || names.size() != count ||
      !std::all_of(names.begin(), names.end(), [](const nlohmann::json& name) { return name.is_string(); })) {
    fields.fail("of", "must be an array of " + std::to_string(count) + " names");
  }
  return names.get<std::vector<std::string>>();
}

Operation readOperation(const nlohmann::json& json, const std::string& where) {
  using Kind = Operation::Kind;
  static const std::map<std::string, Kind> kinds{
      {"bend", Kind::kBend}, {"split", Kind::kSplit}, {"merge", Kind::kMerge}, {"limit", Kind::kLimit}};
  JsonFields fields(json, where);
  const auto kind = kinds.find(fields.text("operation"));
  if (kind == kinds.end()) {
    fields.fail("operation", "must be bend, split, merge or limit");
  }
  Operation operation;
  operation.kind = kind->second;
  operation.where = where;
  operation.of = readNames(fields, operation.kind == Kind::kMerge ? 2 : 1);
  if (operation.kind == Kind::kLimit) {
    operation.limit = readPlane(fields.value("plane"), where + ", \"plane\"");
  } else if (operation.kind == Kind::kSplit) {
    const nlohmann::json& into = fields.value("into");
    if (!into.is_array() || into.size() != 2) {
      fields.fail("into", "must be an array of two frusta");
    }
    for (const nlohmann::json& frustum : into) {
      operation.into.push_back(readFrustum(frustum, where + ", \"into\""));
    }
  } else {
    operation.into.push_back(readFrustum(fields.value("into"), where + ", \"into\""));
  }
  const bool hasPart = std::any_of(operation.into.begin(), operation.into.end(),
                                   [](const NewFrustum& frustum) { return !frustum.part.empty(); });
  if (operation.kind != Kind::kBend && hasPart) {
    fields.fail("into", "has a \"part\", which only a bend takes");
  }
  fields.rejectUnknown();
  return operation;
}

std::list<Operation> readOperations(JsonFields& fields) {
  const nlohmann::json& list = fields.value("operations");
  if (!list.is_array() || list.size() > GraphCamera::kMaxFrusta) {
    fields.fail("operations", "must be an array of at most " + std::to_string(GraphCamera::kMaxFrusta));
  }
  std::list<Operation> operations;
  std::set<std::string> names{kRootName};
  for (const nlohmann::json& each : list) {
    const std::string where = fields.where() + ", operation " + std::to_string(operations.size() + 1);
    operations.push_back(readOperation(each, where));
    for (const NewFrustum& frustum : operations.back().into) {
      if (!names.insert(frustum.name).second) {
        throw InputError("there is a frustum \"" + frustum.name + "\" already", where, "give it another name");
      }
    }
  }
  for (const Operation& operation : operations) {
    for (const std::string& name : operation.of) {
      if (!names.contains(name)) {
        throw InputError("there is no frustum \"" + name + "\"", operation.where,
                         "use \"root\", or a name that another operation makes");
      }
    }
  }
  return operations;
}

/// Does operations as soon as what they act on is there.
class OperationBuilder {
 public:
  explicit OperationBuilder(const PinholeCamera& root) : camera_(root), frusta_{{kRootName, {GraphCamera::kRoot}}} {}

  void apply(const Operation& operation) {
    switch (operation.kind) {
      case Operation::Kind::kBend:
        return bend(operation);
      case Operation::Kind::kSplit:
        return split(operation);
      case Operation::Kind::kMerge:
        return merge(operation);
      case Operation::Kind::kLimit:
        for (const int i : frusta_.at(operation.of[0])) {
          camera_.limit(i, operation.limit);
        }
    }
  }
  bool isReady(const Operation& operation) const {
    return std::all_of(operation.of.begin(), operation.of.end(),
                       [&](const std::string& name) { return frusta_.contains(name); });
  }
  const GraphCamera& camera() const { return camera_; }

 private:
  void bend(const Operation& operation) {
    const NewFrustum& bent = operation.into[0];
    const std::vector<int>& of = frusta_.at(operation.of[0]);
    if (of.size() > 1 && !bent.part.empty()) {
      throw InputError("\"" + operation.of[0] + "\" is merged from two, which share no part of the image",
                       operation.where + ", \"into\", \"part\"", "leave \"part\" out");
    }
    GraphCamera::Part part = bent.part;
    for (glm::dvec2& corner : part) {
      corner *= glm::dvec2(camera_.width(), camera_.height());
    }
    for (const int i : of) {
      const std::string name =
          of.size() == 1 ? bent.name : bent.name + " of " + camera_.frusta()[static_cast<size_t>(i)].name;
      frusta_[bent.name].push_back(camera_.bend(i, bent.bend, name, part));
    }
  }
  int single(const std::string& name, const Operation& operation) const {
    const std::vector<int>& of = frusta_.at(name);
    if (of.size() > 1) {
      throw InputError("\"" + name + "\" is merged from two already, and can only be bent or limited", operation.where,
                       "split or merge before");
    }
    return of[0];
  }
  void split(const Operation& operation) {
    const NewFrustum& one = operation.into[0];
    const NewFrustum& other = operation.into[1];
    const auto [a, b] = camera_.split(single(operation.of[0], operation), one.bend, other.bend, one.name, other.name);
    frusta_[one.name] = {a};
    frusta_[other.name] = {b};
  }
  void merge(const Operation& operation) {
    const auto [a, b] = camera_.merge(single(operation.of[0], operation), single(operation.of[1], operation),
                                      operation.into[0].bend, operation.into[0].name);
    frusta_[operation.into[0].name] = {a, b};
  }

  GraphCamera camera_;
  std::map<std::string, std::vector<int>> frusta_;  // by the name that operations give; two after a merge
};

/// `left` comes from nothing that is there, so following what they come from leads round in a circle.
[[noreturn]] void failOnCircle(const std::list<Operation>& left) {
  std::map<std::string, const Operation*> made;
  for (const Operation& operation : left) {
    for (const NewFrustum& frustum : operation.into) {
      made[frustum.name] = &operation;
    }
  }
  const auto waitsFor = [&](const Operation& operation) {
    return *std::find_if(operation.of.begin(), operation.of.end(),
                         [&](const std::string& name) { return made.contains(name); });
  };
  std::vector<std::string> way{waitsFor(left.front())};
  std::string next = waitsFor(*made.at(way.back()));
  for (; std::find(way.begin(), way.end(), next) == way.end(); next = waitsFor(*made.at(next))) {
    way.push_back(next);
  }
  way.erase(way.begin(), std::find(way.begin(), way.end(), next));
  way.push_back(next);
  std::string circle = "\"" + way.front() + "\"";
  for (size_t i = 1; i < way.size(); ++i) {
    circle += " comes from \"" + way[i] + "\"" + (i + 1 < way.size() ? ", which" : "");
  }
  throw InputError("frusta form a circle: " + circle, made.at(way.front())->where,
                   "let one of them come from \"root\" or from a frustum that does");
}

/// Those of the frusta, with a number where two have the same.
std::vector<std::string> uniqueNames(const GraphCamera& camera) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const GraphCamera::Frustum& frustum : camera.frusta()) {
    std::string name = frustum.name;
    for (int number = 2; !taken.insert(name).second; ++number) {
      name = frustum.name + " " + std::to_string(number);
    }
    names.push_back(name);
  }
  return names;
}

}  // namespace

GraphCamera readGraphCamera(JsonFields& fields, const PinholeCamera& reference, const Box& world) {
  const std::string overlap = fields.text("overlap", "refused");
  if (overlap != "refused" && overlap != "allowed") {
    fields.fail("overlap", "must be refused or allowed");
  }
  OperationBuilder builder(readRoot(fields, reference));
  std::list<Operation> left = readOperations(fields);
  while (!left.empty()) {
    const auto ready =
        std::find_if(left.begin(), left.end(), [&](const Operation& each) { return builder.isReady(each); });
    if (ready == left.end()) {
      failOnCircle(left);
    }
    builder.apply(*ready);
    left.erase(ready);
  }
  if (overlap == "refused" && !world.empty()) {
    checkDisjoint(builder.camera(), glm::dvec3(world.lower), glm::dvec3(world.upper));
  }
  return builder.camera();
}

std::string jsonText(const GraphCamera& camera) {
  const std::vector<std::string> names = uniqueNames(camera);
  nlohmann::ordered_json operations = nlohmann::ordered_json::array();
  const glm::dvec2 size(camera.width(), camera.height());
  for (size_t i = 0; i < names.size(); ++i) {
    const GraphCamera::Frustum& frustum = camera.frusta()[i];
    if (frustum.parent >= 0) {
      nlohmann::ordered_json into{
          {"name", names[i]}, {"plane", jsonOf(frustum.plane)}, {"viewpoint", jsonOf(frustum.viewpoint)}};
      for (const glm::dvec2& corner : frustum.part) {
        const glm::dvec2 share = glm::clamp(corner / size, 0.0, 1.0);
        into["part"].push_back({share.x, share.y});
      }
      operations.push_back({{"operation", "bend"}, {"of", names[static_cast<size_t>(frustum.parent)]}, {"into", into}});
    }
    for (const Plane& limit : frustum.limits) {
      operations.push_back({{"operation", "limit"}, {"of", names[i]}, {"plane", jsonOf(limit)}});
    }
  }
  nlohmann::ordered_json json{{"camera", "graph"}};
  writeRoot(json, camera.root());
  json["overlap"] = "allowed";
  json["operations"] = operations;
  return textOfJson(json, 1);
}

}  // namespace ocelli
