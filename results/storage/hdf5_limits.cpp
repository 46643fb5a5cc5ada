#include "results/storage/hdf5_limits.hpp"

#include "base/available_memory.hpp"
#include "base/plain_text.hpp"
#include "results/storage/hdf5_call.hpp"

#include <fmt/format.h>

namespace asperity::results {

void forbid_other_files() {
  if (H5Lis_registered(H5L_TYPE_EXTERNAL) > 0)
    H5Lunregister(H5L_TYPE_EXTERNAL);
  H5PLset_loading_state(0);
}

void require_own_storage(std::int64_t dataset, const std::string& place) {
  const Hdf5Handle creation(
      checked(H5Dget_create_plist(dataset), place, "inspect this dataset"),
      H5Pclose);
  if (H5Pget_layout(creation.id()) == H5D_VIRTUAL ||
      H5Pget_external_count(creation.id()) > 0)
    throw Hdf5Error(place +
                    ": stores its values in another file, which is not opened");
}

void require_stored_values(std::int64_t dataset, const std::string& place) {
  constexpr double best_packing = 1032.0; // of deflate, the only filter here
  constexpr double negligible = 16e6;     // [B]
  const Hdf5Handle space(H5Dget_space(dataset), H5Sclose);
  const Hdf5Handle type(H5Dget_type(dataset), H5Tclose);
  const hssize_t count = checked(H5Sget_simple_extent_npoints(space.id()),
                                 place, "determine the size of this dataset");
  const double declared =
      static_cast<double>(count) * static_cast<double>(H5Tget_size(type.id()));
  const hsize_t stored = H5Dget_storage_size(dataset);
  if (declared > best_packing * static_cast<double>(stored) + negligible)
    throw Hdf5Error(fmt::format("{}: has {} values, but the file stores only "
                                "{} bytes of them",
                                place, count, stored));
}

std::size_t element_count(std::int64_t space, std::size_t bytes_each,
                          const std::string& place) {
  const hssize_t count = checked(H5Sget_simple_extent_npoints(space), place,
                                 "determine the size of this dataset");
  const double bytes =
      static_cast<double>(count) * static_cast<double>(bytes_each);
  if (const std::string shortage = memory_shortage(bytes); !shortage.empty())
    throw Hdf5Error(
        fmt::format("{}: has {} values and {}", place, count, shortage));
  return static_cast<std::size_t>(count);
}

void require_plain(const std::string& text, const std::string& place) {
  if (text.size() > largest_text)
    throw Hdf5Error(fmt::format("{}: has {} bytes, but must have at most {}",
                                place, text.size(), largest_text));
  if (find_not_plain(text) != text.npos)
    throw Hdf5Error(
        fmt::format("{} = \"{}\", but must be UTF-8 text without control "
                    "characters",
                    place, printable(text)));
}

void require_good_name(const std::string& name, const std::string& place) {
  if (!is_good_name(name))
    throw Hdf5Error(fmt::format(
        "{}: the name \"{}\" must have 1 to {} characters, each of them a "
        "letter A-Z or a-z, a digit, a blank or one of . _ + -",
        place, printable(name), longest_name));
}

} // namespace asperity::results
