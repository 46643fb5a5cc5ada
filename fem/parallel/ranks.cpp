#include "fem/parallel/ranks.hpp"

#include "base/require.hpp"
#include "fem/parallel/mpi_session.hpp"
#include "input/input_error.hpp"

#include <fmt/format.h>
#include <mpi.h>

#include <algorithm>
#include <chrono>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <stdexcept>
#include <thread>

namespace asperity::fem {
namespace {

constexpr int leader = 0;

using Clock = std::chrono::steady_clock;

/// Time that a failed rank waits for the other ranks to fail as well, and time
/// that a rank without a failure waits to be terminated.
constexpr std::chrono::seconds failure_timeout{5};

/// A second communicator over all ranks, for reaching agreement on failures:
/// messages on it never match operations that a failed rank left incomplete in
/// MPI_COMM_WORLD. The first call is collective.
MPI_Comm agreement() {
  static const MPI_Comm ranks = [] {
    MPI_Comm made = MPI_COMM_NULL;
    MPI_Comm_dup(MPI_COMM_WORLD, &made);
    return made;
  }();
  return ranks;
}

/// Waits for a request by sleeping instead of polling continuously, so that a
/// waiting rank leaves its core to others.
/// @return  whether the request completed in time
bool is_done_by(MPI_Request& request, Clock::time_point end) {
  int is_done = 0;
  MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
  while (!is_done && Clock::now() < end) {
    std::this_thread::sleep_for(std::chrono::microseconds(200));
    MPI_Test(&request, &is_done, MPI_STATUS_IGNORE);
  }
  return is_done != 0;
}

/// The length of the text with which rank 0 ends the other ranks.
constexpr std::int64_t no_text = -1;

void broadcast_length(std::int64_t& length) {
  broadcast_from_rank_0(std::as_writable_bytes(std::span(&length, 1)));
}

struct EndOfFollowers {
  ~EndOfFollowers() {
    std::int64_t length = no_text;
    broadcast_length(length);
  }
};

struct Failure {
  std::string words;
  int exit_code = 4;
};

Failure described(const std::exception_ptr& failure) {
  try {
    std::rethrow_exception(failure);
  } catch (const input::InputError& error) {
    return {error.what(), 2};
  } catch (const std::domain_error& error) {
    return {error.what(), 2};
  } catch (const std::exception& error) {
    return {error.what()};
  } catch (...) { // Trilinos throws integers
    return {"a library threw an object that is not a std::exception"};
  }
}

/// Number of ranks that failed, or -1 if not all of them reported in time.
int count_failed(bool has_failed) {
  static const int n = n_ranks();
  int failed = has_failed ? 1 : 0;
  if (n == 1)
    return failed;
  int all = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Iallreduce(&failed, &all, 1, MPI_INT, MPI_SUM, agreement(), &request);
  const auto end =
      has_failed ? Clock::now() + failure_timeout : Clock::time_point::max();
  return is_done_by(request, end) ? all : -1;
}

} // namespace

int n_ranks() {
  start_mpi();
  int ranks = 1;
  MPI_Comm_size(MPI_COMM_WORLD, &ranks);
  return ranks;
}

int own_rank() {
  start_mpi();
  int rank = 0;
  MPI_Comm_rank(MPI_COMM_WORLD, &rank);
  return rank;
}

int mpi_count(std::size_t count, const char* what) {
  if (count > std::numeric_limits<int>::max())
    refuse_argument(fmt::format("number of {}", what),
                    static_cast<double>(count),
                    "below 2^31, the limit of an MPI count");
  return static_cast<int>(count);
}

void end_all_ranks(const std::exception_ptr& failure) {
  const auto [words, exit_code] = described(failure);
  fmt::print(stderr, "asperity: rank {} of {}: {}\n", own_rank(), n_ranks(),
             words);
  std::fflush(stderr);
  MPI_Abort(MPI_COMM_WORLD, exit_code);
  std::abort(); // not reached
}

void do_share(const std::function<void()>& share) {
  if (n_ranks() > 1)
    agreement(); // while no rank has failed
  std::exception_ptr failure;
  try {
    share();
  } catch (...) {
    failure = std::current_exception();
  }
  const int n_failed = count_failed(failure != nullptr);
  if (n_failed == 0)
    return;
  if (n_failed == n_ranks())
    std::rethrow_exception(failure);
  if (!failure) { // another rank terminates this one
    std::this_thread::sleep_for(failure_timeout);
    failure =
        std::make_exception_ptr(std::runtime_error("another rank failed"));
  }
  end_all_ranks(failure);
}

void broadcast(std::span<std::byte> bytes, int from) {
  constexpr std::size_t most = std::size_t{1} << 30;
  for (std::size_t at = 0; at < bytes.size(); at += most)
    MPI_Bcast(bytes.data() + at,
              static_cast<int>(std::min(most, bytes.size() - at)), MPI_BYTE,
              from, MPI_COMM_WORLD);
}

void broadcast_from_rank_0(std::span<std::byte> bytes) {
  agreement();
  char is_here = 0;
  MPI_Request request = MPI_REQUEST_NULL;
  MPI_Ibcast(&is_here, 1, MPI_CHAR, leader, MPI_COMM_WORLD, &request);
  is_done_by(request, Clock::time_point::max());
  broadcast(bytes, leader);
}

void do_on_all_ranks(const std::string& text,
                     const std::function<void()>& share) {
  if (n_ranks() > 1) {
    auto length = static_cast<std::int64_t>(text.size());
    std::string sent = text; // MPI_Bcast does not accept a pointer to const
    broadcast_length(length);
    broadcast_from_rank_0(std::as_writable_bytes(std::span(sent)));
  }
  do_share(share);
}

void follow_rank_0(
    const std::function<void(const std::string& text)>& execute) try {
  std::int64_t length = 0;
  for (broadcast_length(length); length != no_text; broadcast_length(length)) {
    std::string text(static_cast<std::size_t>(length), '\0');
    broadcast_from_rank_0(std::as_writable_bytes(std::span(text)));
    try {
      do_share([&] { execute(text); });
    } catch (...) { // all ranks have failed, and rank 0 says why
    }
  }

} catch (...) {

  end_all_ranks(std::current_exception());
}

void end_followers_at_exit() {
  if (n_ranks() > 1)
    static const EndOfFollowers end;
}

} // namespace asperity::fem
