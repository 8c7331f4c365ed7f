#include "oc_core/feeds/subject_tracks.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "oc_core/base/parallel.h"
#include "oc_core/feeds/place_telling.h"
#include "oc_core/feeds/subject_body.h"
#include "oc_core/feeds/subject_places.h"

namespace ocelli {
namespace {

constexpr int kTellRounds = 2;    ///< cells tell places, and places cells
constexpr double kMinOpen = 0.4;  ///< share of a body's cells in the image that nobody hides
constexpr double kMinOpenCells = 40;
constexpr double kMaxMissedSeconds = 0.3;  ///< while the feed that would show it sees background
constexpr double kMaxHiddenSeconds = 4;    ///< while others hide it
constexpr double kMaxUnknownSeconds = 2.5;
constexpr double kNewSeconds = 2;     ///< so long a subject may turn out to be one that was lost
constexpr float kMinLikeness = 1.2f;  ///< as SubjectColors::likenessOf() has it
constexpr double kMaxStrayed = 1;     ///< metres: a lost one that stood still is at most so far from where it was seen,
constexpr double kMaxSpeed = 2;       ///< metres a second: and others are farther off by that
constexpr double kNearSubject = 0.6;  ///< metres: what is told so near to a subject is that one
constexpr double kFarSubject = 0.9;   ///< metres: or so near to one that no feed sees
constexpr double kMinError = 0.2;     ///< metres, of the place of a new subject
constexpr double kNewHeight = 0.02;   ///< share of what a frame tells of a height

}  // namespace

SubjectTracks::SubjectTracks(const FeedGraph& graph)
    : graph_(graph), bodies_(graph.setup().feeds.size()), cells_(bodies_.size()) {}

glm::dvec3 SubjectTracks::place(size_t subject) const {
  const glm::dvec2 place = tracks_[subject].motion.place();
  return {place.x, graph_.setup().floorHeight, place.y};
}

const BodySight* SubjectTracks::sight(size_t feed, size_t subject) const {
  for (size_t b = 0; b < cells_[feed].sights.size(); ++b) {
    if (bodies_[feed][b].subject == subject) {
      return &cells_[feed].sights[b];
    }
  }
  return nullptr;
}

void SubjectTracks::update(const std::vector<FeedBlobs>& blobs, double seconds) {
  for (Track& track : tracks_) {
    track.motion.goOn(seconds - seconds_);
  }
  seconds_ = seconds;
  tellCellsOf(blobs);
  for (int round = 1; round < kTellRounds; ++round) {
    tellPlaces();
    tellCellsOf(blobs);
  }
  learnColors();
  judge();
  recognize();
  forget();
  addNew(blobs);
}

void SubjectTracks::tellCellsOf(const std::vector<FeedBlobs>& blobs) {
  parallelFor(blobs.size(), 1, [&](size_t begin, size_t end) {
    for (size_t feed = begin; feed < end; ++feed) {
      bodies_[feed].clear();
      cells_[feed] = {};
      const FeedBlobs& of = blobs[feed];
      if (of.core.empty()) {
        continue;
      }
      for (size_t i = 0; i < tracks_.size(); ++i) {
        const auto& colors = tracks_[i].colors;
        if (auto view = BodyView::of(graph_.setup().feeds[feed], place(i), tracks_[i].height,
                                     {of.core.width(), of.core.height()}, of.scale)) {
          bodies_[feed].push_back({i, std::move(*view), colors[feed].isKnown() ? &colors[feed] : &colors.back()});
        }
      }
      std::sort(bodies_[feed].begin(), bodies_[feed].end(),
                [](const ExpectedBody& a, const ExpectedBody& b) { return a.view.distance() < b.view.distance(); });
      cells_[feed] = tellCells(of, bodies_[feed]);
    }
  });
}

void SubjectTracks::tellPlaces() {
  for (size_t feed = 0; feed < cells_.size(); ++feed) {
    for (size_t b = 0; b < cells_[feed].sights.size(); ++b) {
      const ExpectedBody& body = bodies_[feed][b];
      Track& track = tracks_[body.subject];
      if (const auto seen = tellPlace(graph_.setup(), feed, body, cells_[feed].sights[b], track.height, track.motion)) {
        track.height += (*seen - track.height) * kNewHeight;
      }
    }
  }
}

void SubjectTracks::learnColors() {
  for (Track& track : tracks_) {
    for (SubjectColors& colors : track.colors) {
      colors.forget();
    }
  }
  for (size_t feed = 0; feed < cells_.size(); ++feed) {
    for (const SureCell& cell : cells_[feed].sure) {
      Track& track = tracks_[bodies_[feed][cell.body].subject];
      track.colors[feed].add(cell.part, cell.bin);
      track.colors.back().add(cell.part, cell.bin);
    }
  }
}

void SubjectTracks::judge() {
  std::vector<bool> isMissed(tracks_.size(), false);
  for (Track& track : tracks_) {
    track.isHidden = false;
  }
  for (size_t i = 0; i < graph_.frusta(); ++i) {
    const size_t feed = graph_.feedIndexOf(i);
    for (size_t b = 0; b < cells_[feed].sights.size(); ++b) {
      const size_t subject = bodies_[feed][b].subject;
      const BodySight& sight = cells_[feed].sights[b];
      Track& track = tracks_[subject];
      if (isSeen(sight)) {
        track.toldAt = seconds_;
      } else if (sight.inImage >= kMinOpenCells && shareShown(graph_, i, place(subject)) > 0.5) {
        const bool isOpen = sight.open >= kMinOpenCells && sight.open >= kMinOpen * sight.inImage;
        isMissed[subject] = isMissed[subject] || isOpen;
        track.isHidden = track.isHidden || !isOpen;
      }
    }
  }
  for (size_t i = 0; i < tracks_.size(); ++i) {
    tracks_[i].expectedAt = isMissed[i] ? tracks_[i].expectedAt : seconds_;
  }
}

void SubjectTracks::recognize() {
  for (Track& found : tracks_) {
    if (seconds_ - found.foundAt > kNewSeconds || found.toldAt < seconds_ || !found.colors.back().isKnown()) {
      continue;
    }
    if (Track* const lost = lostLike(found)) {
      found.number = lost->number;
      found.height = lost->height;
      found.foundAt = lost->foundAt;
      for (size_t i = 0; i < found.colors.size(); ++i) {
        if (lost->colors[i].isKnown()) {
          found.colors[i] = lost->colors[i];
        }
      }
      lost->isRecognized = true;
    }
  }
}

SubjectTracks::Track* SubjectTracks::lostLike(const Track& found) {
  Track* best = nullptr;
  float most = kMinLikeness;
  for (Track& lost : tracks_) {
    const double away = glm::length(lost.motion.place() - found.motion.place());
    if (lost.foundAt >= found.foundAt || lost.toldAt > found.foundAt || lost.isRecognized ||
        !lost.colors.back().isKnown() || away > kMaxStrayed + kMaxSpeed * (seconds_ - lost.toldAt)) {
      continue;
    }
    if (const float likeness = lost.colors.back().likenessOf(found.colors.back()); likeness > most) {
      best = &lost;
      most = likeness;
    }
  }
  return best;
}

bool SubjectTracks::goesOn(const Track& track) const {
  const double maxUntold = track.isHidden ? kMaxHiddenSeconds : kMaxUnknownSeconds;
  return !track.isRecognized && seconds_ - track.expectedAt <= kMaxMissedSeconds &&
         seconds_ - track.toldAt <= maxUntold;
}

void SubjectTracks::forget() {
  std::vector<Track> kept;
  std::vector<uint16_t> numbers(tracks_.size() + 1, SubjectCells::kNobody);
  for (size_t i = 0; i < tracks_.size(); ++i) {
    if (goesOn(tracks_[i])) {
      kept.push_back(std::move(tracks_[i]));
      numbers[i + 1] = static_cast<uint16_t>(kept.size());
    }
  }
  tracks_ = std::move(kept);
  renumber(numbers);
}

void SubjectTracks::renumber(const std::vector<uint16_t>& numbers) {
  for (size_t feed = 0; feed < cells_.size(); ++feed) {
    for (uint16_t& who : cells_[feed].who) {
      who = numbers[who];
    }
    std::vector<ExpectedBody> bodies;
    std::vector<BodySight> sights;
    for (size_t b = 0; b < cells_[feed].sights.size(); ++b) {
      ExpectedBody& body = bodies_[feed][b];
      if (const uint16_t number = numbers[body.subject + 1]; number != SubjectCells::kNobody) {
        body.subject = number - 1u;
        bodies.push_back(std::move(body));
        sights.push_back(cells_[feed].sights[b]);
      }
    }
    bodies_[feed] = std::move(bodies);
    cells_[feed].sights = std::move(sights);
  }
}

void SubjectTracks::addNew(const std::vector<FeedBlobs>& blobs) {
  std::vector<const Image<uint16_t>*> known;
  for (const SubjectCells& cells : cells_) {
    known.push_back(&cells.who);
  }
  const size_t old = tracks_.size();
  for (const SeenSubject& subject : locateSubjects(graph_.setup(), blobs, known)) {
    const glm::dvec2 plan = planOf(subject.place);
    const double error = std::max(subject.error, kMinError);
    Track* nearest = nullptr;
    double least = 1;
    for (size_t i = 0; i < old; ++i) {
      const double reach = tracks_[i].toldAt >= seconds_ ? kNearSubject : kFarSubject + subject.error;
      if (const double away = glm::length(tracks_[i].motion.place() - plan) / reach; away < least) {
        nearest = &tracks_[i];
        least = away;
      }
    }
    if (nearest == nullptr) {
      tracks_.push_back({nextNumber_++, SubjectMotion(plan, error), kSubjectHeight,
                         std::vector<SubjectColors>(blobs.size() + 1), seconds_, seconds_, seconds_});
    } else if (nearest->toldAt < seconds_) {
      nearest->motion.tell({1, 0}, plan.x, error);
      nearest->motion.tell({0, 1}, plan.y, error);
      nearest->toldAt = nearest->expectedAt = seconds_;
    }
  }
}

}  // namespace ocelli
