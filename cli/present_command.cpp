// `ocelli present`: a scene, a recording or what a tracked eye sees, on a display.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <exception>
#include <functional>
#include <optional>

#include "cli/command.h"
#include "cli/display_wait.h"
#include "cli/emulated_display.h"
#include "cli/interrupt.h"
#include "cli/output_option.h"
#include "cli/present_choice.h"
#include "cli/scene_notes.h"
#include "cli/scene_options.h"
#include "cli/shown_output.h"
#include "cli/slicing_options.h"
#include "cli/values.h"
#include "cli/viewed_scene.h"
#include "cli/volume_slicing_options.h"
#include "display_driver/devices/device_kinds.h"
#include "display_driver/pacing/device_log_player.h"
#include "display_driver/pacing/eye_feed.h"
#include "display_driver/pacing/eyes_source.h"
#include "display_driver/pacing/motion_source.h"
#include "display_driver/pacing/moving_view.h"
#include "display_driver/pacing/pacer.h"
#include "display_driver/pacing/presentation_report.h"
#include "display_driver/pacing/recording_device.h"
#include "display_driver/pacing/recording_source.h"
#include "display_driver/pacing/series_moment.h"
#include "display_driver/pacing/still_source.h"
#include "display_driver/pacing/turning_source.h"
#include "display_driver/pacing/turning_volume_source.h"
#include "display_sim/frames/svol_file.h"
#include "display_sim/slicing/exact_slicer.h"
#include "display_sim/volume_slicing/transfer_blend.h"
#include "oc_core/base/error.h"
#include "oc_core/base/output_file.h"
#include "oc_core/ocri/union_mesh.h"
#include "oc_core/volume/transfer_file.h"
#include "oc_core/volume/transfer_presets.h"
#include "oc_core/worlds/packed_source.h"
#include "oc_core/worlds/scene_motion.h"
#ifdef OCELLI_WITH_OPENGL
#include "cli/present_quilt.h"
#include "display_driver/picture_device/picture_devices.h"
#endif

