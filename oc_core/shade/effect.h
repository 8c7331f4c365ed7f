// An effect of `ocelli shade`: what a scene looks like where rays go further than to the first surface, drawn by
// several ways, each against the traced picture. An effect is a row of effects.h and a file that makes it; nothing else
// knows effects.
//
// An EffectStage is one effect in one scene. From it come ways, which are built once and draw any view, and
// measurements of a way. What a picture's errors are is up to the effect: its columns, its maps, its legend.
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "oc_core/base/progress.h"
#include "oc_core/camera/pinhole_camera.h"
#include "oc_core/depth_rays/depth_ray_caster.h"
#include "oc_core/image/png_file.h"
#include "oc_core/shade/shaded_scene.h"

namespace ocelli {

/// The name of the way that all are compared with: the geometry itself.
inline constexpr const char* kTraced = "traced";

/// One figure of a way.
struct FigureColumn {
  const char* field;    ///< in JSON and CSV
  const char* heading;  ///< in tables; nullptr for what stands in JSON and CSV alone
  const char* meaning;
  int digits;    ///< behind the point, in tables
  double scale;  ///< in tables: 100 for what is a ratio
};

/// A picture beside the picture.
struct ShadedMap {
  std::string name;         ///< of its file: "errors", "steps"
  std::string alternative;  ///< what it shows, for those who do not see it
  Image<Rgb8> image;
};

/// A way, measured.
struct ShadedWay {
  std::string name;
  Image<glm::vec3> picture = {};                    ///< linear
  std::vector<ShadedMap> maps = {};                 ///< none for the traced picture where they tell of errors
  std::vector<std::optional<double>> figures = {};  ///< one a column of the effect; nothing where the way has none
};

/// Something that the page and the JSON say of a comparison besides its table.
struct ShadeFact {
  std::string field;          ///< in JSON
  std::string json;           ///< its value, as JSON
  std::string sentence = {};  ///< on the page; empty for what it does not say
};

/// A colour of the maps.
struct ShadeLegend {
  Rgb8 color;
  std::string meaning;
};

/// A word of the page, explained.
struct ShadeTerm {
  std::string term;
  std::string meaning;
};

/// A way that is ready: images and structures are built.
class EffectWay {
 public:
  virtual ~EffectWay() = default;
  /// The linear picture. Where nothing of the effect is seen, it is the scene as it is. Safe to call from one thread at
  /// a time; works on all threads.
  virtual Image<glm::vec3> draw(const PinholeCamera& camera) const = 0;
};

class EffectStage {
 public:
  virtual ~EffectStage() = default;
  /// `way` is one that Effect::checkWay() takes. May take long; throws InputError and WorkError where it cannot be
  /// built. It may outlive the stage.
  virtual std::unique_ptr<EffectWay> build(const std::string& way) const = 0;
  /// Throws InputError where a picture of this view shows nothing of the effect.
  virtual void checkView(const PinholeCamera& camera) const = 0;
  /// Builds it, draws it, and compares it with the traced picture, which is made once a view. Times are the least of
  /// `runs`.
  virtual ShadedWay measure(const std::string& way, const PinholeCamera& camera, int runs) = 0;
  /// In the order of the page. `camera` is that of the picture.
  virtual std::vector<ShadeFact> facts(const PinholeCamera& camera) = 0;
};

/// An option that an effect has of its own: `--NAME VALUE`. Effects may share one.
struct EffectOption {
  const char* name;
  const char* values;   ///< what it takes, in help
  const char* initial;  ///< its value by default
  const char* meaning;
  /// Throws InputError for a value that it does not take.
  void (*check)(const std::string& value);
};

struct StageInputs {
  std::shared_ptr<const ShadedScene> scene;
  glm::ivec2 referenceSize{720, 480};  ///< of reference images, pixels
  std::optional<float> cellSide =
      {};                        ///< of the viewpoints that they are made for, world units; by default the effect's
  int environmentHeight = 1024;  ///< rows of environment maps
  Progress progress = {};
  /// The camera of the picture, where it is known beforehand: what is built may be fitted to it, whatever is drawn
  /// then.
  std::optional<PinholeCamera> picture = {};
  /// Of Effect::options, by name; those that are missing have their initial value.
  std::map<std::string, std::string> options = {};
  /// Casts rays at depth images, for ways of which Effect::castsOnDevice() says so; nothing: the CPU does.
  std::shared_ptr<const DepthRayCaster> caster = {};
};

/// What was given for an option of the effect, or its initial value. OC_CHECKs that `options` has the name.
std::string optionValue(const StageInputs& inputs, const std::vector<EffectOption>& options, const char* name);

/// The names of all cameras that have reference images, in the order of lists: ways that effects have in common.
std::vector<std::string> camerasWithImages();

struct Effect {
  const char* name;         ///< on the command line
  const char* title;        ///< of its page
  const char* description;  ///< in help
  const char* ways;         ///< what `--by` takes, in help
  std::vector<FigureColumn> columns;
  std::vector<ShadeLegend> legend;
  const char* mapNote;  ///< a sentence under the legend; empty where it needs none
  std::vector<ShadeTerm> terms;
  /// Throws InputError for a way that it does not have.
  void (*checkWay)(const std::string& way);
  /// Throws InputError where the scene lacks objects with the roles that it needs.
  void (*requireObjects)(const ShadedScene& scene);
  /// Of the picture.
  View (*defaultView)(const ShadedScene& scene);
  /// `inputs.scene` has what requireObjects() asks for.
  std::unique_ptr<EffectStage> (*stage)(const StageInputs& inputs);
  /// Whether it lights the scene: that is to be loaded with Shading::kNone, so that no other light is in its colours.
  bool lightsScene = false;
  std::vector<EffectOption> options = {};
  /// The ways that lists offer, without "traced", which all have; null: the cameras that checkWay() takes.
  std::vector<std::string> (*waysToOffer)() = nullptr;
  bool needsRoles = true;  ///< else it takes scenes of whose objects nothing says roles
  /// Whether StageInputs::caster casts the rays of a way; nullptr for an effect without such ways.
  bool (*castsOnDevice)(const std::string& way) = nullptr;
  /// Of reference images, pixels, where the user gives none.
  glm::ivec2 referenceSize{720, 480};
};

}  // namespace ocelli
