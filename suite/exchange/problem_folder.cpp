#include "suite/exchange/problem_folder.hpp"

#include "base/atomic_file.hpp"
#include "base/content_hash.hpp"
#include "base/json.hpp"
#include "base/read_file.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "results/storage/hdf5_file.hpp"
#include "suite/exchange/checksums.hpp"
#include "suite/exchange/problem_texts.hpp"
#include "surfaces/formats/map_writer.hpp"
#include "surfaces/formats/npy.hpp"

#include <fmt/format.h>

#include <map>
#include <mutex>
#include <sstream>

namespace asperity::exchange {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

std::string hdf5_bytes(const Problem& problem, const fs::path& folder) {
  const fs::path path = temporary_beside(folder / "heights.h5");
  try {
    {
      const std::lock_guard lock(results::hdf5_mutex());
      results::Hdf5File file(path, results::Hdf5File::Mode::create);
      file.set_attribute("length_x", problem.grid.length_x);
      file.set_attribute("length_y", problem.grid.length_y);
      file.write_map("heights", problem.heights,
                     {static_cast<std::size_t>(problem.grid.points_y),
                      static_cast<std::size_t>(problem.grid.points_x)},
                     results::Hdf5Number::float64, "m");
      file.close();
    }
    std::string bytes = read_file(path, fs::file_size(path));
    fs::remove(path);
    return bytes;
  } catch (...) {
    std::error_code ignored;
    fs::remove(path, ignored);
    throw;
  }
}

/// The sums of a folder; empty if it has none.
std::map<std::string, std::string> sums_in(const fs::path& folder) {
  std::map<std::string, std::string> sums;
  std::error_code error;
  if (!fs::is_regular_file(folder / checksum_file, error))
    return sums;
  std::istringstream lines(
      input::read_input_file(folder / checksum_file, input::largest_text_file));
  for (std::string hash, file; lines >> hash >> file;)
    sums[file] = hash;
  return sums;
}

/// Returns the existing files of a problem's folder.
std::vector<fs::path> problem_files_in(const fs::path& folder) {
  std::vector<fs::path> files;
  for (const char* name :
       {"heights.npy", "heights.h5", "heights.txt", "heights.gwy", "mesh.msh",
        "mesh.inp", "reference.json", "problem.schema.json", "case.toml",
        "README.md", "problem.json", checksum_file})
    if (fs::exists(fs::symlink_status(folder / name)))
      files.push_back(folder / name);
  return files;
}

std::string reference_json(const Problem& problem,
                           std::span<const ProblemAnswer> answers,
                           std::span<const ContinuumAnswer> continuum) {
  Json discrete = Json::array();
  for (const ProblemAnswer& answer : answers)
    discrete.push_back({{"nominal_pressure [Pa]", answer.nominal_pressure},
                        {"mean_gap [m]", answer.mean_gap},
                        {"mean_gap_error [m]", answer.mean_gap_error},
                        {"contact_area_fraction [1]", answer.area_fraction},
                        {"elastic_energy [J/m^2]", answer.elastic_energy},
                        {"largest_pressure [Pa]", answer.largest_pressure},
                        {"energy [J/m^2]", answer.energy}});
  Json limit = Json::array();
  for (const ContinuumAnswer& answer : continuum)
    limit.push_back(
        {{"nominal_pressure [Pa]", answer.nominal_pressure},
         {"mean_gap [m]", answer.mean_gap},
         {"mean_gap_error [m]", answer.mean_gap_error},
         {"contact_area_fraction [1]", answer.area_fraction},
         {"contact_area_fraction_error [1]", answer.area_fraction_error},
         {"source", answer.source}});
  const Json json{
      {"problem", problem.name},
      {"discrete",
       {{"meaning", problem.adhesion ? path_meaning : discrete_meaning},
        {"answers", discrete}}},
      {"continuum", {{"meaning", continuum_meaning}, {"answers", limit}}}};
  return text_of_json(json, 2) + "\n";
}

/// The README of a problem.
/// @param first  the answer at its first load
std::string readme(const Problem& problem, const ProblemAnswer& first,
                   const ProblemMesh* mesh) {
  const ReadmeParts& parts = problem.adhesion ? adhesive_readme : hard_readme;
  const mechanics::ContactInterface law =
      problem.adhesion.value_or(mechanics::ContactInterface{});
  const auto filled = [&](std::string_view text) {
    return fmt::format(
        fmt::runtime(text),
        fmt::arg("cell",
                 problem.is_periodic() ? "a periodic cell" : "a rectangle"),
        fmt::arg("means", problem.is_periodic() ? ", mean(w) = 0" : ""),
        fmt::arg("points_x", problem.grid.points_x),
        fmt::arg("points_y", problem.grid.points_y),
        fmt::arg("steps", problem.loads.size()),
        fmt::arg("loads", problem.loads.size() == 1
                              ? "one nominal pressure"
                              : fmt::format("each of the {} nominal pressures",
                                            problem.loads.size())),
        fmt::arg("first_load", problem.loads.front()),
        fmt::arg("work", law.work_of_adhesion),
        fmt::arg("range", law.adhesion_range),
        fmt::arg("energy", first.energy));
  };
  return fmt::format(
      fmt::runtime(readme_text), fmt::arg("name", problem.name),
      fmt::arg("title", problem.title),
      fmt::arg("statement", filled(parts.statement)),
      fmt::arg("body", stated_body(problem).text),
      fmt::arg("references",
               problem.adhesion
                   ? "our minima along the path, with their energies"
                   : "answers on this grid with rigorous error bounds, and "
                     "estimates of the continuum's answers"),
      fmt::arg("mesh", mesh == nullptr ? "" : mesh_readme(*mesh, problem)),
      fmt::arg("answer", filled(parts.answer)));
}

} // namespace

