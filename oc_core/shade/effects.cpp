#include "oc_core/shade/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>

#include "oc_core/base/error.h"
#include "oc_core/shade/ambient_effect.h"
#include "oc_core/shade/specular_effect.h"

namespace ocelli {

const std::vector<Effect>& shadeEffects() {
  static const std::vector<Effect> effects{reflectionEffect(), refractionEffect(), ambientEffect()};
  return effects;
}

const Effect& shadeEffect(const std::string& name) {
  std::string known;
  for (const Effect& effect : shadeEffects()) {
    if (effect.name == name) {
      return effect;
    }
    known += (known.empty() ? "" : ", ") + std::string(effect.name);
  }
  throw InputError("there is no effect \"" + name + "\"", "--effect", "one of " + known);
}

std::map<std::string, double> effectOptions(const Effect& effect, const std::vector<std::string>& texts) {
  std::map<std::string, double> values;
  for (const std::string& text : texts) {
    const std::string where = "--set " + text;
    const std::string name = text.substr(0, text.find('='));
    const auto option = std::find_if(effect.options.begin(), effect.options.end(),
                                     [&](const EffectOption& each) { return each.name == name; });
    if (option == effect.options.end()) {
      std::string known;
      for (const EffectOption& each : effect.options) {
        known += (known.empty() ? "" : ", ") + std::string(each.name);
      }
      throw InputError(fmt::format("the effect {} has no option \"{}\"", effect.name, name), where,
                       known.empty() ? "leave --set out" : "set one of " + known);
    }
    double value = 0;
    const char* const begin = text.data() + std::min(name.size() + 1, text.size());
    const char* const end = text.data() + text.size();
    const auto [stop, problem] = std::from_chars(begin, end, value);
    if (problem != std::errc() || stop != end || !(value >= option->least && value <= option->most)) {
      throw InputError(fmt::format("\"{}\" must be a number from {} to {}", name, option->least, option->most), where,
                       fmt::format("for example --set {}={}", name, option->most));
    }
    if (!values.emplace(name, value).second) {
      throw InputError(fmt::format("\"{}\" is set twice", name), where, "set it once");
    }
  }
  return values;
}

}  // namespace ocelli
