// Numbers in texts, as JSON and C++ write them whatever the locale.
#pragma once

#include <charconv>
#include <cmath>
#include <concepts>
#include <optional>
#include <string_view>

namespace ocelli {

/// The whole of a text as a number. Nothing where it is empty, is no number or more than one, has spaces, or where the
/// number is not finite or does not fit the type.
template <class Number>
std::optional<Number> numberFromText(std::string_view text) {
  Number number{};
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, number);
  if (error != std::errc() || stop != end) {
    return std::nullopt;
  }
  if constexpr (std::floating_point<Number>) {
    if (!std::isfinite(number)) {
      return std::nullopt;
    }
  }
  return number;
}

}  // namespace ocelli
