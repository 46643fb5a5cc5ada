#pragma once

// Recognises numbers that programs write where a point was not measured and
// that a reader of a format without missing points takes for heights.

#include "surfaces/formats/scan.hpp"

#include <span>
#include <string>

namespace asperity::surfaces {

/// Refuses a map whose least or largest number marks missing points. That is:
/// its magnitude is 1e20 or more; or it is one of the usual marks (-9999,
/// -32768, 65535, ...), also after a conversion between units of length, and
/// farther from the other numbers than 1/8 of their range; or, in a file that
/// another program has converted, several points have it and it is farther from
/// the other numbers than these are from each other.
/// @param heights  [m], not finite at missing points
/// @param name     of the file, for messages
/// @throws input::InputError  names the number, how many points have it, and
///                            the key surface.missing_value
void refuse_marks(std::span<const double> heights, const FileNumbers& numbers,
                  const std::string& name);

} // namespace asperity::surfaces
