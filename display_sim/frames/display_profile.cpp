#include "display_sim/frames/display_profile.h"

#include <algorithm>

#include "display_sim/frames/builtin_profiles.h"
#include "oc_core/base/conventions.h"
#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"

namespace ocelli {
namespace {

constexpr const char* kSecondHalfTurnNames[] = {"mirrored", "own"};
constexpr const char* kChannelTimingNames[] = {"together", "in_turn"};

std::string readName(JsonFields& fields) {
  const std::string name = fields.text("name");
  const bool allowed = std::ranges::all_of(
      name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; });
  if (name.empty() || name.size() > 64 || !allowed) {
    fields.fail("name", "must be 1 to 64 lower-case letters, digits, '-' or '_'");
  }
  return name;
}

/// Which of two names stands in a field; the first where the field is missing.
int readEither(JsonFields& fields, const char* field, const char* const (&names)[2]) {
  const std::string text = fields.text(field, names[0]);
  if (text != names[0] && text != names[1]) {
    fields.fail(field, std::string("must be \"") + names[0] + "\" or \"" + names[1] + "\"");
  }
  return text == names[1] ? 1 : 0;
}

}  // namespace

int DisplayProfile::storedSlices() const {
  return secondHalfTurn == SecondHalfTurn::kOwn ? 2 * slicesPerHalfTurn : slicesPerHalfTurn;
}

size_t DisplayProfile::volumeBytes() const {
  const size_t planeBytes = (static_cast<size_t>(width) + 7) / 8 * static_cast<size_t>(height);
  return planeBytes * static_cast<size_t>(3 * colorBitsPerChannel) * static_cast<size_t>(storedSlices());
}

double DisplayProfile::refreshHertz() const {
  const double halfTurnsPerSecond = rotationsPerMinute / 60 * 2;
  return secondHalfTurn == SecondHalfTurn::kOwn ? halfTurnsPerSecond / 2 : halfTurnsPerSecond;
}

DisplayProfile profileFromJsonText(const std::string& text, const std::string& where) {
  return readAs("display_sim/frames/profiles/display_profile.schema.json", [&] {
    const nlohmann::json json = parseJson(text, where);
    JsonFields fields(json, where);
    DisplayProfile profile;
    profile.name = readName(fields);
    profile.radiusMetres = fields.number("radius_metres", 0.001, 100);
    profile.halfHeightRadii = fields.number("half_height_radii", 0.01, 100, 1);
    profile.slicesPerHalfTurn = fields.integer("slices_per_half_turn", 2, 4096);
    profile.width = fields.integer("width", 2, kMaxSliceSide);
    profile.height = fields.integer("height", 1, kMaxSliceSide);
    profile.colorBitsPerChannel = fields.integer("color_bits_per_channel", 1, 8, 1);
    profile.channelTiming = static_cast<ChannelTiming>(readEither(fields, "channel_timing", kChannelTimingNames));
    profile.rotationsPerMinute = fields.number("rotations_per_minute", 0.001, 1e6);
    profile.secondHalfTurn = static_cast<SecondHalfTurn>(readEither(fields, "second_half_turn", kSecondHalfTurnNames));
    profile.viewingDistanceMetres =
        fields.number("viewing_distance_metres", 0.001, 1e4, kDefaultEyeDistance * profile.radiusMetres);
    fields.rejectUnknown();
    if (profile.volumeBytes() > kMaxVolumeBytes) {
      throw InputError("a volume of this display would take more than 2 GiB", where,
                       "lower \"slices_per_half_turn\", \"width\", \"height\" or \"color_bits_per_channel\"");
    }
    return profile;
  });
}

DisplayProfile readProfile(const std::filesystem::path& path) {
  return profileFromJsonText(readJsonFile(path).dump(), path.string());
}

std::string jsonText(const DisplayProfile& profile) {
  nlohmann::ordered_json json;
  json["name"] = profile.name;
  json["radius_metres"] = profile.radiusMetres;
  json["half_height_radii"] = profile.halfHeightRadii;
  json["slices_per_half_turn"] = profile.slicesPerHalfTurn;
  json["width"] = profile.width;
  json["height"] = profile.height;
  json["color_bits_per_channel"] = profile.colorBitsPerChannel;
  json["channel_timing"] = kChannelTimingNames[static_cast<int>(profile.channelTiming)];
  json["rotations_per_minute"] = profile.rotationsPerMinute;
  json["second_half_turn"] = kSecondHalfTurnNames[static_cast<int>(profile.secondHalfTurn)];
  json["viewing_distance_metres"] = profile.viewingDistanceMetres;
  return textOfJson(json);
}

const std::vector<std::string>& builtinProfileNames() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> list;
    for (const BuiltinProfile& profile : builtinProfiles()) {
      list.push_back(profile.name);
    }
    return list;
  }();
  return names;
}

DisplayProfile loadProfile(const std::string& nameOrFile) {
  for (const BuiltinProfile& profile : builtinProfiles()) {
    if (profile.name == nameOrFile) {
      return profileFromJsonText(profile.json, "profile " + profile.name);
    }
  }
  if (nameOrFile.ends_with(".json")) {
    return readProfile(nameOrFile);
  }
  std::string names;
  for (const std::string& name : builtinProfileNames()) {
    names += (names.empty() ? "" : ", ") + name;
  }
  throw InputError("there is no display profile of this name", nameOrFile, "use one of " + names + ", or a .json file");
}

}  // namespace ocelli
