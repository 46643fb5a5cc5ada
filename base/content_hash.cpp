#include "base/content_hash.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <openssl/evp.h>
#include <stdexcept>

namespace asperity {

struct ContentHash::State {
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context{
      EVP_MD_CTX_new(), EVP_MD_CTX_free};
};

ContentHash::ContentHash(HashMethod method)
    : state_(std::make_unique<State>()) {
  const bool is_md5 = method == HashMethod::md5;
  if (!state_->context ||
      EVP_DigestInit_ex(state_->context.get(),
                        is_md5 ? EVP_md5() : EVP_sha256(), nullptr) != 1)
    throw std::runtime_error(
        fmt::format("OpenSSL has no {}", is_md5 ? "MD5" : "SHA-256"));
}

ContentHash::~ContentHash() = default;

void ContentHash::add(std::string_view bytes) {
  if (EVP_DigestUpdate(state_->context.get(), bytes.data(), bytes.size()) != 1)
    throw std::runtime_error("OpenSSL failed to hash bytes");
}

std::string ContentHash::text() const {
  const State copy; // the digest of OpenSSL ends its context
  std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
  unsigned int length = 0;
  if (EVP_MD_CTX_copy_ex(copy.context.get(), state_->context.get()) != 1 ||
      EVP_DigestFinal_ex(copy.context.get(), digest.data(), &length) != 1)
    throw std::runtime_error("OpenSSL failed to hash bytes");
  return fmt::format("{:02x}",
                     fmt::join(digest.begin(), digest.begin() + length, ""));
}

std::string content_hash(std::string_view text) {
  ContentHash hash;
  hash.add(text);
  return hash.text();
}

std::string md5_hash(std::string_view text) {
  ContentHash hash(HashMethod::md5);
  hash.add(text);
  return hash.text();
}

} // namespace asperity
