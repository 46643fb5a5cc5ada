#include "results/storage/skipped_storage.hpp"

#include <array>
#include <string>

namespace asperity::results {
namespace {

constexpr const char* what_name = "what";
constexpr const char* why_name = "why";
constexpr const char* cpu_time_name = "cpu_time";
constexpr const char* bytes_name = "bytes";

} // namespace

void write_skipped(Hdf5Group& group, std::span<const Skipped> skipped) {
  std::vector<std::string> things;
  std::vector<std::string> reasons;
  std::vector<double> times;
  std::vector<double> sizes;
  for (const Skipped& one : skipped) {
    things.push_back(one.what);
    reasons.push_back(one.why);
    times.push_back(one.cpu_time);
    sizes.push_back(one.bytes);
  }
  group.append(what_name, things);
  group.append(why_name, reasons);
  group.append(cpu_time_name, times, Hdf5Number::float64, "s");
  group.append(bytes_name, sizes, Hdf5Number::float64, "B");
}

std::vector<Skipped> read_skipped(const Hdf5Group& group) {
  if (!group.has(what_name))
    return {};
  const std::array<std::string, 4> names{what_name, why_name, cpu_time_name,
                                         bytes_name};
  group.common_length(names);
  const std::vector<std::string> things = group.texts(what_name);
  const std::vector<std::string> reasons = group.texts(why_name);
  const std::vector<double> times = group.column(cpu_time_name);
  const std::vector<double> sizes = group.column(bytes_name);
  std::vector<Skipped> skipped;
  for (std::size_t i = 0; i < things.size(); ++i)
    skipped.push_back({things[i], reasons[i], times[i], sizes[i]});
  return skipped;
}

} // namespace asperity::results
