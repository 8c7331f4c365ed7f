#include "cli/output_option.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>

#include "cli/command.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/output_file.h"

namespace ocelli {

namespace {

template <class Paths>
CLI::Option* addFile(CLI::App& command, const std::string& names, Paths& path, const std::string& help,
                     const std::vector<std::string>& endings) {
  std::string type;
  std::string wanted;
  for (const std::string& ending : endings) {
    type += (type.empty() ? "FILE" : "|FILE") + ending;
    wanted += (wanted.empty() ? "" : " or ") + ending;
  }
  return command.add_option(names, path, help)
      ->check([endings, wanted](const std::string& given) {
        const bool fits = isStream(given) ||
                          std::ranges::any_of(endings, [&](const auto& ending) { return given.ends_with(ending); });
        return fits ? std::string() : "\"" + given + "\" does not end in " + wanted;
      })
      ->type_name(type);
}

}  // namespace

void addOutputOption(CLI::App& command, std::string& path, const std::string& help,
                     const std::vector<std::string>& endings) {
  addFile(command, "-o,--output", path, help, endings)->required();
}

void addSecondOutputOption(CLI::App& command, const std::string& name, std::string& path, const std::string& help,
                           const std::vector<std::string>& endings) {
  addFile(command, name, path, help, endings);
}

void addOutputFilesOption(CLI::App& command, std::vector<std::string>& paths, const std::string& help,
                          const std::vector<std::string>& endings) {
  addFile(command, "-o,--output", paths, help, endings)->expected(1)->take_all();
}

void addFiguresOption(CLI::App& command, std::string& json) {
  command.add_option("--json", json, "Also write the figures here; alone or as - they go to standard output")
      ->expected(0, 1)
      ->default_str("-")
      ->type_name("FILE");
}

void checkFiguresOutput(const std::string& json, const std::string& output) {
  if (json != "-") {
    checkSecondOutput(json, "--json", output);
  }
}

void giveFigures(const std::string& json, const std::string& figures, const std::string& table,
                 const CommandContext& context) {
  const std::string& printed = json == "-" ? figures : table;
  if (!printed.empty()) {
    context.print(printed);
  }
  if (!json.empty() && json != "-") {
    writeFile(json, figures);
  }
}

void checkSecondOutput(const std::string& path, const std::string& name, const std::string& first) {
  if (path.empty()) {
    return;
  }
  std::error_code noFile;
  if (path == first || std::filesystem::equivalent(path, first, noFile)) {
    throw InputError("both would go into " + path, name, "choose another file");
  }
  checkWritable(path);
}

}  // namespace ocelli
