#include "display_sim/frames/svol_join.h"

#include <cmath>

#include "display_sim/frames/svol_player.h"
#include "display_sim/frames/svol_writer.h"
#include "oc_core/base/check.h"

namespace ocelli {
namespace {

class Joiner {
 public:
  Joiner(const std::filesystem::path& output, const DisplayProfile& profile, const std::string& metadata,
         const JoinOptions& options)
      : profile_(profile),
        options_(options),
        writer_(output, profile, SvolOptions{.metadata = metadata, .framesPerKey = options.framesPerKey}) {}

  /// Returns whether all of it was there. `progress` takes the fraction of this source.
  bool add(SvolReader& reader, const std::function<void(double)>& progress) {
    requireFits(reader);
    const std::vector<SvolFrame>& frames = reader.frames();
    const uint64_t first = frames.front().timeMicroseconds;
    if (start_ + static_cast<double>(frames.back().timeMicroseconds - first) >
        static_cast<double>(svol::kMaxMicroseconds)) {
      throw InputError("with this file the recording would last more than 285 years", reader.where(),
                       "leave it out, or give it other times");
    }
    const auto base = static_cast<uint64_t>(std::llround(start_));
    SvolPlayer player(reader);
    size_t k = 0;
    for (; k < frames.size(); ++k) {
      progress(static_cast<double>(k) / static_cast<double>(frames.size()));
      try {
        player.seek(k);
      } catch (const InputError&) {
        if (!options_.salvage || k == 0) {
          throw;
        }
        break;
      }
      writer_.append(player.volume(), base + (frames[k].timeMicroseconds - first));
    }
    const double rate = options_.framesPerSecond.value_or(profile_.refreshHertz());
    start_ += static_cast<double>(frames[k - 1].timeMicroseconds - first) + 1e6 / rate;
    return k == frames.size() && reader.ending() == SvolEnding::kFinished;
  }

  size_t finish() {
    writer_.finish();
    return writer_.frames();
  }

 private:
  void requireFits(const SvolReader& reader) const {
    if (reader.profile() != profile_) {
      throw InputError("this volume is for another display than the first one", reader.where(),
                       "slice all for one profile");
    }
    if (reader.damage() && (!options_.salvage || reader.frames().empty())) {
      throw *reader.damage();
    }
    if (reader.frames().empty()) {
      throw InputError("there is no whole frame in this file", reader.where(), "leave it out");
    }
    if (reader.ending() == SvolEnding::kUnfinished && !options_.salvage) {
      throw InputError("this recording is unfinished", reader.where(), "--salvage takes the frames that are whole");
    }
  }

  DisplayProfile profile_;
  JoinOptions options_;
  SvolWriter writer_;
  double start_ = 0;  ///< of the next source, in microseconds
};

}  // namespace

JoinResult joinSvol(const std::vector<std::filesystem::path>& sources, const std::filesystem::path& output,
                    const JoinOptions& options, const Progress& progress) {
  OC_CHECK(!sources.empty(), "there is nothing to join");
  if (const auto& rate = options.framesPerSecond; rate && !(*rate >= 0.001 && *rate <= 1e6)) {
    throw InputError("between 0.001 and 1000000 files are shown in a second", "--fps", "--fps 12");
  }
  JoinResult result;
  std::optional<Joiner> joiner;
  for (size_t s = 0; s < sources.size(); ++s) {
    SvolReader reader(sources[s]);
    if (!joiner) {
      joiner.emplace(output, reader.profile(), reader.metadata(), options);
    }
    const bool whole = joiner->add(reader, [&](double fraction) {
      report(progress, "joining", (static_cast<double>(s) + fraction) / static_cast<double>(sources.size()));
    });
    if (!whole) {
      result.incomplete.push_back(sources[s]);
    }
  }
  result.frames = joiner->finish();
  return result;
}

}  // namespace ocelli
