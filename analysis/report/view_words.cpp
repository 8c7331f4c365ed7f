#include "analysis/report/view_words.h"

#include "study/trial/view_condition.h"

namespace ocelli {
namespace {

class Speller {
 public:
  Speller(const TextChange& shown, const TextChange& kept) : shown_(shown), kept_(kept) {}

  void operator()(ReportHeading& heading) const { show(heading.text); }
  void operator()(ReportParagraph& paragraph) const { show(paragraph.text); }
  void operator()(ReportList& list) const {
    for (std::string& item : list.items) {
      show(item);
    }
  }
  void operator()(ReportFacts& facts) const {
    for (ReportFacts::Fact& fact : facts.facts) {
      fact.text = (fact.code ? kept_ : shown_)(fact.text);
    }
  }
  void operator()(ReportNote& note) const { show(note.text); }
  void operator()(ReportExcerpt& excerpt) const { show(excerpt.text); }
  void operator()(ReportTable& table) const {
    show(table.caption);
    for (ReportColumn& column : table.columns) {
      show(column.title);
      show(column.group);
    }
    for (std::vector<ReportCell>& row : table.rows) {
      for (ReportCell& cell : row) {
        show(cell.text);
        show(cell.footnote);
        cell.source = kept_(cell.source);
      }
    }
  }
  void operator()(ReportFigure& figure) const {
    show(figure.caption);
    show(figure.figure.title);
  }

 private:
  void show(std::string& text) const { text = shown_(text); }

  const TextChange& shown_;
  const TextChange& kept_;
};

}  // namespace

void replaceViewMarks(ReportDocument& document, const TextChange& shown, const TextChange& kept) {
  for (std::vector<ReportElement>* part : {&document.elements, &document.supplement}) {
    for (ReportElement& element : *part) {
      std::visit(Speller(shown, kept), element);
    }
  }
  for (std::string& failure : document.failures) {
    failure = kept(failure);
  }
}

void spellOutViews(ReportDocument& document) {
  const ViewConditions& conditions = document.origins.conditions;
  replaceViewMarks(
      document, [&](const std::string& text) { return withViewLabels(text, conditions); },
      [&](const std::string& text) { return withViewNames(text, conditions); });
}

}  // namespace ocelli
