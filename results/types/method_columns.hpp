#pragma once

// The columns that some methods fill.

#include "results/types/curve_columns.hpp"

namespace asperity::columns {

inline const CurveColumn area_fraction_fit{
    "fit",
    {.name = "area_fraction_fit",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "contact area by Eq. (21), fitted to P(sigma)"}};

inline const CurveColumn area_fraction_moment{
    "fit",
    {.name = "area_fraction_moment",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "contact area by Eq. (21), from <sigma^2>"}};

inline const CurveColumn certified_gap_error{
    "certificate",
    {.name = "certified_gap_error",
     .unit = "m",
     .text = "bound of the error of `mean_gap` against the exact answer of "
             "the discrete problem "
             "([certificate.md](../numerics/certificate.md)); NaN: the "
             "method has no certificate",
     .use = ColumnUse::solution}};

inline const CurveColumn estimated_gap_error{
    "certificate",
    {.name = "estimated_gap_error",
     .unit = "m",
     .text = "full 3-D model only: estimate, no bound, of the error of "
             "`mean_gap` by the mesh "
             "([full-block.md](../numerics/"
             "full-block.md#estimated-error-of-the-mean-gap)); "
             "NaN: no contact, or not converged",
     .use = ColumnUse::solution}};

inline const CurveColumn transforms{
    "cost",
    {.name = "transforms",
     .unit = "1",
     .text = "applications of the elastic operator or its inverse on the "
             "method's grid; 0: the method has no such operator",
     .use = ColumnUse::solution,
     .is_integer = true}};

inline const CurveColumn transform_time{
    "cost",
    {.name = "transform_time",
     .unit = "s",
     .text = "CPU time of all applications, including those on coarser "
             "grids; part of `cpu_time`",
     .use = ColumnUse::cost}};

inline const CurveColumn observation_time{
    "cost",
    {.name = "observation_time",
     .unit = "s",
     .text = "CPU time of areas, fits and energy; part of `cpu_time`",
     .use = ColumnUse::cost}};

inline const DirectedColumn pressure_centre{
    "free edges",
    {.name = "pressure_centre",
     .unit = "m",
     .range = results::any_number,
     .text = "lever of the resultant force about the middle of the "
             "surface, the node in column `points`/2 and row `points`/2; "
             "NaN without contact and for surfaces without a middle (all "
             "but spheres, punches, roughness on a sphere, and maps that "
             "are pressed once)"}};

inline const CurveColumn mean_displacement{
    "free edges",
    {.name = "mean_displacement",
     .unit = "m",
     .range = results::any_number,
     .text = "with free boundaries only: mean displacement of the surface "
             "from far points. The approach of far points changes by its "
             "change less that of `mean_gap`"}};

inline const CurveColumn linear_iterations{
    "full block",
    {.name = "linear_iterations",
     .unit = "1",
     .text = "full 3-D model only: iterations of the linear solver",
     .use = ColumnUse::solution,
     .is_integer = true}};

inline const CurveColumn preconditioner_setups{
    "full block",
    {.name = "preconditioner_setups",
     .unit = "1",
     .text = "full 3-D model only: set-ups of the preconditioner, or "
             "factorisations",
     .use = ColumnUse::solution,
     .is_integer = true}};

inline const CurveColumn unknowns{
    "full block",
    {.name = "unknowns", .unit = "1", .text = "full 3-D model only: unknowns"}};

inline const CurveColumn memory{
    "full block",
    {.name = "memory",
     .unit = "bytes",
     .text = "full 3-D model only: memory of matrix and preconditioner",
     .use = ColumnUse::cost}};

inline const CurveColumn von_mises{
    "full block",
    {.name = "von_mises",
     .unit = "Pa",
     .text = "full 3-D model only: largest von Mises stress"}};

inline const CurveColumn von_mises_depth{
    "full block",
    {.name = "von_mises_depth",
     .unit = "m",
     .text = "full 3-D model only: depth of this maximum"}};

inline const CurveColumn plastic_strain{
    "full block",
    {.name = "plastic_strain",
     .unit = "1",
     .text = "full 3-D model with `yield_stress`: largest equivalent "
             "[plastic strain](../numerics/full-block.md#plastic-flow)"}};

inline const CurveColumn normal_stiffness{
    "stiffness",
    {.name = "normal_stiffness",
     .unit = "N/m",
     .text = "full 3-D model with `stiffness = true`: [stiffness of the "
             "contact](../numerics/full-block.md#stiffness-of-the-contact) "
             "against its clamped far boundary; half-space and condensed "
             "blocks with `[conductance]`: [normal "
             "stiffness](../numerics/conductance.md) against the mean gap",
     .extent = Extent::extensive}};

inline const CurveColumn tangential_stiffness{
    "stiffness",
    {.name = "tangential_stiffness",
     .unit = "N/m",
     .text = "likewise, of nodes that stick",
     .extent = Extent::extensive}};

inline const CurveColumn relative_conductance{
    "conductance",
    {.name = "relative_conductance",
     .unit = "1/m",
     .text = "with `[conductance]` only: "
             "[conductance](../numerics/conductance.md) of the spots per "
             "nominal area, over the harmonic mean of the conductivities"}};

inline const CurveColumn adhesive_energy{
    "adhesion",
    {.name = "adhesive_energy",
     .unit = "J/m^2",
     .range = results::any_number,
     .text = "with adhesion only: mean energy of the law or of all pairs "
             "of atoms, <= 0: [adhesion](../numerics/adhesion.md)"}};

inline const CurveColumn repulsive_area{
    "adhesion",
    {.name = "repulsive_area",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "likewise the nodes under pressure"}};

inline const CurveColumn tensile_area{
    "adhesion",
    {.name = "tensile_area",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "likewise the nodes in tension of at least 1 % of the law's "
             "largest"}};

inline const CurveColumn smallest_stiffness{
    "adhesion",
    {.name = "smallest_stiffness",
     .unit = "Pa/m",
     .range = results::any_number,
     .text = "likewise the smallest eigenvalue of the energy's Hessian, > "
             "0 at a minimum"}};

inline const CurveColumn attractive_load{
    "adhesion",
    {.name = "attractive_load",
     .unit = "Pa",
     .text = "likewise the sum of the tensions over the nominal area"}};

inline const CurveColumn jump_pressure{
    "adhesion",
    {.name = "jump_pressure",
     .unit = "Pa",
     .range = results::any_number,
     .text = "where faces with adhesion part or come together in a step: "
             "nominal pressure of the last state before, found to 1/64 of "
             "the step"}};

inline const CurveColumn jump_gap{"adhesion",
                                  {.name = "jump_gap",
                                   .unit = "m",
                                   .range = results::any_number,
                                   .text = "likewise the mean gap"}};

inline const CurveColumn plastic_work{
    "hardness",
    {.name = "plastic_work",
     .unit = "J/m^2",
     .text = "with `yield_stress` or a hardness: [the work of plastic "
             "flow](../numerics/full-block.md#plastic-flow) so far, per "
             "nominal area; with a hardness, over which it is the mean "
             "depth of the imprint"}};

inline const CurveColumn plastic_area{
    "hardness",
    {.name = "plastic_area",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "with a hardness only: area at this pressure, a part of "
             "`area_fraction`: [hardness](../numerics/hardness.md)"}};

} // namespace asperity::columns
