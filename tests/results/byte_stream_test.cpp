// Tests of results/storage/byte_stream.hpp.
#include "results/storage/byte_stream.hpp"

#include <gtest/gtest.h>

#include <string>
#include <string_view>
#include <vector>

namespace asperity::results::byte_stream_test {

/// Writes one item and expects it to be read back, also if nothing follows it,
/// and to be refused if a byte is missing.
template <class Item>
void expect_exact_length(const Item& item,
                         void (ByteWriter::*write)(const Item&),
                         void (ByteReader::*read)(Item&)) {
  ByteWriter writer;
  (writer.*write)(item);
  const std::string bytes = writer.take();

  ByteReader reader(bytes);
  Item found;
  (reader.*read)(found);

  EXPECT_EQ(found, item);
  EXPECT_TRUE(reader.is_at_end());
  for (std::size_t length = 0; length < bytes.size(); ++length) {
    ByteReader cut(std::string_view(bytes).substr(0, length));
    EXPECT_THROW((cut.*read)(found), input::InputError) << length;
  }
}

TEST(ByteStream, EndsWithItsLastItem) {
  expect_exact_length<std::string>("three", &ByteWriter::text,
                                   &ByteReader::text);
  expect_exact_length<std::vector<double>>(
      {1.5, 2.5, 3.5}, &ByteWriter::numbers, &ByteReader::numbers);
  expect_exact_length<std::vector<double>>({1.5, 2.5, 3.5},
                                           &ByteWriter::single_numbers,
                                           &ByteReader::single_numbers);
}

} // namespace asperity::results::byte_stream_test
