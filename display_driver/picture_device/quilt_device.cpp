#include "display_driver/picture_device/quilt_device.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <functional>
#include <type_traits>
#include <vector>

#include "oc_core/base/error.h"
#include "oc_core/gl/gl_api.h"
#include "oc_core/window/gl_window.h"
#include "oc_core/window/monitors.h"

namespace ocelli {
namespace {

constexpr int kMaxMonitor = 99;

/// What was read, in any order.
struct WindowText {
  QuiltWindowOptions options;
  std::optional<double> coneDegrees;
};

/// What may follow the display's name, described once: reader and usage come from it.
struct QuiltWindowKey {
  const char* name;
  const char* value;  ///< for people
  std::function<void(WindowText&, const std::string& value)> set;
};

template <class Number>
Number numberIn(const std::string& text, const char* key, Number min, Number max) {
  Number value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !(value >= min && value <= max)) {
    throw InputError(fmt::format("\"{}\" is no {} from {} to {}", text,
                                 std::is_integral_v<Number> ? "whole number" : "number", min, max),
                     key, std::string("--device quilt:") + quiltWindowUsage());
  }
  return value;
}

const std::vector<QuiltWindowKey>& quiltWindowKeys() {
  static const std::vector<QuiltWindowKey> keys{
      {"monitor", "N",
       [](WindowText& read, const std::string& value) {
         read.options.monitor = numberIn(value, "monitor", 0, kMaxMonitor);
       }},
      {"calibration", "FILE.json",
       [](WindowText& read, const std::string& value) { read.options.calibration = readCalibration(value); }},
      {"cone", "DEGREES",
       [](WindowText& read, const std::string& value) {
         read.coneDegrees = numberIn(value, "cone", kMinConeDegrees, kMaxConeDegrees);
       }},
  };
  return keys;
}

constexpr double kPreviewPixels = 800;  ///< the longer side of a window on the desktop

GlWindowOptions windowOptionsOf(const QuiltWindowOptions& options, const glm::ivec2& picture) {
  GlWindowOptions window;
  window.title = "Ocelli: " + options.display.name;
  const double scale = std::min(1.0, kPreviewPixels / std::max(picture.x, picture.y));
  window.width = std::max(1, static_cast<int>(picture.x * scale));
  window.height = std::max(1, static_cast<int>(picture.y * scale));
  window.monitor = options.monitor;
  return window;
}

class QuiltWindow final : public PictureDevice {
 public:
  explicit QuiltWindow(QuiltWindowOptions options)
      : options_(std::move(options)), window_(windowOptionsOf(options_, pictureSize())) {
    if (options_.monitor) {
      window_.setCursor(CursorMode::kHidden);
    }
  }
  ~QuiltWindow() override {
    const GlScope scope(window_.context());
    framebuffer_ = GlObject();
    texture_ = GlObject();
  }

  const QuiltDisplay& display() const override { return options_.display; }

  std::string description() const override {
    const std::string what = options_.calibration ? "the dots of its panel" : "the quilt";
    const std::string where = options_.monitor ? fmt::format("monitor {}", *options_.monitor) : "a window";
    std::string text = fmt::format("{} of {} on {}, {}x{}", what, options_.display.name, where, window_.pixelWidth(),
                                   window_.pixelHeight());
    const glm::ivec2 size = pictureSize();
    if (options_.calibration && (window_.pixelWidth() != size.x || window_.pixelHeight() != size.y)) {
      text += fmt::format(" (the panel has {}x{}: scaled, its dots show the wrong views)", size.x, size.y);
    }
    for (const std::string& field : options_.calibration ? options_.calibration->unused : std::vector<std::string>()) {
      text += " (the calibration asks for " + field + ", which is not done)";
    }
    return text;
  }

  void show(const Image<Rgb8>& quilt) override {
    if (options_.calibration) {
      upload(panelPicture(quilt, options_.display, *options_.calibration));
    } else {
      upload(quilt);
    }
    draw();
  }

