// Editing a transfer function: points, steps that are undone, what is saved; and its pane's axis of values.
#include "display_sim/viewer/transfer_editor.h"

#include <gmock/gmock.h>

#include <glm/geometric.hpp>

#include "display_sim/viewer/transfer_overlays.h"
#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/volume/transfer_presets.h"
#include "tests/base/temporary_folder.h"
#include "tests/viewer/transfer_state.h"

namespace ocelli {
namespace {

using test::eightVoxels;
using test::transferState;

TransferEditor threePoints() {
  return TransferEditor(eightVoxels().scene.appearance);
}

std::vector<double> valuesOf(const TransferEditor& editor) {
  std::vector<double> values;
  for (const TransferPoint& point : editor.points()) {
    values.push_back(point.value);
  }
  return values;
}

TEST(TransferEditor, pointsStayInOrderAndOpacitiesWithinTheirLimits) {
  TransferEditor editor = threePoints();
  editor.movePoint(1, 70, 0.25);
  EXPECT_THAT(valuesOf(editor), testing::ElementsAre(0, 70, 100));
  EXPECT_EQ(editor.points()[1].opacity, 0.25);
  editor.movePoint(1, 300, 7);
  EXPECT_THAT(valuesOf(editor), testing::ElementsAre(0, 100, 100)) << "as far as its neighbour";
  EXPECT_EQ(editor.points()[1].opacity, 1);
  editor.movePoint(1, -300, -7);
  EXPECT_THAT(valuesOf(editor), testing::ElementsAre(0, 0, 100));
  EXPECT_EQ(editor.points()[1].opacity, 0);
  editor.movePoint(2, 1e300, 1);
  EXPECT_EQ(editor.points()[2].value, TransferDescription::kMaxValue);
}

TEST(TransferEditor, aNewPointLiesOnTheColoursOfTheOthers) {
  TransferEditor editor = threePoints();
  editor.addPoint(25, 0.9);
  EXPECT_THAT(valuesOf(editor), testing::ElementsAre(0, 25, 50, 100));
  EXPECT_EQ(editor.chosen(), 1U);
  EXPECT_EQ(editor.points()[1].color, glm::dvec3(0, 0.5, 0.5));
  EXPECT_EQ(editor.points()[1].opacity, 0.9);
  editor.addBeside(2);
  EXPECT_EQ(editor.points()[3].value, 75);
  EXPECT_EQ(editor.points()[3].opacity, 0.75);
  editor.addBeside(4);
  EXPECT_EQ(editor.points()[4].value, 87.5) << "before the last one";
}

TEST(TransferEditor, aPointBesideAnotherLeavesTheCurveAsItIs) {
  VolumeAppearance appearance = eightVoxels().scene.appearance;
  appearance.transfer = TransferFunction({{100, {1, 0, 0}, 0}, {100, {0, 0, 1}, 1}, {200, {0, 1, 0}, 1}}, 1);
  for (const size_t point : {0U, 1U, 2U}) {
    TransferEditor editor(appearance);
    ASSERT_TRUE(editor.addBeside(point));
    EXPECT_EQ(editor.points().size(), 4U);
    for (double value = 90; value < 210; value += 2.5) {
      const OpticalSample before = appearance.transfer.at(value);
      const OpticalSample after = editor.appearance()->transfer.at(value);
      // Rounding of opacities up to 0.9999, 10,000 times as large in the logarithm of what is left.
      EXPECT_NEAR(after.extinction, before.extinction, 1e-11) << point << " at " << value;
      EXPECT_LT(glm::distance(after.color, before.color), 1e-14) << point << " at " << value;
    }
  }
  TransferEditor editor(appearance);
  editor.addBeside(0);
  EXPECT_EQ(editor.chosen(), 1U);
  EXPECT_EQ(editor.points()[1].value, 100);
  EXPECT_EQ(editor.points()[1].opacity, 0.5) << "halfway up the step";
  EXPECT_EQ(editor.points()[1].color, glm::dvec3(0.5, 0, 0.5));
}

TEST(TransferEditor, oneIsLeftAndNoMoreThanAFileTakesAreAdded) {
  TransferEditor editor = threePoints();
  EXPECT_TRUE(editor.removePoint(1));
  EXPECT_EQ(editor.chosen(), 1U);
  EXPECT_TRUE(editor.removePoint(1));
  EXPECT_EQ(editor.chosen(), 0U);
  EXPECT_FALSE(editor.removePoint(0));
  EXPECT_THAT(valuesOf(editor), testing::ElementsAre(0));
  EXPECT_TRUE(editor.addBeside(0)) << "beside the only one";
  while (editor.points().size() < TransferDescription::kMaxPoints) {
    ASSERT_TRUE(editor.addPoint(static_cast<double>(editor.points().size()), 0));
  }
  EXPECT_FALSE(editor.addPoint(5, 0));
  EXPECT_EQ(editor.points().size(), TransferDescription::kMaxPoints);
}

TEST(TransferEditor, aDragIsOneStepAndOtherEditsAreTheirOwn) {
  TransferEditor editor = threePoints();
  const auto start = editor.appearance();
  for (int i = 1; i <= 10; ++i) {
    editor.movePoint(1, 50 + i, 0.5);
  }
  editor.endStep();
  const auto dragged = editor.appearance();
  editor.movePoint(1, 80, 0.5);
  editor.colorPoint(1, {1, 1, 1});
  editor.setOpacityLength(3);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.appearance()->transfer.opacityLength(), 1);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.points()[1].color, glm::dvec3(0, 1, 0));
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.appearance(), dragged);
  EXPECT_TRUE(editor.undo());
  EXPECT_EQ(editor.appearance(), start);
  EXPECT_FALSE(editor.undo());
  EXPECT_TRUE(editor.redo());
  EXPECT_EQ(editor.appearance(), dragged);
  editor.setShading({.isOn = true});
  EXPECT_FALSE(editor.redo()) << "there is another future now";
}

