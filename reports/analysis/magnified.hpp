#pragma once

// Collects the tables of a magnification study. It is internal to the figures.

#include "results/types/result.hpp"

#include <cstddef>
#include <vector>

namespace asperity::reports {

/// One load of the study.
struct MagnifiedLoad {
  std::size_t index = 0;
  double pressure = 0.0;                ///< [Pa]
  double contact_weight = 0.0;          ///< A(zeta_1)/A_0 [1]
  const results::Table* seen = nullptr; ///< one row per zeta
  const results::Table* gaps = nullptr; ///< quantiles of u_1
};

/// A magnification study in the form that its figures need.
struct MagnifiedStudy {
  double rms_height = 0.0;          ///< with all of the roughness [m]
  std::vector<MagnifiedLoad> loads; ///< loads whose tables are present
};

/// Returns the available part of the study; no loads if the study was not run.
MagnifiedStudy study_of(const results::Result& result);

} // namespace asperity::reports
