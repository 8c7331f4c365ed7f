#include "oc_core/worlds/builtin_scenes.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <set>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/worlds/builtin_list.h"

namespace ocelli {
namespace {

constexpr std::string_view kPrefix = "builtin:";

/// The whole of `text` as a finite number, or nothing.
std::optional<double> parseNumber(const std::string& text) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::string rangeText(const BuiltinParameter& parameter) {
  return fmt::format("{} from {:.15g} to {:.15g}",
                     parameter.kind == BuiltinParameter::Kind::kInteger ? "a whole number" : "a number",
                     parameter.least, parameter.most);
}

template <class Named>
std::string namesOf(const std::vector<Named>& list) {
  std::string names;
  for (const Named& each : list) {
    names += (names.empty() ? "" : ", ") + each.name;
  }
  return names;
}

const BuiltinScene& findScene(const std::string& name, const std::string& source) {
  for (const BuiltinScene& scene : listBuiltinScenes()) {
    if (scene.name == name) {
      return scene;
    }
  }
  throw InputError("there is no built-in scene '" + name + "'", source, "one of " + namesOf(listBuiltinScenes()));
}

std::vector<std::string> splitAtCommas(const std::string& text) {
  std::vector<std::string> pieces(1);
  for (const char c : text) {
    if (c == ',') {
      pieces.emplace_back();
    } else {
      pieces.back() += c;
    }
  }
  return pieces;
}

}  // namespace

class BuiltinReader {
 public:
  BuiltinReader(const BuiltinScene& scene, const std::string& source) : scene_(scene), source_(source) {
    for (const BuiltinParameter& parameter : scene.parameters) {
      set(parameter, parameter.otherwise);
    }
  }

  void read(const std::string& piece) {
    const size_t equals = piece.find('=');
    const std::string key = piece.substr(0, equals);
    if (equals == std::string::npos) {
      throw InputError("'" + piece + "' is not of the form key=value", source_, validKeys());
    }
    for (const BuiltinParameter& parameter : scene_.parameters) {
      if (parameter.name == key) {
        if (!values_.given_.insert(key).second) {
          throw InputError("'" + key + "' is given twice", source_, "leave one of them out");
        }
        set(parameter, piece.substr(equals + 1));
        return;
      }
    }
    throw InputError("the scene " + scene_.name + " has no parameter '" + key + "'", source_, validKeys());
  }

  const BuiltinValues& values() const { return values_; }

 private:
  std::string validKeys() const {
    return scene_.parameters.empty() ? "builtin:" + scene_.name + " takes no parameters"
                                     : "one of " + namesOf(scene_.parameters) + ", for example builtin:" + scene_.name +
                                           "," + scene_.parameters[0].name + "=" + scene_.parameters[0].otherwise;
  }

  void set(const BuiltinParameter& parameter, const std::string& text) {
    if (parameter.kind == BuiltinParameter::Kind::kFile) {
      values_.paths_[parameter.name] = text;
      return;
    }
    const std::optional<double> value = parseNumber(text);
    const bool whole = parameter.kind != BuiltinParameter::Kind::kInteger || (value && *value == std::floor(*value));
    if (!value || !whole || *value < parameter.least || *value > parameter.most) {
      throw InputError("the value of '" + parameter.name + "' is '" + text + "', which is not " + rangeText(parameter),
                       source_, fmt::format("{}={}", parameter.name, parameter.otherwise));
    }
    values_.numbers_[parameter.name] = *value;
  }

  const BuiltinScene& scene_;
  const std::string& source_;
  BuiltinValues values_;
};

namespace {

struct ParsedBuiltin {
  const BuiltinScene* scene;
  BuiltinValues values;
};

ParsedBuiltin parsed(const std::string& source) {
  OC_CHECK(isBuiltinScene(source), "callers ask isBuiltinScene() first");
  const std::vector<std::string> pieces = splitAtCommas(source.substr(kPrefix.size()));
  const BuiltinScene& builtin = findScene(pieces[0], source);
  BuiltinReader reader(builtin, source);
  for (size_t i = 1; i < pieces.size(); ++i) {
    reader.read(pieces[i]);
  }
  return {&builtin, reader.values()};
}

}  // namespace

double BuiltinValues::number(const std::string& name) const {
  const auto found = numbers_.find(name);
  OC_CHECK(found != numbers_.end(), "a scene asks for the parameters that it lists");
  return found->second;
}

size_t BuiltinValues::count(const std::string& name) const {
  return static_cast<size_t>(number(name));
}

const std::string& BuiltinValues::path(const std::string& name) const {
  const auto found = paths_.find(name);
  OC_CHECK(found != paths_.end(), "a scene asks for the parameters that it lists");
  return found->second;
}

const std::vector<BuiltinScene>& listBuiltinScenes() {
  static const std::vector<BuiltinScene> scenes{
      teapotScene(),  roomScene(),   statuesScene(), crowdScene(),      fenceScene(),     doorsScene(),
      boxesScene(),   mazeScene(),   townScene(),    canyonScene(),     sphereScene(),    torusScene(),
      boxScene(),     wavingScene(), mirrorScene(),  mirrorMazeScene(), lensScene(),      parkingScene(),
      barrelsScene(), lampScene(),   pergolaScene(), dnaScene(),        particlesScene(), treeScene()};
  return scenes;
}

bool isBuiltinScene(std::string_view source) {
  return source.substr(0, kPrefix.size()) == kPrefix;
}

Scene makeBuiltinScene(const std::string& source) {
  const auto [builtin, values] = parsed(source);
  Scene scene = builtin->build(values);
  scene.name = source;
  return scene;
}

const std::vector<RoledObject>& builtinRoles(const std::string& source) {
  const std::vector<std::string> pieces = splitAtCommas(source.substr(kPrefix.size()));
  return findScene(pieces[0], source).roles;
}

bool isMovingBuiltin(const std::string& source) {
  const std::vector<std::string> pieces = splitAtCommas(source.substr(kPrefix.size()));
  return static_cast<bool>(findScene(pieces[0], source).motion);
}

std::unique_ptr<MovingScene> makeBuiltinMotion(const std::string& source) {
  const auto [builtin, values] = parsed(source);
  OC_CHECK(builtin->motion != nullptr, "callers ask isMovingBuiltin() first");
  return builtin->motion(values);
}

}  // namespace ocelli
