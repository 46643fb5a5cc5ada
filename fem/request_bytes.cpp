#include "fem/request_bytes.hpp"

#include "meshes/mesh_bytes.hpp"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <optional>
#include <type_traits>
#include <utility>
#include <vector>

namespace asperity::fem {
namespace {

using Json = nlohmann::json;

/// The members of each structure, in the order of its declaration. A structured
/// binding does not compile if a member is missing here.
template <typename Archive>
void pass(Archive& archive, mechanics::Quantity& quantity) {
  auto& [value, unit] = quantity;
  archive(value, unit);
}

template <typename Archive>
void pass(Archive& archive, mechanics::BodyModuli& moduli) {
  auto& [youngs_modulus, poisson_ratio] = moduli;
  archive(youngs_modulus, poisson_ratio);
}

template <typename Archive>
void pass(Archive& archive, mechanics::MaterialLayer& layer) {
  auto& [thickness, moduli] = layer;
  archive(thickness, moduli);
}

template <typename Archive>
void pass(Archive& archive, mechanics::MaterialInclusion& inclusion) {
  auto& [radius, depth, moduli] = inclusion;
  archive(radius, depth, moduli);
}

template <typename Archive>
void pass(Archive& archive, mechanics::MaterialVariation& variation) {
  auto& [kind, factor, spread, seed, edge, file] = variation;
  archive(kind, factor, spread, seed, edge, file);
}

template <typename Archive>
void pass(Archive& archive, mechanics::MaterialSpec& material) {
  auto& [modulus, ratio, counter, layers, inclusion, variation] = material;
  archive(modulus, ratio, counter, layers, inclusion, variation);
}

template <typename Archive>
void pass(Archive& archive, mechanics::CounterMeshSpec& counter) {
  auto& [shape, radius, height, size_at_contact, size_far, fine_radius,
         offset_x, offset_y] = counter;
  archive(shape, radius, height, size_at_contact, size_far, fine_radius,
          offset_x, offset_y);
}

template <typename Archive>
void pass(Archive& archive, mechanics::MeshSpec& mesh) {
  auto& [kind, cells_a_level, halvings, moduli_ratio, interface_halvings,
         geometry, cells, size_at_contact, size_far, fine_radius, file,
         file_unit, allow_commands, counter] = mesh;
  archive(kind, cells_a_level, halvings, moduli_ratio, interface_halvings,
          geometry, cells, size_at_contact, size_far, fine_radius, file,
          file_unit, allow_commands, counter);
}

template <typename Archive>
void pass(Archive& archive, mechanics::BlockSettings& settings) {
  auto& [element, surface_cell_depth, growth, depth, far_boundary] = settings;
  archive(element, surface_cell_depth, growth, depth, far_boundary);
}

template <typename Archive>
void pass(Archive& archive, mechanics::FullBlockSettings& settings) {
  auto& [sides, linear_solver, contact_at, height_interpolation, uses_case_mesh,
         bodies, has_stiffness] = settings;
  archive(sides, linear_solver, contact_at, height_interpolation,
          uses_case_mesh, bodies, has_stiffness);
}

template <typename Archive>
void pass(Archive& archive, mechanics::Scales& scales) {
  auto& [contact_modulus, length, spacing, rms_height, rms_slope] = scales;
  archive(contact_modulus, length, spacing, rms_height, rms_slope);
}

template <typename Archive>
void pass(Archive& archive, Grid& grid) {
  auto& [points_x, points_y, length_x, length_y] = grid;
  archive(points_x, points_y, length_x, length_y);
}

template <typename Archive>
void pass(Archive& archive, FullRequest& request) {
  auto& [grid, block, full, material, mesh, scales, file_mesh] = request;
  archive(grid, block, full, material, mesh, scales);
}

template <typename Archive>
void pass(Archive& archive, BlockRequest& request) {
  auto& [grid, settings, scales, youngs_modulus, poisson_ratio, threads, cache,
         layers] = request;
  archive(grid, settings, scales, youngs_modulus, poisson_ratio, layers);
}

/// Takes structures apart to numbers and texts in one list, or puts them
/// together again from such a list.
class RequestArchive {
public:
  /// Writes, to an empty list.
  RequestArchive() = default;

  /// Reads.
  explicit RequestArchive(Json list)
      : list_(std::move(list)), is_reading_(true) {}

  template <typename... Values>
  void operator()(Values&... values) {
    (item(values), ...);
  }

  const Json& list() const { return list_; }

private:
  template <typename Value>
  void item(Value& value) {
    if constexpr (std::is_enum_v<Value>) {
      int number = static_cast<int>(value);
      scalar(number);
      value = static_cast<Value>(number);
    } else if constexpr (std::is_arithmetic_v<Value> ||
                         std::is_same_v<Value, std::string>) {
      scalar(value);
    } else {
      pass(*this, value);
    }
  }

  template <typename Value>
  void item(std::optional<Value>& value) {
    bool has_value = value.has_value();
    scalar(has_value);
    if (is_reading_ && has_value)
      value.emplace();
    if (has_value)
      item(*value);
  }

  template <typename Value>
  void item(std::vector<Value>& values) {
    std::size_t size = values.size();
    scalar(size);
    values.resize(size);
    for (Value& value : values)
      item(value);
  }

  template <typename Value>
  void scalar(Value& value) {
    if (is_reading_)
      value = list_.at(next_++).get<Value>();
    else
      list_.push_back(value);
  }

  Json list_ = Json::array();
  bool is_reading_ = false;
  std::size_t next_ = 0; ///< index of the next value to read
};

} // namespace

std::string bytes_of(FullRequest request, const meshes::BlockMesh& mesh) {
  RequestArchive archive;
  archive(request);
  const std::string bytes = meshes::bytes_of(mesh);
  // CBOR, because the mesh is binary data.
  std::string text;
  Json::to_cbor(Json{{"request", archive.list()},
                     {"mesh", Json::binary({bytes.begin(), bytes.end()})}},
                text);
  return text;
}

MeshedRequest request_of_bytes(std::string_view bytes) {
  const Json json = Json::from_cbor(bytes);
  RequestArchive archive(json.at("request"));
  MeshedRequest meshed;
  archive(meshed.request);
  const auto& mesh = json.at("mesh").get_binary();
  meshed.mesh = meshes::mesh_of_bytes(
      {reinterpret_cast<const char*>(mesh.data()), mesh.size()});
  return meshed;
}

std::string text_of(BlockRequest request) {
  RequestArchive archive;
  archive(request);
  return archive.list().dump();
}

BlockRequest block_request_of(const std::string& text) {
  RequestArchive archive(Json::parse(text));
  BlockRequest request;
  archive(request);
  return request;
}

} // namespace asperity::fem
