#include "oc_core/page/html.h"

#include <fmt/format.h>

#include "oc_core/page/page_style.h"

namespace ocelli {

std::string htmlFromText(const std::string& text) {
  std::string html;
  for (const char c : text) {
    switch (c) {
      case '&':
        html += "&amp;";
        break;
      case '<':
        html += "&lt;";
        break;
      case '>':
        html += "&gt;";
        break;
      case '"':
        html += "&quot;";
        break;
      default:
        html += c;
    }
  }
  return html;
}

std::string groupedDigits(size_t number) {
  std::string digits = std::to_string(number);
  for (size_t at = digits.size(); at > 3;) {
    at -= 3;
    digits.insert(at, "\u202f");  // a narrow space that does not break
  }
  return digits;
}

std::string pageBegin(const std::string& title, std::initializer_list<std::string_view> styles) {
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<link rel=\"icon\" href=\"data:,\">\n"
      "<style>{}",
      htmlFromText(title), kPageStyle);
  for (const std::string_view style : styles) {
    html += style;
  }
  return html + "</style>\n</head>\n<body>\n";
}

std::string pageEnd() {
  return "</body>\n</html>\n";
}

}  // namespace ocelli
