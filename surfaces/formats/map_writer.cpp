#include "surfaces/formats/map_writer.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "results/storage/hdf5_file.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/formats/zip_archive.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <cstring>
#include <iterator>
#include <mutex>
#include <span>
#include <system_error>
#include <utility>

namespace asperity::surfaces {
namespace {

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

/// The heights as little-endian numbers.
std::string bytes_of_heights(const HeightMap& map) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes(map.heights.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), map.heights.data(), bytes.size());
  return bytes;
}

/// main.xml of an X3P file; the schema prescribes the order of the records and
/// of their entries.
std::string x3p_document(const Grid& grid, const std::string& point_sum) {
  const auto axis = [](const char* name, double increment) {
    return fmt::format("<{0}><AxisType>I</AxisType><DataType>D</DataType>"
                       "<Increment>{1:.17g}</Increment><Offset>0</Offset>"
                       "</{0}>\n",
                       name, increment);
  };
  return fmt::format(
      "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"no\"?>\n"
      "<p:ISO5436_2 xmlns:p=\"http://www.opengps.eu/2008/ISO5436_2\">\n"
      "<Record1>\n<Revision>ISO5436 - 2000</Revision>\n"
      "<FeatureType>SUR</FeatureType>\n<Axes>\n{}{}"
      "<CZ><AxisType>A</AxisType><DataType>D</DataType></CZ>\n"
      "</Axes>\n</Record1>\n"
      "<Record3>\n<MatrixDimension><SizeX>{}</SizeX><SizeY>{}</SizeY>"
      "<SizeZ>1</SizeZ></MatrixDimension>\n"
      "<DataLink><PointDataLink>bindata/data.bin</PointDataLink>"
      "<MD5ChecksumPointData>{}</MD5ChecksumPointData></DataLink>\n"
      "</Record3>\n"
      "<Record4><ChecksumFile>md5checksum.hex</ChecksumFile></Record4>\n"
      "</p:ISO5436_2>\n",
      axis("CX", grid.spacing_x()), axis("CY", grid.spacing_y()), grid.points_x,
      grid.points_y, point_sum);
}

std::string x3p_bytes(const HeightMap& map) {
  const std::string heights = bytes_of_heights(map);
  const std::string document = x3p_document(map.grid, md5_hash(heights));
  return zip_bytes({{"main.xml", document},
                    {"bindata/data.bin", heights},
                    {"md5checksum.hex", md5_hash(document) + " *main.xml\n"}});
}

/// Writes beside the target and renames, because the library writes the file
/// by itself.
void write_hdf5(const std::filesystem::path& path, const HeightMap& map,
                const std::string& title, const MapQuantity& quantity) {
  const std::filesystem::path temporary = temporary_beside(path);
  try {
    const std::lock_guard lock(results::hdf5_mutex());
    results::Hdf5File file(temporary, results::Hdf5File::Mode::create);
    file.write_map(quantity.name, map.heights,
                   {static_cast<std::size_t>(map.grid.points_y),
                    static_cast<std::size_t>(map.grid.points_x)},
                   results::Hdf5Number::float64, quantity.unit);
    {
      results::Hdf5Group heights = file.open_dataset(quantity.name);
      heights.set_attribute("length", map.grid.length_x);
      heights.set_attribute("length_y", map.grid.length_y);
      heights.set_attribute("title", title);
    }
    file.close();
    std::filesystem::rename(temporary, path);
  } catch (...) {
    std::error_code ignored;
    std::filesystem::remove(temporary, ignored);
    throw;
  }
}

} // namespace

std::string written_map_endings() {
  return ".npy, .h5, .gwy, .txt, .x3p";
}

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

std::string gwyddion_text(const HeightMap& map, const std::string& title,
                          const std::string& unit) {
  std::string text =
      fmt::format("# Channel: {}\n# Width: {} m\n"
                  "# Height: {} m\n# Value units: {}\n",
                  printable(title), map.grid.length_x, map.grid.length_y, unit);
  const auto columns = static_cast<std::size_t>(map.grid.points_x);
  for (std::size_t i = 0; i < map.heights.size(); ++i)
    text += fmt::format("{}{}", map.heights[i],
                        (i + 1) % columns == 0 ? '\n' : '\t');
  return text;
}

void write_map(const std::filesystem::path& path, const HeightMap& map,
               const std::string& title, const MapQuantity& quantity) {
  const std::string ending = path.extension().string();
  if (ending == ".npy")
    write_file_atomically(
        path,
        npy_bytes(map.heights, static_cast<std::size_t>(map.grid.points_y),
                  static_cast<std::size_t>(map.grid.points_x)));
  else if (ending == ".h5")
    write_hdf5(path, map, title, quantity);
  else if (ending == ".gwy")
    write_file_atomically(path,
                          gwyddion_bytes(map, printable(title), quantity.unit));
  else if (ending == ".txt")
    write_file_atomically(path, gwyddion_text(map, title, quantity.unit));
  else if (ending == ".x3p" && quantity.unit != "m")
    throw input::InputError(fmt::format(
        "{}: X3P holds lengths only, but the {} is in {}; .gwy, .h5, .txt and "
        ".npy hold it",
        path.string(), quantity.name, quantity.unit));
  else if (ending == ".x3p")
    write_file_atomically(path, x3p_bytes(map));
  else
    throw input::InputError(
        fmt::format("{}: has the ending \"{}\", but a map can be written as {}",
                    path.string(), printable(ending), written_map_endings()));
}

} // namespace asperity::surfaces
