#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "oc_core/base/error.h"
#include "oc_core/base/json_fields.h"
#include "oc_core/constructor/camera_fields.h"
#include "oc_core/explore/explore_steps.h"

namespace ocelli {
namespace {

constexpr double kMaxWay = 10'000;  // metres of one step
constexpr double kMaxTurn = 3600;   // degrees
constexpr int kMaxTurnFrames = 100'000;
constexpr int kRestFrames = 600;  // until everything must have come to rest

/// Whole frames that last so long; the least share of a whole frame more counts as none.
int framesFor(double seconds) {
  return static_cast<int>(std::ceil(seconds * kExploreFramesPerSecond - 1e-9));
}

ExploreStep readWalk(JsonFields& fields) {
  JsonFields inner = fields.inner("walk");
  const double forward = inner.number("forward", -kMaxWay, kMaxWay, 0);
  const double right = inner.number("right", -kMaxWay, kMaxWay, 0);
  const double up = inner.number("up", -kMaxWay, kMaxWay, 0);
  const bool fast = inner.boolean("fast", false);
  inner.rejectUnknown();
  return [=](ExploreSession& session) {
    const WalkerOptions& walker = session.explorer().walker().options();
    const double speed = walker.speed * (fast ? walker.fastFactor : 1);
    const double way = std::max({std::abs(forward), std::abs(right), std::abs(up)});
    const int frames = framesFor(way / speed);
    if (frames == 0) {
      return;
    }
    if (frames > framesFor(kMaxExploreSeconds)) {
      throw InputError(
          fmt::format("the walk takes {:.0f} minutes, and may take {:.0f}", way / speed / 60, kMaxExploreSeconds / 60),
          "", "make several steps of it, walk fast, or give a greater --speed");
    }
    // The last frame ends where it should, so all are a little shorter.
    const double share = kExploreFramesPerSecond / (speed * frames);
    WalkInput input;
    input.forward = forward * share;
    input.right = right * share;
    input.up = up * share;
    input.fast = fast;
    for (int i = 0; i < frames; ++i) {
      session.showFrame(input);
    }
  };
}

/// At the full speed, as a pressed key turns; the last frame turns by what is left.
ExploreStep readTurn(JsonFields& fields, const std::string& name, double WalkInput::*part) {
  const double degrees = fields.number(name, -kMaxTurn, kMaxTurn);
  return [=](ExploreSession& session) {
    double left = degrees;
    for (int i = 0; i < kMaxTurnFrames && std::abs(left) > 1e-9; ++i) {
      // The speed may change as cameras deploy.
      const double speed = session.explorer().turnDegrees();
      WalkInput input;
      input.*part = std::clamp(left * kExploreFramesPerSecond / speed, -1.0, 1.0);
      left -= input.*part * speed / kExploreFramesPerSecond;
      session.showFrame(input);
    }
  };
}

ExploreStep readGo(JsonFields& fields) {
  JsonFields inner = fields.inner("go");
  const bool hasPlace = inner.has("to");
  const glm::dvec3 to = hasPlace ? readVector(inner, "to") : glm::dvec3(0);
  const bool turns = inner.has("heading");
  const double heading = inner.number("heading", -kMaxTurn, kMaxTurn, 0);
  const double pitch = inner.number("pitch", -89, 89, 0);
  const bool glides = inner.boolean("glide", false);
  inner.rejectUnknown();
  return [=](ExploreSession& session) {
    Explorer& explorer = session.explorer();
    WalkerView view = explorer.walker().view();
    view.eye = hasPlace ? to : view.eye;
    view.headingDegrees = turns ? heading : view.headingDegrees;
    view.pitchDegrees = pitch;
    if (glides) {
      explorer.glideTo(view);
    } else {
      explorer.jumpTo(view);
    }
    session.showFrame({});
  };
}

ExploreStep readWait(JsonFields& fields) {
  fields.choice("wait", {"rest"});
  return [](ExploreSession& session) {
    session.showFrame({});
    for (int i = 0; i < kRestFrames && !session.explorer().atRest(); ++i) {
      session.showFrame({});
    }
    if (!session.explorer().atRest()) {
      throw InputError(fmt::format("it has not come to rest within {} frames", kRestFrames), "",
                       "leave the step out, or let time pass with {\"seconds\": 5}");
    }
  };
}

ExploreStep readSeconds(JsonFields& fields) {
  const double seconds = fields.number("seconds", 0, kMaxExploreSeconds);
  return [=](ExploreSession& session) { showFrames(session, {}, seconds); };
}

ExploreStep readFly(JsonFields& fields) {
  const bool fly = fields.boolean("fly", true);
  return [=](ExploreSession& session) {
    session.explorer().setFlying(fly);
    session.showFrame({});
  };
}

}  // namespace

void showFrames(ExploreSession& session, const WalkInput& input, double seconds) {
  for (int i = framesFor(seconds); i > 0; --i) {
    session.showFrame(input);
  }
}

std::vector<ExploreStepKind> exploreWalkSteps() {
  return {
      {"walk", "metres to go forward, to the right and, flying, up, as far as walls let one", readWalk},
      {"turn", "degrees to turn to the right",
       [](JsonFields& fields) { return readTurn(fields, "turn", &WalkInput::turnRight); }},
      {"look", "degrees to look up", [](JsonFields& fields) { return readTurn(fields, "look", &WalkInput::lookUp); }},
      {"go", "a place, in the scene, to be at, and where to look; at once or gliding there", readGo},
      {"fly", "whether one flies, through walls, too", readFly},
      {"wait", "rest: until nothing deploys, collapses, glides or dissolves any more", readWait},
      {"seconds", "lets time pass", readSeconds},
  };
}

}  // namespace ocelli
