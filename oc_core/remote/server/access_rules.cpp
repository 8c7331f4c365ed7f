#include "oc_core/remote/server/access_rules.h"

#include <arpa/inet.h>
#include <sys/random.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>
#include <optional>

#include "oc_core/base/error.h"
#include "oc_core/base/file_bytes.h"
#include "oc_core/base/sha256.h"

namespace ocelli {
namespace {

bool isDigit(char c) {
  return c >= '0' && c <= '9';
}

char smallLetter(char c) {
  return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
}

bool isSameName(std::string_view a, std::string_view b) {
  return std::ranges::equal(a, b, {}, smallLetter, smallLetter);
}

bool isAddress(int family, std::string_view text) {
  std::array<unsigned char, sizeof(in6_addr)> address{};
  return inet_pton(family, std::string(text).c_str(), address.data()) == 1;
}

/// The name without its port. Nothing where the text is no "NAME" or "NAME:PORT".
std::optional<std::string_view> nameOfHost(std::string_view host) {
  const size_t bracket = host.starts_with('[') ? host.find(']') : 0;
  if (bracket == std::string_view::npos) {
    return std::nullopt;
  }
  const size_t colon = host.find(':', bracket);
  const std::string_view name = host.substr(0, colon);
  if (colon == std::string_view::npos) {
    return name;
  }
  const std::string_view port = host.substr(colon + 1);
  constexpr size_t kMaxDigits = 5;
  return !port.empty() && port.size() <= kMaxDigits && std::ranges::all_of(port, isDigit) ? std::optional(name)
                                                                                          : std::nullopt;
}

bool isTokenCharacter(char c) {
  return isDigit(c) || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_';
}

}  // namespace

bool isHostAllowed(std::string_view host, const std::vector<std::string>& names) {
  const std::optional<std::string_view> name = nameOfHost(host);
  if (!name || name->empty()) {
    return false;
  }
  if (name->front() == '[') {
    return name->back() == ']' && isAddress(AF_INET6, name->substr(1, name->size() - 2));
  }
  return isAddress(AF_INET, *name) || isSameName(*name, "localhost") ||
         std::ranges::any_of(names, [&](const std::string& ours) { return isSameName(*name, ours); });
}

bool isOriginAllowed(std::string_view origin, std::string_view host) {
  constexpr std::string_view kScheme = "http://";
  return origin.empty() || (origin.starts_with(kScheme) && isSameName(origin.substr(kScheme.size()), host));
}

bool isTokenRight(std::string_view given, std::string_view wanted) {
  if (wanted.empty()) {
    return true;
  }
  // Digests have one length, and tell nothing of how far two tokens agree.
  const Digest a = sha256Digest(given);
  const Digest b = sha256Digest(wanted);
  unsigned difference = 0;
  for (size_t i = 0; i < a.size(); ++i) {
    difference |= static_cast<unsigned>(a[i] ^ b[i]);
  }
  return difference == 0;
}

std::string tokenOfQuery(std::string_view query) {
  constexpr std::string_view kField = "token=";
  std::string token;
  while (!query.empty()) {
    const std::string_view field = query.substr(0, query.find('&'));
    query.remove_prefix(std::min(query.size(), field.size() + 1));
    if (field.starts_with(kField)) {
      if (!token.empty()) {
        return {};
      }
      token = field.substr(kField.size());
    }
  }
  return token;
}

std::string newToken() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size())) {
    throw WorkError(std::string("no random numbers from the system (") + std::strerror(errno) + ")", "the token",
                    "write one into a file yourself, and give it with --token-file");
  }
  constexpr const char* kDigits = "0123456789abcdef";
  std::string token;
  for (const unsigned char byte : bytes) {
    token += kDigits[byte >> 4U];
    token += kDigits[byte & 15U];
  }
  return token;
}

std::string nameOfThisComputer() {
  std::array<char, 256> name{};
  return gethostname(name.data(), name.size() - 1) == 0 ? name.data() : "";
}

std::string readTokenFile(const std::filesystem::path& path) {
  constexpr size_t kMaxFileBytes = 4096;
  constexpr size_t kMinCharacters = 16;
  constexpr size_t kMaxCharacters = 128;
  const std::string text = readFile(path, kMaxFileBytes);
  const std::string token = text.substr(0, text.find_first_of("\r\n"));
  if (token.size() < kMinCharacters || token.size() > kMaxCharacters || !std::ranges::all_of(token, isTokenCharacter)) {
    throw InputError("its first line is no token", path.string(),
                     "write 16 to 128 letters, digits, \"-\" and \"_\", which nobody can guess: openssl rand -hex 16");
  }
  return token;
}

}  // namespace ocelli
