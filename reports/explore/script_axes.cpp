#include "reports/explore/script_axes.hpp"

#include "base/special_numbers.hpp"
#include "reports/explore/chart_of_script.hpp"
#include "reports/explore/script_curves.hpp"
#include "reports/explore/script_words.hpp"

#include <algorithm>
#include <iterator>
#include <optional>
#include <utility>

namespace asperity::reports {
namespace {

ChartAxis* chart_axis(ScriptState& state, const std::string& word) {
  return word.starts_with("x2")   ? nullptr
         : word.starts_with("y2") ? &state.second
         : word.starts_with("x")  ? &state.x
         : word.starts_with("y")  ? &state.y
                                  : nullptr;
}

void read_range(const std::string& text, ChartAxis& axis) {
  const std::size_t colon = text.find(':');
  if (text.size() < 3 || colon == std::string::npos)
    throw NotUnderstood();
  const auto limit = [](const std::string& word) -> std::optional<double> {
    return word == "*" ? std::nullopt : std::optional(number_of(word));
  };
  axis.low = limit(text.substr(1, colon - 1));
  axis.high = limit(text.substr(colon + 1, text.size() - colon - 2));
}

void set_log(ScriptState& state, const std::string& axes, bool is_log) {
  const bool is_second = axes.find("y2") != std::string::npos;
  if (is_second)
    state.second.is_log = is_log;
  if (axes.find('x') != std::string::npos)
    state.x.is_log = is_log;
  if (axes.find('y') != std::string::npos && !is_second)
    state.y.is_log = is_log;
}

/// A corner of an arrow or object. A coordinate is a value of its axis, or a
/// share of the plot's side from 0 to 1.
struct Corner {
  double x = 0.0, y = 0.0;
  bool has_share_of_x = false, has_share_of_y = false;

  bool operator==(const Corner&) const = default;

  /// Value of x; infinite at the left and right edge of the plot.
  double value_of_x() const {
    if (!has_share_of_x)
      return x;
    if (x != 0.0 && x != 1.0)
      throw NotUnderstood();
    return x == 0.0 ? -infinity : infinity;
  }
};

/// Reads "0.3, graph 0", "graph 0, graph 0" or "first 0.3, graph 1", and moves
/// `at` behind it.
Corner read_corner(const std::vector<std::string>& words, std::size_t& at) {
  const auto coordinate = [&](double& value, bool& has_share) {
    has_share = at < words.size() && words[at] == "graph";
    if (has_share || (at < words.size() && words[at] == "first"))
      ++at;
    if (at == words.size())
      throw NotUnderstood();
    value = number_of(words[at++]);
  };
  Corner corner;
  coordinate(corner.x, corner.has_share_of_x);
  coordinate(corner.y, corner.has_share_of_y);
  return corner;
}

/// Reads "from CORNER to CORNER"; nothing for other words.
std::optional<std::pair<Corner, Corner>>
read_corners(const std::vector<std::string>& words) {
  const auto from = std::ranges::find(words, "from");
  if (from == words.end())
    return std::nullopt;
  std::size_t at = static_cast<std::size_t>(from - words.begin()) + 1;
  const Corner first = read_corner(words, at);
  if (at == words.size() || words[at++] != "to")
    return std::nullopt;
  return std::pair(first, read_corner(words, at));
}

std::string color_in(const std::vector<std::string>& words) {
  const auto rgb = std::ranges::find(words, "rgb");
  return rgb == words.end() || std::next(rgb) == words.end()
             ? ""
             : unquoted(*std::next(rgb));
}

/// Reads a bar: from 0.3, graph 0.02 to 1.5, graph 0.02 nohead ... linecolor
/// rgb '#222222', or a line over the whole height: from 0.3, graph 0 to 0.3,
/// graph 1. Other arrows are guides for the eye, which are left out.
void read_arrow(const std::vector<std::string>& words, ScriptState& state) {
  const auto corners = read_corners(words);
  if (!corners)
    return;
  const auto& [from, to] = *corners;
  const bool is_across = !from.has_share_of_x && !to.has_share_of_x &&
                         from.has_share_of_y && to.has_share_of_y;
  if (is_across && from.y == to.y)
    state.marks.push_back({from.x, to.x, from.y, color_in(words), ""});
  else if (is_across && from.x == to.x && from.y == 0.0 && to.y == 1.0)
    state.marks.push_back({from.x, to.x, -1.0, color_in(words), ""});
}

/// Reads a shaded range: rectangle from 0.3, graph 0 to 1.5, graph 1 behind
/// fillcolor rgb '#0072B2' ...
void read_object(const std::vector<std::string>& words, ScriptState& state) {
  const auto corners = read_corners(words);
  const std::string color = color_in(words);
  if (std::ranges::find(words, "rectangle") == words.end() || !corners ||
      color.empty() || !corners->first.has_share_of_y ||
      !corners->second.has_share_of_y)
    throw NotUnderstood();
  state.marks.push_back({corners->first.value_of_x(),
                         corners->second.value_of_x(), -1.0, color, ""});
}

/// Reads the name of a line over the whole height: 'tip radius' at 0.3, graph
/// 0.03 ... Other labels are left out.
void read_label(const std::vector<std::string>& words, ScriptState& state) {
  if (words.size() < 5 || words[3] != "at" || state.marks.empty())
    return;
  ChartMark& line = state.marks.back();
  if (line.low == line.high && line.height < 0.0 && words[4] != "graph" &&
      words[4] != "first" && number_of(words[4]) == line.low)
    line.label = plain_label(unquoted(words[2]));
}

/// Reads "('soft' 0, 'hard' 1)".
void read_ticks(const std::string& word, ChartAxis& axis) {
  if (!word.starts_with("(") || !word.ends_with(")"))
    return; // a step between ticks
  axis.ticks.clear();
  for (const std::string& tick :
       split_outside(word.substr(1, word.size() - 2), ',')) {
    const std::vector<std::string> parts = words_of(tick);
    if (parts.size() != 2)
      throw NotUnderstood();
    axis.ticks.emplace_back(number_of(parts[1]),
                            plain_label(unquoted(parts[0])));
  }
}

void read_set(const std::vector<std::string>& words, ScriptState& state) {
  if (words.size() < 3)
    return;
  const std::string& name = words[1];
  ChartAxis* const axis = chart_axis(state, name);
  if (name.ends_with("label") && axis != nullptr)
    axis->label = plain_label(unquoted(words[2]));
  else if (name.ends_with("range") && axis != nullptr)
    read_range(words[2], *axis);
  else if (name == "logscale")
    set_log(state, words[2], true);
  else if (name == "arrow")
    read_arrow(words, state);
  else if (name == "object")
    read_object(words, state);
  else if (name == "label")
    read_label(words, state);
  else if (name.ends_with("tics") && axis != nullptr)
    read_ticks(words[2], *axis);
}

void read_unset(const std::vector<std::string>& words, ScriptState& state) {
  if (words.size() < 2)
    return;
  ChartAxis* const axis = chart_axis(state, words[1]);
  if (words[1].ends_with("label") && axis != nullptr)
    axis->label.clear();
  else if (words[1].ends_with("range") && axis != nullptr)
    axis->low = axis->high = std::nullopt;
  else if (words[1] == "logscale")
    set_log(state, words.size() > 2 ? words[2] : "xy", false);
  else if (words[1] == "arrow" || words[1] == "object")
    state.marks.clear();
}

} // namespace

void read_setting(const std::vector<std::string>& words, ScriptState& state) {
  if (words.front() == "set")
    read_set(words, state);
  else
    read_unset(words, state);
}

} // namespace asperity::reports
