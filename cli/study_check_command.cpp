// `ocelli study check`: is a protocol valid, and what does a study by it look like?
#include <CLI/CLI.hpp>

#include "cli/command.h"
#include "cli/study_command.h"
#include "study/protocol/check_report.h"
#ifdef OCELLI_WITH_OPENGL
#include "study/screen/protocol_texts.h"
#endif

namespace ocelli {

void addStudyCheckCommand(CLI::App& study, const CommandContext& context) {
  struct Choice {
    std::string protocol;
    CheckOptions options;
    int session = 1;
  };
  CLI::App& command =
      *study.add_subcommand("check", "Check a protocol; show the schedule of a subject, its length and its balance");
  const auto choice = std::make_shared<Choice>();
  command.add_option("protocol", choice->protocol, "The protocol, a JSON file")->required()->type_name("PROTOCOL");
  command.add_option("--subjects", choice->options.subjects, "Count the balance over so many subjects")
      ->check(CLI::Range(1, 10000))
      ->capture_default_str();
  command
      .add_option("--subject-slot", choice->options.slot,
                  "Whose schedule to show: the first subject of the study has slot 0")
      ->check(CLI::Range(0, 1000000))
      ->capture_default_str();
  command.add_option("--session", choice->options.session, "Of which session, from 1")
      ->check(CLI::Range(1, 1000))
      ->capture_default_str();
  command.add_flag("--answers", choice->options.answers, "Show the right answers too");
  command.add_flag("--coverage", choice->options.coverage,
                   "Draw what the views show, and count the places that they cover; takes seconds");
  command.add_flag("--json", choice->options.asJson, "Print all of it as JSON");
  context.finish(command,
                 "  ocelli study check protocols/rosen2010-balanced.json\n"
                 "  ocelli study check protocols/short.json --subjects 60 --subject-slot 3 --answers",
                 [choice, context] {
                   const Protocol protocol = readProtocol(choice->protocol);
#ifdef OCELLI_WITH_OPENGL
                   requireDrawable(protocol);
#endif
                   context.print(checkReport(protocol, choice->options, context.progress()));
                 });
}

}  // namespace ocelli
