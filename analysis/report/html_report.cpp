#include "analysis/report/html_report.h"

#include <fmt/format.h>
#include <openssl/evp.h>

#include <algorithm>
#include <array>

#include "analysis/plot/style.h"
#include "analysis/report/html_style.h"
#include "oc_core/base/sha256.h"
#include "oc_core/page/html.h"
#include "oc_core/page/page_colors.h"

namespace ocelli {
namespace {

constexpr const char* kReportPage = "index.html";
constexpr const char* kSupplementPage = "supplement.html";
constexpr const char* kSourcesPrefix = "sources-";

// Narrower than this share of its size a wide figure scrolls: its letters would be too small.
constexpr double kMinShare = 0.85;

std::string escaped(const std::string& text) {
  return htmlFromText(text);
}

/// As a policy names a script: base64 of its SHA-256.
std::string scriptDigest(std::string_view script) {
  const Digest digest = sha256Digest(script);
  std::array<unsigned char, 4 * ((std::tuple_size_v<Digest> + 2) / 3) + 1> text{};
  const int length = EVP_EncodeBlock(text.data(), digest.data(), static_cast<int>(digest.size()));
  return {reinterpret_cast<const char*>(text.data()), static_cast<size_t>(length)};
}

const char* noteClass(NoteKind kind) {
  switch (kind) {
    case NoteKind::kNote:
      return "note";
    case NoteKind::kWarning:
    case NoteKind::kSimulated:
      return "note caution";
    case NoteKind::kNotEstimable:
      return "note missing";
  }
  return "note";
}

bool hasGroups(const ReportTable& table) {
  return std::any_of(table.columns.begin(), table.columns.end(),
                     [](const auto& column) { return !column.group.empty(); });
}

std::string tableHead(const ReportTable& table) {
  const bool groups = hasGroups(table);
  std::string top;
  std::string bottom;
  for (size_t i = 0; i < table.columns.size(); ++i) {
    const ReportColumn& column = table.columns[i];
    const std::string words = column.words ? " class=\"words\"" : "";
    if (groups && column.group.empty()) {
      top += fmt::format("<th scope=\"col\" rowspan=\"2\"{}>{}</th>", words, escaped(column.title));
      continue;
    }
    if (groups && (i == 0 || table.columns[i - 1].group != column.group)) {
      size_t end = i;
      while (end < table.columns.size() && table.columns[end].group == column.group) {
        ++end;
      }
      top += fmt::format("<th scope=\"colgroup\" colspan=\"{}\">{}</th>", end - i, escaped(column.group));
    }
    bottom += fmt::format("<th scope=\"col\"{}>{}</th>", words, escaped(column.title));
  }
  return groups ? fmt::format("<thead><tr>{}</tr>\n<tr>{}</tr></thead>\n", top, bottom)
                : fmt::format("<thead><tr>{}</tr></thead>\n", bottom);
}

std::string cellMarkup(const ReportTable& table, const std::vector<std::string>& footnotes, const ReportCell& cell,
                       size_t column) {
  std::string attributes;
  if (!cell.id.empty()) {
    attributes += fmt::format(" id=\"{}\"", escaped(cell.id));
  }
  std::string inner = escaped(cell.text);
  if (!cell.source.empty()) {
    attributes += fmt::format(" title=\"{}\"", escaped(cell.source));
    inner = fmt::format("<span class=\"source\">{}</span>", inner);
  }
  if (!cell.footnote.empty()) {
    inner += fmt::format("<sup>{}</sup>", footnoteMark(footnotes, cell.footnote));
  }
  if (!cell.shortName.empty()) {
    inner += fmt::format("<small>{}</small>", escaped(cell.shortName));
  }
  if (column == 0) {
    return fmt::format("<th scope=\"row\"{}>{}</th>", attributes, inner);
  }
  const bool words = column < table.columns.size() && table.columns[column].words;
  const std::string names = fmt::format("{}{}", words ? "words" : "", cell.emphasised ? " strong" : "");
  return fmt::format("<td{}{}>{}</td>", attributes, names.empty() ? "" : fmt::format(" class=\"{}\"", names), inner);
}

/// Of a table in the main report, as a part of the supplement: which cells came from where.
std::string sourcesMarkup(const ReportTable& table, const ElementName& name, const std::string& page) {
  std::string items;
  for (const SourceEntry& entry : sourcesOf(table)) {
    std::string cells;
    for (size_t i = 0; i < entry.cells.size(); ++i) {
      cells += i == 0 ? "" : "; ";
      cells += entry.ids[i].empty()
                   ? escaped(entry.cells[i])
                   : fmt::format("<a href=\"{}#{}\">{}</a>", page, escaped(entry.ids[i]), escaped(entry.cells[i]));
    }
    items += fmt::format("<li>{}: <code>{}</code></li>\n", cells, escaped(entry.source));
  }
  return items.empty() ? ""
                       : fmt::format("<h3 id=\"{0}{1}\"><a href=\"{2}#{1}\">{3}</a>. {4}</h3>\n<ul>\n{5}</ul>\n",
                                     kSourcesPrefix, name.id, page, name.label, escaped(table.caption), items);
}

class HtmlWriter {
 public:
  /// `sourcesPage`: the file that says where numbers come from; empty for the page itself.
  explicit HtmlWriter(std::string sourcesPage) : sourcesPage_(std::move(sourcesPage)) {}

