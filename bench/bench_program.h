// What the programs that print tables of times share: options, and how they end.
#pragma once

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "oc_core/base/error.h"
#include "oc_core/base/parallel.h"

namespace ocelli {

/// `choice` has the members runs, threads, width and height.
template <class Choice>
void addCommonOptions(CLI::App& program, Choice& choice) {
  program.add_option("--runs", choice.runs, "Runs a figure")->check(CLI::Range(1, 1000))->capture_default_str();
  program.add_option("--threads", choice.threads, "0 stands for all cores")->check(CLI::Range(0, 1024));
  program.add_option("--width", choice.width, "Pixels")->check(CLI::Range(1, 8192))->capture_default_str();
  program.add_option("--height", choice.height, "Pixels")->check(CLI::Range(1, 8192))->capture_default_str();
}

/// Reads the command line, and calls `measure(choice)`. The exit code of the program.
template <class Choice, class Measure>
int runProgram(CLI::App& program, int argumentCount, char** arguments, const Choice& choice, const Measure& measure) {
  CLI11_PARSE(program, argumentCount, arguments);
  setThreadCount(choice.threads);
  try {
    measure(choice);
    return 0;
  } catch (const Error& error) {
    fmt::print(stderr, "{}: error: {}\n", program.get_name(), error.what());
    return 1;
  }
}

}  // namespace ocelli
