#pragma once

// Inside results/ only: what of a file is refused before memory is taken for
// it or another file is opened because of it.

#include <cstddef>
#include <cstdint>
#include <string>

namespace asperity::results {

/// Largest text of an attribute or dataset [bytes], number of texts in a
/// dataset, children or attributes of a group.
inline constexpr std::size_t largest_text = 16 * 1024 * 1024;
inline constexpr std::size_t most_texts = 1'000'000;
inline constexpr std::size_t most_children = 100'000;

/// From now on the library follows no link to another file and loads no filter
/// from a folder: it calls both an error.
void forbid_other_files();

/// @throws Hdf5Error  the values of the dataset are in other files (a virtual
///         dataset, external storage)
void require_own_storage(std::int64_t dataset, const std::string& place);

/// Number of elements of a dataset or attribute.
/// @param space  its dataspace
/// @throws Hdf5Error  reading them into `bytes_each` takes more memory than is
///         available: with both numbers
std::size_t element_count(std::int64_t space, std::size_t bytes_each,
                          const std::string& place);

/// @throws Hdf5Error  the text is not UTF-8 without control characters, or is
///         longer than largest_text
void require_plain(const std::string& text, const std::string& place);

/// @throws Hdf5Error  the name of a method, table or column is not made
///         of 1 to 100 letters, digits and " . _ + -" (results.md)
void require_good_name(const std::string& name, const std::string& place);

} // namespace asperity::results
