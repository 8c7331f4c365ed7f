#include "oc_core/base/sha256.h"

#include <openssl/evp.h>

#include "oc_core/base/check.h"

namespace ocelli {

Digest sha256Digest(std::string_view bytes) {
  Digest digest{};
  unsigned size = 0;
  OC_CHECK(EVP_Digest(bytes.data(), bytes.size(), digest.data(), &size, EVP_sha256(), nullptr) == 1 && size == 32,
           "SHA-256 is always there");
  return digest;
}

std::string hexadecimal(const Digest& digest) {
  std::string text;
  for (const uint8_t byte : digest) {
    constexpr const char* kDigits = "0123456789abcdef";
    text += kDigits[byte >> 4U];
    text += kDigits[byte & 15U];
  }
  return text;
}

std::string sha256(std::span<const uint8_t> bytes) {
  return sha256(std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

std::string sha256(std::string_view text) {
  return hexadecimal(sha256Digest(text));
}

}  // namespace ocelli
