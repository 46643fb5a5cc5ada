#pragma once

#include "studies/study.hpp"

namespace asperity::studies {

/// [adhesion]: adhesion of rough faces by the theory (Sec. 9 of Yang and
/// Persson, 2008).
extern const Study adhesion_study;

/// Its parts, which its object joins.
const cases::StudyKeys& adhesion_keys();
const reports::StudyPages& adhesion_pages();

} // namespace asperity::studies
