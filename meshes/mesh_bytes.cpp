#include "meshes/mesh_bytes.hpp"

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <type_traits>

namespace asperity::meshes {
namespace {

/// Appends the bytes of each value that it is called with.
class Writer {
public:
  template <class Value>
  void operator()(const Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(Value));
  }

  template <class Value>
  void operator()(const std::vector<Value>& values) {
    (*this)(std::uint64_t{values.size()});
    for (const Value& value : values)
      (*this)(value);
  }

  void operator()(const std::string& text) {
    (*this)(std::vector<char>(text.begin(), text.end()));
  }

  std::string bytes;
};

/// Fills each value that it is called with, in the order of the writer.
class Reader {
public:
  explicit Reader(std::string_view bytes) : left(bytes) {}

  template <class Value>
  void operator()(Value& value) {
    static_assert(std::is_trivially_copyable_v<Value>);
    if (left.size() < sizeof(Value))
      throw std::runtime_error(
          "the mesh received from another process is truncated");
    std::memcpy(&value, left.data(), sizeof(Value));
    left.remove_prefix(sizeof(Value));
  }

  template <class Value>
  void operator()(std::vector<Value>& values) {
    std::uint64_t size = 0;
    (*this)(size);
    if (size > left.size()) // no value is smaller than a byte
      throw std::runtime_error(
          "the mesh received from another process is truncated");
    values.resize(size);
    for (Value& value : values)
      (*this)(value);
  }

  void operator()(std::string& text) {
    std::vector<char> letters;
    (*this)(letters);
    text.assign(letters.begin(), letters.end());
  }

  std::string_view left;
};

/// Calls `visit` with each member.
template <class Mesh, class Visit>
void each_member(Mesh& mesh, Visit& visit) {
  visit(mesh.shape);
  visit(mesh.vertices);
  visit(mesh.cells);
  visit(mesh.cell_group);
  visit(mesh.group_names);
  visit(mesh.faces);
  visit(mesh.refine_below);
  visit(mesh.length_x);
  visit(mesh.length_y);
  visit(mesh.depth);
}

} // namespace

std::string bytes_of(const BlockMesh& mesh) {
  Writer writer;
  each_member(mesh, writer);
  return std::move(writer.bytes);
}

BlockMesh mesh_of_bytes(std::string_view bytes) {
  Reader reader(bytes);
  BlockMesh mesh;
  each_member(mesh, reader);
  if (!reader.left.empty())
    throw std::runtime_error(
        "the mesh received from another process has trailing bytes");
  return mesh;
}

} // namespace asperity::meshes
