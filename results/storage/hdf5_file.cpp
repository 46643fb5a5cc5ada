#include "results/storage/hdf5_file.hpp"

#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "results/storage/hdf5_call.hpp"

#include <cmath>
#include <limits>

namespace asperity::results {
namespace {

/// The library must not write at the end of the process: after a write that
/// failed, e.g. on a full disk, its exit handler crashes on what is left of
/// the file. Every file that is written is closed explicitly. The function has
/// an effect only before all others of the library.
[[maybe_unused]] const herr_t without_exit_handler = H5dont_atexit();

/// Returns creation properties of groups and files that preserve the order of
/// links and attributes, without times of creation, so that equal data have
/// equal bytes.
template <class SetAttributes>
Hdf5Handle ordered(hid_t kind, SetAttributes set_attributes) {
  Hdf5Handle properties(H5Pcreate(kind), H5Pclose);
  const unsigned tracked = H5P_CRT_ORDER_TRACKED | H5P_CRT_ORDER_INDEXED;
  H5Pset_link_creation_order(properties.id(), tracked);
  H5Pset_obj_track_times(properties.id(), false);
  set_attributes(properties.id(), tracked);
  return properties;
}

std::int64_t open_file(const std::filesystem::path& path, Hdf5File::Mode mode) {
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr); // errors are reported as
                                               // exceptions instead
  forbid_other_files();
  const Hdf5Handle access(H5Pcreate(H5P_FILE_ACCESS), H5Pclose);
  H5Pset_fclose_degree(access.id(), H5F_CLOSE_STRONG);
  if (mode != Hdf5File::Mode::create) {
    try {
      require_regular_file(path, std::numeric_limits<std::uintmax_t>::max());
    } catch (const FileError& error) {
      throw Hdf5Error(error.what());
    }
    return checked(
        H5Fopen(path.c_str(),
                mode == Hdf5File::Mode::read ? H5F_ACC_RDONLY : H5F_ACC_RDWR,
                access.id()),
        path.string(), "open this HDF5 file");
  }
  const Hdf5Handle creation =
      ordered(H5P_FILE_CREATE, H5Pset_attr_creation_order);
  return checked(
      H5Fcreate(path.c_str(), H5F_ACC_TRUNC, creation.id(), access.id()),
      path.string(), "create this HDF5 file");
}

extern "C" herr_t keep_innermost(unsigned depth, const H5E_error2_t* error,
                                 void* reason) {
  if (depth == 0 && error->desc != nullptr)
    *static_cast<std::string*>(reason) = error->desc;
  return 0;
}

/// Collects one name. Returns -1, which ends the iteration with an error, if
/// there are too many.
herr_t append_name(const char* name, void* names) {
  auto& list = *static_cast<std::vector<std::string>*>(names);
  list.emplace_back(name);
  return list.size() <= most_children ? 0 : -1;
}

extern "C" herr_t append_link_name(hid_t, const char* name, const H5L_info_t*,
                                   void* names) {
  return append_name(name, names);
}

extern "C" herr_t append_attribute_name(hid_t, const char* name,
                                        const H5A_info_t*, void* names) {
  return append_name(name, names);
}

/// Returns the index by which the links or attributes of a group are listed.
template <class GetOrder>
H5_index_t listing_index(hid_t group, GetOrder get_order) {
  const Hdf5Handle properties(H5Gget_create_plist(group), H5Pclose);
  unsigned order = 0;
  get_order(properties.id(), &order);
  return order & H5P_CRT_ORDER_TRACKED ? H5_INDEX_CRT_ORDER : H5_INDEX_NAME;
}

void write_attribute(hid_t group, const std::string& name, hid_t type,
                     const void* value, const std::string& place) {
  if (H5Aexists(group, name.c_str()) > 0)
    checked(H5Adelete(group, name.c_str()), place, "replace this attribute");
  const Hdf5Handle space(H5Screate(H5S_SCALAR), H5Sclose);
  const Hdf5Handle attribute(
      checked(H5Acreate2(group, name.c_str(), type, space.id(), H5P_DEFAULT,
                         H5P_DEFAULT),
              place, "create this attribute"),
      H5Aclose);
  checked(H5Awrite(attribute.id(), type, value), place, "write this attribute");
}

bool is_object(hid_t group, const std::string& name, H5I_type_t type) {
  const hid_t id = H5Oopen(group, name.c_str(), H5P_DEFAULT);
  if (id < 0) {
    H5Eclear2(H5E_DEFAULT);
    return false;
  }
  const Hdf5Handle object(id, H5Oclose);
  return H5Iget_type(id) == type;
}

} // namespace

