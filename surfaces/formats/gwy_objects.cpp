#include "surfaces/formats/gwy_objects.hpp"

#include "base/plain_text.hpp"
#include "surfaces/formats/byte_reader.hpp"

#include <charconv>
#include <cstdint>
#include <vector>

namespace asperity::surfaces {
namespace {

/// A named, typed component of an object. The bytes of the value exclude the
/// count of an array; those of an object are its whole serialised form.
struct GwyComponent {
  std::string_view name;
  char type = ' ';
  std::string_view value;
  std::size_t offset = 0; ///< of the value in the file
};

/// Size of one element of the types that have a fixed size, else 0.
std::size_t element_size(char type) {
  switch (type) {
  case 'b':
  case 'c':
  case 'C':
    return 1;
  case 'i':
  case 'I':
    return 4;
  case 'q':
  case 'd':
  case 'Q':
  case 'D':
    return 8;
  default:
    return 0;
  }
}

/// Skips a serialised object: its type, size and content.
void skip_object(ByteReader& bytes) {
  bytes.take_text();
  bytes.take_bytes(bytes.take<std::uint32_t>());
}

std::string_view take_array(ByteReader& bytes, char type) {
  const auto count = bytes.take<std::uint32_t>();
  if (const std::size_t size = element_size(type); size > 0)
    return bytes.take_bytes(count * size);
  for (std::uint32_t i = 0; i < count; ++i)
    if (type == 'S')
      bytes.take_text();
    else
      skip_object(bytes);
  return {};
}

/// The components of one object, in the order of the file.
class GwyComponents {
public:
  /// Reads the type and the size of the object.
  explicit GwyComponents(ByteReader bytes)
      : type_(bytes.take_text()), bytes_(content_of(bytes)) {}

  std::string_view type() const { return type_; }

  std::optional<GwyComponent> next() {
    if (bytes_.is_at_end())
      return std::nullopt;
    GwyComponent component;
    component.name = bytes_.take_text();
    component.type = bytes_.take<char>();
    component.offset = bytes_.offset();
    component.value = take_value(component.type);
    return component;
  }

  const ByteReader& bytes() const { return bytes_; }

private:
  static ByteReader content_of(ByteReader& bytes) {
    const auto size = bytes.take<std::uint32_t>();
    const std::size_t begin = bytes.offset();
    return ByteReader(bytes.take_bytes(size), bytes.name(), begin);
  }

  std::string_view take_value(char type) {
    if (type == 's')
      return bytes_.take_text();
    if (type == 'o') {
      ByteReader ahead = bytes_;
      skip_object(ahead);
      return bytes_.take_bytes(ahead.offset() - bytes_.offset());
    }
    if (std::string_view("CIQDSO").find(type) != std::string_view::npos)
      return take_array(bytes_, type);
    const std::size_t size = element_size(type);
    if (size == 0)
      bytes_.refuse(fmt::format("a component of the unknown type '{}'",
                                printable(std::string_view(&type, 1))));
    return bytes_.take_bytes(size);
  }

  std::string_view type_;
  ByteReader bytes_;
};

template <class Number>
Number number_in(const GwyComponent& component) {
  Number number{};
  std::memcpy(&number, component.value.data(), sizeof(Number));
  return number;
}

ByteReader reader_of(const GwyComponent& component, const std::string& name) {
  return ByteReader(component.value, name, component.offset);
}

std::string unit_in(const GwyComponent& component, const std::string& name) {
  GwyComponents unit(reader_of(component, name));
  while (const auto part = unit.next())
    if (part->name == "unitstr" && part->type == 's')
      return std::string(part->value);
  return "";
}

void take_field_part(GwyField& field, const GwyComponent& part,
                     const std::string& name) {
  if (part.name == "xres" && part.type == 'i')
    field.points_x = number_in<std::int32_t>(part);
  else if (part.name == "yres" && part.type == 'i')
    field.points_y = number_in<std::int32_t>(part);
  else if (part.name == "xreal" && part.type == 'd')
    field.length_x = number_in<double>(part);
  else if (part.name == "yreal" && part.type == 'd')
    field.length_y = number_in<double>(part);
  else if (part.name == "si_unit_xy" && part.type == 'o')
    field.unit_xy = unit_in(part, name);
  else if (part.name == "si_unit_z" && part.type == 'o')
    field.unit_z = unit_in(part, name);
  else if (part.name == "data" && part.type == 'D')
    field.values = part.value;
}

/// The field of a component; empty if it is another object.
std::optional<GwyField> field_in(const GwyComponent& component,
                                 const std::string& name) {
  GwyComponents parts(reader_of(component, name));
  if (parts.type() != "GwyDataField")
    return std::nullopt;
  GwyField field;
  while (const auto part = parts.next())
    take_field_part(field, *part, name);
  const std::size_t count = field.values.size() / sizeof(double);
  if (field.points_x < 1 || field.points_y < 1 ||
      static_cast<std::size_t>(field.points_x) *
              static_cast<std::size_t>(field.points_y) !=
          count)
    throw input::InputError(fmt::format(
        "{}: byte {}: the field {} has {} x {} points, but {} values", name,
        component.offset, printable(component.name), field.points_x,
        field.points_y, count));
  return field;
}

/// Splits "/12/data" into 12 and "data"; empty for other names.
std::optional<std::pair<int, std::string_view>>
channel_key(std::string_view name) {
  if (!name.starts_with('/'))
    return std::nullopt;
  int number = 0;
  const char* const end = name.data() + name.size();
  const auto [stop, error] = std::from_chars(name.data() + 1, end, number);
  if (error != std::errc() || stop == end || *stop != '/')
    return std::nullopt;
  return std::pair(number, std::string_view(stop + 1, end));
}

} // namespace

std::map<int, GwyChannel> read_gwy_channels(std::string_view bytes,
                                            const std::string& name) {
  ByteReader reader(bytes, name);
  reader.take_bytes(4); // GWYP, which has been recognised
  GwyComponents container(reader);
  std::map<int, GwyChannel> channels;
  while (const auto component = container.next()) {
    const auto key = channel_key(component->name);
    if (!key)
      continue;
    const auto& [number, part] = *key;
    if (part == "data" && component->type == 'o')
      channels[number].field = field_in(*component, name);
    else if (part == "mask" && component->type == 'o')
      channels[number].mask = field_in(*component, name);
    else if (part == "data/title" && component->type == 's')
      channels[number].title = component->value;
  }
  std::erase_if(channels,
                [](const auto& entry) { return !entry.second.field; });
  return channels;
}

} // namespace asperity::surfaces
