#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// [magnification]: the contact at a range of magnifications by the theory,
/// with the leak through the one pore at which the open area percolates (Sec. 8
/// of Yang and Persson, 2008).
extern const Study magnification_study;

/// Its parts, which its object joins.
const cases::StudyKeys& magnification_keys();
const reports::StudyPages& magnification_pages();

} // namespace asperity::studies
