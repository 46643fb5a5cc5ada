#include "results/joined_result.hpp"

#include "input/input_error.hpp"
#include "results/result_reader.hpp"
#include "results/result_writer.hpp"
#include "results/storage/result_layout.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <functional>
#include <stdexcept>
#include <string_view>

namespace asperity::results {
namespace {

enum class Joining { sum, largest, smallest };

/// How facts that are numbers, with a unit behind them, or times are joined.
struct JoinedFact {
  std::string_view name;
  Joining joining;
  int digits; ///< behind the point
};

constexpr std::array<JoinedFact, 9> joined_facts{{
    {"started", Joining::smallest, 0},
    {"finished", Joining::largest, 0},
    {"wall time", Joining::largest, 2},
    {"CPU time", Joining::sum, 2},
    {"writing CPU time", Joining::sum, 4},
    {"peak memory", Joining::largest, 0},
    {"steps computed", Joining::sum, 0},
    {"steps from the cache", Joining::sum, 0},
    {"steps computed again for what follows them", Joining::sum, 0},
}};

/// Returns the sum of "1.50 s" and "2.25 s", "3.75 s".
std::string sum_of(const std::string& one, const std::string& other,
                   int digits) {
  char* unit = nullptr;
  const double sum =
      std::strtod(one.c_str(), &unit) + std::strtod(other.c_str(), nullptr);
  return fmt::format("{:.{}f}{}", sum, digits, unit);
}

/// Returns true if `one` is the smaller number, or, of two times, the earlier.
bool is_smaller(const std::string& one, const std::string& other) {
  if (one.ends_with('Z') && other.ends_with('Z'))
    return one < other;
  return std::strtod(one.c_str(), nullptr) <
         std::strtod(other.c_str(), nullptr);
}

/// Adds one more value to a list "a; b", unless it is in it.
std::string listed(const std::string& list, const std::string& value) {
  constexpr std::string_view between = "; ";
  const std::string padded = fmt::format("{}{}{}", between, list, between);
  return padded.find(fmt::format("{}{}{}", between, value, between)) !=
                 std::string::npos
             ? list
             : fmt::format("{}{}{}", list, between, value);
}

std::string joined(const std::string& name, const std::string& one,
                   const std::string& other) {
  const auto known = std::ranges::find(joined_facts, name, &JoinedFact::name);
  if (known == joined_facts.end())
    return listed(one, other);
  if (known->joining == Joining::sum)
    return sum_of(one, other, known->digits);
  const bool is_first = is_smaller(one, other);
  return is_first == (known->joining == Joining::smallest) ? one : other;
}

/// Adds the facts of one more part. Those that name the inputs are equal.
void join_facts(Provenance& facts, const Provenance& more) {
  for (const auto& [name, value] : more) {
    if (name.starts_with(layout::input))
      continue;
    const auto known =
        std::ranges::find(facts, name, &Provenance::value_type::first);
    if (known == facts.end())
      facts.emplace_back(name, value);
    else
      known->second = joined(name, known->second, value);
  }
}

/// Adds what one more part did not compute. Each part lists what the case makes
/// redundant, and its own steps that were in a cache.
void join_skipped(std::vector<Skipped>& all, const std::vector<Skipped>& more) {
  for (const Skipped& one : more) {
    const bool is_known = std::ranges::any_of(all, [&](const Skipped& known) {
      return known.what == one.what && known.why == one.why;
    });
    if (!is_known)
      all.push_back(one);
  }
}

CaseInfo info_of(const Result& result) {
  return {result.case_name, result.case_title,      result.case_text,
          result.case_hash, result.contact_modulus, result.reference,
          inputs_of(result)};
}

std::vector<std::string> methods_of(const Result& result) {
  std::vector<std::string> names;
  for (const MethodRecord& method : result.methods)
    names.push_back(method.name);
  return names;
}

void require_same(const Result& part, const CaseInfo& info,
                  const std::vector<std::string>& methods,
                  const std::filesystem::path& first) {
  if (part.status != "complete")
    throw input::InputError(
        fmt::format("{}: is {}, not complete", part.path, part.status));
  if (part.case_hash != info.hash || inputs_of(part) != info.inputs ||
      methods_of(part) != methods)
    throw input::InputError(
        fmt::format("{}: is of another case, of other methods or input files, "
                    "or of another build of the program than {}",
                    part.path, first.string()));
}

void write_curve_of(const Curve& curve, const std::string& method,
                    int realization, ResultWriter& writer) {
  writer.record_setup_time(method, realization, curve.setup_cpu_time);
  if (curve.own_surface)
    writer.record_own_surface(method, realization, *curve.own_surface);
  for (const Fields& fields : curve.fields)
    writer.append_fields(method, realization, fields.grid, fields);
  writer.append_steps(method, realization, curve.points);
}

/// Writes surfaces, curves and tables. A realisation that the part does not
/// hold has no surface points and no rows.
void write_part(const Result& part, ResultWriter& writer) {
  for (std::size_t r = 0; r < part.surfaces.size(); ++r)
    if (part.surfaces[r].grid.size() > 0)
      writer.record_surface(static_cast<int>(r), part.surfaces[r]);
  for (const MethodRecord& method : part.methods)
    for (std::size_t r = 0; r < method.realizations.size(); ++r)
      if (!method.realizations[r].points.empty())
        write_curve_of(method.realizations[r], method.name, static_cast<int>(r),
                       writer);
  for (const Table& table : part.tables)
    writer.record_table(table);
}

} // namespace

void join_results(const std::vector<std::filesystem::path>& parts,
                  const std::filesystem::path& folder) {
  if (parts.empty())
    throw std::domain_error("parts is empty, but must hold a result");
  Result part = read_result(parts.front(), MapsInFile::large);
  const CaseInfo info = info_of(part);
  const std::vector<std::string> methods = methods_of(part);
  require_same(part, info, methods, parts.front());
  ResultWriter writer(folder, info);
  for (const MethodRecord& method : part.methods)
    writer.begin_method(method.name, method.kind, method.description,
                        method.contact);
  write_part(part, writer);
  Provenance facts;
  join_facts(facts, part.provenance);
  std::vector<Skipped> skipped = part.skipped;
  for (std::size_t i = 1; i < parts.size(); ++i) {
    part = {}; // its memory
    part = read_result(parts[i], MapsInFile::large);
    require_same(part, info, methods, parts.front());
    write_part(part, writer);
    join_facts(facts, part.provenance);
    join_skipped(skipped, part.skipped);
  }
  facts.emplace_back("parts", std::to_string(parts.size()));
  writer.record_provenance(facts);
  writer.record_skipped(skipped);
  writer.finish("complete");
}

} // namespace asperity::results
