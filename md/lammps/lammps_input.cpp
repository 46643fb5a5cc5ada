#include "md/lammps/lammps_input.hpp"

#include "md/lammps/lammps_units.hpp"
#include "md/minimise/relaxation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace asperity::md {
namespace {

/// Margin of the neighbour lists beyond the cutoff [m]. The lists are rebuilt
/// when an atom has moved by half of it.
constexpr double neighbour_skin = 0.5e-10;

/// Number of attempts. A minimiser of LAMMPS may stop because roundoff in the
/// energy prevents a further descent; it is then restarted from the same state.
constexpr int attempts = 3;

/// During the approach to a prescribed height, a stage only needs to follow the
/// substrate approximately.
constexpr double stage_tolerance = 0.03;
constexpr int stage_evaluations = 200;

/// Returns an upper bound of the number of neighbours of an atom: the substrate
/// atoms below it, with a margin for slopes.
int neighbours(const LammpsBlock& block) {
  const double radius = block.interaction.cutoff + neighbour_skin;
  const double in_disc =
      std::numbers::pi * radius * radius / block.substrate.cell_area();
  return std::max(2000, static_cast<int>(4.0 * in_disc));
}

/// Returns the lines that define the crystal. Bonds are defined by atom
/// numbers, and only pairs of the lowest layer with the substrate interact. All
/// other pairs of types are excluded, so the LAMMPS lists of bonded neighbours
/// are not needed beyond the first.
std::string crystal_lines(const LammpsBlock& block) {
  std::string text = fmt::format(
      "units metal\natom_style bond\natom_modify map array\n"
      "boundary p p s\nnewton on\nprocessors * * 1\n"
      "special_bonds lj/coul 0.0 1.0 1.0\nbond_style harmonic\n"
      "pair_style hybrid table linear {}\n"
      "neighbor {:.17g} bin\n"
      "neigh_modify delay 0 every 1 check yes one {} page {}\n"
      "read_data {}\n"
      "pair_coeff * * none\npair_coeff 1 4 table {} {} {:.17g}\n",
      table_points, neighbour_skin / metal::length, neighbours(block),
      100 * neighbours(block), lammps_file::block, lammps_file::table,
      table_section, block.interaction.cutoff / metal::length);
  for (int first = 1; first <= 4; ++first)
    for (int second = first; second <= 4; ++second)
      if (first != 1 || second != 4)
        text += fmt::format("neigh_modify exclude type {} {}\n", first, second);
  return text + fmt::format("read_dump {} 0 x y z box no replace yes wrapped "
                            "no\n",
                            lammps_file::start);
}

/// Returns the lines that define constraints and load. The force added to the
/// lowest layer removes the mean of the constrained components. It does no work
/// on the free displacements, so its energy is 0.
std::string load_lines(const LammpsBlock& block, const LammpsTask& task) {
  const bool is_height = task.control == mechanics::Control::mean_gap;
  const double load =
      is_height ? 0.0 : task.amount * block.layer.cell_area() / metal::force;
  return fmt::format(
      "group lowest type 1\ngroup top type 3\ngroup substrate type 4\n"
      "group block type 1 2 3\n"
      "compute mean lowest reduce ave fx fy fz\n"
      "compute push lowest group/group substrate\n"
      "variable mx equal -c_mean[1]\nvariable my equal -c_mean[2]\n"
      "variable mz equal {}\nvariable none atom 0.0\n"
      "fix hold substrate setforce 0.0 0.0 0.0\n"
      "fix mean lowest addforce v_mx v_my v_mz energy v_none\n"
      "fix load lowest addforce 0.0 0.0 {:.17g}\nfix_modify load energy yes\n"
      "fix plate top aveforce 0.0 0.0 0.0\n"
      "thermo_style custom step pe ebond evdwl fnorm c_push[3]\n"
      "thermo_modify norm no flush yes format float %.15g\nthermo 20\n",
      is_height ? "-c_mean[3]" : "0.0", -load);
}

/// Returns the force norm, relative to the contact force, at which LAMMPS must
/// stop for the residual to equal `tolerance`.
double stopping_norm(const LammpsBlock& block, double tolerance) {
  return tolerance / residual(block, 1.0, 1.0);
}

std::string minimize(const std::string& norm, int evaluations) {
  return fmt::format("minimize 0.0 {} {} {}\n", norm, evaluations, evaluations);
}

/// Returns the lines for a prescribed height. The contact force to which the
/// tolerance refers is not known in advance; it is evaluated after each stage.
/// Without contact it is 0, and so is the residual.
std::string height_lines(const LammpsBlock& block, const LammpsTask& task) {
  const double way = task.start_height - task.amount;
  const int stages = std::max(
      1, static_cast<int>(std::ceil(way / RelaxationSettings{}.largest_step)));
  const auto norm = [&](double tolerance) {
    return fmt::format("$({:.17g}*abs(c_push[3])+1.0e-12:%.17g)",
                       stopping_norm(block, tolerance));
  };
  std::string text;
  for (int stage = 0; stage < stages; ++stage)
    text += fmt::format("displace_atoms block move 0.0 0.0 {:.17g} units box\n"
                        "run 0\n",
                        -way / stages / metal::length) +
            minimize(norm(stage_tolerance), stage_evaluations);
  for (int attempt = 0; attempt < attempts; ++attempt)
    text += minimize(norm(0.9 * task.tolerance), task.max_evaluations);
  return text;
}

std::string pressure_lines(const LammpsBlock& block, const LammpsTask& task) {
  const double norm = stopping_norm(block, 0.9 * task.tolerance) * task.amount *
                      block.layer.area() / metal::force;
  std::string text;
  for (int attempt = 0; attempt < attempts; ++attempt)
    text += minimize(fmt::format("{:.17g}", norm), task.max_evaluations);
  return text;
}

/// Returns the lines that write the results. Without bonds and loads, the
/// remaining force on an atom is that of the substrate.
std::string answer_lines() {
  return fmt::format(
      "write_dump block custom {} id xu yu zu fx fy fz modify sort id "
      "format float %.17g\n"
      "print \"$(ebond:%.17g) $(evdwl:%.17g)\" file {}\n"
      "unfix plate\nunfix load\nunfix mean\n"
      "bond_style zero nocoeff\nbond_coeff *\nrun 0\n"
      "write_dump lowest custom {} id fx fy fz modify sort id "
      "format float %.17g\n",
      lammps_file::answer, lammps_file::energies, lammps_file::contact);
}

} // namespace

std::string input_script(const LammpsBlock& block, const LammpsTask& task) {
  return crystal_lines(block) + load_lines(block, task) +
         "min_style cg\nmin_modify dmax 0.1 line quadratic\n" +
         (task.control == mechanics::Control::mean_gap
              ? height_lines(block, task)
              : pressure_lines(block, task)) +
         answer_lines();
}

} // namespace asperity::md
