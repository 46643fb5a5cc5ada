#include "methods/cached_operator.hpp"

#include "base/cpu_clock.hpp"

#include <cstring>

namespace asperity::methods {

fem::OperatorCache operator_cache(Cache& cache, const std::string& key,
                                  int threads, double& saved_setup_time) {
  const auto read = [&cache, key, &saved_setup_time] {
    std::optional<std::string> bytes = cache.read(key, entry_kind::face);
    if (!bytes || bytes->size() < sizeof(double))
      return std::optional<std::string>();
    std::memcpy(&saved_setup_time, bytes->data(), sizeof(double));
    return std::optional(bytes->substr(sizeof(double)));
  };
  const auto write = [&cache, key,
                      clock = CpuClock(threads)](std::string_view bytes) {
    const double cost = clock.seconds();
    std::string kept(sizeof(double), '\0');
    std::memcpy(kept.data(), &cost, sizeof(double));
    cache.write(key, entry_kind::face, kept.append(bytes));
  };
  return {read, write};
}

} // namespace asperity::methods
