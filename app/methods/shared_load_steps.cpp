#include "app/methods/shared_load_steps.hpp"

#include "app/methods/chosen.hpp"
#include "app/methods/shared_surface.hpp"
#include "contact/operators/halfspace.hpp"
#include "contact/operators/shared_fourier_operator.hpp"
#include "fem/plugin.hpp"

#include <nlohmann/json.hpp>

#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

namespace asperity::app {
namespace {

using nlohmann::json;

constexpr const char* command_key = "shared load steps";

/// JSON has no infinity.
json finite_or_null(double value) {
  return std::isinf(value) ? json() : json(value);
}

double or_infinite(const json& value) {
  return value.is_null() ? std::numeric_limits<double>::infinity()
                         : value.get<double>();
}

json json_of_block(const mechanics::ElasticBlock& block) {
  json layers = json::array();
  for (const mechanics::BondedLayer& layer : block.layers)
    layers.push_back(
        {layer.thickness, layer.youngs_modulus, layer.poisson_ratio});
  return {{"modulus", block.contact_modulus},
          {"poisson", block.poisson_ratio},
          {"thickness", finite_or_null(block.thickness)},
          {"far", static_cast<int>(block.far_boundary)},
          {"layers", layers}};
}

mechanics::ElasticBlock block_in(const json& text) {
  mechanics::ElasticBlock block{
      text.at("modulus"), text.at("poisson"), or_infinite(text.at("thickness")),
      static_cast<mechanics::FarBoundary>(text.at("far").get<int>())};
  for (const json& layer : text.at("layers"))
    block.layers.push_back({layer.at(0), layer.at(1), layer.at(2)});
  return block;
}

/// The operator of the block of a "build" command on the rows of this rank.
std::unique_ptr<contact::SurfaceOperator>
elasticity_in(const json& command, const Grid& grid, int threads) {
  const fem::FemModule& fem_module = fem::load_fem_module();
  if (command.contains("request"))
    return fem_module.condensed_on_ranks(command.at("request"), threads);
  return std::make_unique<contact::SharedFourierOperator>(
      grid, fem_module.rank_group(),
      contact::compliance_column(grid, block_in(command.at("block"))), threads);
}

/// The part of one rank in a loading path.
struct RankPart {
  SharedRows rows;
  std::unique_ptr<LoadSteps> steps;
  /// Of the last step, if its maps are needed.
  std::vector<double> pressure = {}, gap = {};
};

std::map<int, RankPart>& parts_of_this_rank() {
  static std::map<int, RankPart> parts;
  return parts;
}

RankPart& part_in(const json& command) {
  return parts_of_this_rank().at(command.at("number").get<int>());
}

void add_setting(const LoadStepsSetting& setting, json& command) {
  const Observation& observed = setting.observation;
  command["law"] = static_cast<int>(setting.interface.law);
  command["penalty"] = setting.interface.penalty;
  command["gap_tolerance"] = setting.gap_tolerance;
  command["max_iterations"] = setting.max_iterations;
  command["threads"] = setting.threads;
  command["rms_height"] = setting.rms_height;
  command["local_compliance"] = observed.local_compliance;
  command["area_coefficients"] = {observed.area_coefficients.perimeter,
                                  observed.area_coefficients.euler};
  command["contact_modulus"] = observed.contact_modulus;
  command["has_middle"] = observed.has_middle;
}

LoadStepsSetting setting_in(const json& command) {
  LoadStepsSetting setting;
  setting.interface = {
      static_cast<mechanics::ContactLaw>(command.at("law").get<int>()),
      command.at("penalty")};
  setting.gap_tolerance = command.at("gap_tolerance");
  setting.max_iterations = command.at("max_iterations");
  setting.threads = command.at("threads");
  setting.rms_height = command.at("rms_height");
  Observation& observed = setting.observation;
  observed.local_compliance = command.at("local_compliance");
  const json& coefficients = command.at("area_coefficients");
  observed.area_coefficients = {coefficients.at(0), coefficients.at(1)};
  observed.contact_modulus = command.at("contact_modulus");
  observed.has_middle = command.at("has_middle");
  return setting;
}

// Each command is a function that every rank calls. Rank 0 gives it whole
// fields and receives whole fields; the others give and receive nothing.

void build_part(const json& command, std::span<const double> heights) {
  const json& points = command.at("grid");
  const Grid grid{points.at(0), points.at(1), points.at(2), points.at(3)};
  const LoadStepsSetting setting = setting_in(command);
  std::unique_ptr<contact::SurfaceOperator> elasticity =
      elasticity_in(command, grid, setting.threads);
  const SharedRows rows = *elasticity->shared_rows();
  std::vector<double> own =
      command.contains("surface")
          ? take_heights(command.at("surface"), rows, setting.threads)
          : rows.scattered(heights);
  parts_of_this_rank().insert_or_assign(
      command.at("number").get<int>(),
      RankPart{rows, make_load_steps(std::move(elasticity), std::move(own),
                                     setting)});
}

/// Each rank keeps its rows of the maps until the next call, if they are
/// needed.
StepAnswer solve_part(const json& command) {
  RankPart& part = part_in(command);
  part.pressure = part.gap = {};
  const bool needs_maps = command.at("needs_maps");
  StepAnswer answer = part.steps->solve(
      {{static_cast<mechanics::Control>(command.at("control").get<int>()),
        command.at("amount")},
       command.at("step"),
       needs_maps});
  if (needs_maps) {
    part.pressure = std::move(answer.pressure);
    part.gap = std::move(answer.gap);
  }
  answer.pressure = answer.gap = {};
  return answer;
}

/// Passes a map of the last step to rank 0.
void send_part(const json& command, const results::TakeValues& take) {
  const RankPart& part = part_in(command);
  part.rows.pass_to_rank_0(
      command.at("field") == "pressure" ? part.pressure : part.gap, take);
}

/// The layout of contact::LoadSequence::memory(): a number, then a number and a
/// field of each step.
std::vector<double> memory_part(const json& command) {
  const RankPart& part = part_in(command);
  const std::vector<double> own = part.steps->memory();
  std::vector<double> all;
  for (std::size_t at = 1; at < own.size(); at += part.rows.size() + 1) {
    if (all.empty())
      all.push_back(own[0]);
    all.push_back(own[at]);
    const std::vector<double> field = part.rows.gathered_on_rank_0(
        std::span(own).subspan(at + 1, part.rows.size()));
    all.insert(all.end(), field.begin(), field.end());
  }
  return all;
}

void recall_part(const json& command, std::span<const double> memory) {
  RankPart& part = part_in(command);
  const std::size_t nodes = part.rows.grid().size();
  const auto numbers = command.at("numbers").get<std::vector<double>>();
  std::vector<double> own;
  for (std::size_t k = 0; k < numbers.size(); ++k) {
    own.push_back(numbers[k]);
    if (k == 0)
      continue;
    const std::vector<double> field = part.rows.scattered(
        memory.empty() ? memory
                       : memory.subspan(2 + (k - 1) * (nodes + 1), nodes));
    own.insert(own.end(), field.begin(), field.end());
  }
  part.steps->recall(own);
}

void drop_part(const json& command) {
  parts_of_this_rank().erase(command.at("number").get<int>());
}

/// Number of loading paths that rank 0 has made.
int made = 0;

class SharedLoadSteps final : public LoadSteps {
public:
  SharedLoadSteps(const SurfaceOfCase& surface, const SharedBlock& block,
                  const LoadStepsSetting& setting)
      : number_(made++), nodes_(surface.record.grid.size()) {
    const Grid& grid = surface.record.grid;
    json build = command("build");
    if (surface.source) {
      prepare_heights(*surface.source);
      build["surface"] = json_of(*surface.source);
    }
    build["grid"] = {grid.points_x, grid.points_y, grid.length_x,
                     grid.length_y};
    if (const auto* request = std::get_if<std::string>(&block))
      build["request"] = *request;
    else
      build["block"] = json_of_block(std::get<mechanics::ElasticBlock>(block));
    add_setting(setting, build);
    lead(build, [&] { build_part(build, surface.record.heights); });
  }

