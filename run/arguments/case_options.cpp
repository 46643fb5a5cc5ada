#include "run/arguments/case_options.hpp"

#include "base/plain_text.hpp"
#include "input/case_options.hpp"
#include "input/input_error.hpp"
#include "input/nearest.hpp"
#include "input/reader/vocabulary.hpp"
#include "input/refusals.hpp"
#include "input/text/toml_text.hpp"
#include "input/units.hpp"
#include "run/arguments/physics.hpp"
#include "studies/flow/flow.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iterator>

namespace asperity::run {
namespace {

/// The value of an option as TOML: a quantity must have its unit, so that
/// "2e9" is no number in SI.
std::string toml_of(const input::CaseOption& option, const std::string& value) {
  const std::size_t dot = option.key.rfind('.');
  const cases::Key* const key =
      cases::find_key(std::string(option.key.substr(0, dot)),
                      std::string(option.key.substr(dot + 1)));
  const bool is_number = key != nullptr &&
                         key->type == cases::ValueType::quantity &&
                         key->dimension == input::Dimension::none;
  if (!is_number)
    return cases::toml_value(value);
  const auto [number, rest] = number_and_rest(value); // ".5" is not TOML
  if (!rest.empty() || std::isnan(number))
    throw input::InputError(
        fmt::format("{} = \"{}\", but must be a number, as in {}", option.name,
                    printable(value), option.with(option.example)));
  return fmt::format("{}", number);
}

/// A load that is easy to read.
struct RoundLoad {
  double value = 0.0; ///< [Pa]
  std::string text;   ///< in TOML
};

/// 1, 1.5, 2, 3, 5 and 7 times powers of ten around a range, or for more than
/// 2.6 decades 1, 2 and 5 times.
std::vector<RoundLoad> load_series(double low, double high) {
  static constexpr const char* units[] = {"Pa", "kPa", "MPa", "GPa"};
  const std::vector<double> digits =
      std::log10(high / low) > 2.6
          ? std::vector<double>{1.0, 2.0, 5.0}
          : std::vector<double>{1.0, 1.5, 2.0, 3.0, 5.0, 7.0};
  std::vector<RoundLoad> series;
  const int end = static_cast<int>(std::ceil(std::log10(high))) + 1;
  for (int decade = static_cast<int>(std::floor(std::log10(low))) - 1;
       decade <= end; ++decade) {
    const int unit =
        std::clamp(static_cast<int>(std::floor(decade / 3.0)), 0, 3);
    for (const double digit : digits)
      series.push_back({digit * std::pow(10.0, decade),
                        fmt::format("\"{:.6g} {}\"",
                                    digit * std::pow(10.0, decade - 3 * unit),
                                    units[unit])});
  }
  return series;
}

std::string trimmed_word(const std::string& text) {
  const std::size_t begin = text.find_first_not_of(' ');
  return begin == text.npos
             ? ""
             : text.substr(begin, text.find_last_not_of(' ') - begin + 1);
}

/// The pressures of one word of --pressure, each as TOML.
std::vector<std::string> pressures_of(const std::string& word) {
  const std::size_t dots = word.find("..");
  if (dots == word.npos)
    return {cases::toml_value(word)};
  const std::string from = trimmed_word(word.substr(0, dots));
  const std::string to = trimmed_word(word.substr(dots + 2));
  const double low =
      positive_quantity("--pressure", from, input::Dimension::pressure);
  const double high =
      positive_quantity("--pressure", to, input::Dimension::pressure);
  if (!(low < high))
    throw input::InputError(fmt::format(
        "--pressure = \"{}\", but a range goes from the smaller pressure to "
        "the larger one: \"1 kPa..1 MPa\"",
        word));
  std::vector<std::string> loads{cases::toml_value(from)};
  constexpr double apart = 1e-6; // from an end, which the user has written
  for (const RoundLoad& load : load_series(low, high))
    if (load.value > low * (1.0 + apart) && load.value < high * (1.0 - apart))
      loads.push_back(load.text);
  loads.push_back(cases::toml_value(to));
  return loads;
}

/// The values of --pressure, which are separated by commas, as a list in TOML.
std::string pressure_list(const std::string& words) {
  std::vector<std::string> pressures;
  for (std::size_t begin = 0; begin <= words.size();) {
    const std::size_t comma = std::min(words.find(',', begin), words.size());
    for (std::string& one :
         pressures_of(trimmed_word(words.substr(begin, comma - begin))))
      pressures.push_back(std::move(one));
    begin = comma + 1;
  }
  return fmt::format("[{}]", fmt::join(pressures, ", "));
}

/// Replaces each occurrence, and says whether there was one.
bool replace_text(std::string& text, const std::string& from,
                  const std::string& to) {
  bool is_found = false;
  for (std::size_t at = text.find(from); at != text.npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
    is_found = true;
  }
  return is_found;
}

/// Puts an option in the place of its keys in a line of a refusal.
void name_option(const input::CaseOption& option, std::string& line) {
  const std::string name(option.name);
  for (const std::string_view key : {option.key, option.also}) {
    const std::string start = std::string(key) + " ";
    if (key.empty())
      continue;
    if (const std::size_t note = line.find(" (a number without quotes is");
        note != line.npos && line.find(start + "= \"") != line.npos)
      line.erase(note); // an option has its unit
    for (const char* from : {"--set: ", "the case of the map: "})
      replace_text(line, from + start, name + " ");
    if (line.starts_with(start))
      line.replace(0, key.size(), name);
  }
}

/// Makes the entries of a case, and collects what is refused.
class OverrideMaker {
public:
  OverrideMaker(const CaseOptions& options, const AskedOf& asked,
                input::Refusals& refusals)
      : options_(options), asked_(asked), refusals_(refusals) {}

