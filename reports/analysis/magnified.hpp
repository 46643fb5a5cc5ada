#pragma once

// The tables of a study of magnifications, put together. Internal to figures.

#include "results/types/result.hpp"

#include <cstddef>
#include <vector>

namespace asperity::reports {

/// One load of the study.
struct MagnifiedLoad {
  std::size_t index = 0;
  double pressure = 0.0;                ///< [Pa]
  double contact_weight = 0.0;          ///< A(zeta_1)/A_0
  const results::Table* seen = nullptr; ///< rows of zeta
  const results::Table* gaps = nullptr; ///< quantiles of u_1
};

/// A study as its figures want it.
struct MagnifiedStudy {
  double rms_height = 0.0;          ///< of the whole surface [m]
  std::vector<MagnifiedLoad> loads; ///< those whose tables are there
};

/// What is there of the study; no loads if it was not run.
MagnifiedStudy study_of(const results::Result& result);

} // namespace asperity::reports
