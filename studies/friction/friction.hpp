#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// [friction]: partial slip under tangential loads
/// (mechanics/partial_slip.hpp).
extern const Study friction_study;

/// Its parts, which its object joins.
const cases::StudyKeys& friction_keys();
const reports::StudyPages& friction_pages();

} // namespace asperity::studies
