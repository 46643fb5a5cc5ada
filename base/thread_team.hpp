#pragma once

// Threads that stay: what a loop on several threads is run by.

#include <functional>

namespace asperity {

/// Calls work(0) on the calling thread and work(1..threads-1) on helpers that
/// wait parked between calls; returns when all that have begun are done. A
/// helper that has not begun by the end of work(0) is let go without its call,
/// so work(0) alone must be able to do everything: each takes what is left
/// from a shared counter. A loop is therefore never held up by a helper whose
/// core is busy elsewhere.
///
/// Helpers belong to the process, are started when first needed and joined at
/// its end. Callers on several threads, and work that calls again, each get
/// helpers of their own: there are as many as ever worked at once. After a
/// fork() the child starts its own, which oneTBB does not; and oneTBB's threads
/// are limited, for all their users in a process, by deal.II's MPI session.
///
/// @param threads  >= 1; with 1 no helper is asked
/// @param work     may throw: the exception that comes first is thrown again
///                 once all that have begun are done
/// @throws std::system_error  a thread cannot be started; nothing has been done
void work_together(int threads, const std::function<void(int)>& work);

} // namespace asperity