TEST(TransferEditor, onlySoManyStepsAreKept) {
  TransferEditor editor = threePoints();
  for (size_t i = 0; i < TransferEditor::kMaxSteps + 5; ++i) {
    editor.movePoint(1, 50 + 0.01 * static_cast<double>(i), 0.5);
    editor.endStep();
  }
  size_t undone = 0;
  while (editor.undo()) {
    ++undone;
  }
  EXPECT_EQ(undone, TransferEditor::kMaxSteps);
}

TEST(TransferEditor, itIsSavedWhereItIsWhatWasSaved) {
  TransferEditor editor = threePoints();
  EXPECT_TRUE(editor.isSaved());
  editor.movePoint(1, 60, 0.5);
  EXPECT_FALSE(editor.isSaved());
  editor.undo();
  EXPECT_TRUE(editor.isSaved()) << "back to where it began";
  editor.redo();
  editor.markSaved();
  editor.undo();
  EXPECT_FALSE(editor.isSaved());
  editor.replace(eightVoxels().scene.appearance, true);
  EXPECT_TRUE(editor.isSaved());
}

TEST(TransferEditor, warnsOnceOfEachEditThatWouldBeLost) {
  TransferEditor editor = threePoints();
  EXPECT_FALSE(editor.warnsOfLoss());
  editor.movePoint(1, 60, 0.5);
  EXPECT_TRUE(editor.warnsOfLoss());
  EXPECT_FALSE(editor.warnsOfLoss()) << "it has been said";
  editor.markSaved();
  EXPECT_FALSE(editor.warnsOfLoss());
  editor.movePoint(1, 70, 0.5);
  EXPECT_TRUE(editor.warnsOfLoss()) << "saved since, and edited again";
  editor.movePoint(1, 80, 0.5);
  EXPECT_TRUE(editor.warnsOfLoss()) << "edited after it was said";
}

TEST(TransferChoice, whatIsSavedIsReadBackAndPresetsAreChosenByName) {
  const test::TemporaryFolder folder;
  ViewerState state = transferState();
  const LoadedVolume volume = eightVoxels();
  state.volume.transfer->movePoint(1, 30, 0.125);
  const auto path = folder.path() / "mine.json";
  writeFile(path, transferFileText(state));
  chooseTransfer(state, &volume, transferPresets().front().name);
  EXPECT_NE(state.volume.transfer->points().size() == 3 && state.volume.transfer->points()[1].value == 30, true);
  chooseTransfer(state, &volume, path.string());
  ASSERT_EQ(state.volume.transfer->points().size(), 3U);
  EXPECT_EQ(state.volume.transfer->points()[1].value, 30);
  EXPECT_EQ(state.volume.transfer->points()[1].opacity, 0.125);
  EXPECT_TRUE(state.volume.transfer->isSaved());
  EXPECT_THROW(chooseTransfer(state, &volume, "no-such-preset"), InputError);
  EXPECT_EQ(state.volume.transfer->points()[1].value, 30) << "stays as it was";
  EXPECT_THROW(chooseTransfer(state, nullptr, path.string()), InputError);
  EXPECT_THROW(transferFileText(viewerState("builtin:teapot", {}, cameraChoice("di"), View{}, 64, 48, "test")),
               InputError);
}

