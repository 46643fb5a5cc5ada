#pragma once

// Inside results/ only: how the two sources of hdf5_file.hpp call the library.

#include "results/storage/hdf5_file.hpp"
#include "results/storage/hdf5_limits.hpp"

#include <fmt/format.h>
#include <hdf5.h>

namespace asperity::results {

/// @throws Hdf5Error "place: cannot <what>: the library's innermost reason"
[[noreturn]] void refuse_hdf5(const std::string& place,
                              const std::string& what);

/// `result` of a call, unless it is negative, which is the library's "failed".
template <class Result>
Result checked(Result result, const std::string& place,
               const std::string& what) {
  if (result < 0)
    refuse_hdf5(place, what);
  return result;
}

/// A memory type or file type for UTF-8 text of any length.
Hdf5Handle text_type();

/// The texts of an attribute or dataset of the file's `type` on `space`,
/// whether of any or of fixed length. `read(memory type, buffer)` reads it.
/// @throws Hdf5Error  they break a limit of hdf5_limits.hpp
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
