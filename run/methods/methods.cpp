#include "run/methods/methods.hpp"

#include "input/reader/locking.hpp"
#include "run/methods/chosen.hpp"
#include "run/methods/full_block_method.hpp"
#include "run/methods/theory_method.hpp"
#include "run/methods/winkler_method.hpp"

#include <stdexcept>

namespace asperity::methods {
namespace {

/// What a solver is made of besides the settings of its method.
struct SolverInput {
  const cases::Case& contact_case;
  SolverFactory& elastic;
  const cases::MethodSpec& method;
  const SurfaceOfCase& surface;
  int realization;
  const Resources& resources;
};

std::unique_ptr<StepSolver> make_solver(const mechanics::TheorySettings&,
                                        const SolverInput& input) {
  throw std::logic_error(input.method.name + " has no load steps to solve");
}

std::unique_ptr<StepSolver> make_on_face(const SolverInput& input) {
  return input.elastic.make(input.method, input.surface,
                            {input.resources.threads,
                             input.resources.root->ranks(),
                             input.resources.threads_a_rank});
}

std::unique_ptr<StepSolver> make_solver(const mechanics::HalfspaceSettings&,
                                        const SolverInput& input) {
  return make_on_face(input);
}

std::unique_ptr<StepSolver> make_solver(const mechanics::FemSettings&,
                                        const SolverInput& input) {
  if (is_full_block(input.method))
    return make_full_block_solver(input.contact_case, input.method,
                                  input.surface, input.realization,
                                  input.resources);
  return make_on_face(input);
}

std::unique_ptr<StepSolver> make_solver(const mechanics::MdSettings&,
                                        const SolverInput& input) {
  return make_atomic_solver({input.contact_case, input.method, input.surface,
                             input.realization, input.resources.threads,
                             input.resources.scratch, input.resources.watch});
}

std::unique_ptr<StepSolver>
make_solver(const mechanics::WinklerSettings& settings,
            const SolverInput& input) {
  return make_winkler_solver(settings, input.surface);
}

} // namespace

MethodDescription describe(const cases::MethodSpec& method,
                           const mechanics::MaterialSpec& material) {
  MethodDescription description = std::visit(
      [](const auto& settings) { return describe(settings); }, method.settings);
  if (const std::string words = material_text(method, material); !words.empty())
    description.text += ", " + words;
  for (const std::string& warning :
       cases::locking_warnings(material, {&method, 1}))
    description.text += "; warning: " + warning;
  return description;
}

MethodFactory::MethodFactory(const cases::Case& contact_case, Cache& cache,
                             const CaseKeys& keys)
    : case_(contact_case), elastic_(contact_case.material, cache, keys) {}

struct MethodFactory::NoCache {
  Cache cache;
  CaseKeys keys;
};

MethodFactory::MethodFactory(const cases::Case& contact_case)
    : case_(contact_case),
      none_(new NoCache{{}, CaseKeys(contact_case, "", {})}),
      elastic_(contact_case.material, none_->cache, none_->keys) {}

std::unique_ptr<StepSolver> MethodFactory::make(const cases::MethodSpec& method,
                                                const SurfaceOfCase& surface,
                                                int realization,
                                                const Resources& resources) {
  const SolverInput input{case_,   elastic_,    method,
                          surface, realization, resources};
  return std::visit(
      [&](const auto& settings) { return make_solver(settings, input); },
      method.settings);
}

} // namespace asperity::methods
