#include "base/content_hash.hpp"

#include <fmt/format.h>

#include <array>
#include <openssl/evp.h>
#include <stdexcept>

namespace asperity {

std::string content_hash(std::string_view text) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &length, EVP_sha256(),
                 nullptr) != 1)
    throw std::runtime_error("OpenSSL has no SHA-256");
  std::string hash;
  for (unsigned int i = 0; i < length; ++i)
    hash += fmt::format("{:02x}", digest[i]);
  return hash;
}

} // namespace asperity
