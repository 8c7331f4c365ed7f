#include "study/export/export_columns.h"

#include <fmt/format.h>

#include <array>
#include <utility>

#include "study/tasks/task_registry.h"

namespace ocelli {

namespace {

std::string taskMeaning() {
  std::string text = "what was to be done";
  for (const TaskKind& kind : taskKinds()) {
    text += fmt::format("; {}: {}", kind.name, kind.description);
  }
  return text;
}

}  // namespace

const std::vector<ColumnMeaning>& columnMeanings() {
  static const std::vector<ColumnMeaning> meanings{
      {"row_id", "", "number of the row in its file, from 1"},
      {"subject_id", "", "pseudonym of the subject"},
      {"simulated", "", "1: a simulated subject; 0: a person"},
      {"subject_kind", "",
       "person, simulated_generator (numbers with known effects) or simulated_observer (sees frames)"},
      {"slot", "", "place of the subject in the counterbalancing, from 0"},
      {"created_utc", "", "when the subject was added (UTC)"},
      {"sessions", "", "sessions that the subject began"},
      {"session_number", "", "session of the subject, from 1"},
      {"run_id", "", "one start of the program for a session; a session that was resumed has several"},
      {"run_number", "", "number of the run in its session, from 1"},
      {"started_utc", "", "when it began, by the computer's clock (UTC)"},
      {"ended_utc", "", "when it ended, by the computer's clock (UTC); empty where the program was killed"},
      {"ending", "",
       "how it ended. Trials: completed, redone, aborted; runs: completed, unwell, aborted, declined, failed; empty "
       "where "
       "the program was killed"},
      {"program_version", "", "version of the program that ran the session"},
      {"station", "", "name of the computer"},
      {"forced", "", "1: started although the check of the screen's timing refused"},
      {"environment_json", "",
       "system, graphics, screen, clocks, how input is time-stamped, what is not measured (JSON)"},
      {"timing_check_json", "", "what the check of the screen's timing measured (JSON)"},
      {"simulation_json", "", "parameters of a simulated subject (JSON)"},
      {"schedule_seed", "", "seed of the session's schedule, hexadecimal"},
      {"trial_id", "", "number of the attempt in the database; the same in all tables"},
      {"trial_number", "", "number of the attempt among those of its run, from 0, practice included"},
      {"counts", "", "1: the last completed attempt of its plan, or the last answer to its question: use these alone"},
      {"practice", "", "1: practice, which is not analysed"},
      {"plan_index", "", "place in the schedule of the session, from 0; empty for practice"},
      {"attempt", "", "how often this plan was begun, from 1"},
      {"block", "", "name of the block in the protocol"},
      {"block_index", "", "place of the block in the protocol, from 0"},
      {"task", "", taskMeaning()},
      {"case_index", "", "case of the block, from 0; of its practice cases in practice"},
      {"case_label", "", "name of the case"},
      {"view", "", "ppc: planar pinhole camera(s); gc: graph camera"},
      {"trial_seed", "", "seed of what is random in the trial, hexadecimal"},
      {"moving", "", "1: the objects move"},
      {"exposure_s", "s", "planned time for which the scene is shown; empty where the subject ends it"},
      {"objects", "", "how many objects there are, where the task has a number of them"},
      {"duplicate_colors", "", "1: some objects share a colour"},
      {"answer", "", "what was answered; empty where nothing was"},
      {"expected", "", "what would have been right"},
      {"correct", "", "1: the answer is right"},
      {"censored", "", "1: time ran out, and the response would have come after response_s"},
      {"response_s", "s", "time to the answer or to the end of the time; with an exposure, from its end"},
      {"exposure_rule", "", "what ended the exposure: clock, or frames (databases before version 3, empty there)"},
      {"exposure_shown_s", "s", "from the first frame with the scene to the first without it"},
      {"exposure_frames", "frames", "frames that showed the scene, of tasks with an exposure"},
      {"frames", "frames", "frames that the trial showed"},
      {"dropped_frames", "", "intervals between frames that were too long by the protocol's limit"},
      {"median_interval_ns", "ns", "median of the intervals between frames"},
      {"longest_interval_ns", "ns", "longest interval between frames"},
      {"timing_verdict", "", "good, dropped_frames, early_frames, unstable_refresh or simulated_clock"},
      {"screen_width_px", "px", "width of the screen"},
      {"screen_height_px", "px", "height of the screen"},
      {"refresh_hz", "Hz", "refresh rate of the screen"},
      {"started_ns", "ns", "when the trial began, since the start of its run, by a clock that never jumps"},
      {"ended_ns", "ns", "when the trial ended, since the start of its run, by a clock that never jumps"},
      {"form", "", "name of the form in the protocol"},
      {"field", "", "name of the question"},
      {"answer_type", "",
       "option: one of several; options: a JSON array of some of several; text; number; empty where the protocol does "
       "not have the question"},
      {"answered", "", "1: the question was answered; 0: it was left open, and answer is empty"},
      {"answered_utc", "", "when it was answered, by the computer's clock (UTC)"},
      {"at_ns", "ns", "when it happened, since the start of the run, by a clock that never jumps"},
      {"at_utc", "", "when it happened, by the computer's clock (UTC)"},
      {"what", "", "events: what happened; inputs: the key, by its place on a US keyboard, or the button"},
      {"detail", "", "more about the event; empty where an experimenter typed it, unless such notes were exported"},
      {"frame", "", "number of the frame in its trial, from 0"},
      {"tick", "1/240 s", "time of the trial"},
      {"shown_ns", "ns", "when the frame was shown, since the start of the run, by a clock that never jumps"},
      {"x_m", "m", "where the subject stands in the maze, to the east"},
      {"z_m", "m", "where the subject stands in the maze, to the south"},
      {"heading_rad", "rad", "where the subject looks, clockwise from north, seen from above"},
      {"pixel_hash", "", "hash of the image, hexadecimal, where it was read"},
      {"input_index", "", "number of the input in its trial, from 0"},
      {"came_ns", "ns", "when the input or sample came, since the start of the run, by a clock that never jumps"},
      {"kind", "", "key, text, pointer_move, pointer_button, scroll, resize, drop or close"},
      {"pressed", "", "1: pressed, or held and repeated; 0: released"},
      {"modifiers", "", "1 shift + 2 control + 4 alt"},
      {"x", "", "pointer_move: place from the left (px); scroll: steps to the right"},
      {"y", "", "pointer_move: place from the top (px); scroll: steps up"},
      {"more_json", "", "what other kinds of input tell (JSON)"},
      {"gaze_index", "", "number of the sample of gaze in its trial, from 0"},
      {"device_time", "", "when the eye tracker took the sample, by its clock, in its unit"},
      {"valid", "", "1: the eye tracker saw where the subject looks"},
      {"x_px", "px", "where the subject looks, from the left edge of the screen; empty where valid is 0"},
      {"y_px", "px", "where the subject looks, from the upper edge of the screen"},
      {"pupil", "", "size of the pupil, in the eye tracker's unit"},
  };
  return meanings;
}

ColumnMeaning measureMeaning(const std::string& name) {
  static const std::array<std::pair<const char*, const char*>, 7> units{
      {{"_m", "m"}, {"_s", "s"}, {"_ns", "ns"}, {"_px", "px"}, {"_deg", "degrees"}, {"_rad", "rad"}, {"_hz", "Hz"}}};
  ColumnMeaning meaning{name, "", "measure of the task's own: " + name};
  for (const auto& [ending, unit] : units) {
    if (name.ends_with(ending)) {
      meaning.unit = unit;
    }
  }
  return meaning;
}

}  // namespace ocelli
