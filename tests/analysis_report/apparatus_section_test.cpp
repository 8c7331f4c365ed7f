// What the report says of screens and timing, and what it says it does not know.
#include "analysis/report/apparatus_section.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/analysis_report/section_study.h"

namespace ocelli::test {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kEnvironment =
    R"({"graphics": {"renderer": "GeForce"}, "monitor": {"name": "U24", "width": 1920, "height": 1200, "refresh_hertz": 60,
        "width_millimeters": 518, "height_millimeters": 324}, "not_measured": ["latency of mouse and keyboard"]})";

Run runOf(const std::string& subject, int session, const std::string& environment, const std::string& check) {
  Run run;
  run.subject = subject;
  run.session = session;
  run.station = "lab 1";
  run.environment = environment;
  run.timingCheck = check;
  return run;
}

class ApparatusSection : public testing::Test {
 protected:
  ApparatusSection() {
    study_.analysis.data.sources[0].protocolText =
        R"({"name": "made", "screen": {"distance_millimeters": 600, "width_millimeters": 518, "height_millimeters": 324},
            "timing": {"late_factor": 1.5}})";
  }
  void addTrial(const std::string& subject, int session, int64_t frames, int64_t dropped, const std::string& verdict) {
    Trial& trial = study_.add(subject, session, TrialView::kReference, 10);
    trial.frames = frames;
    trial.droppedFrames = dropped;
    trial.timingVerdict = wordNamed(verdict, kTimingVerdicts);
  }
  ReportDocument document() const { return documentOf(study_.analysis, addApparatus); }
  static std::string factOf(const ReportDocument& document, const std::string& term) {
    for (const ReportElement& element : document.elements) {
      if (const auto* facts = std::get_if<ReportFacts>(&element)) {
        for (const ReportFacts::Fact& fact : facts->facts) {
          if (fact.term == term) {
            return fact.text;
          }
        }
      }
    }
    return "no such fact";
  }

  SectionStudy study_;
};

TEST_F(ApparatusSection, tellsScreensDistanceAndDroppedFrames) {
  const std::string good = R"({"verdict": "good", "measured": {"hertz": 59.95, "jitter_share": 0.004}})";
  study_.analysis.data.runs = {runOf("S1", 1, kEnvironment, good), runOf("S2", 1, kEnvironment, good),
                               runOf("S3", 1, kEnvironment, R"({"verdict": "refused"})")};
  addTrial("S1", 1, 1000, 10, "dropped_frames");
  addTrial("S1", 1, 1000, 0, "good");
  addTrial("S2", 1, 2000, 0, "good");
  const ReportDocument report = document();
  EXPECT_EQ(factOf(report, "Viewing distance"), "600 mm, as the protocol asks");
  EXPECT_EQ(factOf(report, "Timing check before"), "good 2 (runs); intervals between frames scatter by at most 0.40 %")
      << "S3 has no analysed trial";
  EXPECT_EQ(factOf(report, "Timing of trials"), "good 2, dropped frames 1 (trials)");
  EXPECT_EQ(factOf(report, "Dropped frames"),
            "0.25 % of 4000 frames: intervals longer than 1.5 times that of the screen");
  EXPECT_THAT(factOf(report, "Not measured"), HasSubstr("latency of mouse and keyboard"));
  EXPECT_EQ(cellText(report, "screens", "U24", "Resolution (px)"), "1920 x 1200");
  EXPECT_EQ(cellText(report, "screens", "U24", "Size (mm)"), "518 x 324");
  EXPECT_EQ(cellText(report, "screens", "U24", "Measured (Hz)"), "59.95");
  // 1920 / 518 px/mm at 600 mm: a degree is 10.47 mm.
  EXPECT_EQ(cellText(report, "screens", "U24", "px per degree"), "38.8");
  EXPECT_EQ(cellText(report, "screens", "U24", "Sessions"), "2");
  EXPECT_EQ(cellValue(report, "dropped-frames", "1", "Dropped"), 10.0 / 4000);
  EXPECT_EQ(cellValue(report, "dropped-frames", "1", "Median of subjects"), 0.0025);
  EXPECT_EQ(cellValue(report, "dropped-frames", "1", "Most of a subject"), 0.005);
  EXPECT_EQ(cellText(report, "dropped-frames-by-subject", "S2", "Check before"), "good") << "in the supplement";
}

TEST_F(ApparatusSection, saysWhatIsNotKnown) {
  study_.analysis.data.sources[0].protocolText = "";
  study_.analysis.data.runs = {runOf("S1", 1, "{}", "no JSON")};
  addTrial("S1", 1, 0, 0, "");
  const ReportDocument report = document();
  EXPECT_EQ(factOf(report, "Viewing distance"), "not known");
  EXPECT_EQ(factOf(report, "Dropped frames"), "not known: no frames were logged");
  EXPECT_EQ(factOf(report, "Timing check before"), "not known 1 (runs)");
  EXPECT_THAT(factOf(report, "Not measured"), HasSubstr("size of some screens"));
  EXPECT_EQ(cellText(report, "screens", "not known", "px per degree"), "not known");
  EXPECT_EQ(cellText(report, "dropped-frames", "1", "Dropped"), "not known");
}

TEST_F(ApparatusSection, saysThatSessionsWereForced) {
  study_.analysis.data.runs = {runOf("S1", 1, kEnvironment, R"({"verdict": "refused"})")};
  study_.analysis.data.runs[0].forced = true;
  addTrial("S1", 1, 100, 0, "good");
  EXPECT_THAT(factOf(document(), "Timing check before"), HasSubstr("1 runs were started although it refused"));
}

TEST_F(ApparatusSection, simulatedSubjectsHadNoScreen) {
  study_.analysis.data.runs = {
      runOf("S1", 1, R"({"simulated": true, "not_measured": ["screen"]})", R"({"verdict": "simulated_clock"})")};
  addTrial("S1", 1, 100, 0, "simulated_clock");
  const ReportDocument report = document();
  EXPECT_EQ(cellText(report, "screens", "none: simulated", "Sessions"), "1");
  EXPECT_THAT(factOf(report, "Not measured"), Not(HasSubstr("size of some screens")));
}

TEST_F(ApparatusSection, nobodyIsNoCrash) {
  const ReportDocument report = document();
  EXPECT_EQ(factOf(report, "Timing of trials"), "no trials");
  EXPECT_THAT(factOf(report, "Not measured"), HasSubstr("the data hold no runs"));
}

}  // namespace
}  // namespace ocelli::test
