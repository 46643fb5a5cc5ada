#include "suite/exchange/problem.hpp"

#include "base/content_hash.hpp"
#include "base/field_sums.hpp"
#include "base/json.hpp"
#include "base/maximum.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "mechanics/limits.hpp"
#include "suite/exchange/checksums.hpp"
#include "surfaces/formats/npy.hpp"
#include "surfaces/maps/statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace asperity::exchange {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::array far_boundary_words{"clamped", "sliding", "pressure"};

Json body_json(const mechanics::ElasticBlock& body) {
  Json layers = Json::array();
  for (const mechanics::BondedLayer& layer : body.layers)
    layers.push_back({{"thickness [m]", layer.thickness},
                      {"youngs_modulus [Pa]", layer.youngs_modulus},
                      {"poisson_ratio [1]", layer.poisson_ratio}});
  Json json = {{"contact_modulus [Pa]", body.contact_modulus},
               {"poisson_ratio [1]", nullptr},
               {"thickness [m]", nullptr},
               {"far_boundary", nullptr},
               {"layers", layers}};
  if (!body.is_halfspace())
    json["poisson_ratio [1]"] = body.poisson_ratio; // E* suffices otherwise
  if (!body.is_infinite()) {
    json["thickness [m]"] = body.thickness;
    json["far_boundary"] =
        far_boundary_words.at(static_cast<std::size_t>(body.far_boundary));
  }
  return json;
}

constexpr const char* hard_contact = "frictionless, non-adhesive, hard";
constexpr const char* adhesive_contact =
    "frictionless, hard wall, exponential attraction";

/// The name of a load in problem.json.
const char* load_name(const Problem& problem) {
  return problem.adhesion ? "mean_gap [m]" : "nominal_pressure [Pa]";
}

Json conventions(const Problem& problem) {
  const bool is_periodic = problem.is_periodic();
  Json json = {
      {"units", "SI; the unit of a number is in the brackets of its name"},
      {"axes", std::string("row i of a field is y = i length_y/points_y, "
                           "column j is x = j length_x/points_x; ") +
                   (is_periodic ? "both directions are periodic"
                                : "there is no pressure beyond the border, "
                                  "half a cell outside the outermost nodes")},
      {"heights", "positive towards the elastic block: the largest value "
                  "touches first; their mean is 0"},
      {"pressure",
       std::string(problem.adhesion ? "positive in compression, negative in "
                                      "tension, "
                                    : "p >= 0 in compression, ") +
           "a pressure and not a force, one value per node"},
      {"mean_gap",
       is_periodic
           ? "u in g = u + C p - h, where C p has mean 0: the mean of "
             "the gap over all nodes, contact included"
           : "the mean of g = d + C p - h over all nodes, contact included, "
             "where C p vanishes at infinity: d plus the mean of C p"},
      {"contact_area_fraction", problem.adhesion
                                    ? "share of the nodes with g = 0"
                                    : "share of the nodes with p > 0"},
      {"elastic_energy", "mean of p C p, divided by 2"}};
  if (problem.adhesion)
    json["energy"] = "the elastic energy of the gap, mean(w K w)/2 with w = g "
                     "+ h - mean(g + h) and K = 1/C, plus the mean of W(g)";
  return json;
}

Json adhesion_json(const mechanics::ContactInterface& law) {
  return {{"energy_per_area", "W(g) = -gamma exp(-g/rho), g >= 0"},
          {"work_of_adhesion [J/m^2]", law.work_of_adhesion},
          {"range [m]", law.adhesion_range}};
}

/// The members of problem.json, whose messages name the file and the member.
class ProblemMembers {
public:
  ProblemMembers(const Json& json, std::string path)
      : json_(json), path_(std::move(path)) {}

  [[noreturn]] void refuse(const std::string& member,
                           const std::string& rule) const {
    const auto pointer = Json::json_pointer(member);
    const std::string found = json_.contains(pointer)
                                  ? text_of_json(json_.at(pointer), -1)
                                  : "missing";
    throw input::InputError(fmt::format("{}: {} is {}, but must be {}", path_,
                                        member, printable(found), rule));
  }

