#include "input/reader/documents.hpp"

#include "input/reader/vocabulary.hpp"
#include "input/text/toml_text.hpp"
#include "input/types/quantity_at_load.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <sstream>

namespace asperity::cases {
namespace {

constexpr std::size_t page_width = 80;

// Wraps text into lines that begin with `prefix`.
std::string wrapped(const std::string& text, const std::string& prefix) {
  std::istringstream words(text);
  std::string page;
  std::string line = prefix;
  for (std::string word; words >> word;) {
    if (line.size() + 1 + word.size() > page_width && line != prefix) {
      page += line + "\n";
      line = prefix;
    }
    line += " " + word;
  }
  return page + line + "\n";
}

bool is_needed(const Key& key) {
  return key.need != Need::never;
}

std::string units_text(const Key& key) {
  if (key.type == ValueType::word)
    return fmt::format("{}", fmt::join(key.words, " | "));
  if (key.dimension != Dimension::none)
    return fmt::format(
        "[{}]", fmt::join(unit_symbols(key.dimension, key.references), ", "));
  return "";
}

std::string template_key(const Key& key, const std::string& example) {
  std::string comment = key.description + " " + units_text(key);
  if (!key.fallback.empty())
    comment += " Default: " + key.fallback + ".";
  else if (!key.when.empty())
    comment +=
        fmt::format(" ({}{})", is_needed(key) ? "needed: " : "", key.when);
  const std::string mark = key.show == Show::yes ? "" : "# ";
  return wrapped(comment, "#") + mark + key.name + " = " + example + "\n";
}

std::string need_text(const Key& key) {
  if (!key.fallback.empty())
    return "default `" + key.fallback + "`";
  if (key.need == Need::always)
    return "needed";
  if (key.when.empty())
    return "optional";
  return is_needed(key) ? "needed: " + key.when : key.when;
}

// Escapes a cell of a Markdown table, which a bar would end.
std::string cell(const std::string& text) {
  std::string safe;
  for (const char letter : text)
    safe += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return safe;
}

std::string type_text(const Key& key) {
  if (key.type == ValueType::program)
    return fmt::format(
        "{} [{}]", allowed_text(key),
        fmt::join(unit_symbols(key.dimension, key.references), ", "));
  return allowed_text(key);
}

std::string key_row(const Key& key) {
  const std::string kinds =
      key.kinds.empty() ? ""
                        : fmt::format(" (for {})", fmt::join(key.kinds, ", "));
  const std::string range = key.range.limits(
      key.dimension == Dimension::none ? "1" : si_unit(key.dimension));
  return fmt::format("| `{}` | {}{} | {} | {}{} |\n", key.name,
                     cell(type_text(key)),
                     range.empty() ? "" : "; " + cell(range),
                     cell(need_text(key) + kinds), cell(key.description),
                     key.example.empty() || key.type == ValueType::band
                         ? ""
                         : " E.g. `" + cell(key.example) + "`");
}

std::string table_section(const Table& table) {
  std::string page = table.name.empty() ? "## Top of the file\n\n"
                     : table.is_part    ? "## `" + table.name + "`\n\n"
                                        : "## `[" + table.name + "]`\n\n";
  page += table.description + " " + table.when + "\n\n";
  page += "| key | value | needed | what it is |\n|---|---|---|---|\n";
  for (const Key& key : table.keys)
    page += key_row(key);
  return page + "\n";
}

// Returns the section that follows the table of [expect].
std::string at_load_section() {
  std::string page =
      "A quantity at one load is written `name@p=pressure`, for example\n"
      "`\"area_fraction@p=0.0129 E*\" = { value = 0.109, within = 0.01 }`, the "
      "pressure\nin " +
      fmt::format(
          "{}",
          fmt::join(unit_symbols(Dimension::pressure,
                                 {mechanics::ReferenceUnit::contact_modulus}),
                    ", ")) +
      ". The quantity is interpolated in\nthe method's loading curve by "
      "monotone cubics in ln p (the area by its logarithm),\n"
      "neither beyond its loads nor between loads more than a decade apart, "
      "and "
      "averaged\nover realisations. `reference.csv` uses the same names.\n\n| "
      "name | what it is |\n|---|---|\n";
  for (const ExpectationName& entry : expectation_names(QuantityOf::load))
    page += fmt::format("| `{}` | {} |\n", entry.name, cell(entry.description));
  page += "\nA quantity of a contact at a magnification names both, "
          "`\"area_fraction@p=10 MPa@zeta=10\"`:\nthe load is one of "
          "[magnification], and the logarithm of the quantity is "
          "interpolated\nlinearly between the magnifications. The theory of "
          "the studies yields it.\n\n"
          "| name | what it is |\n|---|---|\n";
  for (const ExpectationName& entry :
       expectation_names(QuantityOf::magnification))
    page += fmt::format("| `{}` | {} |\n", entry.name, cell(entry.description));
  return page + "\n";
}

// Returns the section with the table of units.
std::string units_section() {
  std::string page =
      "## Units\n\nCases, options of commands, height maps, line scans and "
      "measured curves have the same\nunits. `µ` and `~` are `u`, `Å` is "
      "`angstrom`, `Ω` is `Ohm`, `²` and `2` behind a letter are\n`^2`, and a "
      "product may have a blank, a dot or a star: `µm²`, `N/mm2` and `Pa*s`.\n"
      "Upper and lower case differ: there is no pressure in `mPa`, for which "
      "`MPa` would be meant.\n\n| quantity | units |\n|---|---|\n";
  std::string row;
  const std::vector<input::Unit>& all = input::units();
  for (std::size_t i = 0; i < all.size(); ++i) {
    row += fmt::format("{}`{}`", row.empty() ? "" : ", ", all[i].symbol);
    const bool is_last =
        i + 1 == all.size() || all[i + 1].dimension != all[i].dimension;
    if (is_last && all[i].dimension != Dimension::none)
      page += fmt::format("| {} | {} |\n",
                          input::dimension_name(all[i].dimension), row);
    if (is_last)
      row.clear();
  }
  return page;
}

const char* const page_head =
    R"(# The case file

A case is one TOML file, which holds all of its parameters. This page is
generated from the table that the reader validates against
(`input/reader/vocabulary*.cpp`); `asperity schema` prints the same as JSON
Schema, and `asperity new NAME` writes a template.

- A quantity is a number in SI, or a string with a unit: `"14 nm"`, `"0.3 E*"`.
  Units of the problem: `E*` is the contact modulus, `length` the side of the
  square, `h` the node spacing, `h_rms` the rms height of the realisation (for a
  theory by the formula, that of the formula) and `E*/h` a stiffness per area.
  The row of each key lists its usual units, [Units](#units) all of them. A
  number in quotes without a unit is refused, and so is a number without a unit
  in an option of a command. Other than 0, the
  magnitude of a length is between 1e-16 and 1e16 m, that of a pressure or
  modulus between 1e-15 and 1e21 Pa, and that of a number in a unit of the
  problem between 1e-15 and 1e9.
- A method runs only if its table is present. A table inside a method's table is
  a variant: `[fem.hard]` is the method `fem.hard`; it inherits the keys of
  `[fem]`, and its own keys override them. Its name consists of the letters a-z,
  digits and hyphens, and has at most 80 characters with that of the method.
- All mistakes are reported together: file, line, key, what was found, what is
  allowed and the nearest valid word. The program then ends with exit code 2.
- `--set key.path=value` overrides a value of the file. The value is TOML, or
  else a string (`--set "surface.length=20 um"`); an empty value removes it.
  The case text in a result ends with one line `#--set key.path=value` per
  override, and the reader applies such lines at the end of a file. A key with
  dots or equals signs is quoted: `expect."area_fraction@p=0.01 E*"`.
- A file whose first key is `base = "../polymer/case.toml"` (relative to the
  file) is another case with changes: every other key overrides that case as
  `--set` would; `key = ""` removes a key and `fem = ""` a whole table. Relative
  paths in the base case are still resolved from its folder. The case text of a
  result is that of the base case with the changes as `#--set` lines; it needs
  neither file.

)";

} // namespace

std::string case_template(const std::string& name) {
  std::string text =
      "# A case for asperity. Quantities are numbers in SI or strings with a "
      "unit;\n# keys behind a # show their default or an alternative. "
      "One more method, atoms\n# [md], is described in "
      "docs/reference/case.md.\n";
  for (const Table& table : vocabulary()) {
    bool is_shown = false;
    for (const Key& key : table.keys)
      is_shown = is_shown || key.show == Show::yes;
    if (table.name == "expect")
      is_shown = true;
    if (table.is_part || !is_shown)
      continue;
    if (!table.name.empty())
      text += fmt::format("\n{}[{}]\n",
                          wrapped(table.description + " " + table.when, "#"),
                          table.name);
    for (const Key& key : table.keys)
      if (key.show != Show::no)
        text += template_key(key, key.name == "title" ? toml_value(name)
                                                      : key.example);
  }
  return text;
}

std::string case_reference_markdown() {
  std::string page = page_head;
  for (const Table& table : vocabulary()) {
    page += table_section(table);
    if (table.name == "expect")
      page += at_load_section();
  }
  return page + units_section();
}

} // namespace asperity::cases
