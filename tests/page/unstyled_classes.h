// Whether the markup of a page and its style name the same classes and custom properties.
#pragma once

#include <regex>
#include <set>
#include <string>

namespace ocelli::test {

inline std::set<std::string> wordsOf(const std::string& text, const std::string& pattern) {
  const std::regex regex(pattern);
  const std::regex space(" +");
  std::set<std::string> words;
  for (std::sregex_iterator it(text.begin(), text.end(), regex), end; it != end; ++it) {
    const std::string found = (*it)[1];
    for (std::sregex_token_iterator word(found.begin(), found.end(), space, -1), last; word != last; ++word) {
      words.insert(*word);
    }
  }
  return words;
}

/// Classes of the markup without a rule in the page's style.
inline std::set<std::string> unstyledClasses(const std::string& html) {
  const std::string style = html.substr(0, html.find("</style>"));
  std::set<std::string> classes = wordsOf(html.substr(style.size()), " class=\"([^\"]*)\"");
  for (const std::string& styled : wordsOf(style, "\\.([a-z][a-z-]*)")) {
    classes.erase(styled);
  }
  return classes;
}

/// Custom properties that are used and not defined.
inline std::set<std::string> undefinedProperties(const std::string& html) {
  std::set<std::string> used = wordsOf(html, "var\\(--([a-z]+)\\)");
  for (const std::string& defined : wordsOf(html, "--([a-z]+):")) {
    used.erase(defined);
  }
  return used;
}

}  // namespace ocelli::test
