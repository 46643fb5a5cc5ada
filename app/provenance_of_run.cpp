#include "app/provenance_of_run.hpp"

#include "fem/plugin.hpp"

#include <algorithm>
#include <string>

namespace asperity::app {

results::Provenance
provenance_at_start(const cases::Case& rough_case, int threads,
                    const std::vector<cases::MethodSpec>& methods) {
  results::Provenance facts = results::program_facts();
  const bool uses_fem = std::any_of(
      methods.begin(), methods.end(), [](const cases::MethodSpec& method) {
        return std::holds_alternative<cases::FemSettings>(method.settings);
      });
  if (uses_fem)
    facts.emplace_back("deal.II", fem::load_fem_room().versions());
  facts.emplace_back("threads", std::to_string(threads));
  facts.emplace_back("seed", std::to_string(rough_case.surface.seed));
  facts.emplace_back("realizations",
                     std::to_string(rough_case.surface.realizations));
  facts.emplace_back("started", results::utc_now());
  return facts;
}

} // namespace asperity::app
