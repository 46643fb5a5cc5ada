#include "app/provenance_of_run.hpp"

#include "fem/plugin.hpp"

#include <string>

namespace asperity::app {

results::Provenance provenance_at_start(const cases::Case& rough_case,
                                        int threads) {
  results::Provenance facts = results::program_facts();
  facts.emplace_back("threads", std::to_string(threads));
  facts.emplace_back("seed", std::to_string(rough_case.surface.seed));
  facts.emplace_back("realizations",
                     std::to_string(rough_case.surface.realizations));
  facts.emplace_back("started", results::utc_now());
  return facts;
}

results::Provenance provenance_of_fem() {
  return {{"deal.II", fem::load_fem_room().versions()}};
}

} // namespace asperity::app
