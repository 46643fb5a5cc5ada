#pragma once

// This internal header of results/ provides the error handling of calls to the
// HDF5 library for the source files of hdf5_file.hpp.

#include "results/storage/hdf5_file.hpp"
#include "results/storage/hdf5_limits.hpp"

#include <fmt/format.h>
#include <hdf5.h>

namespace asperity::results {

/// Throws the exception of a failed call.
/// @throws Hdf5Error "place: cannot <what>: the library's innermost reason"
[[noreturn]] void refuse_hdf5(const std::string& place,
                              const std::string& what);

/// Returns the `result` of a call, or throws if it is negative, by which the
/// library indicates a failure.
template <class Result>
Result checked(Result result, const std::string& place,
               const std::string& what) {
  if (result < 0)
    refuse_hdf5(place, what);
  return result;
}

/// Returns a memory or file type for UTF-8 text of variable length.
Hdf5Handle text_type();

/// Reads the texts of an attribute or dataset of the given `type` and `space`,
/// of variable or fixed length. `read(memory type, buffer)` performs the read.
/// @throws Hdf5Error  the texts exceed a limit of hdf5_limits.hpp
template <class Read>
std::vector<std::string> read_texts(hid_t type, hid_t space,
                                    const std::string& place, Read read) {
  const std::size_t length = H5Tget_size(type);
  const std::size_t n_texts =
      element_count(space, length + sizeof(std::string), place);
  if (n_texts > most_texts || length > largest_text)
    throw Hdf5Error(fmt::format(
        "{}: has {} texts of {} bytes, but must have at most {} of at most {}",
        place, n_texts, length, most_texts, largest_text));
  std::vector<std::string> texts(n_texts);
  if (H5Tis_variable_str(type) > 0) {
    std::vector<char*> buffer(n_texts, nullptr);
    read(type, buffer.data());
    for (std::size_t i = 0; i < n_texts; ++i)
      texts[i] = buffer[i] == nullptr ? "" : buffer[i];
    H5Dvlen_reclaim(type, space, H5P_DEFAULT, buffer.data());
    for (const std::string& text : texts)
      require_plain(text, place);
    return texts;
  }
  std::string buffer(n_texts * length, '\0');
  read(type, buffer.data());
  const bool is_padded = H5Tget_strpad(type) == H5T_STR_SPACEPAD;
  for (std::size_t i = 0; i < n_texts; ++i) {
    const std::string text = buffer.substr(i * length, length);
    const auto end =
        is_padded ? text.find_last_not_of(' ') + 1 : text.find('\0');
    texts[i] = text.substr(0, end);
    require_plain(texts[i], place);
  }
  return texts;
}

} // namespace asperity::results
