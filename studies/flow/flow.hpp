#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// [flow]: the flow of a fluid through the gap of each load step by Reynolds'
/// equation (mechanics/flow/reynolds.hpp), and of a theory by the effective
/// medium.
extern const Study flow_study;

/// Its parts, which its object joins.
const cases::StudyKeys& flow_keys();
const reports::StudyPages& flow_pages();

} // namespace asperity::studies