std::recursive_mutex& hdf5_mutex() {
  static std::recursive_mutex mutex;
  return mutex;
}

std::string hdf5_version() {
  unsigned major = 0;
  unsigned minor = 0;
  unsigned release = 0;
  H5get_libversion(&major, &minor, &release);
  return fmt::format("{}.{}.{}", major, minor, release);
}

namespace {

/// Returns the system's words in a reason such as "file write failed: time =
/// ..., error message = 'File too large', buf = ...", which has several lines.
std::string without_details(const std::string& reason) {
  constexpr std::string_view before = "error message = '";
  const std::size_t found = reason.find(before);
  if (found == std::string::npos)
    return reason.substr(0, reason.find('\n'));
  const std::size_t begin = found + before.size();
  return reason.substr(begin, reason.find('\'', begin) - begin);
}

} // namespace

void refuse_hdf5(const std::string& place, const std::string& what) {
  std::string reason;
  H5Ewalk2(H5E_DEFAULT, H5E_WALK_UPWARD, keep_innermost, &reason);
  H5Eclear2(H5E_DEFAULT);
  reason = without_details(reason);
  throw Hdf5Error(place + ": cannot " + what +
                  (reason.empty() ? "" : ": " + reason));
}

Hdf5Handle text_type() {
  Hdf5Handle type(H5Tcopy(H5T_C_S1), H5Tclose);
  H5Tset_size(type.id(), H5T_VARIABLE);
  H5Tset_cset(type.id(), H5T_CSET_UTF8);
  return type;
}

bool Hdf5Group::has(const std::string& name) const {
  return H5Lexists(handle_.id(), name.c_str(), H5P_DEFAULT) > 0;
}

bool Hdf5Group::is_group(const std::string& name) const {
  return is_object(handle_.id(), name, H5I_GROUP);
}

bool Hdf5Group::is_dataset(const std::string& name) const {
  return is_object(handle_.id(), name, H5I_DATASET);
}

Hdf5Group Hdf5Group::open(const std::string& name) const {
  return {Hdf5Handle(checked(H5Gopen2(handle_.id(), name.c_str(), H5P_DEFAULT),
                             place(name), "open this group"),
                     H5Gclose),
          place(name)};
}

Hdf5Group Hdf5Group::open_path(std::string_view path) const {
  Hdf5Group group = open(".");
  group.place_ = place_;
  while (!path.empty()) {
    const std::size_t end = std::min(path.find('/'), path.size());
    if (end > 0)
      group = group.open(std::string(path.substr(0, end)));
    path.remove_prefix(std::min(path.size(), end + 1));
  }
  return group;
}

std::string Hdf5Group::path() const {
  const auto length =
      checked(H5Iget_name(handle_.id(), nullptr, 0), place_, "find its path");
  std::string path(static_cast<std::size_t>(length), ' ');
  H5Iget_name(handle_.id(), path.data(), path.size() + 1);
  return path;
}

Hdf5Group Hdf5Group::open_or_create(const std::string& name) {
  if (has(name))
    return open(name);
  const Hdf5Handle creation =
      ordered(H5P_GROUP_CREATE, H5Pset_attr_creation_order);
  return {Hdf5Handle(checked(H5Gcreate2(handle_.id(), name.c_str(), H5P_DEFAULT,
                                        creation.id(), H5P_DEFAULT),
                             place(name), "create this group"),
                     H5Gclose),
          place(name)};
}

