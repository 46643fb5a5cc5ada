#include "suite/exchange/submission.hpp"

#include "base/maximum.hpp"
#include "base/plain_text.hpp"
#include "input/input_error.hpp"
#include "input/input_file.hpp"
#include "input/nearest.hpp"
#include "input/text/toml_text.hpp"
#include "suite/exchange/pressure_file.hpp"
#include "surfaces/formats/text/number_table.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

namespace asperity::exchange {
namespace {

using cases::Node;
using cases::NodeType;
using input::Mistakes;

constexpr std::size_t most_texts = 100; ///< authors, for example
/// [Pa]; results keep fields in single precision.
constexpr double largest_pressure = 1e30;

/// Reads the keys of one table of submission.toml and collects the mistakes.
class SubmissionTable {
public:
  SubmissionTable(const Node& table, std::vector<std::string> keys,
                  Mistakes& mistakes)
      : table_(table), keys_(std::move(keys)), mistakes_(mistakes) {
    for (const cases::NodeEntry& entry : table.entries)
      if (std::ranges::find(keys_, entry.key) == keys_.end())
        mistakes_.add(entry.node.place,
                      fmt::format("{} is unknown; nearest: {}; allowed are {}",
                                  entry.node.path,
                                  input::nearest(entry.key, keys_),
                                  fmt::join(keys_, ", ")));
  }

  std::string text(const std::string& key, bool is_needed = true,
                   std::size_t longest = longest_line) {
    const Node* const node = find(key, is_needed, "a text");
    if (node == nullptr)
      return {};
    if (node->type != NodeType::text)
      refuse(*node, "must be a text in quotes on one line");
    else if (const std::string rule = line_mistake(node->text, longest);
             !rule.empty())
      refuse(*node, rule);
    return node->text;
  }

  /// A file in the folder of the submission.
  std::filesystem::path file(const std::string& key) {
    std::filesystem::path named = text(key);
    if (named.is_absolute() ||
        std::ranges::find(named, std::filesystem::path("..")) != named.end())
      refuse(*table_.find(key), "must be a file of this folder");
    return named;
  }

  /// NaN if the key is missing and not needed.
  double number(const std::string& key, double lowest, double highest,
                bool is_needed = false) {
    const std::string rule =
        highest < infinity
            ? fmt::format("must be a number from {:g} to {:g}", lowest, highest)
            : fmt::format("must be a finite number >= {:g}", lowest);
    const Node* const node = find(key, is_needed, rule.substr(8));
    if (node == nullptr)
      return not_a_number;
    const double found = node->is_number() ? node->number() : not_a_number;
    if (!(found >= lowest) || !(found <= highest) || std::isinf(found))
      refuse(*node, rule);
    return found;
  }

  std::vector<std::string> texts(const std::string& key) {
    std::vector<std::string> found;
    const Node* const node = find(key, true, "a list of texts");
    if (node == nullptr)
      return found;
    for (const Node& item : node->list)
      if (item.type == NodeType::text && line_mistake(item.text).empty())
        found.push_back(item.text);
    if (node->list.empty() || found.size() != node->list.size() ||
        found.size() > most_texts)
      refuse(*node, fmt::format("must be a list of 1 to {} texts in quotes, "
                                "each on one line of at most {} bytes",
                                most_texts, longest_line));
    return found;
  }

  /// At least `lowest`, which is returned for a mistake.
  int count(const std::string& key, int lowest) {
    const double found = number(key, lowest, 1e6, true);
    if (std::isfinite(found) && found != std::floor(found))
      refuse(*table_.find(key), "must be a whole number");
    return std::isfinite(found) ? static_cast<int>(found) : lowest;
  }

  void refuse(const Node& node, const std::string& rule) {
    mistakes_.add(node.place,
                  fmt::format("{} = {}, but {}", node.path,
                              printable(cases::written(node)), rule));
  }

  const Node& node() const { return table_; }

private:
  const Node* find(const std::string& key, bool is_needed,
                   const std::string& what) {
    const Node* const node = table_.find(key);
    if (node == nullptr && is_needed)
      mistakes_.add(table_.place,
                    fmt::format("{}{}{} is missing: {}", table_.path,
                                table_.path.empty() ? "" : ".", key, what));
    return node;
  }

