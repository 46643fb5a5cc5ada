#pragma once

// A curve that the user has measured, or taken from elsewhere, as a result that
// a report shows beside computed ones.

#include "input/types/case.hpp"
#include "results/types/result.hpp"

#include <filesystem>
#include <string>

namespace asperity::reports {

/// The kind of a method whose curve is read from a table.
inline constexpr const char* measured_kind = "measured";

/// Reads a table whose header line names its columns with their units, as in
///
///     pressure [MPa],area [%],gap [nm]
///
/// "pressure" is the nominal pressure, or "load" the normal force on the
/// nominal area of `beside`; "area" is the contact area, as a share of the
/// nominal area [1, %] or itself, and "gap" the mean gap. One of area and gap
/// may be missing, and is NaN then, as in empty cells. Rows without a number
/// and columns without a head are left out. The units are those of
/// input/units.hpp, the forms of heads those of column_heads.hpp, and the
/// numbers are read as those of instruments (number_table.hpp). A pressure of 0
/// or less is allowed beside a result with adhesion.
///
/// @param beside        the result that it is compared with; the curve gets its
///                      modulus and the size, rms height and slope of its
///                      surface
/// @return        one method of the kind "measured", called as the file, on the
///                surface of `beside`: its gamma is that of this spectrum
/// @throws input::InputError  file, line, what was found and what is allowed
results::Result read_measured_curve(const std::filesystem::path& file,
                                    const results::Result& beside);

/// The nominal area A_0 [m^2] over which loads in N and areas in m^2 are those
/// of the nominal pressure and of A/A_0: that of the user's map.
double nominal_area(const results::Result& result);

} // namespace asperity::reports