std::vector<std::string> Hdf5Group::children() const {
  const Hdf5Handle group(H5Gopen2(handle_.id(), ".", H5P_DEFAULT), H5Gclose);
  std::vector<std::string> names;
  checked(H5Literate(group.id(),
                     listing_index(group.id(), H5Pget_link_creation_order),
                     H5_ITER_INC, nullptr, append_link_name, &names),
          place(), "list this group");
  return names;
}

std::vector<std::string> Hdf5Group::attributes() const {
  const Hdf5Handle group(H5Gopen2(handle_.id(), ".", H5P_DEFAULT), H5Gclose);
  std::vector<std::string> names;
  checked(H5Aiterate2(group.id(),
                      listing_index(group.id(), H5Pget_attr_creation_order),
                      H5_ITER_INC, nullptr, append_attribute_name, &names),
          place(), "list the attributes");
  return names;
}

void Hdf5Group::remove(const std::string& name) {
  checked(H5Ldelete(handle_.id(), name.c_str(), H5P_DEFAULT), place(name),
          "remove this");
}

bool Hdf5Group::has_attribute(const std::string& name) const {
  return H5Aexists(handle_.id(), name.c_str()) > 0;
}

void Hdf5Group::set_attribute(const std::string& name,
                              const std::string& text) {
  const std::string plain = plain_text(text); // no other is read
  const char* characters = plain.c_str();
  write_attribute(handle_.id(), name, text_type().id(), &characters,
                  place(name));
}

void Hdf5Group::set_attribute(const std::string& name, double number) {
  write_attribute(handle_.id(), name, H5T_NATIVE_DOUBLE, &number, place(name));
}

void Hdf5Group::set_attribute(const std::string& name, int number) {
  write_attribute(handle_.id(), name, H5T_NATIVE_INT, &number, place(name));
}

std::string Hdf5Group::text_attribute(const std::string& name) const {
  const Hdf5Handle attribute(
      checked(H5Aopen(handle_.id(), name.c_str(), H5P_DEFAULT), place(name),
              "find this attribute"),
      H5Aclose);
  const Hdf5Handle type(H5Aget_type(attribute.id()), H5Tclose);
  if (H5Tget_class(type.id()) != H5T_STRING)
    return fmt::format("{}", number_attribute(name));
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.id()) > 1)
    refuse_hdf5(place(name), "read this attribute as one text");
  const auto texts = read_texts(
      type.id(), space.id(), place(name), [&](hid_t memory, void* buffer) {
        checked(H5Aread(attribute.id(), memory, buffer), place(name),
                "read this attribute");
      });
  return texts.empty() ? "" : texts.front();
}

double Hdf5Group::number_attribute(const std::string& name) const {
  const Hdf5Handle attribute(
      checked(H5Aopen(handle_.id(), name.c_str(), H5P_DEFAULT), place(name),
              "find this attribute"),
      H5Aclose);
  const Hdf5Handle space(H5Aget_space(attribute.id()), H5Sclose);
  if (H5Sget_simple_extent_npoints(space.id()) != 1)
    refuse_hdf5(place(name), "read this attribute as one number");
  double number = 0.0;
  checked(H5Aread(attribute.id(), H5T_NATIVE_DOUBLE, &number), place(name),
          "read this attribute as a number");
  return number;
}

std::string Hdf5Group::place(const std::string& name) const {
  const bool is_root = place_.ends_with(": /");
  return name.empty() ? place_ : place_ + (is_root ? "" : "/") + name;
}

Hdf5File::Hdf5File(const std::filesystem::path& path, Mode mode)
    : Hdf5Group(Hdf5Handle(open_file(path, mode), H5Fclose),
                path.string() + ": /") {}

void Hdf5File::close() {
  if (!handle_.reset())
    refuse_hdf5(place_, "write this file");
}

} // namespace asperity::results