  const Json& at(const std::string& member, const std::string& rule) const {
    const auto pointer = Json::json_pointer(member);
    if (!json_.contains(pointer))
      refuse(member, rule);
    return json_.at(pointer);
  }

  double number(const std::string& member, double lowest,
                double highest = largest) const {
    const std::string rule =
        highest == largest
            ? fmt::format("a number > {:g}", lowest)
            : fmt::format("a number between {:g} and {:g}", lowest, highest);
    const Json& found = at(member, rule);
    if (!found.is_number() || !(found.get<double>() > lowest) ||
        !(found.get<double>() <= highest))
      refuse(member, rule);
    return found.get<double>();
  }

  int count(const std::string& member) const {
    const std::string rule = "a whole number between 2 and 65536";
    const Json& found = at(member, rule);
    if (!found.is_number_integer() || found < 2 || found > 65536)
      refuse(member, rule);
    return found.get<int>();
  }

  std::string text(const std::string& member) const {
    const std::string rule = "a text";
    const Json& found = at(member, rule);
    if (!found.is_string())
      refuse(member, rule);
    return found.get<std::string>();
  }

  std::string line(const std::string& member) const {
    std::string found = text(member);
    if (const std::string rule = line_mistake(found); !rule.empty())
      refuse(member, rule.substr(std::string_view("must be ").size()));
    return found;
  }

  /// Requires a stated number to be the one that follows from the heights.
  void require(const std::string& member, double found) const {
    constexpr double tolerance = 1e-6;
    const double stated = number(member, 0.0);
    if (!(std::abs(stated - found) <= tolerance * found))
      refuse(member,
             fmt::format("{:.9g}, which follows from heights.npy", found));
  }

  std::size_t list_size(const std::string& member) const {
    const std::string rule = "a list of at most 10000 members";
    const Json& found = at(member, rule);
    if (!found.is_array() || found.size() > 10000)
      refuse(member, rule);
    return found.size();
  }

  static constexpr double largest = std::numeric_limits<double>::max();

private:
  const Json& json_;
  std::string path_;
};

mechanics::ElasticBlock read_body(const ProblemMembers& members) {
  mechanics::ElasticBlock body;
  body.contact_modulus = members.number("/body/contact_modulus [Pa]", 0.0);
  if (!members.at("/body/poisson_ratio [1]", "a number or null").is_null())
    body.poisson_ratio = members.number("/body/poisson_ratio [1]", -1.0, 0.5);
  body.thickness = infinity;
  if (!members.at("/body/thickness [m]", "a length or null").is_null()) {
    body.thickness = members.number("/body/thickness [m]", 0.0);
    const auto* const found = std::ranges::find(
        far_boundary_words, members.text("/body/far_boundary"));
    if (found == far_boundary_words.end())
      members.refuse("/body/far_boundary", "clamped, sliding or pressure");
    body.far_boundary =
        static_cast<mechanics::FarBoundary>(found - far_boundary_words.begin());
  }
  for (std::size_t i = 0; i < members.list_size("/body/layers"); ++i) {
    const std::string layer = fmt::format("/body/layers/{}/", i);
    body.layers.push_back(
        {members.number(layer + "thickness [m]", 0.0),
         members.number(layer + "youngs_modulus [Pa]", 0.0),
         members.number(layer + "poisson_ratio [1]", -1.0, 0.5)});
  }
  return body;
}