namespace ocelli {
namespace {

/// What is presented, and what it needs to stand.
struct Presented {
  std::optional<ViewedScene> scene;
  ShownSeries volumes;                   ///< of scalars
  std::unique_ptr<MovingImages> images;  ///< of an eye or a scene that moves
  std::unique_ptr<MovingView> view;      ///< of a scene that does
  std::unique_ptr<EyeFeed> feed;
  std::unique_ptr<VolumeSource> source;
  EyesSource* eyes = nullptr;
};

Volume sliceOnce(const Mesh& mesh, const DisplayProfile& profile, const SlicingChoice& choice) {
  const SliceOptions options = sliceOptionsOf(choice);
  return choice.exact || needsExactSlicer(options) ? sliceExactly(mesh, profile, options)
                                                   : slice(mesh, profile, options);
}

/// What is looked at, with what there is to say of it: of a packed scene, of its coarse shape.
void addViewedScene(Presented& presented, const PresentChoice& choice, const DisplayProfile& profile,
                    const CommandContext& context) {
  Mesh mesh = loadMeshToSlice(choice.scene, profile, false, context.progress());
  noteSlicedScene(context, mesh, profile);
  if (isPackedScene(choice.scene.source)) {
    presented.scene.emplace(choice.scene, context);
  } else {
    presented.scene.emplace(std::move(mesh));
  }
}

CameraChoice eyesCamera(const PresentChoice& choice) {
  const CameraChoice camera = cameraChoice(choice.hasCamera() ? choice.camera : "ddoc");
  if (!camera.hasImages()) {
    throw InputError("this camera has no image to build for an eye", camera.name, "--camera ddoc");
  }
  return camera;
}

EyesOptions eyesOptions(const PresentChoice& choice) {
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  return {.width = size.width,
          .height = size.height,
          .slicing = sliceOptionsOf(choice.slicing),
          .minImageScale = choice.minImageScale,
          .refreshesToMake = choice.refreshesToMake};
}

/// The scene, where it moves: nullptr otherwise.
std::unique_ptr<SceneMotion> motionOf(const PresentChoice& choice, const DisplayProfile& profile,
                                      const CommandContext& context) {
  if (!choice.mayPlay()) {
    return nullptr;
  }
  SceneOptions options = choice.scene.options;
  if (choice.isFolder() && !options.motion.meshesPerSecond) {
    options.motion.meshesPerSecond = profile.refreshHertz();
  }
  return loadMotion(choice.scene.source, options, context.progress());
}

/// As it moves, and where a camera looks at it, from an eye that stands still or moves, too.
void addMotionSource(Presented& presented, const PresentChoice& choice, std::unique_ptr<SceneMotion> motion,
                     const DisplayProfile& profile, const CommandContext& context) {
  refuseSlowSlicers(choice);
  const MotionPlayback playback{.speed = choice.speed, .loop = choice.loop};
  noteBlackScene(context, motion->at(0));
  if (choice.eyes.empty() && !choice.hasCamera()) {
    auto source = std::make_unique<MotionSource>(std::move(motion), profile, sliceOptionsOf(choice.slicing), playback);
    if (source->isCutOff()) {
      noteCutOffScene(context);
    }
    presented.source = std::move(source);
    return;
  }
  presented.images = std::make_unique<MovingImages>(eyesCamera(choice));
  EyesOptions options = eyesOptions(choice);
  const double fewestPixels = options.width * options.minImageScale * options.height * options.minImageScale;
  presented.view =
      std::make_unique<MovingView>(std::move(motion), *presented.images, playback, static_cast<size_t>(fewestPixels));
  if (choice.eyes.empty()) {
    presented.feed = std::make_unique<StandingEye>();
  } else {
    presented.feed = openEyeFeed(choice.eyes, choice.loop, eyePredictionFromName(choice.prediction, "--predict"));
  }
  options.moveScene = [&view = *presented.view](HostTime seen) { return view.moveTo(seen); };
  auto source = std::make_unique<EyesSource>(
      [&view = *presented.view, &moving = *presented.images](const PinholeCamera& reference) {
        ReferenceImages images = view.imagesFrom(reference);
        return EyesSource::Made(std::move(images), moving.lastBeganCold());
      },
      profile, options, *presented.feed);
  presented.eyes = source.get();
  presented.source = std::move(source);
}

/// The transfer function of a volume that turns into another one and back, where it does.
std::optional<TransferSwing> transferSwing(const PresentChoice& choice, const VolumeScene& scene,
                                           const CommandContext& context) {
  if (choice.transferTo.empty()) {
    return std::nullopt;
  }
  const VolumeAppearance later = appearanceOf(transferByName(choice.transferTo), *scene.volume, scene.voxelSpacing());
  if (!isSameOnDisplay(scene.appearance.shading, later.shading)) {
    context.note(
        fmt::format("warning: the shading of \"{}\" does not count: what is shown keeps the shading that it has",
                    choice.transferTo));
  }
  return TransferSwing(scene.appearance.transfer, later.transfer, choice.transferSeconds);
}

/// A volume of scalars, straight from its field.
void addScalarVolume(Presented& presented, const PresentChoice& choice, const DisplayProfile& profile,
                     const CommandContext& context) {
  const SliceOptions options = volumeSliceOptionsOf(choice.slicing);
  presented.volumes =
      loadShownSeries({choice.scene, choice.volume, choice.volumeSlicing, choice.transferTo}, profile, context);
  const ShownSeries& series = presented.volumes;
  const bool moves = !series.times.empty();
  if (moves) {
    refuseSlowSlicers(choice);
  } else {
    refuseOptionsOfMotion(choice);
  }
  if (!moves && !choice.turn && choice.transferTo.empty()) {
    VolumeSlicer slicer(profile, options);
    slicer.slice(series.volumes.front()->samples(), series.volumes.front()->light());
    presented.source = std::make_unique<StillSource>(slicer.takeVolume());
    return;
  }
  std::vector<std::shared_ptr<const SweptLight>> lights;
  for (const std::unique_ptr<ShownVolume>& volume : series.volumes) {
    lights.push_back(std::make_shared<const SweptLight>(volume->light()));
  }
  const std::optional<TransferSwing> swing = transferSwing(choice, series.volumes.front()->scene(), context);
  const MotionPlayback playback{.speed = choice.speed, .loop = choice.loop};
  presented.source = std::make_unique<TurningVolumeSource>(
      [&series, playback, lights, swing](double seconds) -> std::optional<VolumeMoment> {
        const std::optional<size_t> moment = seriesMoment(series.times, seconds, playback);
        if (!moment) {
          return std::nullopt;
        }
        const ShownVolume& volume = *series.volumes[*moment];
        return VolumeMoment{
            &volume.samples(),
            swing ? std::make_shared<const SweptLight>(volume.lightOf(swing->at(seconds))) : lights[*moment]};
      },
      profile, options, choice.turn.value_or(0));
}

void addSceneSource(Presented& presented, const PresentChoice& choice, const DisplayProfile& profile,
                    const CommandContext& context) {
  if (choice.isVolume()) {
    addScalarVolume(presented, choice, profile, context);
    return;
  }
  if (std::unique_ptr<SceneMotion> motion = motionOf(choice, profile, context)) {
    addMotionSource(presented, choice, std::move(motion), profile, context);
    return;
  }
  refuseOptionsOfMotion(choice);
  const SliceOptions options = sliceOptionsOf(choice.slicing);
  const ImageSize size = imageSizeFromText(choice.size, "--size");
  if (!choice.eyes.empty()) {
    const CameraChoice camera = eyesCamera(choice);
    addViewedScene(presented, choice, profile, context);
    presented.feed = openEyeFeed(choice.eyes, choice.loop, eyePredictionFromName(choice.prediction, "--predict"));
    presented.images = std::make_unique<MovingImages>(camera);
    auto source = std::make_unique<EyesSource>(
        [&scene = *presented.scene, &moving = *presented.images](const PinholeCamera& reference) {
          ReferenceImages images = moving.next(reference, scene.meshFor(moving.choice(), reference));
          return EyesSource::Made(std::move(images), moving.lastBeganCold());
        },
        profile, eyesOptions(choice), *presented.feed);
    presented.eyes = source.get();
    presented.source = std::move(source);
    return;
  }
  if (!choice.turn && choice.hasCamera()) {
    const CameraChoice camera = cameraChoice(choice.camera);
    const PinholeCamera reference(View{}, size.width, size.height);
    addViewedScene(presented, choice, profile, context);
    const Mesh& scene = presented.scene->meshFor(camera, reference);
    const Mesh seen = unionMesh(buildReferenceImages(camera, reference, scene, context.progress()));
    presented.source = std::make_unique<StillSource>(sliceOnce(seen, profile, choice.slicing));
    return;
  }
  const Mesh mesh = loadMeshToSlice(choice.scene, profile, choice.slicing.exact, context.progress());
  noteSlicedScene(context, mesh, profile);
  if (choice.turn) {
    presented.source = std::make_unique<TurningSource>(orderedForSlicing(mesh), profile, options, *choice.turn);
  } else {
    presented.source = std::make_unique<StillSource>(sliceOnce(mesh, profile, choice.slicing));
  }
}

class TimeLineFile {
 public:
  explicit TimeLineFile(const std::string& path) {
    if (!path.empty()) {
      file_.emplace(path);
      file_->write(timeLineHeader());
    }
  }
  void add(const RefreshRecord& record, HostTime start) {
    if (file_) {
      file_->write(timeLineRow(record, start));
    }
  }
  void finish() {
    if (file_) {
      file_->commit();
    }
  }

