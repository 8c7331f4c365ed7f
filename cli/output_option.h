// The option -o of every command that writes one file, and those for a second one beside it.
#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace ocelli {

class CommandContext;

/// Adds the required -o,--output. A path must end in one of `endings` (".png"), so that no file of another kind is
/// overwritten by mistake; pipes, devices and this program's own streams may have any name. Call checkWritable() with
/// it before long work.
void addOutputOption(CLI::App& command, std::string& path, const std::string& help,
                     const std::vector<std::string>& endings);
/// The same for a file that need not be written, by an option of that name.
void addSecondOutputOption(CLI::App& command, const std::string& name, std::string& path, const std::string& help,
                           const std::vector<std::string>& endings);

/// The same for any number of files, by -o,--output, which may be repeated.
void addOutputFilesOption(CLI::App& command, std::vector<std::string>& paths, const std::string& help,
                          const std::vector<std::string>& endings);

/// Adds --json [FILE], for figures that are printed as a table: "-" where they are to go to standard output.
void addFiguresOption(CLI::App& command, std::string& json);
/// Of that option, before long work: throws where that file cannot be written, or is `output`, another that is written.
void checkFiguresOutput(const std::string& json, const std::string& output = "");
/// Prints the table, if there is one, or the figures in its place where that option says so; or writes them to its
/// file.
void giveFigures(const std::string& json, const std::string& figures, const std::string& table,
                 const CommandContext& context);

/// Before long work: throws where that second file, if there is to be one, cannot be written, or is the first one.
void checkSecondOutput(const std::string& path, const std::string& name, const std::string& first);

}  // namespace ocelli
