// What a simulated observer can do: its eye, its movements and its memory, in numbers from the literature on human
// performance. None of them comes from a study of cameras such as these, and none belongs to a condition of a study.
// Each subject has values of its own, drawn from its seed.
//
//   Ball et al. 1988        useful field of view: places are taken in within 10 to 15 degrees of the gaze
//   Cowan 2001              working memory holds about 4 things
//   Getty 1975              times are told apart by about a tenth to a fifth of their length
//   Luck and Vogel 1997     so does visual memory, of the colours of things too
//   Miller 1956             an immediate span of 7, give or take 2, for what can be said in words
//   Pylyshyn, Storm 1988    about 4 moving things are followed at once
//   Rayner 1998             fixations of 260 to 330 ms on scenes, saccades of 30 to 40 ms
//   Rosenholtz 2016         things must be larger the farther from the gaze: twice as large at 2 to 4 degrees or so
//   Soukoreff, MacKenzie 2004   a mouse points with 3.7 to 4.9 bits/s (ISO 9241-9)
//   Trick and Pylyshyn 1994 40 to 100 ms for each of up to 3 or 4 things, 250 to 350 ms for each more
//   Waller, Hodgson 2006    after turning, or from another viewpoint, places are misjudged by 20 degrees and more
//
// A factor is a member and its row in human_factors.cpp: what draws them, writes them and reads --factors follows the
// rows.
#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>

namespace ocelli {

struct HumanFactors {
  uint64_t seed = 1;

  // Looking.
  double fixationSeconds = 0.29;  ///< mean
  double fixationSpread = 0.06;   ///< from one to the next, seconds
  double saccadeSeconds = 0.035;
  double usefulFieldDegrees = 12;  ///< places are taken in that far from the gaze
  double noticedDegrees = 0.15;  ///< side of the least coloured thing noticed at the gaze; the root of its area counts
  double doublingDegrees = 3;    ///< so far from the gaze it must have twice the side
  double noticeSeconds = 0.2;    ///< an object must have been in sight so long
  double minFloorDegrees = 0.3;  ///< likewise the side of a piece of floor

  // Counting.
  double itemSeconds = 0.3;        ///< for each thing beyond those seen at once
  double groupSeconds = 0.07;      ///< for each of those
  double groupItems = 4;           ///< seen at once
  double groupRadiusDegrees = 5;   ///< around the gaze
  double trackedItems = 4;         ///< moving things that the eyes follow at once
  double workingMemoryItems = 4;   ///< things whose colour and place one remembers
  double placeErrorDegrees = 0.5;  ///< of a remembered place, each way in the picture; a guess
  double turnErrorDegrees = 20;    ///< of places carried over to where the picture is turned by 90 degrees

  // Moving.
  double reactionSeconds = 0.2;  ///< from having seen to doing
  double keySpread = 0.03;       ///< of the times at which keys are let go, seconds
  double mouseShare = 0.8;       ///< chance that one turns by the mouse, not by keys
  double bitsPerSecond = 4.3;    ///< of pointing
  double clickSeconds = 0.12;    ///< from pointing to the button
  double holdSeconds = 0.09;     ///< how long a key or button is down that is tapped

  // Deciding and remembering.
  double readSeconds = 2.5;         ///< for a page of instructions
  double decideSeconds = 0.8;       ///< for an answer
  double wayNoise = 0.15;           ///< of what ways seem to cost, a share
  double searchMemorySeconds = 60;  ///< one knows so long where one has looked
  double forgetPerTrial = 0.1;      ///< chance that a way of the maze is forgotten from one trial to the next
  double forgetBetweenSessions = 0.4;
  double turnLapse = 0.06;   ///< chance that a turn is not taken in, or mixed up, or lost
  double timeSpread = 0.15;  ///< of the times between turns, as a share
  double slip = 0.01;        ///< chance of pressing the key beside the one that was meant

  // Estimating. Both are guesses: people differ widely, and no study of such pictures was asked.
  double lengthErrorShare = 0.15;   ///< of how far something seems, from one time to the next, a share
  double pointingErrorDegrees = 8;  ///< likewise of where it seems to be

  /// Of a subject: whether this one turns by the mouse.
  bool turnsByMouse() const { return mouseShare > 0.5; }
};

/// Other values than the usual ones for some factors, by name, for the mean of all subjects.
using FactorMeans = std::map<std::string, double>;

/// Those of a subject, from its seed. Where `means` has another value for a factor, each subject's own is to it as it
/// was to the usual one, within what the factor can be.
HumanFactors drawHumanFactors(uint64_t seed, const FactorMeans& means = {});

/// JSON text with all of them, for the database.
std::string jsonText(const HumanFactors& factors);

/// A JSON object of factors by name. Throws InputError for a name that no factor has, and for a value out of range.
FactorMeans readFactorMeans(const std::filesystem::path& file);

}  // namespace ocelli
