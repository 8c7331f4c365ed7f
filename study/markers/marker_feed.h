// Makes markers of what a session records, and sends each right after the frame that shows it: it stands between a
// session and the sink of its records.
//
//   MarkerFeed feed(store, protocol, outputs);
//   SessionFlow flow(protocol, schedule, done, options, feed);
//   ... flow.frameShown(nanoseconds); feed.frameShown(nanoseconds);
//   feed.finish(nanoseconds);
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "study/markers/marker_output.h"
#include "study/protocol/protocol.h"
#include "study/session/session_sink.h"

namespace ocelli {

class MarkerFeed : public SessionSink {
 public:
  /// `inner` and `protocol` must outlive it. Without outputs it only passes on.
  MarkerFeed(SessionSink& inner, const Protocol& protocol, std::vector<std::unique_ptr<MarkerOutput>> outputs);

  /// A frame was shown, and with it all that was recorded since the last one. Never waits.
  void frameShown(int64_t nanoseconds);
  /// Sends what no frame has shown, and hands all of it over.
  void finish(int64_t nanoseconds);
  /// Of each output.
  std::vector<MarkerCounts> counts() const;

  void consent(const ConsentRecord& record) override { inner_.consent(record); }
  void answer(const AnswerRecord& record) override { inner_.answer(record); }
  void trialBegins(int number, const TrialPlan& plan, int attempt) override;
  void frames(int number, std::span<const FrameRecord> records) override { inner_.frames(number, records); }
  void inputs(int number, std::span<const InputRecord> records) override { inner_.inputs(number, records); }
  void gaze(int number, std::span<const GazeRecord> records) override { inner_.gaze(number, records); }
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override;
  void event(const EventRecord& record) override { inner_.event(record); }
  void sessionEnds(SessionEnding ending, const std::string& utc) override;
  void flush() override { inner_.flush(); }
  std::optional<std::string> failure() const override { return inner_.failure(); }

 private:
  void add(const MarkerCode& code, int trial = -1, const std::string& condition = {}, const std::string& answer = {});

  SessionSink& inner_;
  const Protocol& protocol_;
  std::vector<std::unique_ptr<MarkerOutput>> outputs_;
  std::vector<Marker> waiting_{};  ///< for the next frame
  int64_t sequence_ = 0;
};

}  // namespace ocelli
