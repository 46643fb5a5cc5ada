#include "md/atomic_contact.hpp"

#include "cases/case_error.hpp"
#include "md/green_contact.hpp"
#include "md/lammps_contact.hpp"

#include <utility>

namespace asperity::md {

std::unique_ptr<AtomicContact> make_atomic_contact(AtomRequest request) {
  if (request.settings.engine == cases::AtomEngine::lammps)
    return make_lammps_contact(std::move(request));
  switch (request.settings.bulk) {
  case cases::AtomBulk::green:
    return make_green_contact(std::move(request));
  case cases::AtomBulk::explicit_layers:
    break;
  }
  throw cases::CaseError("[md] bulk = \"explicit\" is not in this build");
}

} // namespace asperity::md
