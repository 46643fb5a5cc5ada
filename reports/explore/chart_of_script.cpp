#include "reports/explore/chart_of_script.hpp"

#include "reports/explore/script_bands.hpp"
#include "reports/explore/script_words.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

namespace asperity::reports {
namespace {

/// A part of a plot that is not understood.
struct NotUnderstood {};

double number_of(const std::string& word) {
  double number = 0.0;
  const auto [end, error] =
      std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size())
    throw NotUnderstood();
  return number;
}

int column_of(std::string word) {
  if (!word.empty() && word.front() == '$')
    word.erase(0, 1);
  const double number = number_of(word);
  if (!(number >= 1.0 && number <= 1000.0) || number != std::floor(number))
    throw NotUnderstood();
  return static_cast<int>(number);
}

/// Reads "($2==1 ? $3 : NaN):4" or "($2==1 ? $3 : NaN):(2*$4):5:6".
void read_using(const std::string& word, ChartCurve& curve) {
  const std::string start = "($2==";
  const std::string end = " : NaN):";
  const std::size_t question = word.find(" ? $");
  const std::size_t close = word.find(end);
  if (!word.starts_with(start) || question == std::string::npos ||
      close == std::string::npos || close < question)
    throw NotUnderstood();
  curve.index = static_cast<int>(
      number_of(word.substr(start.size(), question - start.size())));
  curve.x = column_of(word.substr(question + 4, close - question - 4));
  std::vector<std::string> columns =
      split_outside(word.substr(close + end.size()), ':');
  std::string& y = columns.front();
  if (y.starts_with("(") && y.ends_with(")")) {
    const std::size_t times = y.find('*');
    if (times == std::string::npos)
      throw NotUnderstood();
    curve.factor = number_of(y.substr(1, times - 1));
    y = y.substr(times + 1, y.size() - times - 2);
  }
  curve.y = column_of(y);
  if (columns.size() == 3) {
    curve.low = column_of(columns[1]);
    curve.high = column_of(columns[2]);
  } else if (columns.size() != 1) {
    throw NotUnderstood();
  }
}

void read_style(const std::string& style, ChartCurve& curve) {
  curve.has_x_interval = style == "xerrorbars";
  curve.has_steps = style == "steps";
  curve.has_line =
      style == "lines" || style == "linespoints" || style == "steps";
  curve.has_markers =
      style == "points" || style == "linespoints" || style == "xerrorbars";
  if (!curve.has_line && !curve.has_markers)
    throw NotUnderstood();
}

/// Reads a line without data: "x" or a number.
void read_function(const std::string& word, ChartCurve& curve) {
  if (word == "x")
    curve.slope = 1.0;
  else
    curve.intercept = number_of(word);
}

ChartCurve chart_curve(const std::string& part) {
  const std::vector<std::string> words = words_of(part);
  if (words.empty())
    throw NotUnderstood();
  ChartCurve curve;
  const bool has_data = words.front().starts_with('\'');
  if (!has_data)
    read_function(words.front(), curve);
  for (std::size_t i = 1; i < words.size(); ++i) {
    const std::string& key = words[i];
    if (key == "notitle")
      continue;
    if (++i == words.size())
      throw NotUnderstood();
    const std::string& word = words[i];
    if (key == "using")
      read_using(word, curve);
    else if (key == "axes" && word == "x1y2")
      curve.is_on_second_axis = true;
    else if (key == "with")
      read_style(word, curve);
    else if (key == "title")
      curve.label = plain_label(unquoted(word));
    else if (key == "linewidth")
      curve.width = number_of(word);
    else if (key == "dashtype")
      curve.dash = static_cast<int>(number_of(word));
    else if (key == "pointtype")
      curve.marker = static_cast<int>(number_of(word));
    else if (key == "linecolor" && word == "rgb" && i + 1 < words.size())
      curve.color = unquoted(words[++i]);
    else if (key != "pointsize")
      throw NotUnderstood();
  }
  if (has_data != (curve.x > 0) || (!curve.has_line && !curve.has_markers))
    throw NotUnderstood();
  return curve;
}

/// What is set at one place of the script.
struct State {
  ChartAxis x, y, second;
  std::vector<ChartMark> marks;
};

ChartAxis* chart_axis(State& state, const std::string& word) {
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

void set_log(State& state, const std::string& axes, bool is_log) {
  for (ChartAxis* axis : {&state.x, &state.y})
    if (axes.find(axis == &state.x ? 'x' : 'y') != std::string::npos)
      axis->is_log = is_log;
}

/// Reads the words behind "set arrow": from 0.3, graph 0.02 to 1.5, graph 0.02
/// nohead linewidth 2.5 linecolor rgb '#222222'. Arrows between other places
/// are guides for the eye, which are left out.
void read_arrow(const std::vector<std::string>& words, State& state) {
  if (words.size() < 14 || words[3] == "graph" || words[4] != "graph" ||
      words[5] != words[9] || words[6] != "to")
    return;
  state.marks.push_back({number_of(words[3]), number_of(words[7]),
                         number_of(words[5]), unquoted(words.back())});
}

/// Reads the words behind "set object": 1 rectangle from 0.3, graph 0 to 1.5,
/// graph 1 behind fillcolor rgb '#0072B2' ...
void read_object(const std::vector<std::string>& words, State& state) {
  if (words.size() < 15 || words[3] != "rectangle" || words[6] != "graph" ||
      words[8] != "to")
    throw NotUnderstood();
  const auto rgb = std::ranges::find(words, "rgb");
  if (rgb == words.end())
    throw NotUnderstood();
  state.marks.push_back({number_of(words[5]), number_of(words[9]), -1.0,
                         unquoted(*std::next(rgb))});
}

void read_set(const std::vector<std::string>& words, State& state) {
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
}

void read_unset(const std::vector<std::string>& words, State& state) {
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

/// Names contain quotes, "E* h'", but no commas.
std::vector<std::string> names_of(const std::string& header) {
  std::vector<std::string> names(1);
  for (const char c : header.substr(0, header.find('\n')))
    if (c == ',')
      names.emplace_back();
    else
      names.back() += c;
  return names;
}

std::string column_name(const std::vector<std::string>& header, int column) {
  const auto i = static_cast<std::size_t>(column);
  if (i > header.size())
    throw NotUnderstood();
  return header[i - 1];
}

constexpr const char* logarithm = "log10 ";

void show_logarithm(ChartAxis& axis) {
  axis.is_log = axis.is_log10 = true;
  for (const char* word : {"log₁₀ ", "log10 "})
    if (axis.label.starts_with(word))
      axis.label.erase(0, std::string(word).size());
  for (std::optional<double>* limit : {&axis.low, &axis.high})
    if (*limit)
      *limit = std::pow(10.0, **limit);
}

/// Turns axes around of which every column is a logarithm.
void show_logarithms(ChartPanel& panel,
                     const std::vector<std::string>& header) {
  const auto are_logarithms = [&](auto column, bool is_second) {
    bool has_any = false;
    for (const ChartCurve& curve : panel.curves)
      if (curve.x > 0 && curve.is_on_second_axis == is_second) {
        if (!column_name(header, column(curve)).starts_with(logarithm))
          return false;
        has_any = true;
      }
    return has_any;
  };
  const auto x = [](const ChartCurve& curve) { return curve.x; };
  const auto y = [](const ChartCurve& curve) { return curve.y; };
  if (are_logarithms(x, false))
    show_logarithm(panel.x);
  if (are_logarithms(y, false))
    show_logarithm(panel.y);
  for (ChartBand& band : panel.bands)
    for (auto& [across, up] : band.corners) {
      across = panel.x.is_log10 ? std::pow(10.0, across) : across;
      up = panel.y.is_log10 ? std::pow(10.0, up) : up;
    }
}

ChartPanel panel_of(const std::string& plot, const State& state,
                    const std::vector<std::string>& header,
                    const std::string& polygons) {
  ChartPanel panel{state.x, state.y, std::nullopt, {}, state.marks};
  for (const std::string& part : split_outside(plot, ',')) {
    if (!is_band(part)) {
      panel.curves.push_back(chart_curve(part));
      continue;
    }
    const std::optional<ChartBand> band = band_of(part, polygons);
    if (!band)
      throw NotUnderstood();
    panel.bands.push_back(*band);
  }
  for (const ChartCurve& curve : panel.curves)
    for (const int column : {curve.x, curve.y, curve.low, curve.high})
      if (column > 0)
        column_name(header, column);
  if (std::ranges::any_of(panel.curves, &ChartCurve::is_on_second_axis))
    panel.second = state.second;
  show_logarithms(panel, header);
  return panel;
}

} // namespace

std::optional<Chart> chart_of_script(const std::string& script,
                                     const std::string& header,
                                     const std::string& polygons) {
  Chart chart;
  State state;
  const std::vector<std::string> columns = names_of(header);
  try {
    for (const std::string& line : commands_of(script)) {
      const std::string plot = "plot ";
      if (line.starts_with("set "))
        read_set(words_of(line), state);
      else if (line.starts_with("unset "))
        read_unset(words_of(line), state);
      else if (line.starts_with(plot))
        chart.panels.push_back(
            panel_of(line.substr(plot.size()), state, columns, polygons));
      else
        return std::nullopt;
    }
  } catch (const NotUnderstood&) {
    return std::nullopt;
  }
  return chart.panels.empty() ? std::nullopt : std::optional(chart);
}

} // namespace asperity::reports
