#include "app/methods/methods.hpp"

#include "app/methods/chosen.hpp"
#include "app/methods/full_block_method.hpp"
#include "app/methods/theory_method.hpp"
#include "cases/reader/locking.hpp"

namespace asperity::app {

MethodDescription describe(const cases::MethodSpec& method,
                           const cases::MaterialSpec& material) {
  MethodDescription description = std::visit(
      [](const auto& settings) { return describe(settings); }, method.settings);
  if (const std::string words = material_words(method, material);
      !words.empty())
    description.text += ", " + words;
  for (const std::string& warning :
       cases::locking_warnings(material, {&method, 1}))
    description.text += "; warning: " + warning;
  return description;
}

MethodFactory::MethodFactory(const cases::Case& contact_case, Cache& cache,
                             const CaseKeys& keys)
    : case_(contact_case), elastic_(contact_case.material, cache, keys) {}

std::unique_ptr<StepSolver> MethodFactory::make(const cases::MethodSpec& method,
                                                const SurfaceOfCase& surface,
                                                int realization,
                                                const Resources& resources) {
  if (std::holds_alternative<cases::MdSettings>(method.settings))
    return make_atomic_solver({case_, method, surface, realization,
                               resources.threads, resources.scratch,
                               resources.watch});
  if (is_whole_block(method))
    return make_whole_block(case_, method, surface, realization,
                            resources.scratch);
  return elastic_.make(method, surface, resources.threads);
}

} // namespace asperity::app
