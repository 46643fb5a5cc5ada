#include "surfaces/formats/channel_choice.hpp"

#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "surfaces/formats/length_units.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace asperity::surfaces {
namespace {

bool contains_any(const std::string& title,
                  std::span<const std::string_view> words) {
  const std::string lower = lower_case(title);
  return std::any_of(words.begin(), words.end(), [&](std::string_view word) {
    return lower.find(word) != std::string::npos;
  });
}

/// 2: the title names heights, 1: it names nothing known, 0: another signal.
int rank_of_title(const std::string& title) {
  static constexpr std::string_view others[] = {
      "deflection", "amplitude",  "phase",       "error",   "friction",
      "lateral",    "intensity",  "adhesion",    "current", "voltage",
      "mask",       "excitation", "dissipation", "quality"};
  static constexpr std::string_view heights[] = {
      "height", "topo",  "zsensor",     "z sensor", "z-axis",
      "z axis", "hoehe", "h\xC3\xB6he", "surface"};
  if (contains_any(title, others))
    return 0;
  return contains_any(title, heights) ? 2 : 1;
}

std::string list_of(std::span<const ChannelCandidate> channels) {
  std::string list;
  for (const ChannelCandidate& channel : channels)
    list += fmt::format("{}\"{}\" [{}]", list.empty() ? "" : ", ",
                        printable(channel.info.title),
                        printable(channel.info.unit));
  return list.empty() ? "none" : list;
}

std::optional<std::size_t> titled(std::span<const ChannelCandidate> channels,
                                  const std::string& wanted) {
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (channels[i].info.title == wanted)
      return i;
  std::vector<std::size_t> similar;
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (lower_case(channels[i].info.title) == lower_case(wanted))
      similar.push_back(i);
  if (similar.size() == 1)
    return similar[0];
  for (std::size_t i = 0; i < channels.size(); ++i)
    if (wanted == std::to_string(i + 1))
      return i;
  return std::nullopt;
}

} // namespace

bool is_height_unit(const std::string& unit) {
  return length_unit(unit).has_value();
}

std::size_t chosen_channel(std::span<const ChannelCandidate> channels,
                           const std::optional<std::string>& wanted,
                           const std::string& name) {
  if (wanted) {
    const std::optional<std::size_t> found = titled(channels, *wanted);
    if (!found)
      throw input::InputError(
          fmt::format("surface.channel = \"{}\": {} has no such channel; its "
                      "channels are {}",
                      printable(*wanted), name, list_of(channels)));
    if (!channels[*found].may_have_heights)
      throw input::InputError(fmt::format(
          "surface.channel = \"{}\": this channel of {} is in '{}', but must "
          "be a length over a length; its channels are {}",
          printable(*wanted), name, printable(channels[*found].info.unit),
          list_of(channels)));
    return *found;
  }
  std::optional<std::size_t> best;
  int best_rank = -1;
  for (std::size_t i = 0; i < channels.size(); ++i) {
    constexpr int of_units = 3; // above those of titles
    const int rank = rank_of_title(channels[i].info.title) +
                     (channels[i].has_heights ? of_units : 0);
    if (channels[i].may_have_heights && rank > best_rank) {
      best = i;
      best_rank = rank;
    }
  }
  if (!best)
    throw input::InputError(
        fmt::format("{}: no channel contains heights; its channels are {}",
                    name, list_of(channels)));
  return *best;
}

} // namespace asperity::surfaces
