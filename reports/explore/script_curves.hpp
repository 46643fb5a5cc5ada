#pragma once

// Reads one curve of a plot command. It is internal to this folder.

#include "reports/explore/chart.hpp"

#include <string>

namespace asperity::reports {

/// A part of a plot that is not understood.
struct NotUnderstood {};

/// @throws NotUnderstood  the word is not a number, or is more than one
double number_of(const std::string& word);

/// Reads "'a.csv' using ($2==1 ? $3 : NaN):4 with lines title 'name'", or a
/// straight line without data.
/// @throws NotUnderstood  any word is not understood
ChartCurve curve_of(const std::string& part);

} // namespace asperity::reports
