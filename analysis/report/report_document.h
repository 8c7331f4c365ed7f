// A report as data: what stands in it, in order. html_report.h, pdf_report.h and json_report.h write the same document.
// All text is plain: writers escape it. It has two parts: what answers the study's questions, and a supplement for who
// wants to check it.
#pragma once

#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "analysis/tables/table.h"
#include "oc_core/drawing/figure.h"
#include "study/trial/view_condition.h"

namespace ocelli {

/// The part that says where each number comes from.
inline constexpr const char* kSourcesId = "sources-of-numbers";
inline constexpr const char* kSourcesTitle = "Where the numbers come from";

/// Level 1 parts the report, 2 and 3 are within.
struct ReportHeading {
  int level = 1;
  std::string text;
  std::string id = {};  ///< stable anchor; empty: made from the text
};

struct ReportParagraph {
  std::string text;
};

struct ReportList {
  std::vector<std::string> items;
};

/// Terms with what they are: version, seed, hashes.
struct ReportFacts {
  struct Fact {
    std::string term;
    std::string text;
    bool code = false;  ///< a hash, a command
  };
  std::vector<Fact> facts;
};

enum class NoteKind { kNote, kWarning, kSimulated, kNotEstimable };

struct ReportNote {
  NoteKind kind = NoteKind::kNote;
  std::string text;
};

/// Text to take over elsewhere, such as a methods paragraph.
struct ReportExcerpt {
  std::string title;
  std::string text;
};

struct ReportCell {
  std::string text;
  std::string id = {};                         ///< stable anchor, unique in the document: what --explain takes
  std::string source = {};                     ///< the query or rows that it came from
  std::optional<double> value = std::nullopt;  ///< with all its digits, for report.json
  std::string footnote = {};                   ///< printed below the table
  bool emphasised = false;
  std::string shortName = {};  ///< what data and plan call it: in small type below the text
  /// The bounds that the text shows, with all their digits, for report.json.
  std::optional<std::pair<double, double>> interval = std::nullopt;
};

struct ReportColumn {
  std::string title;
  std::string group = {};  ///< neighbours of one group stand under its name
  bool words = false;      ///< set left, and may be broken; else set right
};

/// The first cell of each row heads it.
struct ReportTable {
  std::string caption;
  std::string id = {};
  std::vector<ReportColumn> columns;
  std::vector<std::vector<ReportCell>> rows;
  bool isRecord = false;     ///< tells what was done, and no result
  bool exploratory = false;  ///< its results are not of the registered plan
};

struct ReportFigure {
  std::string caption;
  std::string id = {};
  Figure figure;
};

using ReportElement = std::variant<ReportHeading, ReportParagraph, ReportList, ReportFacts, ReportNote, ReportExcerpt,
                                   ReportTable, ReportFigure>;

/// Where the numbers of a report's tables came from, cell by cell: for `--explain`, tables/cells.csv and report.json.
struct ReportOrigins {
  std::vector<std::string> sources{};               ///< paths; RowRef::source counts them
  ViewConditions conditions = defaultConditions();  ///< whose names stand in names of cells
  std::vector<Table> tables{};
};

struct ReportDocument {
  std::string title;
  std::string subtitle;
  std::string marking;                           ///< on every page where not empty: "Simulated subjects"
  std::string version;                           ///< of the program
  std::string created = "2000-01-01T00:00:00Z";  ///< ISO 8601; given, so that the same document gives the same bytes
  std::vector<ReportElement> elements;
  ReportOrigins origins{};
  std::vector<std::string> failures{};  ///< parts that threw, and what: faults of the program (part_guard.h)
  std::vector<ReportElement> supplement{};
  bool addsToSupplement = false;  ///< InSupplement sets it

  void add(ReportElement element);
};

/// While it lives, what is added to the document goes to its supplement, below the heading of the current section.
class InSupplement {
 public:
  explicit InSupplement(ReportDocument& document);
  ~InSupplement() { document_.addsToSupplement = before_; }
  InSupplement(const InSupplement&) = delete;
  InSupplement& operator=(const InSupplement&) = delete;

 private:
  ReportDocument& document_;
  bool before_;
};

/// What an element is called. Elements without a name of their own have empty ones.
struct ElementName {
  std::string id;     ///< anchor: letters, digits and hyphens, unique
  std::string label;  ///< "Table 3", in the supplement "Table S3"
};

/// One for each element. Ids that are empty, hold other characters or stand twice are made good.
struct DocumentNames {
  std::vector<ElementName> elements;
  std::vector<ElementName> supplement;
};
DocumentNames documentNames(const ReportDocument& document);
std::vector<ElementName> elementNames(const ReportDocument& document);

/// What the writers put into the caption of a table: "Exploratory" where it is.
inline constexpr const char* kExploratory = "Exploratory";

/// What a note is headed by: "Cannot be estimated".
std::string noteTitle(NoteKind kind);

/// Cells of a table with the same source, for lists of sources. Rows whose cells all have the same are named as one.
struct SourceEntry {
  std::vector<std::string> cells;  ///< "row, column", or "row"
  std::vector<std::string> ids;    ///< of those cells, empty where they have none
  std::string source;
};
std::vector<SourceEntry> sourcesOf(const ReportTable& table);

/// The different footnotes of a table in order; a cell's mark is its footnote's place: a, b, ...
std::vector<std::string> footnotesOf(const ReportTable& table);
std::string footnoteMark(const std::vector<std::string>& footnotes, const std::string& footnote);

}  // namespace ocelli
