// `ocelli man` and `ocelli completion`: what packages install beside the program.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <memory>

#include "cli/command.h"
#include "cli/man_page.h"
#include "cli/shell_completion.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"

namespace ocelli {
namespace {

void writePages(const CommandText& command, const CommandText* above, const std::filesystem::path& folder, int& pages) {
  writeFile(folder / (command.pageName() + ".1"), manPage(command, above, OCELLI_VERSION));
  ++pages;
  for (const CommandText& below : command.commands) {
    writePages(below, &command, folder, pages);
  }
}

void addMan(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("man", "Write the manual pages, one for each command");
  const auto folder = std::make_shared<std::string>();
  command.add_option("-o,--output", *folder, "A folder, which is made where it is missing")
      ->required()
      ->type_name("FOLDER");
  context.finish(command, "  ocelli man -o ~/.local/share/man/man1", [&program, folder, context] {
    std::error_code error;
    std::filesystem::create_directories(*folder, error);
    if (error) {
      throw WorkError(fmt::format("cannot make this folder ({})", error.message()), *folder,
                      "check that the folder above it exists and may be written to");
    }
    int pages = 0;
    writePages(commandText(program), nullptr, *folder, pages);
    context.note(fmt::format("wrote {} pages to {}", pages, *folder));
  });
}

void addCompletion(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("completion", "Print what a shell needs to complete command lines");
  const auto shell = std::make_shared<std::string>();
  std::vector<std::string> names;
  for (const CompletedShell& each : kCompletedShells) {
    names.emplace_back(each.name);
  }
  command.add_option("SHELL", *shell, "Which shell")
      ->required()
      ->check(CLI::IsMember(names))
      ->type_name(fmt::format("{}", fmt::join(names, "|")));
  context.finish(command,
                 "  source <(ocelli completion bash)\n"
                 "  ocelli completion zsh > ~/.zfunc/_ocelli",
                 [&program, shell, context] {
                   const auto found = std::ranges::find(
                       kCompletedShells, *shell, [](const CompletedShell& each) { return std::string(each.name); });
                   context.print(found->script(commandText(program)));
                 });
}

}  // namespace

void addManualCommands(CLI::App& program, const CommandContext& context) {
  addMan(program, context);
  addCompletion(program, context);
}

}  // namespace ocelli
