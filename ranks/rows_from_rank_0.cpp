#include "ranks/rows_from_rank_0.hpp"

#include <algorithm>

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
  for (std::size_t r = 0; r < n_ranks; ++r) {
    const std::size_t size =
        static_cast<std::size_t>(rows.bounds()[r + 1] - rows.bounds()[r]) *
        rows.width();
    for (std::size_t at = 0; at < size; at += most) {
      const std::size_t n = std::min(most, size - at);
      if (r == 0) {
        if (own_rank == 0)
          next(std::span(own).subspan(at, n));
        continue;
      }
      sent.resize(own_rank == 0 ? n : 0);
      if (own_rank == 0)
        next(sent);
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
  return own;
}

} // namespace asperity