  ~SharedLoadSteps() override {
    try {
      const json drop = command("drop");
      lead(drop, [&] { drop_part(drop); });
    } catch (...) { // the ranks then keep the memory until they end
    }
  }

  StepAnswer solve(const StepTarget& target) override {
    json solve = command("solve");
    solve["control"] = static_cast<int>(target.load.control);
    solve["amount"] = target.load.amount;
    solve["step"] = target.step;
    solve["needs_maps"] = target.needs_maps;
    StepAnswer answer;
    lead(solve, [&] { answer = solve_part(solve); });
    if (target.needs_maps)
      answer.rows = {target.step, answer.row.nominal_pressure, sent("pressure"),
                     sent("gap")};
    return answer;
  }

  std::size_t gathered_memory_bytes() const override {
    return (2 * nodes_ + 3) * sizeof(double);
  }

  std::vector<double> memory() const override {
    const json ask = command("memory");
    std::vector<double> memory;
    lead(ask, [&] { memory = memory_part(ask); });
    return memory;
  }

  void recall(std::span<const double> memory) override {
    const std::size_t length = nodes_ + 1;
    if (!memory.empty() && memory.size() != 1 + length &&
        memory.size() != 1 + 2 * length)
      throw std::domain_error("a saved state has another number of nodes");
    json recall = command("recall");
    std::vector<double> numbers;
    if (!memory.empty())
      numbers.push_back(memory[0]);
    for (std::size_t at = 1; at < memory.size(); at += length)
      numbers.push_back(memory[at]);
    recall["numbers"] = numbers;
    lead(recall, [&] { recall_part(recall, memory); });
  }

private:
  /// A map of the last step, which the ranks send when it is asked for.
  results::MapRows sent(const char* field) const {
    json send = command("send");
    send["field"] = field;
    return [send](const results::TakeValues& take) {
      lead(send, [&] { send_part(send, take); });
    };
  }