  std::vector<std::string>
  made(const std::map<std::string, std::string, std::less<>>& values) {
    for (const input::CaseOption& option : input::case_options())
      if (const auto found = values.find(option.name); is_read(option.group) &&
                                                       found != values.end() &&
                                                       !found->second.empty())
        refusals_.of([&] { add(option, found->second); });
    for (const char* other : {"--work-of-adhesion", "--hardness"})
      if (is_read(input::OptionGroup::effect) && options_.has("--friction") &&
          options_.has(other))
        refusals_.add(fmt::format(
            "--friction cannot be combined with {}: partial slip follows from "
            "the normal contact of a half-space without adhesion and hardness",
            other));
    return std::move(entries_);
  }

private:
  bool is_read(input::OptionGroup group) const {
    return !asked_.group || *asked_.group == group;
  }

  void put(std::string_view key, const std::string& toml) {
    entries_.push_back(fmt::format("{}={}", key, toml));
  }

  /// Removes another key for the same thing from a case.
  void drop(const char* key, const char* option) {
    if (!asked_.are_maps && !options_.has(option))
      put(key, "");
  }

  void add(const input::CaseOption& option, const std::string& value) {
    if (option.name == "--flow")
      return (void)std::ranges::move(flow_overrides(value),
                                     std::back_inserter(entries_));
    if (option.name == "--pressure")
      return add_pressures(pressure_list(value));
    if (option.name == "--height-unit" || option.name == "--length-unit")
      return put(option.key, cases::toml_value(length_unit_text(
                                 std::string(option.name), value)));
    put(option.key, toml_of(option, value));
    if (option.name == "--work-of-adhesion")
      add_adhesion();
    if (!option.also.empty() && asked_.are_maps)
      put(option.also, toml_of(option, value));
    if (option.name == "--contact-modulus") {
      drop("material.youngs_modulus", "--youngs-modulus");
      drop("material.counter", "--counter-youngs-modulus");
    }
    if (option.name == "--youngs-modulus")
      drop("material.contact_modulus", "--contact-modulus");
  }

  void add_pressures(const std::string& list) {
    if (asked_.are_maps) {
      put("load.nominal_pressure", list);
      if (options_.has("--work-of-adhesion"))
        put("load.cycle", "\"load-unload\"");
    } else {
      put("load", fmt::format("{{ nominal_pressure = {} }}", list));
    }
  }

  /// The exponential law, and for maps their loads: mean gaps from 4 h_rms to
  /// 0.1 h_rms, where most sticky faces bear a load, and back; or with free
  /// edges adhesive_loads(), of which the theory has no states in tension.
  void add_adhesion() {
    put("halfspace.contact", "\"exponential\"");
    if (!asked_.are_maps || options_.has("--pressure"))
      return;
    if (asked_.has_free_edges) {
      put("theory", "");
      put("load.cycle", "");
      put("load.nominal_pressure", adhesive_loads({}));
      return;
    }
    put("load.cycle", "\"load-unload\"");
    put("load.nominal_pressure", "");
    std::vector<std::string> gaps;
    for (const double gap : {4.0, 3.5, 3.0, 2.5, 2.0, 1.5, 1.0, 0.75, 0.5, 0.4,
                             0.3, 0.25, 0.2, 0.15, 0.1})
      gaps.push_back(fmt::format("\"{} h_rms\"", gap));
    put("load.mean_gap", fmt::format("[{}]", fmt::join(gaps, ", ")));
  }