 private:
  std::optional<OutputFile> file_;
};

PresentationReport present(Device& device, Presented& presented, const PresentChoice& choice,
                           const CommandContext& context) {
  TimeLineFile file(choice.timeLine);
  TimeLine soFar;
  const auto interrupted = [] { return InterruptGuard::interrupted(); };
  const InterruptGuard guard;
  PresentationReport result;
  DisplayWait display(device, context);
  const HostTime begin = realClock().now();
  if (!display.untilThere(choice.seconds, interrupted)) {
    result.absent = true;
  } else {
    const HostTime start = realClock().now();
    std::optional<double> seconds = choice.seconds;
    if (seconds) {
      // Waiting counts.
      *seconds = std::max(0.0, *seconds - std::chrono::duration<double>(start - begin).count());
    }
    const Progress progress = context.progress();
    bool malformedTold = false;
    Pacer pacer(device, *presented.source, realClock(),
                {.seconds = seconds, .tearWhenLate = choice.tear, .coarseWhenLate = choice.coarse});
    result.summary = pacer.run(interrupted, [&](const RefreshRecord& record) {
      file.add(record, start);
      soFar.add(record);
      if (choice.follow && isMiss(record.outcome)) {
        context.note(missText(record, start));
      }
      if (presented.feed != nullptr && presented.feed->malformed() > 0 && !malformedTold) {
        malformedTold = true;
        context.note(presented.feed->firstMalformed() + "\n  more of them are only counted");
      }
      constexpr uint64_t kRefreshesBetween = 6;
      if (soFar.refreshes() % kRefreshesBetween == 0 && display.look() && progress) {
        const double passed = std::chrono::duration<double>(record.due - start).count();
        progress(statusText(soFar.refreshes(), soFar.misses()), seconds && *seconds > 0 ? passed / *seconds : 0);
      }
    });
  }
  file.finish();
  result.interrupted = InterruptGuard::interrupted();
  result.device = device.info();
  result.profile = device.profile().name;
  result.telemetry = device.telemetry();
  if (presented.eyes != nullptr) {
    result.stages = presented.eyes->stages();
    result.eyesLeftOut = presented.eyes->eyesLeftOut();
    result.malformedEyes = presented.feed->malformed();
    result.firstMalformedEye = presented.feed->firstMalformed();
    if (presented.images->remembers()) {
      result.starts = presented.images->starts();
    }
    result.prediction = presented.feed->predictionErrors();
  }
  return result;
}

/// The device, and what hears of what it shows where it is the simulated one.
struct Opened {
  std::unique_ptr<ShownOutput> shown;
  std::unique_ptr<Device> device;

