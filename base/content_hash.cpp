#include "base/content_hash.hpp"

#include <fmt/format.h>

#include <array>
#include <openssl/evp.h>
#include <stdexcept>

namespace asperity {

namespace {

std::string hash_of(std::string_view text, const EVP_MD* method,
                    const char* method_name) {
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_Digest(text.data(), text.size(), digest.data(), &length, method,
                 nullptr) != 1)
    throw std::runtime_error(fmt::format("OpenSSL has no {}", method_name));
  std::string hash;
  for (unsigned int i = 0; i < length; ++i)
    hash += fmt::format("{:02x}", digest[i]);
  return hash;
}

} // namespace

std::string content_hash(std::string_view text) {
  return hash_of(text, EVP_sha256(), "SHA-256");
}

std::string md5_hash(std::string_view text) {
  return hash_of(text, EVP_md5(), "MD5");
}

} // namespace asperity
