#pragma once

// The options of the command line that stand for keys of a case, in one list
// that all commands on cases and maps share.

#include <span>
#include <string>
#include <string_view>

namespace asperity::input {

/// What an option describes: the reading of a map, the elastic bodies, the
/// loads, or an effect besides elastic contact.
enum class OptionGroup { map, body, load, effect };

/// An option that stands for a key of a case. Unit, range and allowed words are
/// those of the key, whose reader checks the value.
struct CaseOption {
  OptionGroup group;
  std::string_view name;    ///< "--youngs-modulus"
  std::string_view key;     ///< "material.youngs_modulus"
  std::string_view value;   ///< how help names the value: "Q"
  std::string_view example; ///< "2 GPa"
  std::string help;         ///< lines of at most 52 characters
  /// Another key that it stands for in the case of a map; "": none.
  std::string_view also = "";

  /// The words of a command line that give the option a value.
  std::string with(std::string_view text) const;
};

/// All options, in the order of the help.
std::span<const CaseOption> case_options();

/// The words of a command line that give a key of a case its value: those of
/// its option, else `--set KEY=VALUE`.
std::string setting(std::string_view key, std::string_view value);

} // namespace asperity::input
