// Tests of base/content_hash.hpp: published digests.
#include "base/content_hash.hpp"

#include <gtest/gtest.h>

namespace asperity::content_hash_test {

// Verifies the digests of the three bytes "abc": FIPS 180-2, B.1, and RFC 1321,
// A.5.
TEST(ContentHash, IsThatOfTheStandards) {
  EXPECT_EQ(content_hash("abc"), "ba7816bf8f01cfea414140de5dae2223"
                                 "b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(md5_hash("abc"), "900150983cd24fb0d6963f7d28e17f72");
}

TEST(ContentHash, OfPiecesIsThatOfTheWhole) {
  ContentHash hash;
  EXPECT_EQ(hash.text(), content_hash(""));
  hash.add("a");
  EXPECT_EQ(hash.text(), content_hash("a"));
  hash.add("bc");
  EXPECT_EQ(hash.text(), content_hash("abc"));
}

} // namespace asperity::content_hash_test
