#include "study/store/identity_key.h"

#include <sys/stat.h>

#include <algorithm>
#include <string_view>

#include "oc_core/base/csv.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

namespace fs = std::filesystem;
using Lines = std::vector<std::vector<std::string>>;

const std::vector<std::string> kHead{"subject_id", "name"};

/// Without its first line.
Lines readKey(const fs::path& keyFile) {
  Lines lines = csvRows(readFile(keyFile), keyFile.string());
  if (!lines.empty() && lines.front() == std::vector<std::string>{"subject_id;name"}) {
    throw InputError("the columns of this identity key are apart by ;", keyFile.string(),
                     "save it with commas: \"CSV UTF-8, separated by commas\"");
  }
  if (lines.empty() || lines.front() != kHead) {
    throw InputError("this is no identity key: its first line is not \"subject_id,name\"", keyFile.string(),
                     "the name of a key file, or of a new file");
  }
  lines.erase(lines.begin());
  return lines;
}

void writeKey(const fs::path& keyFile, const Lines& lines) {
  std::string text = "subject_id,name\r\n";
  for (const std::vector<std::string>& line : lines) {
    for (size_t i = 0; i < line.size(); ++i) {
      text.append(i == 0 ? "" : ",").append(csvText(line[i]));
    }
    text += "\r\n";
  }
  const mode_t before = umask(0077);
  try {
    writeFile(keyFile, text);
  } catch (...) {
    umask(before);
    throw;
  }
  umask(before);
}

auto isOf(const std::string& subject) {
  return [&subject](const std::vector<std::string>& line) { return line.front() == subject; };
}

}  // namespace

void addIdentity(const fs::path& keyFile, const std::string& subject, const std::string& name) {
  Lines lines = fs::exists(keyFile) ? readKey(keyFile) : Lines{};
  if (std::any_of(lines.begin(), lines.end(), isOf(subject))) {
    throw InputError("the identity key has a line of that subject already", keyFile.string(),
                     "check who that is, and choose another id");
  }
  lines.push_back({subject, name});
  writeKey(keyFile, lines);
}

bool removeIdentity(const fs::path& keyFile, const std::string& subject) {
  Lines lines = readKey(keyFile);
  const auto kept = std::remove_if(lines.begin(), lines.end(), isOf(subject));
  const bool found = kept != lines.end();
  lines.erase(kept, lines.end());
  if (found) {
    writeKey(keyFile, lines);
  }
  return found;
}

}  // namespace ocelli
