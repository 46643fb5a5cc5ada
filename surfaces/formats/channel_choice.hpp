#pragma once

// Chooses a channel of an instrument file, whose first channel may be a
// deflection, an amplitude or a phase instead of heights.

#include "surfaces/formats/scan.hpp"

#include <span>

namespace asperity::surfaces {

/// A channel as a candidate.
struct ChannelCandidate {
  ChannelInfo info;
  bool has_heights = false; ///< values and sides are lengths
  /// The same, but units may be absent, for the case to give.
  bool may_have_heights = false;
};

/// Returns the index of a channel.
///
/// With `wanted`, that is the channel of this title, or, if no title is equal,
/// the only one that is equal apart from the case of its letters, or the
/// channel with this number in the list, from 1. Otherwise it is, among the
/// channels of heights, or else among those without units, the first whose
/// title names heights (height, topography, z sensor, and the like), or else
/// the first whose title does not name another signal (deflection, amplitude,
/// phase, error, friction, ...).
/// @throws input::InputError  there is no such channel or none contains
///                            heights; the message lists the channels
std::size_t chosen_channel(std::span<const ChannelCandidate> channels,
                           const std::optional<std::string>& wanted,
                           const std::string& name);

/// Whether the unit is a length.
bool is_height_unit(const std::string& unit);

} // namespace asperity::surfaces
