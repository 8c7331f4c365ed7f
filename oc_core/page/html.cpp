#include "oc_core/page/html.h"

#include <fmt/format.h>

#include "oc_core/base/utf8.h"
#include "oc_core/page/page_style.h"

namespace ocelli {

std::string htmlFromText(std::string_view text) {
  std::string html;
  for (const char c : cleanText(text)) {
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
      case '\'':
        html += "&#39;";
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

std::string pageBegin(const PageHead& head) {
  return fmt::format(
      "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n{}<meta name=\"viewport\" "
      "content=\"width=device-width, initial-scale=1\">\n<title>{}</title>\n<style>\n{}</style>\n</head>\n<body>\n",
      head.tags, htmlFromText(head.title), head.style);
}

std::string pageBegin(const std::string& title, std::initializer_list<std::string_view> styles) {
  // An empty icon: browsers ask the server for one otherwise.
  PageHead head{title, "<link rel=\"icon\" href=\"data:,\">\n", pageStyle()};
  for (const std::string_view style : styles) {
    head.style += style;
  }
  return pageBegin(head);
}

std::string pageEnd() {
  return "</body>\n</html>\n";
}

}  // namespace ocelli
