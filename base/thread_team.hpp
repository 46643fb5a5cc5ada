#pragma once

// Persistent threads that execute parallel loops.

#include <functional>

namespace asperity {

/// Calls work(0) on the calling thread and work(1..threads-1) on helper threads
/// that are parked between calls; returns when all calls that have begun are
/// finished. The call of a helper that has not begun by the end of work(0) is
/// withdrawn, so work(0) alone must be able to do everything: each call takes
/// its share from a shared counter. A loop is therefore never delayed by a
/// helper whose core is busy with other work.
///
/// Helpers belong to the process; they are started when first needed and joined
/// at its end. Concurrent callers, and nested calls from `work`, each get their
/// own helpers: there are as many as were ever in use at once. After a fork()
/// the child starts its own helpers, which oneTBB does not do; also, deal.II's
/// MPI session limits the number of oneTBB threads for all users in a process.
///
/// @param threads  >= 1; with 1 no helper is used
/// @param work     may throw: the first exception is rethrown when all calls
///                 that have begun are finished
/// @throws std::system_error  a thread cannot be started; no work has been done
void work_together(int threads, const std::function<void(int)>& work);

} // namespace asperity
