#include "reports/explore/script_bands.hpp"

#include "reports/explore/script_words.hpp"

#include <algorithm>
#include <sstream>
#include <utility>

namespace asperity::reports {
namespace {

/// Returns the block with this index; empty if there is none.
std::string block_of(const std::string& polygons, const std::string& index) {
  const std::string separator = "\n\n\n";
  std::size_t start = 0;
  if (index.empty() || index.size() > 3 ||
      index.find_first_not_of("0123456789") != std::string::npos)
    return "";
  for (int skipped = std::stoi(index); skipped > 0; --skipped) {
    const std::size_t end = polygons.find(separator, start);
    if (end == std::string::npos)
      return "";
    start = end + separator.size();
  }
  return polygons.substr(start, polygons.find(separator, start) - start);
}

} // namespace

bool is_band(const std::string& part) {
  return part.find(" with filledcurves closed ") != std::string::npos;
}

std::optional<ChartBand> band_of(const std::string& part,
                                 const std::string& polygons) {
  const std::vector<std::string> words = words_of(part);
  const auto rgb = std::ranges::find(words, "rgb");
  if (words.size() < 10 || words[1] != "index" || words[3] != "using" ||
      words[4] != "1:2" || rgb == words.end() || std::next(rgb) == words.end())
    return std::nullopt;
  ChartBand band;
  band.color = unquoted(*std::next(rgb));
  std::istringstream rows(block_of(polygons, words[2]));
  for (std::string row; std::getline(rows, row);) {
    std::istringstream numbers(row);
    double x = 0.0;
    double y = 0.0;
    char comma = ' ';
    if (!(numbers >> x >> comma >> y) || comma != ',')
      return std::nullopt;
    band.corners.emplace_back(x, y);
  }
  return band.corners.empty() ? std::nullopt : std::optional(band);
}

} // namespace asperity::reports