TEST(TransferChoice, theAxisHoldsTheVolumeAndThePoints) {
  ViewerState state = transferState();
  EXPECT_EQ(state.volume.axis, (ValueAxis{0, 100}));
  LoadedVolume volume = eightVoxels();
  volume.scene.appearance.transfer = TransferFunction({{-1000, {}, 0}, {20, {}, 1}}, 1);
  takeVolume(state, volume);
  EXPECT_EQ(state.volume.axis, (ValueAxis{-1000, 100}));
}

TEST(ValueAxis, zoomsAroundAValueAndStaysWithinTheWhole) {
  const ValueAxis whole{0, 100};
  const ValueAxis axis = zoomedAxis(whole, whole, 25, 2);
  EXPECT_EQ(axis, (ValueAxis{12.5, 62.5}));
  EXPECT_EQ(axis.shareOf(25), 0.25) << "where it was";
  EXPECT_EQ(zoomedAxis(axis, whole, 0, 0.5), whole);
  EXPECT_EQ(pannedAxis(axis, whole, -10), (ValueAxis{0, 50}));
  EXPECT_EQ(pannedAxis(axis, whole, 10), (ValueAxis{50, 100}));
  EXPECT_NEAR(zoomedAxis(whole, whole, 50, 1e30).width(), 100 * kMinAxisShare, 1e-9);
  EXPECT_GT(axisBetween(7, 7).width(), 0);
}

TEST(ValueAxis, ticksAreRoundNumbers) {
  EXPECT_EQ(tickStep({0, 100}, 5), 20);
  EXPECT_EQ(tickStep({-1024, 3071}, 8), 1000);
  EXPECT_EQ(tickStep({0, 1}, 10), 0.1);
  EXPECT_EQ(tickStep({0, 0.009}, 3), 0.005);
}

TEST(TransferPlot, barsAreLogarithmsAndFollowTheAxis) {
  VolumeHistogram histogram;
  histogram.bounds = {0, 4};
  histogram.counts = {99, 0, 9, 0};
  const std::vector<float> bars = histogramBars(histogram, {0, 4}, 4);
  EXPECT_FLOAT_EQ(bars[0], 1);
  EXPECT_FLOAT_EQ(bars[1], 0);
  EXPECT_FLOAT_EQ(bars[2], 0.5f) << "log 10 of log 100";
  EXPECT_FLOAT_EQ(bars[3], 0);
  EXPECT_THAT(histogramBars(histogram, {-4, 4}, 4), testing::ElementsAre(0, 0, 1, testing::FloatEq(0.5f)))
      << "nothing beyond the volume's values; the greatest of each part";
  EXPECT_THAT(histogramBars(histogram, {2.25, 2.75}, 2), testing::Each(testing::FloatEq(0.5f))) << "within one bin";
  histogram.counts = {0, 0, 0, 0};
  EXPECT_THAT(histogramBars(histogram, {0, 4}, 4), testing::Each(0.0f));
}

TEST(VolumeShown, clipPlanesKeepTheirPartOfTheBox) {
  Box box;
  box.lower = {-1, -2, 0};
  box.upper = {1, 2, 1};
  EXPECT_TRUE(clipPlanesOf(VolumeShown{}.kept, box).empty());
  const std::vector<ClipPlane> planes = clipPlanesOf({{{0.25, 1}, {0, 0.5}, {0, 1}}}, box);
  ASSERT_EQ(planes.size(), 2U);
  EXPECT_EQ(planes[0].normal, glm::dvec3(1, 0, 0));
  EXPECT_EQ(planes[0].distance, -0.5);
  EXPECT_EQ(planes[1].normal, glm::dvec3(0, -1, 0)) << "y <= 0";
  EXPECT_EQ(planes[1].distance, 0);
}

}  // namespace
}  // namespace ocelli
