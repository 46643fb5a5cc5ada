#include "app/methods/shared_load_steps.hpp"

#include "app/methods/chosen.hpp"
#include "app/methods/shared_surface.hpp"
#include "base/array_memory.hpp"
#include "contact/operators/free_halfspace.hpp"
#include "contact/operators/halfspace.hpp"
#include "fem/plugin.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <stdexcept>
#include <utility>

#include "ranks/rank_sums.hpp"
#include "ranks/rows_from_rank_0.hpp"

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

/// The operator of the block of a "build" command on the rows of this rank.
std::unique_ptr<contact::SurfaceOperator>
elasticity_in(const json& command, const Grid& grid, int threads) {
  const fem::FemModule& fem_module = fem::load_fem_module();
  if (command.contains("request"))
    return fem_module.condensed_on_ranks(command.at("request"), threads);
  if (command.contains("free_modulus"))
    return std::make_unique<contact::FreeHalfspace>(
        grid, fem_module.rank_group(), command.at("free_modulus").get<double>(),
        threads);
  return std::make_unique<contact::FourierOperator>(
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
  free_memory(part.pressure, part.gap);
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
  free_memory(answer.pressure, answer.gap);
  return answer;
}

/// Passes a map of the last step to rank 0.
void send_part(const json& command, const results::TakeValues& take) {
  const RankPart& part = part_in(command);
  part.rows.pass_to_rank_0(
      command.at("field") == "pressure" ? part.pressure : part.gap, take);
}

/// The memory of this rank: a number, then a number and the rows of a field of
/// each step.
std::vector<double> own_memory(const RankPart& part) {
  std::vector<double> own;
  const SavedState memory = part.steps->memory();
  own.reserve(memory.count);
  if (memory.count > 0)
    memory.numbers([&](std::span<const double> numbers) {
      own.insert(own.end(), numbers.begin(), numbers.end());
    });
  return own;
}

std::size_t n_steps_in(std::size_t numbers, std::size_t nodes) {
  return numbers == 0 ? 0 : (numbers - 1) / (nodes + 1);
}

/// Passes the memory of all ranks to rank 0, with whole fields.
void memory_part(const json& command, const results::TakeValues& take) {
  const RankPart& part = part_in(command);
  const std::vector<double> own = own_memory(part);
  const std::span<const double> numbers = own;
  const std::size_t nodes = part.rows.size();
  const bool takes = part.rows.ranks()->rank() == 0;
  if (takes)
    take(numbers.first(1));
  for (std::size_t k = 0; k < n_steps_in(own.size(), nodes); ++k) {
    const std::size_t at = 1 + k * (nodes + 1);
    if (takes)
      take(numbers.subspan(at, 1));
    part.rows.pass_to_rank_0(numbers.subspan(at + 1, nodes), take);
  }
}

/// Divides a memory that rank 0 reads among the ranks.
void recall_part(const json& command, const StateReader& memory) {
  RankPart& part = part_in(command);
  RankGroup& ranks = *part.rows.ranks();
  const std::size_t nodes = part.rows.size();
  const std::size_t steps = command.at("steps");
  std::vector<double> own(command.at("is_empty") ? 0 : 1 + steps * (nodes + 1));
  const auto take_number = [&](double& number) {
    if (ranks.rank() == 0)
      memory.next(std::span(&number, 1));
    number = of_ranks(&ranks, number).front();
  };
  if (!own.empty())
    take_number(own.front());
  for (std::size_t k = 0; k < steps; ++k) {
    const std::size_t at = 1 + k * (nodes + 1);
    take_number(own[at]);
    std::ranges::copy(rows_from_rank_0(part.rows, memory.next),
                      own.begin() + static_cast<std::ptrdiff_t>(at + 1));
  }
  part.steps->recall(saved_reader(own));
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
    else if (const auto* free = std::get_if<FreeBlock>(&block))
      build["free_modulus"] = free->contact_modulus;
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

  SavedState memory() const override {
    const json ask = command("memory");
    const RankPart& own = part_in(ask);
    const std::size_t numbers = own_memory(own).size();
    if (numbers == 0)
      return {};
    const std::size_t steps = n_steps_in(numbers, own.rows.size());
    return {1 + steps * (nodes_ + 1), [ask](const results::TakeValues& take) {
              lead(ask, [&] { memory_part(ask, take); });
            }};
  }

  void recall(const StateReader& memory) override {
    const std::size_t steps = n_steps_in(memory.count, nodes_);
    if (memory.count != 0 &&
        (steps < 1 || steps > 2 || memory.count != 1 + steps * (nodes_ + 1)))
      throw std::domain_error("a saved state has another number of nodes");
    json recall = command("recall");
    recall["steps"] = steps;
    recall["is_empty"] = memory.count == 0;
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

/// Whether a method is of a kind, and its grid of a size, that ranks share.
bool is_for_ranks(const cases::MethodSpec& method, const Grid& grid) {
  const auto* half =
      std::get_if<mechanics::HalfspaceSettings>(&method.settings);
  const auto* block = std::get_if<mechanics::FemSettings>(&method.settings);
  const bool has_columns =
      half != nullptr || (block != nullptr && !is_full_block(method));
  return has_columns && grid.size() >= least_shared_nodes;
}

} // namespace

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

bool is_shared_by_ranks(const cases::MethodSpec& method, const Grid& grid,
                        int n_ranks) {
  return n_ranks > 1 && is_for_ranks(method, grid) &&
         n_ranks <= most_ranks(grid);
}

std::string obstacle_to_sharing(const cases::MethodSpec& method,
                                const Grid& grid, int n_ranks) {
  if (!is_for_ranks(method, grid) || n_ranks <= most_ranks(grid))
    return "";
  return fmt::format("a grid of {} by {} points can be divided among at most "
                     "{} rank{}",
                     grid.points_x, grid.points_y, most_ranks(grid),
                     most_ranks(grid) == 1 ? "" : "s");
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
    memory_part(command, {});
  else if (what == "recall")
    recall_part(command, {});
  else
    drop_part(command);
}

} // namespace asperity::app
