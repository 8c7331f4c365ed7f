// The page as browsers ask for it, and as slow ones do.
#include "oc_core/feeds_page/feeds_page.h"

#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <array>
#include <chrono>

#include "oc_core/base/error.h"
#include "oc_core/image_codecs/image_codec.h"

namespace ocelli {
namespace {

/// A connection that has asked for a path. It reads what it is told to.
class Browser {
 public:
  Browser(int port, const std::string& path, const std::string& host = "127.0.0.1", int bufferBytes = 0)
      : socket_(socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
    if (bufferBytes > 0) {
      setsockopt(socket_, SOL_SOCKET, SO_RCVBUF, &bufferBytes, sizeof(bufferBytes));
    }
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(static_cast<uint16_t>(port));
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    EXPECT_EQ(connect(socket_, reinterpret_cast<const sockaddr*>(&address), sizeof(address)), 0);
    const std::string request =
        "GET " + path + " HTTP/1.1\r\nHost: " + host + ":" + std::to_string(port) + "\r\nConnection: close\r\n\r\n";
    EXPECT_EQ(send(socket_, request.data(), request.size(), MSG_NOSIGNAL), static_cast<ssize_t>(request.size()));
  }
  ~Browser() { close(socket_); }
  Browser(const Browser&) = delete;
  Browser& operator=(const Browser&) = delete;

  /// Reads until `text` stands in what was read, or the connection ends.
  const std::string& readUntil(const std::string& text) {
    std::array<char, 4096> bytes{};
    while (text.empty() || read_.find(text) == std::string::npos) {
      const ssize_t count = recv(socket_, bytes.data(), bytes.size(), 0);
      if (count <= 0) {
        break;
      }
      read_.append(bytes.data(), static_cast<size_t>(count));
    }
    return read_;
  }
  const std::string& readAll() { return readUntil(""); }
  void forget() { read_.clear(); }

 private:
  int socket_ = -1;
  std::string read_;
};

Image<Rgb8> gray(int tone) {
  return Image<Rgb8>(64, 48, Rgb8(static_cast<uint8_t>(tone)));
}

/// The gray of the first whole image in what a browser has read of the stream; its chunks are no longer than it.
int toneIn(const std::string& stream) {
  const size_t begin = stream.find("\xff\xd8");
  const size_t end = stream.find("\xff\xd9", begin);
  if (begin == std::string::npos || end == std::string::npos) {
    return -1;
  }
  const auto bytes = std::as_bytes(std::span(stream).subspan(begin, end + 2 - begin));
  return findColorCodec("jpeg_baseline")->decode(bytes, {64, 48})(32, 24).x;
}

TEST(FeedsPage, hasTheImageAndWhatItsScriptAsksFor) {
  FeedsPage page(0, "corridor <setup>");
  page.show(gray(50), {{"left 33 ms"}, {"right COVERED 33 ms", false}});
  EXPECT_EQ(page.address(), "http://127.0.0.1:" + std::to_string(page.port()) + "/");
  const std::string html = Browser(page.port(), "/").readAll();
  EXPECT_THAT(html, testing::HasSubstr("<h1>corridor &lt;setup&gt;</h1>"));
  EXPECT_THAT(html, testing::HasSubstr("src=\"/image\" alt=\""));
  EXPECT_THAT(html, testing::HasSubstr("default-src 'none'"));
  EXPECT_THAT(Browser(page.port(), "/feeds.js").readAll(), testing::HasSubstr("fetch(\"/feeds.json\""));
  EXPECT_THAT(Browser(page.port(), "/feeds.json").readAll(),
              testing::HasSubstr(
                  "[{\"good\":true,\"text\":\"left 33 ms\"},{\"good\":false,\"text\":\"right COVERED 33 ms\"}]"));
  EXPECT_THAT(Browser(page.port(), "/other").readAll(), testing::HasSubstr("404"));
}

TEST(FeedsPage, isForThisComputerAlone) {
  const FeedsPage page(0, "a");
  EXPECT_THAT(Browser(page.port(), "/", "attacker.example").readAll(), testing::HasSubstr("403"));
  EXPECT_THAT(Browser(page.port(), "/image", "attacker.example").readAll(), testing::HasSubstr("403"));
}

TEST(FeedsPage, streamsImageAfterImage) {
  if (findColorCodec("jpeg_baseline") == nullptr) {
    GTEST_SKIP() << "built without JPEG";
  }
  FeedsPage page(0, "a");
  page.show(gray(50), {});
  Browser browser(page.port(), "/image");
  EXPECT_THAT(browser.readUntil("--ocelli-image\r\nContent-Type: image/jpeg"),
              testing::HasSubstr("multipart/x-mixed-replace; boundary=ocelli-image"));
  EXPECT_NEAR(toneIn(browser.readUntil("\xff\xd9\r\n--ocelli-image\r\n")), 50, 3);
  browser.forget();
  page.show(gray(200), {});
  EXPECT_NEAR(toneIn(browser.readUntil("\xff\xd9\r\n--ocelli-image\r\n")), 200, 3);
}

/// Noise, so that files are large.
Image<Rgb8> noise(int seed) {
  Image<Rgb8> image(640, 480);
  uint32_t state = 1 + static_cast<uint32_t>(seed);
  for (size_t i = 0; i < image.size(); ++i) {
    state = 1664525 * state + 1013904223;
    image[i] = Rgb8(state >> 24U, state >> 16U & 255U, state >> 8U & 255U);
  }
  return image;
}

TEST(FeedsPage, aSlowBrowserHoldsNobodyUp) {
  FeedsPage page(0, "a");
  page.show(noise(0), {});
  const Browser slow(page.port(), "/image", "127.0.0.1", 4096);  // and never reads
  const Image<Rgb8> image = noise(1);
  const auto began = std::chrono::steady_clock::now();
  for (int k = 0; k < 300; ++k) {
    page.show(image, {});
  }
  EXPECT_LT(std::chrono::duration<double>(std::chrono::steady_clock::now() - began).count(), 5)
      << "300 images of 300 KB do not fit into any buffer";
  Browser other(page.port(), "/image");
  page.show(gray(9), {});
  EXPECT_THAT(other.readUntil("image/"), testing::HasSubstr("--ocelli-image"));
}

TEST(FeedsPage, namesPortsThatAreTaken) {
  const FeedsPage page(0, "a");
  EXPECT_THROW(FeedsPage(page.port(), "b"), WorkError);
}

}  // namespace
}  // namespace ocelli
