#include "oc_core/volume/builtin_volumes.h"

#include <algorithm>
#include <string_view>

#include "oc_core/base/check.h"
#include "oc_core/base/error.h"
#include "oc_core/volume/builtin_volume_list.h"

namespace ocelli {
namespace {

constexpr std::string_view kVolumePrefix = "builtin:volume";
constexpr std::string_view kNameKey = "name=";

const BuiltinVolumeKind& volumeKindCalled(const std::string& name, const std::string& source) {
  const auto found = std::ranges::find(listBuiltinVolumes(), name, &BuiltinVolumeKind::name);
  if (found == listBuiltinVolumes().end()) {
    throw InputError("there is no built-in volume '" + name + "'", source, "one of " + listNames(listBuiltinVolumes()));
  }
  return *found;
}

}  // namespace

const std::vector<BuiltinVolumeKind>& listBuiltinVolumes() {
  static const std::vector<BuiltinVolumeKind> kinds{skullVolume(),         engineVolume(), phantomVolume(),
                                                    marschnerLobbVolume(), noiseVolume(),  sphereVolume(),
                                                    slabVolume(),          rampVolume()};
  return kinds;
}

bool isBuiltinVolume(const std::string& source) {
  return source == kVolumePrefix || source.starts_with(std::string(kVolumePrefix) + ",");
}

BuiltinVolume makeBuiltinVolume(const std::string& source) {
  OC_CHECK(isBuiltinVolume(source), "callers ask isBuiltinVolume() first");
  std::vector<std::string> pieces = splitAtCommas(source);
  pieces.erase(pieces.begin());
  const auto isName = [](const std::string& piece) { return piece.starts_with(kNameKey); };
  const auto name = std::ranges::find_if(pieces, isName);
  if (name == pieces.end()) {
    throw InputError(
        "it is not said which volume", source,
        "add name=" + listBuiltinVolumes().front().name + ", or another of " + listNames(listBuiltinVolumes()));
  }
  const BuiltinVolumeKind& kind = volumeKindCalled(name->substr(kNameKey.size()), source);
  pieces.erase(name);
  if (std::ranges::any_of(pieces, isName)) {
    throw InputError("'name' is given twice", source, "leave one of them out");
  }
  const std::string example = std::string(kVolumePrefix) + "," + std::string(kNameKey) + kind.name;
  return kind.make(readBuiltinValues(kind.parameters, pieces, {"the volume " + kind.name, example}, source));
}

}  // namespace ocelli
