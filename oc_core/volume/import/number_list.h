// Lists of numbers in the texts of headers.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

#include "oc_core/base/number_text.h"

namespace ocelli {

/// The numbers of a text that stand between characters of `separators`; nothing where something else stands there. A
/// sign "+" may stand before a number.
inline std::optional<std::vector<double>> numbersFromText(std::string_view text, std::string_view separators) {
  std::vector<double> numbers;
  for (size_t at = text.find_first_not_of(separators); at != std::string_view::npos;) {
    const size_t end = text.find_first_of(separators, at);
    std::string_view token = text.substr(at, end - at);
    token.remove_prefix(token.starts_with('+') ? 1 : 0);
    const std::optional<double> number = numberFromText<double>(token);
    if (!number) {
      return std::nullopt;
    }
    numbers.push_back(*number);
    at = text.find_first_not_of(separators, end);
  }
  return numbers;
}

}  // namespace ocelli