/// The contact of a problem with adhesion; none: it is hard.
std::optional<mechanics::ContactInterface>
read_contact(const ProblemMembers& members, const Problem& problem) {
  const bool is_periodic = problem.is_periodic();
  const std::string words = members.text("/contact");
  if (words == hard_contact)
    return std::nullopt;
  if (words != adhesive_contact || !is_periodic)
    members.refuse(
        "/contact",
        is_periodic
            ? fmt::format("\"{}\" or \"{}\"", hard_contact, adhesive_contact)
            : fmt::format("\"{}\" without periodic boundaries", hard_contact));
  mechanics::ContactInterface law{mechanics::ContactLaw::exponential};
  law.work_of_adhesion =
      members.number("/adhesion/work_of_adhesion [J~1m^2]", 0.0);
  law.adhesion_range =
      members.number("/adhesion/range [m]", 0.0, mechanics::largest_length);
  if (!(law.grid_number(
            problem.body.contact_modulus,
            std::max(problem.grid.spacing_x(), problem.grid.spacing_y())) <=
        mechanics::largest_grid_number))
    members.refuse("/adhesion/range [m]",
                   "so long that the grid resolves it, work_of_adhesion "
                   "spacing/(range^2 contact_modulus) <= 1");
  return law;
}

Json parsed(const std::filesystem::path& path) {
  const std::string text =
      input::read_input_file(path, input::largest_text_file);
  try {
    return json_of_text(text);
  } catch (const Json::parse_error& error) {
    const auto end = text.begin() + static_cast<std::ptrdiff_t>(
                                        std::min(error.byte, text.size()));
    throw input::InputError(fmt::format("{}:{}: is not JSON: {}", path.string(),
                                        1 + std::count(text.begin(), end, '\n'),
                                        error.what()));
  }
}

void read_heights(const std::filesystem::path& folder,
                  const ProblemMembers& members, Problem& problem) {
  const std::filesystem::path file = folder / "heights.npy";
  input::require_own_file(folder, file);
  const std::string bytes =
      input::read_input_file(file, input::largest_number_file);
  problem.heights_hash = content_hash(bytes);
  if (problem.heights_hash != members.text("/heights/files/heights.npy"))
    throw input::InputError(
        fmt::format("{}: its SHA-256 is {}, but problem.json states {}: it is "
                    "not the surface of this problem",
                    file.string(), problem.heights_hash,
                    members.text("/heights/files/heights.npy")));
  surfaces::Matrix matrix = surfaces::read_npy_text(bytes, file.string());
  const Grid& grid = problem.grid;
  if (matrix.rows != static_cast<std::size_t>(grid.points_y) ||
      matrix.columns != static_cast<std::size_t>(grid.points_x))
    throw input::InputError(fmt::format(
        "{}: has {} rows and {} columns, but problem.json states {} and {}",
        file.string(), matrix.rows, matrix.columns, grid.points_y,
        grid.points_x));
  if (!all_finite(matrix.numbers))
    throw input::InputError(
        fmt::format("{}: must hold finite numbers", file.string()));
  problem.heights = std::move(matrix.numbers);
  problem.rms_height = rms_height(problem.heights);
  if (problem.rms_height == 0.0)
    throw input::InputError(
        fmt::format("{}: the surface is flat", file.string()));
  for (const double length : {problem.rms_height, grid.length_x, grid.length_y,
                              largest_magnitude(problem.heights)})
    if (!(length >= mechanics::least_length &&
          length <= mechanics::largest_length))
      throw input::InputError(fmt::format(
          "{}: heights or a side of {:.3g} m, but lengths other than 0 must be "
          "between {} and {} m",
          file.string(), length, mechanics::least_length,
          mechanics::largest_length));
  problem.rms_slope = surfaces::statistics({grid, problem.heights}).rms_slope;
  members.require("/heights/rms_height [m]", problem.rms_height);
  members.require("/heights/rms_slope [1]", problem.rms_slope);
}

} // namespace

std::unique_ptr<contact::SurfaceOperator>
surface_operator(const Problem& problem, const Grid& grid) {
  return contact::halfspace_operator(grid, problem.body).clone();
}

