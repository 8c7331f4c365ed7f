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
#include "study/session/forwarding_sink.h"

namespace ocelli {

class MarkerFeed : public ForwardingSink {
 public:
  /// `inner` and `protocol` must outlive it. Without outputs it only passes on.
  MarkerFeed(SessionSink& inner, const Protocol& protocol, std::vector<std::unique_ptr<MarkerOutput>> outputs);

  /// A frame was shown, and with it all that was recorded since the last one. Never waits.
  void frameShown(int64_t nanoseconds);
  /// Sends what no frame has shown, and hands all of it over.
  void finish(int64_t nanoseconds);
  /// Of each output.
  std::vector<MarkerCounts> counts() const;

  void trialBegins(int number, const TrialPlan& plan, int attempt) override;
  void trialEnds(int number, const TrialRecord& record, std::function<void()> acknowledged) override;
  void sessionEnds(SessionEnding ending, const std::string& utc) override;

 private:
  void add(const MarkerCode& code, int trial = -1, const std::string& condition = {}, const std::string& answer = {});

  const Protocol& protocol_;
  std::vector<std::unique_ptr<MarkerOutput>> outputs_;
  std::vector<Marker> waiting_{};  ///< for the next frame
  int64_t sequence_ = 0;
};

}  // namespace ocelli
