#include "cli/dither_options.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "display_sim/dither_score/dither_fields.h"
#include "oc_core/base/check.h"

namespace ocelli {

std::vector<std::string> ditherNames() {
  std::vector<std::string> names;
  for (const NamedDither& dither : kNamedDithers) {
    names.emplace_back(dither.name);
  }
  return names;
}

ColorReduction ditherOfName(const std::string& name) {
  for (const NamedDither& dither : kNamedDithers) {
    if (dither.name == name) {
      return dither.colors;
    }
  }
  OC_CHECK(false, "no such dither");
}

CLI::Validator radiusCheck() {
  return CLI::Validator(
      [](std::string& text) {
        double value = 0;
        // CLI::Range lets "nan" pass.
        return CLI::detail::lexical_cast(text, value) && value >= 0 && value <= 1
                   ? std::string()
                   : fmt::format("\"{}\" is no number from 0 to 1", text);
      },
      "0 to 1");
}

}  // namespace ocelli
