#include "input/reader/case_hash.hpp"

#include <boost/uuid/detail/sha1.hpp>
#include <fmt/format.h>

namespace asperity::cases {

std::string case_hash(const Case& read) {
  boost::uuids::detail::sha1 sha1;
  sha1.process_bytes(read.text.data(), read.text.size());
  boost::uuids::detail::sha1::digest_type digest = {};
  sha1.get_digest(digest);
  std::string text;
  for (const unsigned int word : digest)
    text += fmt::format("{:08x}", word);
  return text;
}

} // namespace asperity::cases
