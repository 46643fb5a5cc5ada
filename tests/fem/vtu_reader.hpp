#pragma once

// The numbers of a VTU file, read as ParaView would read them (XML with zlib
// blocks in base64), and a folder for such files.

#include "fem/parallel/mpi_session.hpp"

#include <deal.II/base/mpi.h>
#include <deal.II/base/utilities.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <cstring>
#include <filesystem>
#include <map>
#include <pugixml.hpp>
#include <stdexcept>
#include <string>
#include <vector>
#include <zlib.h>

namespace asperity::fem {

struct Vtu {
  std::size_t n_points = 0, n_cells = 0;
  std::map<std::string, std::vector<double>> fields; ///< "Points" too
  std::map<std::string, int> components;
};

template <class Number>
std::vector<double> numbers_in(const std::vector<unsigned char>& bytes) {
  std::vector<Number> raw(bytes.size() / sizeof(Number));
  std::memcpy(raw.data(), bytes.data(), raw.size() * sizeof(Number));
  return {raw.begin(), raw.end()};
}

/// One block: four 32-bit numbers (blocks, size, last size, packed size) in
/// base64, then the packed bytes in base64.
inline std::vector<unsigned char> unpacked(std::string text) {
  text.erase(0, text.find_first_not_of(" \n"));
  text.erase(text.find_last_not_of(" \n") + 1);
  constexpr std::size_t header_length = 24; // of 16 bytes in base64
  const auto head =
      dealii::Utilities::decode_base64(text.substr(0, header_length));
  std::uint32_t sizes[4];
  std::memcpy(sizes, head.data(), sizeof sizes);
  const auto packed =
      dealii::Utilities::decode_base64(text.substr(header_length));
  std::vector<unsigned char> bytes(sizes[1]);
  uLongf size = bytes.size();
  if (sizes[0] != 1 || packed.size() < sizes[3] ||
      uncompress(bytes.data(), &size, packed.data(), sizes[3]) != Z_OK ||
      size != bytes.size())
    throw std::runtime_error("a data array cannot be unpacked");
  return bytes;
}

inline Vtu read_vtu(const std::string& path) {
  pugi::xml_document document;
  if (!document.load_file(path.c_str()))
    throw std::runtime_error("no XML: " + path);
  const pugi::xml_node piece =
      document.child("VTKFile").child("UnstructuredGrid").child("Piece");
  Vtu vtu;
  vtu.n_points = piece.attribute("NumberOfPoints").as_ullong();
  vtu.n_cells = piece.attribute("NumberOfCells").as_ullong();
  if (vtu.n_points == 0) // a rank without cells writes empty arrays
    return vtu;
  const auto take = [&](const std::string& name, const pugi::xml_node& array) {
    const std::string type = array.attribute("type").value();
    const auto bytes = unpacked(array.child_value());
    vtu.fields[name] = type == "Float64"   ? numbers_in<double>(bytes)
                       : type == "Float32" ? numbers_in<float>(bytes)
                                           : numbers_in<std::uint8_t>(bytes);
    vtu.components[name] = array.attribute("NumberOfComponents").as_int(1);
  };
  take("Points", piece.child("Points").child("DataArray"));
  for (const pugi::xml_node& array : piece.child("PointData").children())
    take(array.attribute("Name").value(), array);
  return vtu;
}

/// A folder that all ranks share, removed before and after each test.
class OutputFiles : public ::testing::Test {
protected:
  std::filesystem::path folder_;

  void SetUp() override {
    start_mpi();
    folder_ = dealii::Utilities::MPI::broadcast(MPI_COMM_WORLD,
                                                ::testing::TempDir()) +
              "block";
    remove_folder();
  }

  void TearDown() override { remove_folder(); }

  static unsigned int n_ranks() {
    return dealii::Utilities::MPI::n_mpi_processes(MPI_COMM_WORLD);
  }

  std::string stem() const { return (folder_ / "block").string(); }

private:
  void remove_folder() const {
    MPI_Barrier(MPI_COMM_WORLD);
    if (dealii::Utilities::MPI::this_mpi_process(MPI_COMM_WORLD) == 0)
      std::filesystem::remove_all(folder_);
    MPI_Barrier(MPI_COMM_WORLD);
  }
};

} // namespace asperity::fem
