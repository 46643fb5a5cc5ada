#include "fem/block_proxy.hpp"

#include "fem/parallel/ranks.hpp"
#include "fem/request_bytes.hpp"

#include <map>
#include <stdexcept>
#include <utility>

namespace asperity::fem {
namespace {

BlockProblem problem_in(const std::string& text) {
  MeshedRequest meshed = request_of_bytes(text);
  return problem_of(meshed.request, std::move(meshed.mesh));
}

/// The arguments of a load step are sent as numbers: the heights, followed by
/// these six settings.
constexpr std::size_t n_settings = 6;

std::vector<double> packed(std::span<const double> heights,
                           const mechanics::LoadTarget& load,
                           const BlockContact& contact) {
  std::vector<double> numbers(heights.begin(), heights.end());
  numbers.insert(numbers.end(), {static_cast<double>(load.control), load.amount,
                                 static_cast<double>(contact.law),
                                 contact.penalty, contact.tolerance,
                                 static_cast<double>(contact.max_iterations)});
  return numbers;
}

void solve_as_told(FullBlock& block, const std::vector<double>& numbers) {
  const std::size_t n_heights = numbers.size() - n_settings;
  const double* settings = numbers.data() + n_heights;
  const mechanics::LoadTarget load{
      static_cast<mechanics::Control>(static_cast<int>(settings[0])),
      settings[1]};
  const BlockContact contact{
      static_cast<mechanics::ContactLaw>(static_cast<int>(settings[2])),
      settings[3], settings[4], static_cast<int>(settings[5])};
  static_cast<void>(block.solve({numbers.data(), n_heights}, load, contact));
}

/// Serialises a plane as numbers: y, the body, the number of x, the x, the
/// depths.
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

/// To be called on rank 0. Broadcasts a command, then executes it on this rank.
void lead(const Order& order, const std::function<void()>& share) {
  pass_on(order);
  do_share(share);
}

class BlockProxy final : public FullBlock {
public:
  BlockProxy(int number, std::unique_ptr<FullBlock> own)
      : number_(number), own_(std::move(own)) {}

  ~BlockProxy() override { pass_on({OrderKind::drop, number_}); }

  const Grid& grid() const override { return own_->grid(); }

  std::size_t unknowns() const override { return own_->unknowns(); }

  std::span<const double> nodal_weights() const override {
    return own_->nodal_weights();
  }

  std::string report() const override { return own_->report(); }

  std::vector<double> displacement(std::span<const double> pressure) override {
    std::vector<double> found;
    lead({OrderKind::displacement,
          number_,
          {},
          {pressure.begin(), pressure.end()}},
         [&] { found = own_->displacement(pressure); });
    return found;
  }

  BlockSolution solve(std::span<const double> heights,
                      const mechanics::LoadTarget& load,
                      const BlockContact& contact) override {
    BlockSolution found;
    lead({OrderKind::solve, number_, {}, packed(heights, load, contact)},
         [&] { found = own_->solve(heights, load, contact); });
    return found;
  }

  ContactStiffness stiffness() override {
    ContactStiffness found;
    lead({OrderKind::stiffness, number_}, [&] { found = own_->stiffness(); });
    return found;
  }

  StressPeak strongest_stress() const override {
    StressPeak found;
    lead({OrderKind::strongest_stress, number_},
         [&] { found = own_->strongest_stress(); });
    return found;
  }

  std::vector<double> section(const SectionPlane& plane) const override {
    std::vector<double> found;
    lead({OrderKind::section, number_, {}, packed(plane)},
         [&] { found = own_->section(plane); });
    return found;
  }

  void write(const std::string& folder_and_stem) override {
    lead({OrderKind::write, number_, folder_and_stem},
         [&] { own_->write(folder_and_stem); });
  }

private:
  int number_;
  std::unique_ptr<FullBlock> own_;
};

/// Number of blocks that rank 0 has requested, including those that were
/// refused.
int built = 0;

/// Executes one command on a rank other than 0.
void execute_command(const Order& order, const BlockMaker& make_block,
                     std::unique_ptr<FullBlock>& block) {
  if (order.kind == OrderKind::build) {
    block = make_block(problem_in(order.text));
    return;
  }
  if (!block)
    throw std::logic_error("a command for a block that was never built");
  switch (order.kind) {
  case OrderKind::displacement:
    static_cast<void>(block->displacement(order.numbers));
    break;
  case OrderKind::solve:
    solve_as_told(*block, order.numbers);
    break;
  case OrderKind::stiffness:
    static_cast<void>(block->stiffness());
    break;
  case OrderKind::strongest_stress:
    static_cast<void>(block->strongest_stress());
    break;
  case OrderKind::section:
    static_cast<void>(block->section(plane_in(order.numbers)));
    break;
  case OrderKind::write:
    block->write(order.text);
    break;
  case OrderKind::build:
  case OrderKind::drop:
  case OrderKind::command:
  case OrderKind::quit:
    break;
  }
}

/// Executes the commands of rank 0 until the last one.
void follow(const BlockMaker& make_block, const RankCommand& command) {
  std::map<int, std::unique_ptr<FullBlock>> blocks;
  for (Order order = next_order(); order.kind != OrderKind::quit;
       order = next_order()) {
    if (order.kind == OrderKind::command) {
      do_share([&] { command(order.text, own_rank()); });
      continue;
    }
    std::unique_ptr<FullBlock>& block = blocks[order.block];
    if (order.kind == OrderKind::drop)
      block.reset();
    else
      do_share([&] { execute_command(order, make_block, block); });
  }
}

struct EndOfFollowers {
  ~EndOfFollowers() { pass_on({OrderKind::quit}); }
};

} // namespace

std::unique_ptr<FullBlock>
make_distributed_block(const FullRequest& request,
                       const BlockMaker& make_block) {
  const BlockProblem problem = problem_of(request);
  if (n_ranks() == 1)
    return make_block(problem);
  const int number = built++;
  std::unique_ptr<FullBlock> own;
  lead({OrderKind::build, number, bytes_of(request, problem.mesh)},
       [&] { own = make_block(problem); });
  return std::make_unique<BlockProxy>(number, std::move(own));
}

void execute_on_all_ranks(const std::string& text, const RankCommand& command) {
  lead({OrderKind::command, 0, text}, [&] { command(text, own_rank()); });
}

void serve_rank_0(const BlockMaker& make_block, const RankCommand& command) {
  try {
    follow(make_block, command);
  } catch (...) {
    end_all_ranks(std::current_exception());
  }
}

void end_followers_at_exit() {
  if (n_ranks() > 1)
    static const EndOfFollowers end;
}

} // namespace asperity::fem
