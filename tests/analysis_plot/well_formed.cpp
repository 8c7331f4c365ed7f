#include "tests/analysis_plot/well_formed.h"

#include <algorithm>
#include <cctype>
#include <set>

namespace ocelli {
namespace {

class Reader {
 public:
  Reader(std::string_view markup, const std::vector<std::string>& voidTags) : markup_(markup), voidTags_(voidTags) {}

  MarkupReading read() {
    while (at_ < markup_.size() && reading_.problem.empty()) {
      if (markup_[at_] == '<') {
        tag();
      } else {
        character(reading_.text);
      }
    }
    if (reading_.problem.empty() && !open_.empty()) {
      reading_.problem = "never closed: " + open_.back();
    }
    return reading_;
  }

 private:
  bool starts(std::string_view with) const { return markup_.substr(at_, with.size()) == with; }
  void fail(const std::string& what) {
    reading_.problem = what + " near: " + std::string(markup_.substr(at_, 60));
    at_ = markup_.size();
  }
  std::string name() {
    const size_t from = at_;
    while (at_ < markup_.size() && (std::isalnum(static_cast<unsigned char>(markup_[at_])) != 0 ||
                                    std::string_view("-_:.").find(markup_[at_]) != std::string_view::npos)) {
      ++at_;
    }
    return std::string(markup_.substr(from, at_ - from));
  }
  void spaces() {
    while (at_ < markup_.size() && std::isspace(static_cast<unsigned char>(markup_[at_])) != 0) {
      ++at_;
    }
  }
  /// One character of text or of a value; an ampersand must start an entity.
  void character(std::string& into) {
    if (markup_[at_] == '&') {
      const size_t end = markup_.find(';', at_);
      static const std::set<std::string_view> kEntities{"&amp;", "&lt;", "&gt;", "&quot;", "&#39;"};
      if (end == std::string_view::npos || kEntities.count(markup_.substr(at_, end + 1 - at_)) == 0) {
        return fail("a bare ampersand");
      }
    }
    into += markup_[at_++];
  }
  void tag() {
    if (starts("<?xml") || starts("<!")) {
      at_ = std::min(markup_.find('>', at_), markup_.size() - 1) + 1;
      return;
    }
    const bool closing = starts("</");
    at_ += closing ? 2 : 1;
    const std::string tagName = name();
    if (tagName.empty()) {
      return fail("a bare <");
    }
    if (closing) {
      if (open_.empty() || open_.back() != tagName) {
        return fail("closes what is not open: " + tagName);
      }
      open_.pop_back();
      spaces();
      if (!starts(">")) {
        return fail("a closing tag goes on");
      }
      ++at_;
      return;
    }
    reading_.tags.push_back(tagName);
    std::set<std::string> names;
    for (spaces(); !starts(">") && !starts("/>"); spaces()) {
      const std::string attribute = name();
      if (attribute.empty() || !names.insert(attribute).second) {
        return fail("no attribute, or a second one of a name");
      }
      std::string value;
      if (starts("=\"")) {
        at_ += 2;
        while (at_ < markup_.size() && markup_[at_] != '"' && markup_[at_] != '<') {
          character(value);
        }
        if (!starts("\"")) {
          return fail("a value is not closed");
        }
        ++at_;
      } else if (voidTags_.empty()) {
        return fail("an attribute without a value");
      }
      reading_.attributes.push_back(attribute + "=" + value);
    }
    const bool empty = starts("/>");
    at_ += empty ? 2 : 1;
    if (!empty && std::find(voidTags_.begin(), voidTags_.end(), tagName) == voidTags_.end()) {
      open_.push_back(tagName);
      // What stands in these is no markup.
      if (!voidTags_.empty() && (tagName == "script" || tagName == "style")) {
        at_ = std::min(markup_.find("</" + tagName, at_), markup_.size());
      }
    }
  }

  std::string_view markup_;
  const std::vector<std::string>& voidTags_;
  size_t at_ = 0;
  std::vector<std::string> open_;
  MarkupReading reading_;
};

}  // namespace

MarkupReading readMarkup(std::string_view markup, const std::vector<std::string>& voidTags) {
  return Reader(markup, voidTags).read();
}

}  // namespace ocelli
