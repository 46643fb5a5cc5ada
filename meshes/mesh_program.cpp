// The program asperity_mesh lets gmsh read or mesh a user's file in a process
// separate from the program that needs the mesh, so that the latter can limit
// its resources.
//
//     asperity_mesh FILE UNIT periodic|free OUTPUT
//
// It writes the bytes of mesh_bytes.hpp to OUTPUT. The exit codes are those of
// asperity.
#include "meshes/gmsh_file.hpp"
#include "meshes/mesh_bytes.hpp"

#include <cstdio>
#include <exception>
#include <fstream>
#include <stdexcept>
#include <string>

namespace asperity::meshes {
namespace {

int mesh_as_asked(char** words) {
  const mechanics::BlockSides sides = std::string(words[3]) == "periodic"
                                          ? mechanics::BlockSides::periodic
                                          : mechanics::BlockSides::free;
  const std::string bytes =
      bytes_of(gmsh_file(words[1], std::stod(words[2]), sides));
  std::ofstream output(words[4], std::ios::binary);
  output.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  output.close();
  if (!output)
    throw std::runtime_error(std::string("cannot write ") + words[4]);
  return 0;
}

} // namespace
} // namespace asperity::meshes

int main(int n_words, char** words) {
  if (n_words != 5) {
    std::fputs("usage: asperity_mesh FILE UNIT periodic|free OUTPUT\n", stderr);
    return 2;
  }
  try {
    return asperity::meshes::mesh_as_asked(words);
  } catch (const std::domain_error& error) {
    std::fputs(error.what(), stderr);
    return 2;
  } catch (const std::bad_alloc&) {
    std::fputs("out of memory", stderr);
  } catch (const std::exception& error) {
    std::fputs(error.what(), stderr);
  }
  return 4;
}
