// A check of numbers on the command line.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <string>

namespace ocelli {

/// From `least` to `most`, and a number: CLI::Range lets "nan" pass.
inline CLI::Validator numberCheck(double least, double most) {
  return CLI::Validator(
      [least, most](std::string& text) {
        double value = 0;
        return CLI::detail::lexical_cast(text, value) && value >= least && value <= most
                   ? std::string()
                   : fmt::format("\"{}\" is no number from {} to {}", text, least, most);
      },
      "");
}

}  // namespace ocelli