  const CaseOptions& options_;
  const AskedOf& asked_;
  std::vector<std::string> entries_;
  input::Refusals& refusals_;
};

} // namespace

std::string& CaseOptions::place(std::string_view name) {
  return values_[std::string(name)];
}

std::string CaseOptions::value(std::string_view name) const {
  const auto found = values_.find(name);
  return found == values_.end() ? "" : found->second;
}

bool CaseOptions::empty() const {
  return std::ranges::all_of(
      values_, [](const auto& entry) { return entry.second.empty(); });
}

std::vector<std::string>
CaseOptions::overrides(const AskedOf& asked, input::Refusals& refusals) const {
  return OverrideMaker(*this, asked, refusals).made(values_);
}

std::vector<std::string> CaseOptions::words() const {
  std::vector<std::string> words;
  for (const auto& [name, value] : values_)
    if (!value.empty())
      words.insert(words.end(), {name, value});
  return words;
}

std::string CaseOptions::with_options(const std::string& refusal,
                                      bool has_hints) const {
  std::string text;
  std::string last;
  for (std::size_t begin = 0; begin < refusal.size();) {
    const std::size_t end = std::min(refusal.find('\n', begin), refusal.size());
    std::string line = refusal.substr(begin, end - begin);
    begin = end + 1;
    if (has_hints && line.ends_with("mistake(s) in the case file"))
      continue; // which the user does not have
    bool is_refused = false;
    for (const input::CaseOption& option : input::case_options()) {
      const std::string missing = std::string(option.key) + " is missing";
      if (line.find(missing) == line.npos) {
        if (has(option.name))
          name_option(option, line);
      } else if (has_hints && has(option.name)) {
        is_refused = true;
      } else if (has_hints) {
        line += option.name == "--youngs-modulus"
                    ? "; please add --contact-modulus \"2 GPa\", or "
                      "--youngs-modulus \"2 GPa\" with --poisson-ratio 0.3"
                    : "; please add " + option.with(option.example);
      }
    }
    if (has_hints) {
      replace_text(line, "the case of the map: ", "");
      line.erase(0, line.find_first_not_of(' '));
    }
    if (!is_refused && line != last)
      text += (text.empty() ? "" : "\n") + line;
    last = line;
  }
  return text;
}

std::vector<std::string> flow_overrides(const std::string& fluid) {
  const auto named = std::ranges::find(
      studies::named_fluids, fluid, [](const auto& one) { return one.first; });
  std::string viscosity = fluid;
  if (named != studies::named_fluids.end())
    viscosity = fmt::format("{} Pa s", named->second);
  else if (fluid.empty() ||
           std::isalpha(static_cast<unsigned char>(fluid.front())) != 0)
    throw input::InputError(fmt::format(
        "--flow = \"{}\" is no known fluid: water, air, or a viscosity such as "
        "\"0.1 Pa s\"; nearest: {}",
        fluid, input::nearest(fluid, {"air", "water"})));
  (void)positive_quantity("--flow", viscosity, input::Dimension::viscosity);
  return {"flow.viscosity=\"" + viscosity + "\"",
          "flow.pressure_drop=\"100 kPa\""};
}

std::string adhesive_loads(std::optional<double> scale) {
  std::vector<std::string> loads;
  for (const double share :
       {0.001, 0.003, 0.01,   0.03,   0.1,   0.3,   0.1,  0.03, 0.01, 0.003,
        0.001, 0.0,   -0.001, -0.003, -0.01, -0.03, -0.1, -0.3, -1.0, -3.0})
    loads.push_back(scale ? fmt::format("\"{:.2g} Pa\"", share * *scale)
                          : fmt::format("\"{} E* h'\"", share));
  return fmt::format("[{}]", fmt::join(loads, ", "));
}

std::string round_loads(double low, double high, double highest) {
  const std::vector<RoundLoad> series = load_series(low, high);
  auto first = std::ranges::find_if(
      series, [&](const RoundLoad& load) { return load.value > low; });
  first = first == series.begin() ? first : first - 1;
  std::vector<std::string> loads;
  for (auto load = first; load != series.end() && load->value <= highest;
       ++load) {
    loads.push_back(load->text);
    if (load->value >= high)
      break;
  }
  return fmt::format("[{}]", fmt::join(loads, ", "));
}

} // namespace asperity::run
