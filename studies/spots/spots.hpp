#pragma once

// [spots]: its settings, the columns of its answers, and its object.

#include "results/types/curve_columns.hpp"
#include "studies/study.hpp"

namespace asperity::studies {

/// [spots]: the clusters of contact and of the gap.
struct SpotsStudy {
  int smallest = 10; ///< nodes of the smallest cluster in a dimension >= 1
};

/// [spots]: the clusters of contact and of the gap of each load step
/// (results/observables/clusters.hpp).
extern const Study spots_study;

/// Its pages, which its object joins.
const reports::StudyPages& spots_pages();

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

inline const DirectedColumn spots_percolate{
    "spots",
    {.name = "spots_percolate",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "likewise whether one goes around the map (0 or 1)"}};

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

inline const DirectedColumn gap_percolates{
    "spots",
    {.name = "gap_percolates",
     .unit = "1",
     .range = results::zero_to_one,
     .text = "likewise whether one joins opposite sides along x (0 or 1)"}};

} // namespace asperity::columns