  std::string write(const ReportElement& element, const ElementName& name) const {
    return std::visit([&](const auto& what) { return markup(what, name); }, element);
  }

 private:
  static std::string markup(const ReportHeading& heading, const ElementName& name) {
    const int level = std::clamp(heading.level, 1, 3) + 1;
    return fmt::format("<h{0} id=\"{1}\">{2}</h{0}>\n", level, name.id, escaped(heading.text));
  }
  static std::string markup(const ReportParagraph& paragraph, const ElementName&) {
    return fmt::format("<p>{}</p>\n", escaped(paragraph.text));
  }
  static std::string markup(const ReportList& list, const ElementName&) {
    std::string items;
    for (const std::string& item : list.items) {
      items += fmt::format("<li>{}</li>\n", escaped(item));
    }
    return items.empty() ? "" : fmt::format("<ul>\n{}</ul>\n", items);
  }
  static std::string markup(const ReportFacts& facts, const ElementName&) {
    std::string items;
    for (const ReportFacts::Fact& fact : facts.facts) {
      const std::string text = escaped(fact.text);
      items += fmt::format("<dt>{}</dt><dd>{}</dd>\n", escaped(fact.term),
                           fact.code ? fmt::format("<code>{}</code>", text) : text);
    }
    return items.empty() ? "" : fmt::format("<dl class=\"facts\">\n{}</dl>\n", items);
  }
  static std::string markup(const ReportNote& note, const ElementName&) {
    return fmt::format("<div class=\"{}\" role=\"note\"><b>{}</b> {}</div>\n", noteClass(note.kind),
                       noteTitle(note.kind), escaped(note.text));
  }
  static std::string markup(const ReportExcerpt& excerpt, const ElementName& name) {
    return fmt::format(
        "<section class=\"excerpt\" id=\"{0}\" aria-label=\"{1}\"><div class=\"bar\"><h3>{1}</h3></div><div "
        "class=\"text\">{2}</div></section>\n",
        name.id, escaped(excerpt.title), escaped(excerpt.text));
  }
  std::string markup(const ReportTable& table, const ElementName& name) const {
    const std::vector<std::string> footnotes = footnotesOf(table);
    std::string rows;
    for (const std::vector<ReportCell>& row : table.rows) {
      rows += "<tr>";
      for (size_t i = 0; i < row.size(); ++i) {
        rows += cellMarkup(table, footnotes, row[i], i);
      }
      rows += "</tr>\n";
    }
    if (rows.empty()) {
      rows = fmt::format("<tr><td class=\"words\" colspan=\"{}\">No rows.</td></tr>\n",
                         std::max<size_t>(table.columns.size(), 1));
    }
    std::string notes;
    for (const std::string& footnote : footnotes) {
      notes += fmt::format("<li><sup>{}</sup> {}</li>\n", footnoteMark(footnotes, footnote), escaped(footnote));
    }
    if (!notes.empty()) {
      notes = fmt::format("<ul class=\"footnotes\">\n{}</ul>\n", notes);
    }
    // Where the numbers come from stands in the supplement.
    const std::string sources =
        sourcesOf(table).empty()
            ? ""
            : fmt::format("<p class=\"sources\"><a href=\"{}#{}{}\">Where these numbers come from</a></p>\n",
                          sourcesPage_, kSourcesPrefix, name.id);
    return fmt::format(
        "<div class=\"table\" id=\"{0}\"><p class=\"title\" id=\"{0}-title\"><b>{1}.</b>{6} {2}</p>\n<div "
        "class=\"scroll\" "
        "tabindex=\"0\" role=\"region\" aria-labelledby=\"{0}-title\"><table "
        "aria-labelledby=\"{0}-title\">\n{3}<tbody>\n{4}</tbody></table></div>\n{5}{7}</div>\n",
        name.id, name.label, escaped(table.caption), tableHead(table), rows, notes,
        table.exploratory ? fmt::format(" <span class=\"exploratory\">{}</span>", kExploratory) : "", sources);
  }
  static std::string markup(const ReportFigure& figure, const ElementName& name) {
    const bool wide = figure.figure.width > 1.2 * kSingleColumnMillimetres * kPointsPerMillimetre;
    return fmt::format(
        "<figure id=\"{0}\"><div class=\"scroll\"{1} style=\"--width: {2:.0f}pt; --least: {3:.0f}pt\">{4}</div>"
        "<figcaption><b>{5}.</b> {6}</figcaption></figure>\n",
        name.id, wide ? fmt::format(" tabindex=\"0\" role=\"region\" aria-label=\"{}\"", name.label) : "",
        figure.figure.width, wide ? kMinShare * figure.figure.width : 0,
        inlineSvgText(figure.figure, fmt::format("{}-", name.id)), name.label, escaped(figure.caption));
  }

