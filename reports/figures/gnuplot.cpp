#include "reports/figures/gnuplot.hpp"

#include "base/atomic_file.hpp"
#include "base/child_process.hpp"
#include "base/plain_text.hpp"
#include "base/read_file.hpp"
#include "reports/explore/explore_data.hpp"
#include "reports/figures/gnuplot_script.hpp"

#include <boost/algorithm/string/replace.hpp>
#include <fmt/format.h>

#include <array>
#include <cmath>
#include <stdexcept>
#include <system_error>

namespace asperity::reports {
namespace {

// Fonts that a browser should try, in place of the single name that gnuplot
// accepts.
constexpr const char* font_list =
    "Helvetica Neue, Helvetica, Arial, Liberation Sans, sans-serif";

// These names are written into scripts, between quotes.
void require_file_word(const char* what, const std::string& name) {
  if (name.empty() || name.find_first_not_of(
                          "abcdefghijklmnopqrstuvwxyz0123456789-") != name.npos)
    throw std::domain_error(fmt::format(
        "{} = \"{}\", but must be of the letters a-z, digits and hyphens", what,
        printable(name)));
}

// Limits far beyond what a figure needs.
constexpr double gibibyte = 1024.0 * 1024.0 * 1024.0;
constexpr ChildLimits limits{
    .wall_time = 600.0,
    .memory = static_cast<std::uintmax_t>(8 * gibibyte),
    .file_size = static_cast<std::uintmax_t>(gibibyte)};

// Runs `program script` inside `folder`. Returns the error message, or "" on
// success.
std::string run(const std::string& program, const std::string& script,
                const std::filesystem::path& folder) {
  try {
    const ChildAnswer answer = run_child(
        {.words = {program, script}, .folder = folder, .limits = limits});
    return answer.end.failure.empty()
               ? ""
               : fmt::format("{} ended with {}: {}", program,
                             answer.end.failure, answer.output);
  } catch (const std::system_error& error) {
    return error.what();
  }
}

} // namespace

std::string run_script(const Figure& figure,
                       const std::filesystem::path& folder,
                       const std::string& terminal, const std::string& ending,
                       const std::string& program) {
  require_file_word("figure.name", figure.name);
  for (const auto& [suffix, matrix] : figure.maps)
    require_file_word("figure.maps", suffix);
  std::filesystem::create_directories(folder);
  write_file_atomically(folder / (figure.name + ".csv"), figure.data);
  for (const auto& [suffix, matrix] : figure.maps)
    write_file_atomically(
        folder / fmt::format("{}-{}.csv", figure.name, suffix), matrix);
  if (const std::string polygons = band_file(figure); !polygons.empty())
    write_file_atomically(folder / (figure.name + "-bands.csv"), polygons);
  const std::string picture = figure.name + "." + ending;
  const std::string script_name = figure.name + ".gp";
  write_file_atomically(folder / script_name,
                        fmt::format("# gnuplot {}\nset terminal {}\nset output "
                                    "'{}'\n{}set output\n",
                                    script_name, terminal, picture,
                                    gnuplot_script(figure)));
  std::error_code ignored;
  std::filesystem::remove(folder / picture, ignored);
  if (std::string problem = run(program, script_name, folder); !problem.empty())
    return problem;
  return std::filesystem::exists(folder / picture)
             ? ""
             : program + " produced no picture";
}

DrawnFigure draw(const Figure& figure, const std::filesystem::path& folder,
                 const std::string& program) {
  DrawnFigure drawn{figure.name, figure.title, figure.caption, "",
                    figure.problem};
  if (!drawn.problem.empty()) {
    require_file_word("figure.name", figure.name);
    return drawn;
  }
  drawn.explore = explore_data(figure);
  drawn.problem = run_script(
      figure, folder,
      fmt::format("svg size {},{} fixed enhanced font 'Helvetica,12' "
                  "background '#ffffff'",
                  figure.width, figure.height),
      "svg", program);
  if (!drawn.problem.empty())
    return drawn;
  const std::filesystem::path svg_path = folder / (figure.name + ".svg");
  drawn.svg = read_file(svg_path, limits.file_size);
  if (drawn.svg.find("</svg>") == std::string::npos) {
    drawn.svg.clear();
    drawn.problem = program + " produced no picture";
    return drawn;
  }
  boost::replace_all(drawn.svg, "font-family=\"Helvetica\"",
                     fmt::format("font-family=\"{}\"", font_list));
  boost::replace_all(drawn.svg, "<title>Gnuplot</title>",
                     "<title>" + figure.name + "</title>");
  write_file_atomically(svg_path, drawn.svg);
  return drawn;
}

std::string explore_data(const Figure& figure) {
  return explore_data(figure.name, figure.title, figure.data, figure.panels,
                      figure.stack);
}

const char* method_color(std::size_t index) {
  static constexpr std::array<const char*, 6> colors{
      "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9"};
  return colors[index % colors.size()];
}

CsvTable::CsvTable(const std::vector<std::string>& header) {
  for (const std::string& name : header)
    text_ += (text_.empty() ? "" : ",") + name;
  text_ += "\n";
}

void CsvTable::add(const std::string& label,
                   const std::vector<double>& numbers) {
  text_ += '"';
  for (const char c : label)
    text_ +=
        c == '"'
            ? std::string("\"\"")
            : std::string(1, static_cast<unsigned char>(c) < 0x20 ? ' ' : c);
  text_ += '"';
  for (const double number : numbers)
    text_ += std::isfinite(number) ? fmt::format(",{:.10g}", number) : ",nan";
  text_ += "\n";
}

} // namespace asperity::reports
