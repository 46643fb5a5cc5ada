#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// [spots]: the clusters of contact and of the gap of each load step
/// (results/observables/clusters.hpp).
extern const Study spots_study;

/// Its parts, which its object joins.
const cases::StudyKeys& spots_keys();
const reports::StudyPages& spots_pages();

} // namespace asperity::studies
