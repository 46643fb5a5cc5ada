#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// The thermal and the electrical resistance of the contact, where
/// [conductance] has the conductivities for them.
extern const Study resistance_study;

/// Its parts, which its object joins.
const cases::StudyKeys& resistance_keys();
const reports::StudyPages& resistance_pages();

} // namespace asperity::studies
