#pragma once

// The columns of what a case may ask of a contact.

#include "results/types/curve_columns.hpp"

namespace asperity::columns {

inline const CurveColumn stick_stiffness_x{
    "friction",
    {.name = "stick_stiffness_x",
     .unit = "Pa/m",
     .text = "half-space with `[friction]`: tangential load over "
             "displacement of far points along x, per nominal area, if all "
             "of the contact sticks ([friction](../numerics/friction.md))"}};

inline const CurveColumn stick_stiffness_y{
    "friction",
    {.name = "stick_stiffness_y", .unit = "Pa/m", .text = "likewise along y"}};

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

inline const CurveColumn flow_factor_x{
    "flow",
    {.name = "flow_factor_x",
     .unit = "1",
     .text = "with `[flow]` only: [flow through the "
             "gap](../numerics/flow.md) along x over that of smooth faces "
             "at the mean gap; 0 if the contact is sealed, NaN if the step "
             "has not converged"}};

inline const CurveColumn flow_factor_y{
    "flow", {.name = "flow_factor_y", .unit = "1", .text = "likewise along y"}};

inline const CurveColumn flow_conductance_x{
    "flow",
    {.name = "flow_conductance_x",
     .unit = "m^3",
     .text = "likewise the flow of a square with 12 eta = Dp = 1"}};

inline const CurveColumn flow_conductance_y{
    "flow",
    {.name = "flow_conductance_y", .unit = "m^3", .text = "likewise along y"}};

inline const CurveColumn critical_gap_x{
    "flow",
    {.name = "critical_gap_x",
     .unit = "m",
     .text = "likewise the narrowest place of the widest path; theory: u_1 "
             "where the open area percolates"}};

inline const CurveColumn critical_gap_y{
    "flow",
    {.name = "critical_gap_y", .unit = "m", .text = "likewise along y"}};

inline const CurveColumn leak_rate_x{
    "flow",
    {.name = "leak_rate_x",
     .unit = "m^3/s",
     .text = "likewise the leak rate of the seal"}};

inline const CurveColumn leak_rate_y{
    "flow",
    {.name = "leak_rate_y", .unit = "m^3/s", .text = "likewise along y"}};

inline const CurveColumn effective_medium{
    "flow",
    {.name = "effective_medium",
     .unit = "m^3",
     .text = "likewise the flow of a square by the effective medium, which "
             "has no direction"}};

inline const CurveColumn spot_count{
    "spots",
    {.name = "spot_count",
     .unit = "1",
     .text = "with `[spots]` only: number of the [spots of "
             "contact](../numerics/conductance.md#spots)"}};

inline const CurveColumn largest_spot{
    "spots",
    {.name = "largest_spot",
     .unit = "m^2",
     .text = "likewise the area of the largest ([on the "
             "map](results.md#cell-and-map))"}};

inline const CurveColumn spot_dimension{
    "spots",
    {.name = "spot_dimension",
     .unit = "1",
     .range = results::any_number,
     .text = "likewise the dimension by area and perimeter"}};

inline const CurveColumn spots_percolate_x{
    "spots",
    {.name = "spots_percolate_x",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "likewise whether one goes around the map (0 or 1)"}};

inline const CurveColumn spots_percolate_y{"spots",
                                           {.name = "spots_percolate_y",
                                            .unit = "1",
                                            .range = results::zero_to_one,
                                            .text = "likewise along y"}};

inline const CurveColumn spot_radii{
    "spots",
    {.name = "spot_radii",
     .unit = "1/m",
     .text = "likewise the sum of the radii of circles of the areas of the "
             "spots, per nominal area"}};

inline const CurveColumn gap_count{
    "spots",
    {.name = "gap_count",
     .unit = "1",
     .text = "with `[spots]` only: the same of the connected parts of the "
             "gap"}};

inline const CurveColumn largest_gap{
    "spots",
    {.name = "largest_gap",
     .unit = "m^2",
     .text = "likewise the area of the largest ([on the "
             "map](results.md#cell-and-map))"}};

inline const CurveColumn gap_dimension{
    "spots",
    {.name = "gap_dimension",
     .unit = "1",
     .range = results::any_number,
     .text = "likewise the dimension by area and perimeter"}};

inline const CurveColumn gap_percolates_x{
    "spots",
    {.name = "gap_percolates_x",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "likewise whether one joins opposite sides along x (0 or 1)"}};

inline const CurveColumn gap_percolates_y{"spots",
                                          {.name = "gap_percolates_y",
                                           .unit = "1",
                                           .range = results::zero_to_one,
                                           .text = "likewise along y"}};

inline const CurveColumn relative_conductance{
    "conductance",
    {.name = "relative_conductance",
     .unit = "1/m",
     .text = "with `[conductance]` only: "
             "[conductance](../numerics/conductance.md) of the spots per "
             "nominal area, over the harmonic mean of the conductivities"}};

inline const CurveColumn relative_gap_conductance{
    "conductance",
    {.name = "relative_gap_conductance",
     .unit = "1/m",
     .text = "with `gap_conductivity` only: what [the medium in the "
             "gap](../numerics/conductance.md#heat-through-the-gap) adds "
             "to `relative_conductance`"}};

inline const CurveColumn thermal_conductance{
    "conductance",
    {.name = "thermal_conductance",
     .unit = "W/(m^2 K)",
     .text = "with `[conductance]` and conductivities: conductance of "
             "heat, with the medium in the gap"}};

inline const CurveColumn electrical_conductance{
    "conductance",
    {.name = "electrical_conductance",
     .unit = "1/(Ohm m^2)",
     .text = "with `[conductance]` and resistivities: conductance of "
             "current"}};

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

} // namespace asperity::columns
