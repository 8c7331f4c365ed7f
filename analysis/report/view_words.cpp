#include "analysis/report/view_words.h"

#include <cctype>
#include <string_view>

#include "analysis/dataset/trial.h"

namespace ocelli {
namespace {

/// Of a name that goes on.
bool joins(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || static_cast<unsigned char>(c) >= 0x80 || c == '_' ||
         c == '-' || c == '/';
}

bool startsSentence(const std::string& text, size_t at) {
  return at == 0 || (at >= 2 && text[at - 1] == ' ' && (text[at - 2] == '.' || text[at - 2] == ':'));
}

class Speller {
 public:
  void operator()(ReportHeading& heading) const { spell(heading.text); }
  void operator()(ReportParagraph& paragraph) const { spell(paragraph.text); }
  void operator()(ReportList& list) const {
    for (std::string& item : list.items) {
      spell(item);
    }
  }
  void operator()(ReportFacts& facts) const {
    for (ReportFacts::Fact& fact : facts.facts) {
      if (!fact.code) {
        spell(fact.text);
      }
    }
  }
  void operator()(ReportNote& note) const { spell(note.text); }
  void operator()(ReportExcerpt& excerpt) const { spell(excerpt.text); }
  void operator()(ReportTable& table) const {
    spell(table.caption);
    if (table.isRecord) {
      return;
    }
    for (ReportColumn& column : table.columns) {
      spell(column.title);
      spell(column.group);
    }
    for (std::vector<ReportCell>& row : table.rows) {
      for (ReportCell& cell : row) {
        spell(cell.text);
        spell(cell.footnote);
      }
    }
  }
  void operator()(ReportFigure& figure) const {
    spell(figure.caption);
    spell(figure.figure.title);
  }

 private:
  static void spell(std::string& text) { text = withViewWords(text); }
};

}  // namespace

std::string withViewWords(const std::string& text) {
  std::string result;
  for (size_t at = 0; at < text.size();) {
    bool replaced = false;
    for (const TrialView view : {TrialView::kPinhole, TrialView::kGraph}) {
      const std::string_view name = nameOf(view);
      const size_t end = at + name.size();
      if (text.compare(at, name.size(), name) == 0 && (at == 0 || !joins(text[at - 1])) &&
          (end >= text.size() || !joins(text[end]))) {
        std::string word = labelOf(view);
        if (startsSentence(text, at)) {
          word[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(word[0])));
        }
        result += word;
        at = end;
        replaced = true;
        break;
      }
    }
    if (!replaced) {
      result += text[at++];
    }
  }
  return result;
}

void spellOutViews(ReportDocument& document) {
  for (std::vector<ReportElement>* part : {&document.elements, &document.supplement}) {
    for (ReportElement& element : *part) {
      std::visit(Speller(), element);
    }
  }
}

}  // namespace ocelli
