#pragma once

#include <memory>
#include <string>
#include <string_view>

namespace asperity {

/// SHA-256 of a text, as 64 hexadecimal digits.
std::string content_hash(std::string_view text);

enum class HashMethod { sha256, md5 };

/// The same of bytes that come in pieces.
class ContentHash {
public:
  explicit ContentHash(HashMethod method = HashMethod::sha256);
  ~ContentHash();
  ContentHash(const ContentHash&) = delete;
  ContentHash& operator=(const ContentHash&) = delete;

  void add(std::string_view bytes);

  /// The digits of all bytes so far.
  std::string text() const;

private:
  struct State;
  std::unique_ptr<State> state_;
};

/// MD5 of a text, as 32 hexadecimal digits: for file formats that prescribe it,
/// not for security.
std::string md5_hash(std::string_view text);

} // namespace asperity
