#include "fem/led_blocks.hpp"

#include "cases/case_error.hpp"
#include "fem/ranks.hpp"

#include <nlohmann/json.hpp>

#include <map>
#include <stdexcept>

namespace asperity::fem {
namespace {

using Json = nlohmann::json;

std::string packed(const FullRequest& request) {
  const Grid& grid = request.grid;
  const cases::Scales& scales = request.scales;
  return Json{{"text", request.case_text},
              {"path", request.case_path},
              {"method", request.method},
              {"points", {grid.points_x, grid.points_y}},
              {"lengths", {grid.length_x, grid.length_y}},
              {"scales",
               {scales.contact_modulus, scales.length, scales.spacing,
                scales.rms_height}}}
      .dump();
}

FullRequest unpacked(const std::string& text) {
  const Json json = Json::parse(text);
  FullRequest request{
      json.at("text"), json.at("path"), json.at("method"), {}, {}};
  request.grid.points_x = json.at("points").at(0);
  request.grid.points_y = json.at("points").at(1);
  request.grid.length_x = json.at("lengths").at(0);
  request.grid.length_y = json.at("lengths").at(1);
  const Json& scales = json.at("scales");
  request.scales = {scales.at(0), scales.at(1), scales.at(2), scales.at(3)};
  return request;
}

/// A step's arguments as numbers: the heights, then these six.
constexpr std::size_t n_settings = 6;

std::vector<double> packed(std::span<const double> heights,
                           const BlockLoad& load, const BlockContact& contact) {
  std::vector<double> numbers(heights.begin(), heights.end());
  numbers.insert(numbers.end(), {static_cast<double>(load.control), load.target,
                                 static_cast<double>(contact.law),
                                 contact.penalty, contact.tolerance,
                                 static_cast<double>(contact.max_iterations)});
  return numbers;
}

void solve_as_told(FullBlock& block, const std::vector<double>& numbers) {
  const std::size_t n_heights = numbers.size() - n_settings;
  const double* settings = numbers.data() + n_heights;
  const BlockLoad load{
      static_cast<cases::Control>(static_cast<int>(settings[0])), settings[1]};
  const BlockContact contact{
      static_cast<cases::ContactLaw>(static_cast<int>(settings[2])),
      settings[3], settings[4], static_cast<int>(settings[5])};
  static_cast<void>(block.solve({numbers.data(), n_heights}, load, contact));
}

/// A plane as numbers: y, the body, how many x, these, the depths.
std::vector<double> packed(const SectionPlane& plane) {
  std::vector<double> numbers{plane.y, plane.is_counter ? 1.0 : 0.0,
                              static_cast<double>(plane.x.size())};
  numbers.insert(numbers.end(), plane.x.begin(), plane.x.end());
  numbers.insert(numbers.end(), plane.depth.begin(), plane.depth.end());
  return numbers;
}

SectionPlane plane_in(const std::vector<double>& numbers) {
  const auto first_x = numbers.begin() + 3;
  const auto first_depth = first_x + static_cast<std::ptrdiff_t>(numbers[2]);
  return {numbers[0],
          numbers[1] != 0.0,
          {first_x, first_depth},
          {first_depth, numbers.end()}};
}

class LedBlock final : public FullBlock {
public:
  LedBlock(int number, std::unique_ptr<FullBlock> own)
      : number_(number), own_(std::move(own)) {}

  ~LedBlock() override { pass_on({OrderKind::drop, number_}); }

  const Grid& grid() const override { return own_->grid(); }

  std::size_t unknowns() const override { return own_->unknowns(); }

  std::span<const double> nodal_weights() const override {
    return own_->nodal_weights();
  }

  std::string report() const override { return own_->report(); }

  std::vector<double> displacement(std::span<const double> pressure) override {
    pass_on({OrderKind::displacement,
             number_,
             {},
             {pressure.begin(), pressure.end()}});
    return own_->displacement(pressure);
  }

  BlockSolution solve(std::span<const double> heights, const BlockLoad& load,
                      const BlockContact& contact) override {
    pass_on({OrderKind::solve, number_, {}, packed(heights, load, contact)});
    return own_->solve(heights, load, contact);
  }

  StressPeak strongest_stress() const override {
    pass_on({OrderKind::strongest_stress, number_});
    return own_->strongest_stress();
  }

  std::vector<double> section(const SectionPlane& plane) const override {
    pass_on({OrderKind::section, number_, {}, packed(plane)});
    return own_->section(plane);
  }

  void write(const std::string& folder_and_stem) override {
    pass_on({OrderKind::write, number_, folder_and_stem});
    own_->write(folder_and_stem);
  }

private:
  int number_;
  std::unique_ptr<FullBlock> own_;
};

/// How many blocks rank 0 has asked for, refused ones too.
int built = 0;

/// What rank 0 refuses in words, this rank refuses too and stays silent.
std::unique_ptr<FullBlock> built_as_told(const std::string& text) {
  try {
    return make_full_block(problem_of_case(unpacked(text)));
  } catch (const std::domain_error&) {
  } catch (const cases::CaseError&) {
  }
  return nullptr;
}

/// What cannot be written is rank 0's to say.
void write_as_told(FullBlock& block, const std::string& folder_and_stem) {
  try {
    block.write(folder_and_stem);
  } catch (const std::runtime_error&) {
  }
}

struct EndOfFollowers {
  ~EndOfFollowers() { pass_on({OrderKind::quit}); }
};

} // namespace

std::unique_ptr<FullBlock> lead_full_block(const FullRequest& request) {
  if (n_ranks() == 1)
    return make_full_block(problem_of_case(request));
  pass_on({OrderKind::build, built, packed(request)});
  const int number = built++;
  return std::make_unique<LedBlock>(number,
                                    make_full_block(problem_of_case(request)));
}

void follow_rank_0() {
  std::map<int, std::unique_ptr<FullBlock>> blocks;
  for (Order order = next_order(); order.kind != OrderKind::quit;
       order = next_order()) {
    std::unique_ptr<FullBlock>& block = blocks[order.block];
    switch (order.kind) {
    case OrderKind::build:
      block = built_as_told(order.text);
      break;
    case OrderKind::displacement:
      static_cast<void>(block->displacement(order.numbers));
      break;
    case OrderKind::solve:
      solve_as_told(*block, order.numbers);
      break;
    case OrderKind::strongest_stress:
      static_cast<void>(block->strongest_stress());
      break;
    case OrderKind::section:
      static_cast<void>(block->section(plane_in(order.numbers)));
      break;
    case OrderKind::write:
      write_as_told(*block, order.text);
      break;
    case OrderKind::drop:
      block.reset();
      break;
    case OrderKind::quit:
      break;
    }
  }
}

void end_followers_at_exit() {
  if (n_ranks() > 1)
    static const EndOfFollowers end;
}

} // namespace asperity::fem
