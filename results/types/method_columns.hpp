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

inline const CurveColumn pressure_centre_x{
    "free edges",
    {.name = "pressure_centre_x",
     .unit = "m",
     .range = results::any_number,
     .text = "lever of the resultant force about the middle of the "
             "surface, the node in column `points`/2 and row `points`/2; "
             "NaN without contact and for surfaces without a middle (all "
             "but spheres, punches, roughness on a sphere, and maps that "
             "are pressed once)"}};

inline const CurveColumn pressure_centre_y{"free edges",
                                           {.name = "pressure_centre_y",
                                            .unit = "m",
                                            .range = results::any_number,
                                            .text = "likewise along y"}};

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

} // namespace asperity::columns
