#pragma once

// The block of atoms computed by LAMMPS, a program of other people, run as a
// child process a load step: the independent judge of our own engine, and the
// one for several processes.

#include "md/contact/atomic_contact.hpp"

#include <memory>

namespace asperity::md {

/// The block is `central`, of one spacing down to the asked depth, its
/// uppermost layer a rigid plate that carries the load. It is not linearised:
/// bonds turn and stretch as they must, where our own engine has small strains.
///
/// Files are exchanged in request.scratch / "lammps"; the log of every step
/// stays there, and with settings.dump its atoms, step-0003.dump.
///
/// @throws cases::CaseError   settings LAMMPS' parts cannot be, or no program
///                            lmp
/// @throws std::domain_error  what a part refuses
std::unique_ptr<AtomicContact> make_lammps_contact(AtomRequest request);

} // namespace asperity::md