StatedBody stated_body(const Problem& problem) {
  const mechanics::ElasticBlock& body = problem.body;
  if (body.is_halfspace())
    return {body.is_free() ? free_half_space_text : half_space_text, true,
            mechanics::halfspace(body.contact_modulus, body.border)};
  std::string text =
      body.is_infinite()
          ? std::string("The body is a half-space")
          : fmt::format("The body is a block {:g} m thick", body.thickness);
  if (!body.layers.empty())
    text += fmt::format(", of which {} bonded layer(s) at the contact surface "
                        "have other moduli",
                        body.layers.size());
  return {text + "; `body` in problem.json has all\nmoduli, thicknesses (from "
                 "the contact surface downwards) and the far boundary.\n"};
}

void require_own_problem(const fs::path& folder) {
  const std::map<std::string, std::string> sums = sums_in(folder);
  for (const fs::path& file : problem_files_in(folder)) {
    const auto known = sums.find(file.filename().string());
    const bool is_own =
        fs::is_regular_file(fs::symlink_status(file)) &&
        (file.filename() == checksum_file
             ? sums.contains("heights.npy")
             : known != sums.end() &&
                   known->second == content_hash(read_file(
                                        file, input::largest_number_file)));
    if (!is_own)
      throw input::InputError(fmt::format(
          "{}: is there already, but not as 'asperity problem' writes it "
          "(SHA256SUMS); move it away, or name another --out",
          file.string()));
  }
}

void write_problem(const Problem& problem,
                   std::span<const ProblemAnswer> answers,
                   std::span<const ContinuumAnswer> continuum,
                   const std::string& case_text, const fs::path& folder,
                   const ProblemMesh* mesh) {
  require_own_problem(folder);
  fs::create_directories(folder);
  for (const fs::path& file : problem_files_in(folder))
    if (file.filename() != checksum_file)
      fs::remove(file);
  Hashes hashes;
  // The sums come first, so that the files of a process that is killed are
  // known as ours.
  const auto write = [&](const std::string& name, const std::string& bytes) {
    hashes.emplace_back(name, content_hash(bytes));
    write_file_atomically(folder / checksum_file, checksum_text(hashes));
    write_file_atomically(folder / name, bytes);
  };
  const Grid& grid = problem.grid;
  write("heights.npy",
        surfaces::npy_bytes(problem.heights,
                            static_cast<std::size_t>(grid.points_y),
                            static_cast<std::size_t>(grid.points_x)));
  write("heights.h5", hdf5_bytes(problem, folder));
  const surfaces::HeightMap map{grid, problem.heights};
  write("heights.txt", surfaces::gwyddion_text(map, problem.name));
  write("heights.gwy", surfaces::gwyddion_bytes(map, problem.name));
  const std::string json =
      problem_json(problem, answers.front(), hashes,
                   mesh == nullptr ? Json() : mesh_json(*mesh));
  if (mesh != nullptr) {
    write("mesh.msh", gmsh_text(*mesh));
    write("mesh.inp", abaqus_text(*mesh));
  }
  write("reference.json", reference_json(problem, answers, continuum));
  write("problem.schema.json", std::string(problem_schema));
  if (!case_text.empty())
    write("case.toml", case_text);
  write("README.md", readme(problem, answers.front(), mesh));
  write("problem.json", json);
}

References read_references(const fs::path& folder) {
  const fs::path file = folder / "reference.json";
  References found;
  if (!fs::exists(file))
    return found;
  input::require_own_file(folder, file);
  const auto number = [](const Json& answer, const char* name) {
    const Json& member = answer.at(name);
    return member.is_null() ? not_a_number : member.get<double>();
  };
  try {
    const Json json =
        json_of_text(input::read_input_file(file, input::largest_text_file));
    for (const Json& answer : json.at("discrete").at("answers"))
      found.discrete.push_back(
          {number(answer, "nominal_pressure [Pa]"),
           number(answer, "mean_gap [m]"), number(answer, "mean_gap_error [m]"),
           number(answer, "contact_area_fraction [1]"),
           number(answer, "elastic_energy [J/m^2]"),
           number(answer, "largest_pressure [Pa]"),
           answer.contains("energy [J/m^2]") ? number(answer, "energy [J/m^2]")
                                             : not_a_number});
    for (const Json& answer : json.at("continuum").at("answers"))
      found.continuum.push_back(
          {number(answer, "nominal_pressure [Pa]"),
           number(answer, "mean_gap [m]"), number(answer, "mean_gap_error [m]"),
           number(answer, "contact_area_fraction [1]"),
           number(answer, "contact_area_fraction_error [1]"),
           answer.at("source").get<std::string>()});
  } catch (const Json::exception& error) {
    throw input::InputError(fmt::format("{}: {}", file.string(), error.what()));
  }
  return found;
}

} // namespace asperity::exchange
