#include "analysis/report/report_document.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <map>
#include <set>

namespace ocelli {
namespace {

/// Letters, digits and single hyphens; a letter first.
std::string anchorOf(const std::string& text) {
  std::string anchor;
  for (const char c : text) {
    if (std::isalnum(static_cast<unsigned char>(c)) != 0 && static_cast<unsigned char>(c) < 0x80) {
      anchor += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    } else if (!anchor.empty() && anchor.back() != '-') {
      anchor += '-';
    }
  }
  while (!anchor.empty() && anchor.back() == '-') {
    anchor.pop_back();
  }
  const bool letter = !anchor.empty() && std::isalpha(static_cast<unsigned char>(anchor.front())) != 0;
  return letter ? anchor : fmt::format("s-{}", anchor);
}

/// Several cells of the row have a source, and it is the same.
bool haveOneSource(const std::vector<ReportCell>& row) {
  std::string source;
  int cells = 0;
  for (const ReportCell& cell : row) {
    if (!cell.source.empty()) {
      if (cells++ > 0 && cell.source != source) {
        return false;
      }
      source = cell.source;
    }
  }
  return cells > 1;
}

class Namer {
 public:
  explicit Namer(const ReportDocument& document) {
    // Cells keep the ids that they have.
    for (const std::vector<ReportElement>* part : {&document.elements, &document.supplement}) {
      for (const ReportElement& element : *part) {
        if (const auto* table = std::get_if<ReportTable>(&element)) {
          keepCells(*table);
        }
      }
    }
  }

  /// Counts tables and figures anew, as S1, S2, ...
  void beginSupplement() {
    tables_ = figures_ = 0;
    prefix_ = "S";
  }

  ElementName operator()(const ReportHeading& heading) {
    return {unique(heading.id.empty() ? heading.text : heading.id), ""};
  }
  ElementName operator()(const ReportTable& table) {
    const std::string label = fmt::format("Table {}{}", prefix_, ++tables_);
    return {unique(table.id.empty() ? label : table.id), label};
  }
  ElementName operator()(const ReportFigure& figure) {
    const std::string label = fmt::format("Figure {}{}", prefix_, ++figures_);
    return {unique(figure.id.empty() ? label : figure.id), label};
  }
  ElementName operator()(const ReportExcerpt& excerpt) { return {unique(excerpt.title), ""}; }
  template <class Other>
  ElementName operator()(const Other&) {
    return {};
  }

 private:
  void keepCells(const ReportTable& table) {
    for (const std::vector<ReportCell>& row : table.rows) {
      for (const ReportCell& cell : row) {
        taken_.insert(cell.id);
      }
    }
  }
  std::string unique(const std::string& wanted) {
    const std::string anchor = anchorOf(wanted);
    std::string id = anchor;
    for (int i = 2; !taken_.insert(id).second; ++i) {
      id = fmt::format("{}-{}", anchor, i);
    }
    return id;
  }

  std::set<std::string> taken_;
  int tables_ = 0;
  int figures_ = 0;
  const char* prefix_ = "";  ///< of the numbers
};

/// The last heading of level 1; nullptr where there is none.
const ReportHeading* lastSection(const std::vector<ReportElement>& elements) {
  for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
    const auto* heading = std::get_if<ReportHeading>(&*element);
    if (heading != nullptr && heading->level <= 1) {
      return heading;
    }
  }
  return nullptr;
}

}  // namespace

void ReportDocument::add(ReportElement element) {
  (addsToSupplement ? supplement : elements).push_back(std::move(element));
}

InSupplement::InSupplement(ReportDocument& document) : document_(document), before_(document.addsToSupplement) {
  const ReportHeading* section = lastSection(document.elements);
  const ReportHeading* inSupplement = lastSection(document.supplement);
  if (section != nullptr && (inSupplement == nullptr || inSupplement->text != section->text)) {
    document.supplement.emplace_back(ReportHeading{
        1, section->text, fmt::format("supplement-{}", section->id.empty() ? section->text : section->id)});
  }
  document.addsToSupplement = true;
}

DocumentNames documentNames(const ReportDocument& document) {
  Namer namer(document);
  DocumentNames names;
  for (const ReportElement& element : document.elements) {
    names.elements.push_back(std::visit(namer, element));
  }
  namer.beginSupplement();
  for (const ReportElement& element : document.supplement) {
    names.supplement.push_back(std::visit(namer, element));
  }
  return names;
}

std::vector<ElementName> elementNames(const ReportDocument& document) {
  return documentNames(document).elements;
}

std::string noteTitle(NoteKind kind) {
  switch (kind) {
    case NoteKind::kNote:
      return "Note";
    case NoteKind::kWarning:
      return "Caution";
    case NoteKind::kSimulated:
      return "Simulated subjects";
    case NoteKind::kNotEstimable:
      return "Cannot be estimated";
  }
  return "";
}

std::vector<SourceEntry> sourcesOf(const ReportTable& table) {
  std::vector<SourceEntry> entries;
  std::map<std::string, size_t> places;
  for (const std::vector<ReportCell>& row : table.rows) {
    const bool asRow = haveOneSource(row);
    bool isDone = false;
    for (size_t i = 0; i < row.size() && !isDone; ++i) {
      if (row[i].source.empty()) {
        continue;
      }
      const auto [place, isNew] = places.try_emplace(row[i].source, entries.size());
      if (isNew) {
        entries.push_back({{}, {}, row[i].source});
      }
      const std::string column = i < table.columns.size() ? table.columns[i].title : "";
      const std::string group = i < table.columns.size() ? table.columns[i].group : "";
      entries[place->second].cells.push_back(
          i == 0 || asRow ? row.front().text
                          : fmt::format("{}, {}{}{}", row.front().text, group, group.empty() ? "" : " ", column));
      entries[place->second].ids.push_back(row[i].id);
      isDone = asRow;
    }
  }
  return entries;
}

std::vector<std::string> footnotesOf(const ReportTable& table) {
  std::vector<std::string> footnotes;
  for (const std::vector<ReportCell>& row : table.rows) {
    for (const ReportCell& cell : row) {
      if (!cell.footnote.empty() && std::find(footnotes.begin(), footnotes.end(), cell.footnote) == footnotes.end()) {
        footnotes.push_back(cell.footnote);
      }
    }
  }
  return footnotes;
}

std::string footnoteMark(const std::vector<std::string>& footnotes, const std::string& footnote) {
  auto place = static_cast<size_t>(std::find(footnotes.begin(), footnotes.end(), footnote) - footnotes.begin());
  std::string mark;
  do {
    mark.insert(mark.begin(), static_cast<char>('a' + place % 26));
    place /= 26;
  } while (place-- > 0);
  return mark;
}

}  // namespace ocelli
