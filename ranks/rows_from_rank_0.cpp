#include "ranks/rows_from_rank_0.hpp"

#include "ranks/rank_sums.hpp"

#include <algorithm>
#include <exception>
#include <stdexcept>

namespace asperity {

std::vector<double>
rows_from_rank_0(const SharedRows& rows,
                 const std::function<void(std::span<double>)>& next) {
  constexpr std::size_t most_bytes = std::size_t{1} << 22; // far below 2^31
  const std::size_t most =
      std::max<std::size_t>(1, most_bytes / sizeof(double) / rows.width()) *
      rows.width();
  const std::size_t n_ranks = rows.bounds().size() - 1;
  const auto own_rank = static_cast<std::size_t>(
      rows.ranks() == nullptr ? 0 : rows.ranks()->rank());
  std::vector<double> own(rows.size());
  std::vector<double> sent;
  std::exception_ptr failure;
  const auto read = [&](std::span<double> values) {
    try {
      if (!failure)
        next(values);
    } catch (...) { // the ranks still exchange the rest
      failure = std::current_exception();
    }
  };
  for (std::size_t r = 0; r < n_ranks; ++r) {
    const std::size_t size =
        static_cast<std::size_t>(rows.bounds()[r + 1] - rows.bounds()[r]) *
        rows.width();
    for (std::size_t at = 0; at < size; at += most) {
      const std::size_t n = std::min(most, size - at);
      if (r == 0) {
        if (own_rank == 0)
          read(std::span(own).subspan(at, n));
        continue;
      }
      sent.resize(own_rank == 0 ? n : 0);
      if (own_rank == 0)
        read(sent);
      std::vector<std::size_t> to(n_ranks, 0);
      std::vector<std::size_t> from(n_ranks, 0);
      to[r] = sent.size() * sizeof(double);
      from[0] = own_rank == r ? n * sizeof(double) : 0;
      const std::span<double> received =
          own_rank == r ? std::span(own).subspan(at, n) : std::span<double>();
      rows.ranks()->exchange(std::as_bytes(std::span(sent)), to,
                             std::as_writable_bytes(received), from);
    }
  }
  const bool is_unread = rank_max(rows.ranks(), failure ? 1.0 : 0.0) > 0.0;
  if (failure)
    std::rethrow_exception(failure);
  if (is_unread)
    throw std::runtime_error("rank 0 could not read the field");
  return own;
}

} // namespace asperity
