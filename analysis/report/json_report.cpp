#include "analysis/report/json_report.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <nlohmann/json.hpp>

#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

using Json = nlohmann::ordered_json;

void put(Json& json, const char* key, const std::string& text) {
  if (!text.empty()) {
    json[key] = cleanText(text);
  }
}

const char* nameOf(NoteKind kind) {
  switch (kind) {
    case NoteKind::kNote:
      return "note";
    case NoteKind::kWarning:
      return "caution";
    case NoteKind::kSimulated:
      return "simulated";
    case NoteKind::kNotEstimable:
      return "not estimable";
  }
  return "";
}

/// "1-5, 9".
std::string rangesOf(const std::vector<int64_t>& sorted) {
  std::string text;
  for (size_t first = 0; first < sorted.size();) {
    size_t last = first;
    while (last + 1 < sorted.size() && sorted[last + 1] == sorted[last] + 1) {
      ++last;
    }
    fmt::format_to(std::back_inserter(text), "{}{}", text.empty() ? "" : ", ", sorted[first]);
    if (last > first) {
      fmt::format_to(std::back_inserter(text), "-{}", sorted[last]);
    }
    first = last + 1;
  }
  return text;
}

/// By source: {"file", "table", "rows"}.
Json rowsOf(const Cell& cell, const std::vector<std::string>& sources) {
  std::map<int, std::vector<int64_t>> bySource;
  for (const RowRef& row : cell.rows) {
    bySource[row.source].push_back(row.row);
  }
  Json json = Json::array();
  for (auto& [source, rows] : bySource) {
    std::sort(rows.begin(), rows.end());
    json.push_back({{"file", cleanText(sources[static_cast<size_t>(source)])},
                    {"table", cell.from == Cell::From::kAnswers ? "final_answer" : "final_trial"},
                    {"rows", rangesOf(rows)}});
  }
  return json;
}

/// The rows of each cell by its name. What many cells share stands once, in `sets`.
struct OriginsAsJson {
  Json sets = Json::object();
  Json cells = Json::object();
};

OriginsAsJson jsonOf(const ReportOrigins& origins) {
  OriginsAsJson result;
  std::map<std::string, std::string> names;
  for (const Table& table : origins.tables) {
    for (const TableRow& row : table.rows) {
      for (const Cell& cell : row.cells) {
        if (cell.from == Cell::From::kCells) {
          result.cells[cell.name] = {{"from", cell.cells}};
        } else if (cell.from == Cell::From::kSubjects) {
          result.cells[cell.name] = {{"subjects", cell.subjects.size()}};
        } else if (!cell.rows.empty()) {
          const Json rows = rowsOf(cell, origins.sources);
          const auto [name, isNew] = names.try_emplace(rows.dump(), fmt::format("set-{}", names.size() + 1));
          if (isNew) {
            result.sets[name->second] = rows;
          }
          result.cells[cell.name] = {{"rows", name->second}};
        }
      }
    }
  }
  return result;
}

Json cellOf(const ReportCell& cell) {
  Json json = {{"text", cleanText(cell.text)}};
  put(json, "id", cell.id);
  if (cell.value) {
    json["value"] = std::isfinite(*cell.value) ? Json(*cell.value) : Json(nullptr);
  }
  if (cell.interval) {
    json["interval"] = {cell.interval->first, cell.interval->second};
  }
  put(json, "short_name", cell.shortName);
  put(json, "source", cell.source);
  put(json, "footnote", cell.footnote);
  return json;
}

Json jsonOf(const ReportHeading& heading) {
  return {{"type", "heading"}, {"level", heading.level}, {"text", cleanText(heading.text)}};
}

Json jsonOf(const ReportParagraph& paragraph) {
  return {{"type", "paragraph"}, {"text", cleanText(paragraph.text)}};
}

Json jsonOf(const ReportList& list) {
  Json items = Json::array();
  for (const std::string& item : list.items) {
    items.push_back(cleanText(item));
  }
  return {{"type", "list"}, {"items", items}};
}

Json jsonOf(const ReportFacts& facts) {
  Json items = Json::array();
  for (const ReportFacts::Fact& fact : facts.facts) {
    items.push_back({{"term", cleanText(fact.term)}, {"text", cleanText(fact.text)}});
  }
  return {{"type", "facts"}, {"facts", items}};
}

Json jsonOf(const ReportNote& note) {
  return {{"type", "note"}, {"kind", nameOf(note.kind)}, {"text", cleanText(note.text)}};
}

Json jsonOf(const ReportExcerpt& excerpt) {
  return {{"type", "excerpt"}, {"title", cleanText(excerpt.title)}, {"text", cleanText(excerpt.text)}};
}

Json jsonOf(const ReportTable& table) {
  Json columns = Json::array();
  for (const ReportColumn& column : table.columns) {
    Json json = {{"title", cleanText(column.title)}};
    put(json, "group", column.group);
    columns.push_back(json);
  }
  Json rows = Json::array();
  for (const std::vector<ReportCell>& row : table.rows) {
    Json cells = Json::array();
    for (const ReportCell& cell : row) {
      cells.push_back(cellOf(cell));
    }
    rows.push_back(cells);
  }
  Json json = {{"type", "table"}, {"caption", cleanText(table.caption)}};
  if (table.exploratory) {
    json["exploratory"] = true;
  }
  json["columns"] = columns;
  json["rows"] = rows;
  return json;
}

Json jsonOf(const ReportFigure& figure) {
  return {{"type", "figure"},
          {"caption", cleanText(figure.caption)},
          {"title", cleanText(figure.figure.title)},
          {"description", cleanText(figure.figure.description)}};
}

}  // namespace

std::string jsonReport(const ReportDocument& document) {
  Json json = {{"format", kReportFormat}, {"title", cleanText(document.title)}};
  put(json, "subtitle", document.subtitle);
  put(json, "marking", document.marking);
  put(json, "version", document.version);
  put(json, "created", document.created);
  const DocumentNames names = documentNames(document);
  Json elements = Json::array();
  const auto addAll = [&](const std::vector<ReportElement>& part, const std::vector<ElementName>& named,
                          const std::string& partName) {
    for (size_t i = 0; i < part.size(); ++i) {
      Json element = std::visit([](const auto& what) { return jsonOf(what); }, part[i]);
      put(element, "id", named[i].id);
      put(element, "label", named[i].label);
      put(element, "part", partName);
      elements.push_back(element);
    }
  };
  addAll(document.elements, names.elements, "");
  addAll(document.supplement, names.supplement, "supplement");
  json["elements"] = elements;
  const OriginsAsJson origins = jsonOf(document.origins);
  json["row_sets"] = origins.sets;
  json["cells"] = origins.cells;
  return json.dump(1) + "\n";
}

}  // namespace ocelli
