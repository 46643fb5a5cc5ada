#pragma once

// [spots]: its settings and the columns of its answers.

#include "results/types/curve_columns.hpp"

namespace asperity::studies {

/// [spots]: the clusters of contact and of the gap.
struct SpotsStudy {
  int smallest = 10; ///< nodes of the smallest cluster in a dimension >= 1
};

} // namespace asperity::studies

namespace asperity::columns {

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

} // namespace asperity::columns
