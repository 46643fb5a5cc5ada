#pragma once

// Elements that are too stiff for the material they are asked for. Owns the
// Poisson's ratios from which that is said, and the words.

#include "cases/types/case.hpp"

#include <span>
#include <string>
#include <vector>

namespace asperity::cases {

/// Poisson's ratio from which a wave of eight nodes is too stiff by more than a
/// tenth (Q1) or a twentieth (Q2): measured, fem/locking_test.cpp.
double locking_ratio(Element element);

/// One sentence for each [fem] method with a material above its element's
/// ratio: which, how stiff, and what to take instead.
std::vector<std::string> locking_warnings(const MaterialSpec& material,
                                          std::span<const MethodSpec> methods);

} // namespace asperity::cases
