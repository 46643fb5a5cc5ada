#pragma once

// The description of a block as bytes, with which rank 0 lets the other ranks
// build it.

#include "fem/full_request.hpp"
#include "fem/plugin.hpp"

#include <string>
#include <string_view>

namespace asperity::fem {

/// A request and the mesh that rank 0 has generated for it.
struct MeshedRequest {
  FullRequest request;
  meshes::BlockMesh mesh;
};

/// Serialises a request and its mesh. All numbers are restored to the last bit.
std::string bytes_of(FullRequest request, const meshes::BlockMesh& mesh);

/// Restores the result of bytes_of().
MeshedRequest request_of_bytes(std::string_view bytes);

/// Serialises the request of a condensed block without its cache and threads.
/// All numbers are restored to the last bit.
std::string text_of(BlockRequest request);

/// Restores the result of text_of().
BlockRequest block_request_of(const std::string& text);

} // namespace asperity::fem