  /// All of it. What failed first, or nullptr.
  std::exception_ptr close(const CommandContext& context) {
    std::exception_ptr failure;
    const auto attempt = [&](const std::function<void()>& work) {
      try {
        work();
      } catch (...) {
        failure = failure ? failure : std::current_exception();
      }
    };
    attempt([&] { device->close(); });
    device.reset();
    attempt([&] { shown->finish(context); });
    return failure;
  }
};

void rethrow(const std::exception_ptr& failure) {
  if (failure) {
    std::rethrow_exception(failure);
  }
}

/// Devices that have no display of their own show any profile, and this one where none is asked for.
constexpr const char* kUsualProfile = "perspecta";

bool takesAnyProfile(const std::string& device) {
  return device == "sim" || device == "null" || device.starts_with("file:");
}

Opened openFor(const PresentChoice& choice, DeviceOptions options, const CommandContext& context) {
  const DisplayProfile simulated = options.profile ? *options.profile : loadProfile(kUsualProfile);
  Opened opened{std::make_unique<ShownOutput>(choice.shown, simulated), nullptr};
  if (choice.device == "sim") {
    options.profile = simulated;
    options.sim.emplace();
    options.sim->display = emulatedDisplay(choice.simulated, "unlimited");
    options.sim->sink = opened.shown->sink();
  }
  opened.device = openDevice(choice.device, options);
  if (options.profile && *options.profile != opened.device->profile()) {
    throw InputError(fmt::format("this is made for the display {}, the device is a {}", options.profile->name,
                                 opened.device->profile().name),
                     choice.profile.empty() ? choice.scene.source : "--profile", "slice the scene for that display");
  }
  if (!choice.record.empty()) {
    opened.device = recordDeviceLog(std::move(opened.device), choice.record,
                                    [&context](const std::string& what) { context.note(what); });
  }
  return opened;
}

/// Throws WorkError where nothing could be seen.
void requireShown(const PresentationReport& report, const Presented& presented, const PresentChoice& choice) {
  if (report.interrupted || choice.seconds == 0.0) {
    return;
  }
  if (presented.eyes != nullptr && !presented.eyes->eyeCame()) {
    throw WorkError("no eye ever came", "--eyes " + choice.eyes, "send lines TIME,X,Y,Z: 0,0,0.2,9.8");
  }
  requireFrames(report, choice.device);
}

/// Until what is missing is told.
constexpr double kLogWaitSeconds = 0.5;

void runDeviceLog(const PresentChoice& choice, const CommandContext& context) {
  DeviceLogReader reader(choice.scene.source);
  DeviceOptions options;
  options.profile = reader.profile();
  Opened opened = openFor(choice, options, context);
  DeviceLogPlayed played;
  bool interrupted = false;
  {
    const InterruptGuard guard;
    // Frames come at their own times, display or not.
    DisplayWait(*opened.device, context).untilThere(kLogWaitSeconds, [] { return InterruptGuard::interrupted(); });
    played = playDeviceLog(reader, *opened.device, realClock(), {.fast = choice.fast},
                           [] { return InterruptGuard::interrupted(); });
    interrupted = InterruptGuard::interrupted();
  }
  const std::exception_ptr failure = opened.close(context);
  played.countEnded();
  context.print(choice.json ? reportJson(played) : reportText(played));
  rethrow(failure);
  if (interrupted) {
    return;
  }
  if (reader.damage()) {
    throw InputError(*reader.damage());
  }
  if (reader.ending() == RecordingEnding::kUnfinished) {
    if (played.submitted == 0) {
      throw InputError("this log was cut short before its first frame", choice.scene.source, "record it again");
    }
    context.note("the recording was cut short");
  }
  if (played.presented > 0 && played.shown == 0) {
    throw WorkError("no frame was ever shown", choice.device,
                    "see with ocelli device info whether the display is there");
  }
}

void addSource(Presented& presented, const PresentChoice& choice, const DisplayProfile& profile,
               const CommandContext& context) {
  if (choice.isScene()) {
    addSceneSource(presented, choice, profile, context);
  }
}

void run(const PresentChoice& choice, [[maybe_unused]] const CLI::App& command, const CommandContext& context) {
#ifdef OCELLI_WITH_OPENGL
  if (isPictureDevice(choice.device)) {
    presentQuilt(choice, command, context);
    return;
  }
#endif
  checkPresentChoice(choice);
  checkSecondOutput(choice.record, "--record", choice.scene.source);
  if (choice.isDeviceLog()) {
    runDeviceLog(choice, context);
    return;
  }
  checkSecondOutput(choice.timeLine, "--timeline", choice.record);
  Presented presented;
  DeviceOptions options;
  if (choice.isRecording()) {
    auto source = std::make_unique<RecordingSource>(choice.scene.source, choice.loop);
    options.profile = source->profile();
    if (source->frames() == 1) {
      noteDarkVolume(context, readSvol(choice.scene.source));
    }
    presented.source = std::move(source);
  } else if (!choice.profile.empty()) {
    options.profile = loadProfile(choice.profile);
  }
  // Where the profile is known the source is there before the device: a scene that cannot be read leaves no trace, and
  // nothing is dark while it is sliced.
  const bool sourceFirst = takesAnyProfile(choice.device);
  if (sourceFirst) {
    options.profile = options.profile ? options.profile : loadProfile(kUsualProfile);
    checkShownOptions(choice.shown, *options.profile);
    addSource(presented, choice, *options.profile, context);
  }
  Opened opened = openFor(choice, options, context);
  if (!sourceFirst) {
    addSource(presented, choice, opened.device->profile(), context);
  }
  const PresentationReport result = present(*opened.device, presented, choice, context);
  const std::exception_ptr failure = opened.close(context);
  if (result.eyesLeftOut > 0) {
    context.note(fmt::format("{} eyes were left out: {}", result.eyesLeftOut, presented.eyes->firstLeftOut()));
  }
  context.print(choice.json ? reportJson(result) : reportText(result));
  rethrow(failure);
  requireShown(result, presented, choice);
}

}  // namespace

void addPresentCommand(CLI::App& program, const CommandContext& context) {
  CLI::App& command = *program.add_subcommand("present", "Show a scene or a volume on a display, in time with it");
  const auto choice = std::make_shared<PresentChoice>();
  addPresentOptions(command, *choice, context);
  context.finish(command,
                 "  ocelli present builtin:teapot --device sim --seconds 5 --watch seen.mp4\n"
                 "  ocelli present turning.svol --device usb --loop\n"
                 "  ocelli present bunny.obj --device null --follow --turn 30 --seconds 10 --timeline misses.csv\n"
                 "  ocelli present builtin:statues --device file:seen.svol --eyes udp:5005 --camera ddoc\n"
                 "  ocelli present builtin:statues --device quilt:portrait,monitor=1,calibration=visual.json",
                 [choice, context, &command] { run(*choice, command, context); });
}

}  // namespace ocelli
