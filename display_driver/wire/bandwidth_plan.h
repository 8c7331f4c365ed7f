// Which rate a scene gets on a link, and why: the planner of `ocelli device plan`. Its bytes are exact, those that the
// frames of a scene take as messages of the wire protocol; its times are measured on this machine.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "display_driver/wire/wire_format.h"
#include "display_sim/frames/volume.h"

namespace ocelli::wire {

/// What bulk transfers carry in practice.
///
/// USB 2, 480 Mbit/s: at most 13 packets of 512 bytes fit a microframe of 125 us, 53 MB/s (USB 2.0 specification, table
/// 5-10); host controllers reach about 10 of them, 41 MB/s.
inline constexpr double kUsb2BytesPerSecond = 40e6;
/// USB 3, 5 Gbit/s: the 8b/10b code leaves 500 MB/s; with framing, flow control and the protocol it is realistic that
/// 400 MB/s or more reach an application (USB 3.0 specification, section 4.4.11).
inline constexpr double kUsb3BytesPerSecond = 400e6;

struct PlannedLink {
  std::string name;
  double bytesPerSecond = 0;
};
/// "usb2", "usb3", or bytes a second as a number. Throws InputError.
PlannedLink plannedLink(const std::string& text);

/// What keeps a coding from the wanted rate, or nothing.
enum class PlanLimit {
  kNone,
  kLink,      ///< the bytes of the slices
  kOverhead,  ///< those of headers and records alone: without them the link would do
  kCoding,    ///< the CPU, which codes one frame while another one is sent
};
const char* nameOf(PlanLimit limit);

/// Of one way to send frames; all figures are means over the frames that were planned with.
struct CodingPlan {
  Coding coding = Coding::kRaw;
  bool changes =
      false;          ///< only slices that differ from the frame before are sent, as differences where those are less
  double slices = 0;  ///< that are sent
  double payloadBytes = 0;
  double overheadBytes = 0;
  double codingSeconds = 0;  ///< with all threads, with the checksums; as measured

  double bytes() const { return payloadBytes + overheadBytes; }
  double linkHertz(const PlannedLink& link) const { return link.bytesPerSecond / bytes(); }
  double codingHertz() const { return 1 / codingSeconds; }
  /// The least of the two.
  double hertz(const PlannedLink& link) const;
  PlanLimit limit(const PlannedLink& link, double wantedHertz) const;
};
/// "raw", "run length", "zstd".
const char* nameOf(Coding coding);

/// Takes the frames of a scene one after the other.
class BandwidthPlanner {
 public:
  /// The first frame is coded whole alone; more tell what changes take too.
  void add(const Volume& frame);

  /// Each coding whole, then each with changes (where more than one frame was added).
  std::vector<CodingPlan> plans() const;

 private:
  struct Sum {
    CodingPlan total;
    int frames = 0;
  };
  static void code(Sum& sum, const Volume& frame, const Volume* base);

  std::vector<Sum> sums_;
  std::optional<Volume> last_;
};

/// The one that is fastest on the link; of those that reach the rate the one with the least bytes.
const CodingPlan& bestPlan(const std::vector<CodingPlan>& plans, const PlannedLink& link, double wantedHertz);

}  // namespace ocelli::wire
