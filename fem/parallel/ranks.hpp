#pragma once

// The processes of one mpirun: rank 0 runs the program and lets the others do
// what all ranks do together, and a failure on any rank ends all of them.

#include <cstddef>
#include <exception>
#include <functional>
#include <span>
#include <string>

namespace asperity::fem {

/// Size of MPI_COMM_WORLD, which is initialised if necessary; 1 without mpirun.
int n_ranks();
int own_rank();

/// Gives the bytes of rank 0 to every rank; the others sleep instead of polling
/// continuously until rank 0 calls. Collective.
void broadcast_from_rank_0(std::span<std::byte> bytes);

/// To be called on rank 0. Sends a text to the other ranks, which execute it,
/// calls `share` on this one, and waits for all of them as do_share() does.
void do_on_all_ranks(const std::string& text,
                     const std::function<void()>& share);

/// To be called on the other ranks. Executes the texts that rank 0 sends until
/// it ends.
void follow_rank_0(const std::function<void(const std::string& text)>& execute);

/// To be called on rank 0. Lets the other ranks end when the program exits.
void end_followers_at_exit();

/// To be called on every rank. Executes this rank's share and waits for the
/// other ranks. If the share failed on all ranks, each throws its own failure.
/// If it failed on some ranks only, or if the others do not arrive within
/// seconds because one of their collective calls waits for this rank, each
/// failed rank terminates all ranks as end_all_ranks does.
void do_share(const std::function<void()>& share);

/// Prints the failure with the number of this rank and terminates all ranks.
/// The exit code is 2 for a refused argument or case and 4 for anything else,
/// as in the program's main function.
[[noreturn]] void end_all_ranks(const std::exception_ptr& failure);

/// Converts a count to the integer type of MPI.
/// @param what  what is counted, for the message
/// @throws std::domain_error  the count exceeds 2^31 - 1; the message names
///                            what is counted and the count
int mpi_count(std::size_t count, const char* what);

/// MPI_Bcast of any number of bytes.
void broadcast(std::span<std::byte> bytes, int from);

} // namespace asperity::fem
