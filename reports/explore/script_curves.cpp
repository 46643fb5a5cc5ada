#include "reports/explore/script_curves.hpp"

#include "reports/explore/chart_of_script.hpp"
#include "reports/explore/script_words.hpp"

#include <charconv>
#include <cmath>
#include <vector>

namespace asperity::reports {

double number_of(const std::string& word) {
  double number = 0.0;
  const auto [end, error] =
      std::from_chars(word.data(), word.data() + word.size(), number);
  if (error != std::errc() || end != word.data() + word.size())
    throw NotUnderstood();
  return number;
}

namespace {

int column_of(std::string word) {
  if (!word.empty() && word.front() == '$')
    word.erase(0, 1);
  const double number = number_of(word);
  if (!(number >= 1.0 && number <= 1000.0) || number != std::floor(number))
    throw NotUnderstood();
  return static_cast<int>(number);
}

/// Reads "($2==1 ? $3 : NaN):4", "($2==1 ? $3 : NaN):(2*$4):5:6", or for an
/// area "($2==1 ? $3 : NaN):5:6".
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
  if (columns.size() > 3)
    throw NotUnderstood();
  if (columns.size() > 1) {
    curve.low = column_of(columns[columns.size() - 2]);
    curve.high = column_of(columns.back());
  }
  curve.is_area = columns.size() == 2;
}

void read_style(const std::string& style, ChartCurve& curve) {
  if (style == "filledcurves" && curve.is_area)
    return;
  curve.has_x_interval = style == "xerrorbars";
  curve.has_steps = style == "steps";
  curve.has_line = style == "lines" || style == "linespoints" ||
                   style == "steps" || style == "yerrorlines";
  curve.has_markers = style == "points" || style == "linespoints" ||
                      style == "xerrorbars" || style == "yerrorlines";
  if (curve.is_area || (!curve.has_line && !curve.has_markers))
    throw NotUnderstood();
}

/// Returns the index of a word at or behind `start`.
std::size_t index_of(const std::vector<std::string>& words,
                     const std::string& word, std::size_t start) {
  while (start < words.size() && words[start] != word)
    ++start;
  if (start == words.size())
    throw NotUnderstood();
  return start;
}

/// Reads a line without data: "x" or a number.
void read_function(const std::string& word, ChartCurve& curve) {
  if (word == "x")
    curve.slope = 1.0;
  else
    curve.intercept = number_of(word);
}

} // namespace

ChartCurve curve_of(const std::string& part) {
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
    else if (key == "fillstyle" && word == "transparent")
      i = index_of(words, "noborder", i);
    else if (key != "pointsize")
      throw NotUnderstood();
  }
  const bool has_style = curve.is_area || curve.has_line || curve.has_markers;
  if (has_data != (curve.x > 0) || !has_style)
    throw NotUnderstood();
  return curve;
}

} // namespace asperity::reports