  bool wait(double seconds) override {
    using Clock = std::chrono::steady_clock;
    const auto end = Clock::now() + std::chrono::duration<double>(seconds);
    do {
      const std::chrono::duration<double> left = end - Clock::now();
      for (const InputEvent& event : window_.poll(std::max(0.0, left.count()))) {
        const auto* key = std::get_if<KeyEvent>(&event);
        if (std::holds_alternative<CloseEvent>(event) || (key != nullptr && key->key == Key::kEscape)) {
          open_ = false;
        } else if (std::holds_alternative<ResizeEvent>(event) && texture_) {
          draw();
        }
      }
    } while (open_ && Clock::now() < end);
    return open_;
  }

 private:
  glm::ivec2 pictureSize() const {
    return options_.calibration ? glm::ivec2(options_.calibration->width, options_.calibration->height)
                                : glm::ivec2(options_.display.width, options_.display.height);
  }

  void upload(const Image<Rgb8>& picture) {
    GlContext& context = window_.context();
    const GlScope scope(context);
    const GladGLContext& gl = context.gl();
    if (!texture_) {
      int maxSize = 0;
      gl.GetIntegerv(GL_MAX_TEXTURE_SIZE, &maxSize);
      if (std::max(picture.width(), picture.height()) > maxSize) {
        throw GlError(fmt::format("this GPU takes pictures of up to {0}x{0}", maxSize), options_.display.name,
                      "write the quilt to a file with ocelli quilt");
      }
      texture_ = makeTexture(context, GL_RGBA8, picture.width(), picture.height());
      framebuffer_ = makeFramebuffer(context, std::array{texture_.id()}, 0);
    }
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 1);
    gl.TextureSubImage2D(texture_.id(), 0, 0, 0, picture.width(), picture.height(), GL_RGB, GL_UNSIGNED_BYTE,
                         picture.data());
    gl.PixelStorei(GL_UNPACK_ALIGNMENT, 4);
    context.check("uploading a quilt");
  }

  void draw() {
    const GlScope scope(window_.context());
    const glm::ivec2 size = pictureSize();
    window_.show(framebuffer_, size.x, size.y);
  }

  QuiltWindowOptions options_;
  GlWindow window_;
  GlObject texture_;
  GlObject framebuffer_;
  bool open_ = true;
};

}  // namespace

std::string quiltWindowUsage() {
  std::string usage = "NAME|FILE.json";
  for (const QuiltWindowKey& key : quiltWindowKeys()) {
    usage += fmt::format("[,{}={}]", key.name, key.value);
  }
  return usage;
}

QuiltWindowOptions quiltWindowOptionsFromText(const std::string& text) {
  WindowText read;
  size_t begin = text.find(',');
  const QuiltDisplay display = loadQuiltDisplay(text.substr(0, begin));
  while (begin != std::string::npos) {
    const size_t end = text.find(',', begin + 1);
    const std::string part = text.substr(begin + 1, end == std::string::npos ? end : end - begin - 1);
    const size_t equals = part.find('=');
    const std::string name = part.substr(0, equals);
    const auto key = std::ranges::find_if(quiltWindowKeys(), [&](const QuiltWindowKey& k) { return k.name == name; });
    if (equals == std::string::npos || key == quiltWindowKeys().end()) {
      throw InputError("\"" + part + "\" says nothing of this display", "--device quilt:" + text,
                       "quilt:" + quiltWindowUsage());
    }
    key->set(read, part.substr(equals + 1));
    begin = end;
  }
  read.options.display = withCone(display, read.options.calibration, read.coneDegrees);
  return std::move(read.options);
}

std::unique_ptr<PictureDevice> openQuiltWindow(QuiltWindowOptions options) {
  return std::make_unique<QuiltWindow>(std::move(options));
}

}  // namespace ocelli
