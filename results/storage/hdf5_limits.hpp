#pragma once

// This internal header of results/ checks the contents of a file before memory
// is allocated for them or another file is opened because of them.

#include <cstddef>
#include <cstdint>
#include <string>

namespace asperity::results {

/// Limits: the length of a text of an attribute or dataset [bytes], the number
/// of texts in a dataset, and the number of children or attributes of a group.
inline constexpr std::size_t largest_text = std::size_t{16} * 1024 * 1024;
inline constexpr std::size_t most_texts = 1'000'000;
inline constexpr std::size_t most_children = 100'000;

/// Configures the library so that it reports an error instead of following
/// links to other files or loading filter plugins.
void forbid_other_files();

/// Checks that a dataset stores its own values.
/// @throws Hdf5Error  its values are in other files (a virtual dataset or
///                    external storage)
void require_own_storage(std::int64_t dataset, const std::string& place);

/// Checks that a dataset stores the values that it declares, as far as the
/// number of its bytes says so: no packing makes them smaller than a
/// thousandth, and parts that were never written take none.
/// @throws Hdf5Error  it does not; the message gives both numbers
void require_stored_values(std::int64_t dataset, const std::string& place);

/// Returns the number of elements of a dataset or attribute.
/// @param space  its dataspace
/// @throws Hdf5Error  reading the elements with `bytes_each` would exceed the
///                    available memory; the message gives both numbers
std::size_t element_count(std::int64_t space, std::size_t bytes_each,
                          const std::string& place);

/// Checks a text.
/// @throws Hdf5Error  the text is not UTF-8, contains control characters or is
///                    longer than largest_text
void require_plain(const std::string& text, const std::string& place);

/// Checks the name of a method, table or column.
/// @throws Hdf5Error  the name does not consist of 1 to 100 letters, digits,
///                    blanks and the characters . _ + - (results.md)
void require_good_name(const std::string& name, const std::string& place);

} // namespace asperity::results
