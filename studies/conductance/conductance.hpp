#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// [conductance]: heat and current through the contact of each load step, and
/// its normal stiffness (contact/solvers/punch_stiffness.hpp).
extern const Study conductance_study;

/// Its parts, which its object joins.
const cases::StudyKeys& conductance_keys();
const reports::StudyPages& conductance_pages();

} // namespace asperity::studies