std::string
problem_json(const Problem& problem, const ProblemAnswer& example,
             std::span<const std::pair<std::string, std::string>> hashes,
             const Json& mesh) {
  Json files = Json::object();
  for (const auto& [file, hash] : hashes)
    files[file] = hash;
  Json loads = Json::array();
  for (const double load : problem.loads)
    loads.push_back({{load_name(problem), load}});
  const Grid& grid = problem.grid;
  Json json = {{"format", "asperity-problem"},
               {"format_version", 1},
               {"name", problem.name},
               {"title", problem.title},
               {"grid",
                {{"points_x", grid.points_x},
                 {"points_y", grid.points_y},
                 {"length_x [m]", grid.length_x},
                 {"length_y [m]", grid.length_y},
                 {"is_periodic", problem.is_periodic()}}},
               {"heights",
                {{"files", files},
                 {"rms_height [m]", problem.rms_height},
                 {"rms_slope [1]", problem.rms_slope},
                 {"highest [m]", std::ranges::max(problem.heights)}}},
               {"body", body_json(problem.body)},
               {"contact", problem.adhesion ? adhesive_contact : hard_contact},
               {"loads", loads},
               {"requested",
                {"pressure field", "mean_gap", "contact_area_fraction",
                 "elastic_energy"}},
               {"conventions", conventions(problem)},
               {"example",
                {{"nominal_pressure [Pa]", example.nominal_pressure},
                 {"mean_gap [m]", example.mean_gap},
                 {"contact_area_fraction [1]", example.area_fraction},
                 {"elastic_energy [J/m^2]", example.elastic_energy},
                 {"largest_pressure [Pa]", example.largest_pressure}}}};
  if (problem.adhesion) {
    json["adhesion"] = adhesion_json(*problem.adhesion);
    json["requested"] = {"pressure field", "energy"};
    json["example"]["energy [J/m^2]"] = example.energy;
  }
  if (!mesh.is_null())
    json["mesh"] = mesh;
  return text_of_json(json, 2) + "\n";
}

Problem read_problem(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "problem.json";
  input::require_own_file(folder, file);
  const Json json = parsed(file);
  const ProblemMembers members(json, file.string());
  if (members.text("/format") != "asperity-problem")
    members.refuse("/format", "\"asperity-problem\"");
  if (members.at("/format_version", "1") != 1)
    members.refuse("/format_version", "1");
  Problem problem;
  problem.name = members.text("/name");
  if (!is_good_name(problem.name) || problem.name.front() == '.')
    members.refuse("/name", fmt::format("1 to {} letters, digits, blanks and "
                                        ". _ + -, the first of them no point",
                                        longest_name));
  problem.title = members.line("/title");
  problem.grid = {members.count("/grid/points_x"),
                  members.count("/grid/points_y"),
                  members.number("/grid/length_x [m]", 0.0),
                  members.number("/grid/length_y [m]", 0.0)};
  const Json& periodic = members.at("/grid/is_periodic", "true or false");
  if (!periodic.is_boolean())
    members.refuse("/grid/is_periodic", "true or false");
  problem.body = read_body(members);
  if (!periodic.get<bool>())
    problem.body.border = mechanics::Border::free;
  if (!problem.is_periodic() && std::isfinite(problem.body.thickness))
    members.refuse("/body/thickness [m]", "null without periodic boundaries");
  if (!problem.is_periodic() && !problem.body.layers.empty())
    members.refuse("/body/layers", "empty without periodic boundaries");
  problem.adhesion = read_contact(members, problem);
  for (std::size_t i = 0; i < members.list_size("/loads"); ++i) {
    const std::string load = fmt::format("/loads/{}/{}", i, load_name(problem));
    problem.loads.push_back(problem.adhesion
                                ? members.number(load, mechanics::least_length,
                                                 mechanics::largest_length)
                                : members.number(load, 0.0));
  }
  if (problem.loads.empty())
    members.refuse("/loads", "a list of at least one load");
  read_heights(folder, members, problem);
  verified_files(folder);
  return problem;
}

} // namespace asperity::exchange