  json command(const char* what) const {
    return {{command_key, what}, {"number", number_}};
  }

  static void lead(const json& command, const std::function<void()>& share) {
    fem::load_fem_module().on_all_ranks(
        command.dump(), [&](const std::string&, int) { share(); });
  }

  int number_;
  std::size_t nodes_; ///< of the grid
};

} // namespace

bool is_shared_by_ranks(const cases::MethodSpec& method, const Grid& grid,
                        int n_ranks) {
  const auto* half =
      std::get_if<mechanics::HalfspaceSettings>(&method.settings);
  const auto* block = std::get_if<mechanics::FemSettings>(&method.settings);
  const bool has_columns = (half != nullptr && !half->has_free_boundaries) ||
                           (block != nullptr && !is_full_block(method));
  return n_ranks > 1 && has_columns && grid.size() >= least_shared_nodes &&
         n_ranks <= most_ranks(grid);
}

std::unique_ptr<LoadSteps>
make_shared_load_steps(const SurfaceOfCase& surface, const SharedBlock& block,
                       const LoadStepsSetting& setting) {
  return std::make_unique<SharedLoadSteps>(surface, block, setting);
}

bool is_for_shared_steps(const std::string& text) {
  return json::parse(text).contains(command_key);
}

void follow_shared_steps(const std::string& text) {
  const json command = json::parse(text);
  const auto what = command.at(command_key).get<std::string>();
  if (what == "build")
    build_part(command, {});
  else if (what == "solve")
    static_cast<void>(solve_part(command));
  else if (what == "send")
    send_part(command, {});
  else if (what == "memory")
    static_cast<void>(memory_part(command));
  else if (what == "recall")
    recall_part(command, {});
  else
    drop_part(command);
}

} // namespace asperity::app
