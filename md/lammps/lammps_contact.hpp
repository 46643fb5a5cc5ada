#pragma once

// The engine that runs LAMMPS as a child process for each load step. It is an
// independent implementation against which the built-in engine is verified, and
// the one that runs on several processes.

#include "md/contact/atomic_contact.hpp"

#include <memory>

namespace asperity::md {

/// Creates a block with the lattice `central` and a uniform spacing down to the
/// requested depth, whose uppermost layer is a rigid plate. The block is not
/// linearised: bonds rotate and stretch, whereas the built-in engine assumes
/// small strains.
///
/// Files are exchanged in request.scratch / "lammps". The log of every step
/// remains there and, if settings.dump is set, also the atoms, e.g.
/// step-0003.dump.
///
/// @throws input::InputError   a setting is not supported by the LAMMPS engine,
///                             or the program lmp is not found
/// @throws std::domain_error  an argument of a component is out of range
std::unique_ptr<AtomicContact> make_lammps_contact(AtomRequest request);

} // namespace asperity::md
