// How a server of remote visualisation makes its images: each setting is described once, in remoteOptions(), from which
// the command line, its help, JSON and the documentation come.
#pragma once

#include <span>
#include <string>
#include <variant>
#include <vector>

namespace ocelli {

struct RemoteSettings {
  RemoteSettings();

  double reach = 1.4;
  double size = 1.25;
  double zoom = 2;
  double middle = 0.5;
  std::string sampling = "quadratic";
  std::string color;
  double quality = 95;
  std::string depth = "deflate";
  double translation = 0.1;
  double depthError = 1;
  int samples = 1;

  bool operator==(const RemoteSettings&) const = default;
};

struct RemoteOption {
  /// Where settings keep the value.
  using Place = std::variant<double RemoteSettings::*, int RemoteSettings::*, std::string RemoteSettings::*>;

  const char* name;     ///< of the field in JSON; `--name` on a command line
  const char* unit;     ///< of a number; empty where it is a ratio or a count
  const char* meaning;  ///< a sentence without its full stop
  Place place;
  double min = 0;  ///< of a number
  double max = 0;
  std::vector<std::string> (*words)() = nullptr;  ///< what a text may be
};

std::span<const RemoteOption> remoteOptions();

/// The value as a text, as one would write it on a command line.
std::string valueText(const RemoteOption& option, const RemoteSettings& settings);

/// Throws InputError, naming the option, where a number is out of its range or a word is unknown.
void validate(const RemoteSettings& settings, const std::string& where);

/// An object with a field an option.
std::string jsonText(const RemoteSettings& settings);
/// What is missing stays as it is by default. Throws InputError as validate(), and for unknown fields.
RemoteSettings remoteSettingsFromJson(const std::string& text, const std::string& where);

}  // namespace ocelli
