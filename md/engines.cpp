#include "md/engines.hpp"

#include "base/child_process.hpp"
#include "md/contact/explicit_contact.hpp"
#include "md/contact/green_contact.hpp"
#include "md/lammps/lammps_contact.hpp"
#include "md/lammps/lammps_run.hpp"

#include <fmt/format.h>

#include <stdexcept>
#include <utility>

namespace asperity::md {

void require_engine(const mechanics::MdSettings& settings) {
  if (settings.engine == mechanics::AtomEngine::lammps)
    require_lammps(settings.ranks);
}

std::string engine_identity(const mechanics::MdSettings& settings) {
  if (settings.engine != mechanics::AtomEngine::lammps)
    return "";
  std::error_code error;
  const std::filesystem::path program =
      std::filesystem::canonical(program_on_path("lmp"), error);
  if (error)
    return "";
  return fmt::format("{} {} {}", program.string(),
                     std::filesystem::file_size(program, error),
                     std::filesystem::last_write_time(program, error)
                         .time_since_epoch()
                         .count());
}

std::unique_ptr<AtomicContact> make_atomic_contact(AtomRequest request) {
  if (request.settings.engine == mechanics::AtomEngine::lammps)
    return make_lammps_contact(std::move(request));
  switch (request.settings.bulk) {
  case mechanics::AtomBulk::green:
    return make_green_contact(std::move(request));
  case mechanics::AtomBulk::explicit_layers:
    return make_explicit_contact(std::move(request));
  }
  throw std::logic_error("unknown bulk");
}

} // namespace asperity::md
