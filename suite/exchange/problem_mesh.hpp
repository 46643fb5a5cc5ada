#pragma once

// The block of a problem as cells, for programs that need a mesh: mesh.msh,
// mesh.inp and the member `mesh` of problem.json.

#include "mechanics/fem_settings.hpp"
#include "mechanics/material.hpp"
#include "meshes/block_mesh.hpp"
#include "suite/exchange/problem.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>
#include <vector>

namespace asperity::exchange {

/// Hexahedra in layers, z into the block. Node 1 + i + (cells_x + 1) (j +
/// (cells_y + 1) k) of the files is at column i, row j and layer k, and cells
/// are numbered alike, x fastest. With Q1 every node of the contact surface is
/// one of the grid; with Q2 the grid has the middles of the edges and faces,
/// too.
struct ProblemMesh {
  meshes::BlockMesh mesh;
  mechanics::Element element = mechanics::Element::q1;
  int cells_x = 0;
  int cells_y = 0;
  std::vector<double> layers; ///< thicknesses from the contact surface [m]
  mechanics::FarBoundary far_boundary = mechanics::FarBoundary::clamped;
  std::vector<mechanics::BodyModuli> moduli; ///< of each group of the mesh
};

/// Meshes the body of a problem. A half-space becomes a block of one length
/// (the longer side), clamped, with a Poisson's ratio of 0.3 if the problem has
/// none.
/// @param settings  element, depth of the surface cells and grading ratio
/// @throws input::InputError  more than 2 million nodes, or Q2 on a grid with
///                            an odd number of points
/// @throws std::domain_error  the layers do not fit
ProblemMesh problem_mesh(const Problem& problem,
                         const mechanics::BlockSettings& settings);

/// The mesh as a file of gmsh 4.1 (ASCII) [m]. Its physical surfaces are
/// contact, fixed, left, right, front and back, so that [mesh] of a case can
/// read it.
std::string gmsh_text(const ProblemMesh& block);

/// The mesh as Abaqus input [m]: nodes, cells of eight nodes by material, sets
/// of nodes and the surfaces contact and fixed. No number has more than 20
/// characters, which is what CalculiX reads.
std::string abaqus_text(const ProblemMesh& block);

/// The member `mesh` of problem.json.
nlohmann::ordered_json mesh_json(const ProblemMesh& block);

/// The part of README.md on the files of the mesh, and on how the forces of its
/// nodes become pressures.
std::string mesh_readme(const ProblemMesh& block, const Problem& problem);

} // namespace asperity::exchange