  std::string sourcesPage_;
};

/// Headings of levels 1 and 2, the second in lists of their own; then `last`, a list item.
std::string contents(const std::vector<ReportElement>& elements, const std::vector<ElementName>& names,
                     const std::string& last) {
  std::string list;
  bool inItem = false;
  bool inList = false;
  const auto endItem = [&] {
    list += inList ? "</ol>" : "";
    list += inItem ? "</li>\n" : "";
    inList = false;
    inItem = false;
  };
  for (size_t i = 0; i < elements.size(); ++i) {
    const auto* heading = std::get_if<ReportHeading>(&elements[i]);
    if (heading == nullptr || heading->level > 2) {
      continue;
    }
    const std::string link = fmt::format("<a href=\"#{}\">{}</a>", names[i].id, escaped(heading->text));
    if (heading->level <= 1 || !inItem) {
      endItem();
      list += fmt::format("<li>{}", link);
      inItem = true;
    } else {
      list += inList ? "" : "<ol>";
      list += fmt::format("<li>{}</li>", link);
      inList = true;
    }
  }
  endItem();
  list += list.empty() ? "" : last;
  return list.empty() ? "" : fmt::format("<nav aria-label=\"Contents\"><h2>Contents</h2><ol>\n{}</ol></nav>\n", list);
}

/// A whole page of a document.
std::string page(const ReportDocument& document, const std::string& title, const std::string& subtitle,
                 const std::string& nav, const std::string& body) {
  const std::string marking =
      document.marking.empty() ? "" : fmt::format("<p class=\"marking\">{}</p>\n", escaped(document.marking));
  PageHead head;
  head.title = title;
  head.tags = fmt::format(
      "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src &#39;none&#39;; style-src "
      "&#39;unsafe-inline&#39;; script-src &#39;sha256-{}&#39;; base-uri &#39;none&#39;; form-action "
      "&#39;none&#39;\">\n<meta name=\"generator\" content=\"Ocelli {}\">\n",
      scriptDigest(kReportScript), escaped(document.version));
  head.style = fmt::format("{}{}", pageColorsStyle(PageScheme::kLight), kReportStyle);
  std::string html = pageBegin(head);
  html += fmt::format(
      "<a class=\"skip\" href=\"#report\">To the report</a>\n<div class=\"page\">\n"
      "<header>\n{}<h1>{}</h1>\n{}</header>\n{}<main id=\"report\">\n",
      marking, escaped(title), subtitle, nav);
  html += body;
  html += fmt::format(
      "</main>\n<footer>Ocelli {}, {}</footer>\n</div>\n<p id=\"shown\" aria-live=\"polite\"></p>\n<script>",
      escaped(document.version), escaped(document.created));
  html += kReportScript;
  html += "</script>\n";
  return html + pageEnd();
}

std::string subtitleMarkup(const ReportDocument& document, const std::string& more) {
  return document.subtitle.empty() && more.empty()
             ? ""
             : fmt::format("<p class=\"subtitle\">{}{}</p>\n", escaped(document.subtitle), more);
}

}  // namespace

std::string htmlReport(const ReportDocument& document) {
  const std::vector<ElementName> names = documentNames(document).elements;
  const HtmlWriter writer(kSupplementPage);
  std::string body;
  for (size_t i = 0; i < document.elements.size(); ++i) {
    body += writer.write(document.elements[i], names[i]);
  }
  const std::string nav =
      contents(document.elements, names, fmt::format("<li><a href=\"{}\">Supplement</a></li>\n", kSupplementPage));
  return page(document, document.title, subtitleMarkup(document, ""), nav, body);
}

std::string htmlSupplement(const ReportDocument& document) {
  const DocumentNames names = documentNames(document);
  const HtmlWriter writer("");
  std::string body;
  for (size_t i = 0; i < document.supplement.size(); ++i) {
    body += writer.write(document.supplement[i], names.supplement[i]);
  }
  std::string sources;
  const auto addSources = [&](const std::vector<ReportElement>& part, const std::vector<ElementName>& named,
                              const char* file) {
    for (size_t i = 0; i < part.size(); ++i) {
      if (const auto* table = std::get_if<ReportTable>(&part[i])) {
        sources += sourcesMarkup(*table, named[i], file);
      }
    }
  };
  addSources(document.elements, names.elements, kReportPage);
  addSources(document.supplement, names.supplement, "");
  std::string last = fmt::format("<li><a href=\"{}\">Report</a></li>\n", kReportPage);
  if (!sources.empty()) {
    body += fmt::format("<section class=\"sources\"><h2 id=\"{0}\">Where the numbers come from</h2>\n{1}</section>\n",
                        kSourcesId, sources);
    last = fmt::format("<li><a href=\"#{}\">{}</a></li>\n", kSourcesId, kSourcesTitle) + last;
  }
  const std::string nav = contents(document.supplement, names.supplement, last);
  return page(document, fmt::format("{}: supplement", document.title),
              subtitleMarkup(document, fmt::format("{}<a href=\"{}\">Back to the report</a>",
                                                   document.subtitle.empty() ? "" : " \u00b7 ", kReportPage)),
              nav, body);
}

}  // namespace ocelli