  const Node& table_;
  std::vector<std::string> keys_;
  Mistakes& mistakes_;
};

/// Returns the index of a load of the problem, to 1e-6 of it.
std::optional<std::size_t> load_at(const Problem& problem, double pressure) {
  for (std::size_t i = 0; i < problem.loads.size(); ++i)
    if (std::abs(pressure / problem.loads[i] - 1.0) <= 1e-6)
      return i;
  return std::nullopt;
}

/// The keys of a [[load]].
std::vector<std::string> load_keys(const Problem& problem) {
  std::vector<std::string> keys =
      problem.adhesion
          ? std::vector<std::string>{"step", "energy"}
          : std::vector<std::string>{"nominal_pressure", "mean_gap",
                                     "contact_area_fraction", "elastic_energy"};
  for (const char* const key :
       {"pressure", "nodal_force", "cpu_time", "cpu_time_low", "cpu_time_high",
        "peak_memory", "iterations"})
    keys.emplace_back(key);
  return keys;
}

/// The load of the problem that a [[load]] answers: that of its nominal
/// pressure, or with adhesion the step of the path, counted from 0.
std::size_t answered_load(const Problem& problem, SubmissionTable& table) {
  if (problem.adhesion) {
    const auto step = static_cast<std::size_t>(table.count("step", 0));
    const std::size_t last = problem.loads.size() - 1;
    if (step > last)
      table.refuse(*table.node().find("step"),
                   fmt::format("the steps of the path are 0 to {}", last));
    return std::min(step, last);
  }
  const double pressure = table.number("nominal_pressure", 0.0, infinity, true);
  const std::optional<std::size_t> found = load_at(problem, pressure);
  if (!found && std::isfinite(pressure))
    table.refuse(*table.node().find("nominal_pressure"),
                 fmt::format("must be a load of the problem [Pa]: {}",
                             fmt::join(problem.loads, ", ")));
  return found.value_or(0);
}

void read_load(const Node& node, const Problem& problem,
               const std::filesystem::path& folder, Submission& submission,
               Mistakes& mistakes) {
  SubmissionTable table(node, load_keys(problem), mistakes);
  SubmittedLoad load;
  load.load = answered_load(problem, table);
  if (std::ranges::find(submission.loads, load.load, &SubmittedLoad::load) !=
      submission.loads.end())
    mistakes.add(node.place, fmt::format("{} is the second one at the load {}",
                                         node.path, problem.loads[load.load]));
  load.is_force = node.find("nodal_force") != nullptr;
  if (load.is_force && node.find("pressure") != nullptr)
    mistakes.add(
        node.place,
        fmt::format("{} has a pressure and a nodal_force, but must have one "
                    "of them",
                    node.path));
  load.file = folder / table.file(load.is_force ? "nodal_force" : "pressure");
  load.mean_gap = table.number("mean_gap", -infinity, infinity);
  load.area_fraction = table.number("contact_area_fraction", 0.0, 1.0);
  load.elastic_energy = table.number("elastic_energy", 0.0, infinity);
  load.energy = table.number("energy", -infinity, infinity);
  load.cpu_time = table.number("cpu_time", 0.0, infinity);
  load.cpu_time_low = table.number("cpu_time_low", 0.0, infinity);
  load.cpu_time_high = table.number("cpu_time_high", 0.0, infinity);
  if (!std::isnan(load.cpu_time_low + load.cpu_time_high) &&
      !(load.cpu_time_low <= load.cpu_time &&
        load.cpu_time <= load.cpu_time_high))
    table.refuse(*node.find("cpu_time_low"),
                 "cpu_time must be between it and cpu_time_high");
  load.peak_memory = table.number("peak_memory", 0.0, infinity);
  if (node.find("iterations") != nullptr)
    load.iterations = table.count("iterations", 0);
  submission.loads.push_back(std::move(load));
}

Timing read_timing(const Node& node, const Problem& problem,
                   Mistakes& mistakes) {
  SubmissionTable table(node, {"run", "pairs", "threads", "heights"}, mistakes);
  Timing timing{table.text("run"), table.count("pairs", 2),
                table.count("threads", 1), table.text("heights")};
  if (!timing.heights.empty() && timing.heights != problem.heights_hash)
    table.refuse(*node.find("heights"),
                 fmt::format("heights.npy of the problem has the SHA-256 {}: "
                             "the times are of another surface",
                             problem.heights_hash));
  return timing;
}

/// Reads "nominal_pressure [Pa],mean_gap [m],area_fraction [1]" and its rows.
std::vector<SubmittedRow> read_curve(const std::filesystem::path& file) {
  const std::string text =
      input::read_input_file(file, input::largest_number_file);
  const std::string header =
      "nominal_pressure [Pa],mean_gap [m],area_fraction [1]";
  const std::size_t end = std::min(text.find_first_of("\r\n"), text.size());
  if (text.substr(0, end) != header)
    throw input::InputError(fmt::format(
        "{}:1: begins with \"{}\", but must "
        "begin with \"{}\"",
        file.string(), text.substr(0, std::min(end, 60UL)), header));
  const surfaces::NumberTable table =
      surfaces::read_number_text("#" + text, file.string());
  std::vector<SubmittedRow> rows;
  rows.reserve(table.rows());
  for (std::size_t i = 0; i < table.rows(); ++i) {
    if (table.columns != 3 || !(table.number(i, 0) > 0.0) ||
        !(table.number(i, 2) >= 0.0) || !(table.number(i, 2) <= 1.0))
      surfaces::refuse_line(file.string(), table.lines[i],
                            "must have three numbers: a pressure > 0, a mean "
                            "gap and an area fraction from 0 to 1");
    rows.push_back(
        {table.number(i, 0), table.number(i, 1), table.number(i, 2)});
  }
  return rows;
}

void read_head(SubmissionTable& table, const Problem& problem,
               Submission& submission) {
  submission.problem = table.text("problem");
  if (!submission.problem.empty() && submission.problem != problem.name)
    table.refuse(*table.node().find("problem"),
                 fmt::format("problem.json is \"{}\"", problem.name));
  // Both are parts of the name of a method.
  constexpr std::size_t longest = 40;
  static_assert(2 * longest + sizeof "--default" <= longest_name);
  submission.code = table.text("code", true, longest);
  submission.version = table.text("version", true, longest);
  submission.method = table.text("method");
  submission.accuracy = table.text("accuracy");
  if (!submission.accuracy.empty() && submission.accuracy != "default" &&
      submission.accuracy != "best")
    table.refuse(*table.node().find("accuracy"),
                 "must be \"default\" or \"best\"");
  submission.authors = table.texts("authors");
  submission.licence = table.text("licence");
  submission.machine = table.text("machine", false);
  submission.element = table.text("element", false);
  if (!submission.element.empty() && submission.element != "Q1" &&
      submission.element != "Q2")
    table.refuse(
        *table.node().find("element"),
        "must be \"Q1\" or \"Q2\", the elements of the problem's mesh");
  const double claimed = table.number("claimed_error", 0.0, 1.0);
  if (std::isfinite(claimed))
    submission.claimed_error = claimed;
}

Node parsed_submission(const std::filesystem::path& folder) {
  const std::filesystem::path file = folder / "submission.toml";
  input::require_own_file(folder, file);
  return cases::parse_toml(
      input::read_input_file(file, input::largest_text_file), file.string(),
      "submission.toml");
}

} // namespace

std::string submitted_problem(const std::filesystem::path& folder) {
  const Node root = parsed_submission(folder);
  const Node* const name = root.find("problem");
  if (name == nullptr || name->type != NodeType::text || name->text.empty())
    throw input::InputError(
        fmt::format("{}: problem is missing: the name of the problem",
                    (folder / "submission.toml").string()));
  return name->text;
}

Submission read_submission(const std::filesystem::path& folder,
                           const Problem& problem) {
  const Node root = parsed_submission(folder);
  Mistakes mistakes;
  SubmissionTable table(root,
                        {"problem", "code", "version", "method", "accuracy",
                         "authors", "licence", "machine", "element",
                         "claimed_error", "timing", "load", "curve"},
                        mistakes);
  Submission submission;
  read_head(table, problem, submission);
  std::filesystem::path curve_file;
  if (const Node* const loads = root.find("load"))
    for (const Node& load : loads->list)
      read_load(load, problem, folder, submission, mistakes);
  if (const Node* const timing = root.find("timing"))
    submission.timing = read_timing(*timing, problem, mistakes);
  if (const Node* const curve = root.find("curve"))
    curve_file = SubmissionTable(*curve, {"file"}, mistakes).file("file");
  if (submission.loads.empty() && root.find("curve") == nullptr)
    mistakes.add({(folder / "submission.toml").string(), 0},
                 "has neither [[load]] with a pressure field nor [curve]");
  mistakes.throw_if_any("submission.toml");
  for (SubmittedLoad& load : submission.loads) {
    input::require_own_file(folder, load.file);
    // So many that a field on another grid is still told by its shape.
    surfaces::Matrix matrix =
        read_pressure_file(load.file, 16 * problem.grid.size());
    load.rows = matrix.rows;
    load.columns = matrix.columns;
    load.pressure = std::move(matrix.numbers);
    if (load.is_force)
      for (double& value : load.pressure)
        value /= problem.grid.spacing_x() * problem.grid.spacing_y();
    if (const double found = largest_magnitude(load.pressure);
        !(found <= largest_pressure))
      throw input::InputError(
          fmt::format("{}: has a pressure of magnitude {:.3g} Pa, but at most "
                      "{:g} Pa may be",
                      load.file.string(), found, largest_pressure));
  }
  if (!curve_file.empty()) {
    input::require_own_file(folder, folder / curve_file);
    submission.curve = read_curve(folder / curve_file);
  }
  return submission;
}

} // namespace asperity::exchange
