#include "surfaces/formats/gwyddion_file.hpp"

#include <bit>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>

namespace asperity::surfaces {
namespace {

static_assert(std::endian::native == std::endian::little);

template <class Number>
std::string bytes_of(Number number) {
  std::string bytes(sizeof(number), '\0');
  std::memcpy(bytes.data(), &number, sizeof(number));
  return bytes;
}

/// An object of the format: a type and named components, each preceded by the
/// letter of its own type.
class GwyObject {
public:
  explicit GwyObject(std::string type) : type_(std::move(type)) {}

  GwyObject& add(const std::string& name, std::int32_t number) {
    return add(name, 'i', bytes_of(number));
  }

  GwyObject& add(const std::string& name, double number) {
    return add(name, 'd', bytes_of(number));
  }

  GwyObject& add(const std::string& name, const std::string& text) {
    return add(name, 's', text + '\0');
  }

  GwyObject& add(const std::string& name, const GwyObject& object) {
    return add(name, 'o', object.bytes());
  }

  GwyObject& add(const std::string& name, std::span<const double> numbers) {
    std::string bytes(numbers.size_bytes(), '\0');
    std::memcpy(bytes.data(), numbers.data(), bytes.size());
    return add(name, 'D',
               bytes_of(static_cast<std::uint32_t>(numbers.size())) + bytes);
  }

  std::string bytes() const {
    return type_ + '\0' +
           bytes_of(static_cast<std::uint32_t>(components_.size())) +
           components_;
  }

private:
  GwyObject& add(const std::string& name, char type, const std::string& value) {
    components_ += name + '\0' + type + value;
    return *this;
  }

  std::string type_;
  std::string components_;
};

} // namespace

std::string gwyddion_bytes(const HeightMap& map, const std::string& title,
                           const std::string& unit) {
  GwyObject metres("GwySIUnit"), values("GwySIUnit");
  metres.add("unitstr", std::string("m"));
  values.add("unitstr", unit);
  GwyObject field("GwyDataField");
  field.add("xres", map.grid.points_x)
      .add("yres", map.grid.points_y)
      .add("xreal", map.grid.length_x)
      .add("yreal", map.grid.length_y)
      .add("xoff", 0.0)
      .add("yoff", 0.0)
      .add("si_unit_xy", metres)
      .add("si_unit_z", values)
      .add("data", std::span<const double>(map.heights));
  GwyObject container("GwyContainer");
  container.add("/0/data", field).add("/0/data/title", title);
  return "GWYP" + container.bytes();
}

} // namespace asperity::surfaces
