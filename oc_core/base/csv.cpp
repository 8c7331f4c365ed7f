#include "oc_core/base/csv.h"

#include <utility>

#include "oc_core/base/error.h"
#include "oc_core/base/utf8.h"

namespace ocelli {
namespace {

constexpr std::string_view kFormulaStarts = "=+-@\t\r";
constexpr std::string_view kReplacementBytes = "\xef\xbf\xbd";  // U+FFFD

}  // namespace

std::string csvText(std::string_view text) {
  std::string field;
  bool quoted = false;
  if (!text.empty() && kFormulaStarts.find(text.front()) != std::string_view::npos) {
    field += '\'';
  }
  while (!text.empty()) {
    const size_t length = bytesOfFirstCharacter(text);
    if (length == 0) {
      field += kReplacementBytes;
      text.remove_prefix(1);
      continue;
    }
    const char c = text.front();
    quoted = quoted || c == ',' || c == '"' || c == '\n' || c == '\r';
    if (c == '"') {
      field += '"';
    }
    field += text.substr(0, length);
    text.remove_prefix(length);
  }
  return quoted ? std::string("\"").append(field).append("\"") : field;
}

std::string textOfCsv(const std::string& field) {
  const bool guarded = field.size() > 1 && field[0] == '\'' && kFormulaStarts.find(field[1]) != std::string_view::npos;
  return guarded ? field.substr(1) : field;
}

CsvReader::CsvReader(std::string_view bytes, std::string where, char separator)
    : bytes_(bytes), where_(std::move(where)), separator_(separator) {
  constexpr std::string_view kByteOrderMark = "\xef\xbb\xbf";
  if (bytes_.starts_with(kByteOrderMark)) {
    bytes_.remove_prefix(kByteOrderMark.size());
  }
}

bool CsvReader::next(std::vector<std::string>& fields) {
  fields.clear();
  if (bytes_.empty()) {
    return false;
  }
  rowLine_ = line_;
  std::string field;
  bool inQuotes = false;
  size_t at = 0;
  bool isEnded = false;
  while (at < bytes_.size() && !isEnded) {
    const char c = bytes_[at++];
    line_ += c == '\n' ? 1 : 0;
    const char following = at < bytes_.size() ? bytes_[at] : '\0';
    if (inQuotes) {
      if (c != '"') {
        field += c;
      } else if (following == '"') {
        field += bytes_[at++];
      } else {
        inQuotes = false;
      }
    } else if (c == '"') {
      inQuotes = true;
    } else if (c == separator_) {
      fields.push_back(std::move(field));
      field.clear();
    } else if (c == '\n') {
      isEnded = true;
    } else if (c != '\r' || following != '\n') {
      field += c;
    }
  }
  if (inQuotes) {
    throw InputError("a quote of this row does not end", place(), "check the quotes from there on");
  }
  fields.push_back(std::move(field));
  bytes_.remove_prefix(at);
  return true;
}

std::string CsvReader::place() const {
  return where_ + ":" + std::to_string(rowLine_);
}

std::vector<std::vector<std::string>> csvRows(std::string_view bytes, const std::string& where) {
  CsvReader reader(bytes, where);
  std::vector<std::vector<std::string>> rows;
  for (std::vector<std::string> fields; reader.next(fields);) {
    rows.push_back(fields);
  }
  return rows;
}

}  // namespace ocelli
