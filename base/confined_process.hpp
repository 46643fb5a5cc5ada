#pragma once

// Confinement of a process that follows instructions of a file of someone else:
// the kernel lets it read and compute, and nothing more.

namespace asperity {

/// What a confined process tried.
struct ForbiddenAct {
  const char* what; ///< "starts a program", "writes a file", ...
  const char* file; ///< the name that it gave; null if there is none
};

/// Called in place of the system call that was tried, on the thread that tried
/// it. It must end the process and may be within any other function, so that it
/// must not allocate.
using OnForbidden = void (*)(const ForbiddenAct& act);

/// Forbids all threads of this process, until it ends, to start a program or
/// process, to open a file for writing, to create, change, rename or remove a
/// file, and to use the network. Files that are open stay open for what they
/// were opened for, and removing a file that does not exist fails as usual.
///
/// The system calls are filtered by the kernel (seccomp), so that no way to
/// them, through whatever library, is missed.
/// @return  false if kernel or processor do not offer it; the process is then
///          not confined
bool confine_process(OnForbidden report);

} // namespace asperity
